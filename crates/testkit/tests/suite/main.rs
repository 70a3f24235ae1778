//! The suite itself: it passes groups of higher classes that have nothing but a pattern, and refuses every mistake made here.

mod faulty;
mod higher;

use assur_testkit::{Rng, judge};

/// The check that refuses a kind.
fn refused(name: &str) -> &'static str {
    let verdict = judge(name);
    verdict.expect_err("a mistake must not pass").check
}

#[test]
fn a_kind_without_mistakes_passes_in_the_same_harness() {
    judge("faulty-none").unwrap();
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

macro_rules! conforms {
    ($($test:ident: $name:literal),*) => {$(
        #[test]
        fn $test() {
            judge($name).unwrap();
        }
    )*};
}
conforms!(
    a_triad_needs_only_its_pattern: "triad",
    a_triad_with_slides_needs_only_its_pattern: "triad-with-slides",
    two_ternary_links_need_only_their_pattern: "two-ternaries",
    a_contour_of_four_needs_only_its_pattern: "contour-of-four"
);

#[test]
fn patterns_that_are_no_assur_group_are_refused() {
    for (name, what) in [
        ("two-dyads", "the pattern is no Assur group: links 0 and 1 are a group of their own"),
        ("held-twice", "the pattern is no Assur group: link 0 has more outer pairs than it needs"),
        ("link-out-of-range", "the pattern names link 7; it has 0 to 3"),
        ("pair-missing", "4 links need 6 pairs, the pattern has 5"),
        ("three-links", "a group has 2, 4, 6 ... links, the pattern has 3"),
    ] {
        let fault = judge(name).expect_err("no Assur group");
        assert_eq!((fault.check, fault.to_string().as_str()), ("pattern", what), "{name}");
    }
}

#[test]
fn an_unknown_kind_is_refused() {
    let fault = judge("no-such").unwrap_err().to_string();
    assert!(
        fault.starts_with("no kind `no-such` is registered; registered are contour-of-four, "),
        "{fault}"
    );
    assert!(fault.ends_with("; is `use your_crate as _;` in the test?"), "{fault}");
}

#[test]
fn random_numbers_are_fair_enough_and_the_same_everywhere() {
    let mut rng = Rng::new(7);
    let drawn: Vec<f64> = (0..4000).map(|_| rng.range(-1.0, 1.0)).collect();
    assert!(drawn.iter().all(|x| (-1.0..1.0).contains(x)));
    assert!(drawn.iter().sum::<f64>().abs() < 4000.0 * 0.05);
    // The first output of SplitMix64 for the seed 1234567, from its authors' reference.
    assert_eq!(Rng::new(1_234_567).bits(), 6_457_827_717_110_365_317);
}
