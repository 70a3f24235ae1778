//! The registry refuses two kinds of one pattern. A program of its own, because it spoils the registry.

use assur_group::{
    Assemblies, Builders, ForceAngle, GroupFrame, GroupPlugin, Iterated, Pattern, RegistryError, inventory,
    plugin_for,
};
use assur_words::Text;

const fn entry(name: &'static str) -> GroupPlugin {
    GroupPlugin {
        name,
        kind: "TWICE",
        number: 0,
        crate_name: "a crate",
        summary: TEST,
        pattern: Some(Pattern { links: 0, inner: &[], outer: &[] }),
        rank: 10,
        ways: Assemblies { most: 1, varies: false, words: TEST },
        iterates: false,
        singular: TEST,
        force_angle: ForceAngle::DEFAULT,
        source: TEST,
        builders: Builders::of::<Iterated>(),
    }
}

/// The words of an entry of a test.
const TEST: Text = Text::message("a test", Vec::new());

inventory::submit! { entry("second") }
inventory::submit! { entry("first") }

#[test]
fn two_of_one_pattern_are_refused_where_a_group_has_it() {
    let empty = GroupFrame { links: vec![], inner: vec![], outer: vec![], driven: vec![], scale: 1.0 };
    let error = plugin_for(&empty).unwrap_err();
    let (first, second) = (("first", "a crate"), ("second", "a crate"));
    assert_eq!(error, RegistryError::Ambiguous { what: assur_words::text!("group-sort"), first, second });
    assert!(error.to_string().contains("`first` of a crate and `second` of a crate"), "{error}");
    let other = GroupFrame { links: vec![1], ..empty };
    assert_eq!(plugin_for(&other).map(|found| found.is_none()), Ok(true));
}
