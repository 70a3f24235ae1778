//! The suite itself: it passes a class III group that has nothing but places, and refuses every mistake made here.

mod faulty;
mod triad;

use assur_testkit::{Dice, dyad, judge};

/// The check that refuses a dyad.
fn refused(name: &str) -> &'static str {
    let verdict = judge(name, |dice, plugin, singular| dyad(dice, &plugin.pattern, singular));
    verdict.expect_err("a mistake must not pass").check
}

#[test]
fn a_kind_without_mistakes_passes_in_the_same_harness() {
    judge("faulty-none", |dice, plugin, singular| dyad(dice, &plugin.pattern, singular)).unwrap();
}

#[test]
fn each_mistake_is_refused() {
    for (name, check) in [
        ("faulty-place", "recovers"),
        ("faulty-moves", "closure"),
        ("faulty-health", "health"),
        ("faulty-sure", "singular"),
        ("faulty-gap", "gap"),
        ("faulty-nan", "NaN"),
        ("faulty-first", "differences"),
        ("faulty-second", "differences"),
        ("faulty-solve", "solve"),
        ("faulty-reaction", "equilibrium"),
        ("faulty-outer", "equilibrium"),
        ("faulty-rounded", "differences"),
    ] {
        assert_eq!(refused(name), check, "{name}");
    }
}

#[test]
fn a_class_iii_group_needs_only_its_places() {
    judge("triad", |dice, _, singular| Some(triad::sample(dice, singular))).unwrap();
}

#[test]
fn an_unknown_kind_is_refused() {
    let fault = judge("no-such", |dice, plugin, singular| dyad(dice, &plugin.pattern, singular)).unwrap_err();
    assert_eq!(fault.to_string(), "registry (seed 0): not there");
}

#[test]
fn dice_are_fair_enough_and_the_same_everywhere() {
    let mut dice = Dice::new(7);
    let thrown: Vec<f64> = (0..4000).map(|_| dice.unit()).collect();
    assert!(thrown.iter().all(|x| (-1.0..1.0).contains(x)));
    assert!(thrown.iter().sum::<f64>().abs() < 4000.0 * 0.05);
    let mut again = Dice::new(7);
    assert_eq!(thrown[0].to_bits(), again.unit().to_bits());
}
