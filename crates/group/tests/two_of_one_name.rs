//! The registry refuses two kinds of one name. A program of its own, because it spoils the registry.

use assur_group::{
    Builders, ForceAngle, GroupFrame, GroupPlugin, Iterated, Pattern, RegistryError, Ways, groups, inventory,
    plugin_for,
};

const fn entry(crate_name: &'static str) -> GroupPlugin {
    GroupPlugin {
        name: "twice",
        kind: "TWICE",
        number: 0,
        crate_name,
        summary: "a name that is taken",
        pattern: Pattern { links: 0, inner: &[], outer: &[] },
        ways: Ways { most: 1, varies: false, words: "one" },
        iterates: false,
        singular: "never",
        force_angle: ForceAngle::DEFAULT,
        source: "a test",
        builders: Builders::of::<Iterated>(),
    }
}

inventory::submit! { entry("second") }
inventory::submit! { entry("first") }

#[test]
fn two_of_one_name_are_refused() {
    let error = groups().unwrap_err();
    assert_eq!(
        error,
        RegistryError::Duplicate { what: "group", name: "twice", first: "first", second: "second" }
    );
    assert_eq!(
        error.to_string(),
        "two plugins are registered as group `twice`: first and second; rename one"
    );
    let frame = GroupFrame { links: vec![], inner: vec![], outer: vec![], scale: 1.0 };
    assert!(plugin_for(&frame).is_err());
}
