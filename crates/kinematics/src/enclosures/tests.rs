use assur_all as _;
use assur_fixtures::SCENES;
use assur_mechanism::Mechanism;
use assur_number::Lanes;
use assur_structure::Structure;
use assur_testkit::specimen::Recipe;

use crate::first::first_ways;
use crate::follow::by_samples;
use crate::wide::Extended;
use crate::{Chain, enclosures::turns_regularly};

/// Whether a turn is proved to be regular; then the samples must have no event.
fn proved(mechanism: &Mechanism) -> bool {
    let structure = Structure::of(mechanism).unwrap();
    let chain = Chain::<f64>::compile(mechanism, &structure).unwrap();
    let lane_chain = Chain::<Lanes>::compile(mechanism, &structure).unwrap();
    let extended = Extended::new(mechanism, &structure);
    let Ok(start) = first_ways(mechanism, &structure, (&chain, &extended), mechanism.input.from) else {
        return false;
    };
    let first = start.0.clone();
    if !turns_regularly(mechanism, &structure, &chain.needed, &first) {
        return false;
    }
    let found = by_samples(mechanism, &structure, (&chain, &lane_chain), (&extended, start));
    assert!(found.range.is_some_and(|range| range.full) && found.ways.are_constant());
    assert!(found.guesses.is_none() && found.first_failure.is_none());
    assert_eq!(found.ways.at(1.0), first);
    assert_eq!(found.ways.period, Some(std::f64::consts::TAU));
    true
}

#[test]
fn the_scenes_with_a_regular_turn_are_known() {
    let is_proved = |(name, text): &(&'static str, &str)| {
        proved(&assur_scene::read(name, text).unwrap()).then_some(*name)
    };
    let found: Vec<_> = SCENES.iter().filter_map(is_proved).collect();
    for name in ["slider-crank", "shaper", "four-bar"] {
        assert!(found.contains(&name), "{name} is not among {found:?}");
    }
}

#[test]
fn random_mechanisms_that_are_proved_have_no_event_among_their_samples() {
    let mut count = 0;
    for seed in 0..400 {
        let recipe = Recipe { loads: false, ..Recipe::of(1 + usize::try_from(seed).unwrap() % 4) };
        count += usize::from(proved(&recipe.specimen(seed).expect("a specimen").mechanism));
    }
    assert!(count > 20, "{count}");
}
