//! Every folder of `plugins/` is registered by the crate that links them all.

use std::collections::BTreeSet;

use assur_all as _;

/// Package names of the plugins by their folders.
fn folders() -> BTreeSet<String> {
    let plugins = format!("{}/../plugins", env!("CARGO_MANIFEST_DIR"));
    let names = std::fs::read_dir(plugins)
        .expect("the folder of the plugins")
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("a plain name"));
    names.filter(|name| name != "all").map(|name| format!("assur-{name}")).collect()
}

/// Package names that have an entry in one of the registries.
fn registered() -> BTreeSet<String> {
    let groups = assur_group::groups().expect("a sound registry").into_iter().map(|plugin| plugin.crate_name);
    let analyzers =
        assur_force::analyzers().expect("a sound registry").into_iter().map(|plugin| plugin.crate_name);
    let integrators = assur_integrator::integrators()
        .expect("a sound registry")
        .into_iter()
        .map(|plugin| plugin.crate_name);
    let catalogues =
        assur_motor::catalogues().expect("a sound registry").into_iter().map(|plugin| plugin.crate_name);
    let importers =
        assur_import::importers().expect("a sound registry").into_iter().map(|plugin| plugin.crate_name);
    let all = groups.chain(analyzers).chain(integrators).chain(catalogues).chain(importers);
    all.map(str::to_owned).collect()
}

#[test]
fn every_folder_is_registered_and_nothing_else() {
    assert_eq!(folders(), registered());
}

#[test]
fn the_crate_of_all_plugins_names_each_once() {
    let source = include_str!("../../plugins/all/src/lib.rs");
    for folder in folders() {
        let line = format!("use {} as _;", folder.replace('-', "_"));
        assert_eq!(source.lines().filter(|found| *found == line).count(), 1, "{line}");
    }
}
