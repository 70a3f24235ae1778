//! The core asks for no plugin by name: what it must know of one, the plugin declares.

use std::fs;
use std::path::{Path, PathBuf};

use assur_all as _;

/// Names that are ordinary words too: labels of other things may be called so, only asking for a plugin by them is a fault.
const ORDINARY: [&str; 4] = ["closed-form", "energy", "groups", "uniform"];

/// Whether a line holds a name as a literal; of an ordinary word, whether it asks for it.
fn names(line: &str, name: &str) -> bool {
    let literal = format!("\"{name}\"");
    if !ORDINARY.contains(&name) {
        return line.contains(&literal);
    }
    let asking = [
        format!("= {literal}"),
        format!("find({literal}"),
        format!("Some({literal}"),
        format!("{literal} =>"),
    ];
    asking.iter().any(|pattern| line.contains(pattern))
}

/// Names of every registry, and how code names the crates that register them.
fn plugins() -> (Vec<&'static str>, Vec<String>) {
    let groups = assur_group::groups().unwrap_or_else(|error| panic!("{error}"));
    let analyzers = assur_force::analyzers().unwrap_or_else(|error| panic!("{error}"));
    let integrators = assur_integrator::integrators().unwrap_or_else(|error| panic!("{error}"));
    let catalogues = assur_motor::catalogues().unwrap_or_else(|error| panic!("{error}"));
    let groups =
        groups.iter().flat_map(|plugin| [(plugin.name, plugin.crate_name), (plugin.kind, plugin.crate_name)]);
    let all: Vec<_> = groups
        .chain(analyzers.iter().map(|plugin| (plugin.name, plugin.crate_name)))
        .chain(integrators.iter().map(|plugin| (plugin.name, plugin.crate_name)))
        .chain(catalogues.iter().map(|plugin| (plugin.name, plugin.crate_name)))
        .collect();
    let names = all.iter().map(|(name, _)| *name).collect();
    (names, all.iter().map(|(_, crate_name)| crate_name.replace('-', "_")).collect())
}

/// Source files of a folder outside its tests and benchmarks.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.unwrap_or_else(|error| panic!("{error}")).path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && !["tests", "benches", "target"].contains(&name.as_str()) {
            sources(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs") && name != "tests.rs" {
            found.push(path);
        }
    }
}

#[test]
fn no_source_of_the_core_names_a_plugin() {
    let (registered, crates) = plugins();
    assert!(registered.len() > 15 && registered.contains(&"RRR"), "{registered:?}");
    let mut files = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates"), &mut files);
    assert!(files.len() > 100, "only {} files were found", files.len());
    let mut faults = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        for (number, line) in
            text.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//"))
        {
            let literal = registered.iter().find(|name| names(line, name));
            let path = crates.iter().find(|name| line.contains(name.as_str()));
            if literal.is_some() || path.is_some() {
                faults.push(format!("{}:{}: {}", file.display(), number + 1, line.trim()));
            }
        }
    }
    assert!(faults.is_empty(), "the core names plugins:\n{}", faults.join("\n"));
}
