//! Random groups of every kind on the way to each of their singular positions.

use assur_structure::Structure;
use assur_testkit::specimen::{Recipe, kinds};

use super::walk_group::walk;

/// Every random group, on its way to each singular position, keeps C eps / health^k or refuses.
#[test]
fn groups_keep_the_bound_of_a_backward_stable_method() {
    for kind in kinds() {
        let mut rows = 0;
        for seed in 0..8 {
            let recipe = Recipe { groups: 1, only: Some(kind), loads: false };
            let Some(specimen) = recipe.specimen(seed) else { continue };
            let structure = Structure::of(&specimen.mechanism).unwrap();
            for row in walk("group", &structure.groups[0]) {
                // The linear system is not held to parallel guides: its links run away, and its pivots with them.
                let excused = row.method.to_string().starts_with("general") && row.finding.number().is_none();
                assert!(!row.finding.failed() || excused, "{kind:?}, seed {seed}: {row:?}");
                rows += 1;
            }
        }
        // Of some kinds of a higher class no singular position lies on the walks of a group alone.
        let groups = assur_group::groups().unwrap();
        let of_class_two = groups.iter().any(|plugin| plugin.name == kind && plugin.number > 0);
        assert!(rows > 100 || !of_class_two, "{kind:?}: only {rows} rows");
    }
}

/// Two stones on one pin, on guides that turn parallel: the links move less than what they are joined to.
#[test]
fn a_group_whose_motion_is_smaller_than_its_terms_keeps_the_bound() {
    let text = include_str!("../../../../../tests/corpus/stability_fail_61.toml");
    let structure = Structure::of(&assur_scene::read("scene.toml", text).unwrap()).unwrap();
    let rows: Vec<_> = structure.groups.iter().flat_map(|group| walk(group.plugin.kind, group)).collect();
    let failed = rows.iter().find(|row| row.finding.failed());
    assert!(rows.len() > 500 && failed.is_none(), "{failed:?}");
}
