//! The registry refuses two kinds of one name. A program of its own, because it spoils the registry.

use assur_group::{
    Assemblies, Builders, ForceAngle, GroupFrame, GroupPlugin, Iterated, Pattern, RegistryError, groups,
    inventory, plugin_for,
};
use assur_words::Text;

const fn entry(crate_name: &'static str) -> GroupPlugin {
    GroupPlugin {
        name: "twice",
        kind: "TWICE",
        number: 0,
        crate_name,
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
fn two_of_one_name_are_refused() {
    let error = groups().unwrap_err();
    assert_eq!(
        error,
        RegistryError::Duplicate {
            what: assur_words::text!("group-sort"),
            name: "twice",
            first: "first",
            second: "second"
        }
    );
    assert_eq!(
        error.to_string(),
        "two plugins are registered as group `twice`: first and second; rename one"
    );
    let frame = GroupFrame { links: vec![], inner: vec![], outer: vec![], driven: vec![], scale: 1.0 };
    assert!(plugin_for(&frame).is_err());
}
