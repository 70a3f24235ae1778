//! The analyzers register themselves in a program that links them.

use assur_force::{RegistryError, analyzers, choose, find};
use assur_force_groups as _;
use assur_force_newton_euler as _;

#[test]
fn registered_under_their_names() {
    for (name, crate_name) in [("groups", "assur-force-groups"), ("newton-euler", "assur-force-newton-euler")]
    {
        let plugin = find(name).unwrap();
        assert_eq!(plugin.crate_name, crate_name);
        assert!(plugin.gives_reactions && !plugin.summary.is_empty() && !plugin.source.is_empty());
    }
    let known: Vec<_> = analyzers().unwrap().iter().map(|plugin| plugin.name).collect();
    assert!(known.is_sorted());
    let error = find("graphical").unwrap_err();
    let (what, name) = (assur_words::text!("force-sort"), "graphical".to_owned());
    assert_eq!(error, RegistryError::Unknown { what, name, known: known.clone() });
    let text = format!("no force analyzer is called `graphical`; there are: {}", known.join(", "));
    assert_eq!(error.to_string(), text);
}

#[test]
fn without_a_name_the_lowest_rank_is_chosen() {
    let chosen = choose(None, false, false).unwrap();
    assert_eq!((chosen.name, chosen.by_groups), ("groups", true));
    assert_eq!(choose(Some("newton-euler"), false, false).unwrap().name, "newton-euler");
    assert!(choose(Some("no such method"), false, false).is_err());
}
