use assur_testkit::specimen::Recipe;

use assur_words::Language;

use super::evaluate::recomputes;
use super::{compiled, forces_agree, worked};

/// Random mechanisms of one kind: its equations hold, recompute, and give the reactions of the independent analyzer.
fn kind(only: Option<&'static str>) {
    for seed in 0..12 {
        let groups = if only.is_some() { 2 } else { 4 };
        let Some(specimen) = (Recipe { groups, only, loads: seed % 4 != 0 }).specimen(seed) else { continue };
        let (linkage, loads) = compiled(specimen.mechanism);
        for index in [0, 2] {
            let what = format!("{only:?}, seed {seed}, position {index}");
            let working = worked(&linkage, loads.as_ref(), index);
            assert_eq!(working.general, Vec::<usize>::new(), "{what}");
            assert!(recomputes(&what, &working.text(Language::english())) > 20, "{what}");
            if let Some(loads) = &loads {
                forces_agree(&what, &linkage, loads, index, &working);
            }
        }
    }
}

#[test]
fn rrr() {
    kind(Some("rrr"));
}

#[test]
fn rrp() {
    kind(Some("rrp"));
}

#[test]
fn rpr() {
    kind(Some("rpr"));
}

#[test]
fn prp() {
    kind(Some("prp"));
}

#[test]
fn rpp() {
    kind(Some("rpp"));
}

#[test]
fn any_kinds() {
    kind(None);
}
