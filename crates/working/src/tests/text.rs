use assur_words::Language;

use super::evaluate::{equations, printed};
use super::fixtures::scene;
use super::{compiled, worked};
use crate::{PositionOrSample, Task, Working, WorkingError};

fn value(text: &str, name: &str) -> f64 {
    let all = equations(text);
    let row = all.iter().find(|parts| parts[0] == name).unwrap_or_else(|| panic!("no {name}"));
    printed(row.last().unwrap()).0
}

#[test]
fn slider_crank_at_45_degrees_by_hand() {
    // r = 0.06, l = 0.24, guide upwards: y_B = r sin q + sqrt(l² - r² cos² q); the slider stays on the y axis.
    let (linkage, loads) = compiled(scene("slider-crank"));
    let text = worked(&linkage, loads.as_ref(), 3).text(Language::english());
    let (r, l) = (0.06, 0.24_f64);
    let c = r * std::f64::consts::FRAC_1_SQRT_2;
    let root = (l * l - c * c).sqrt();
    let near = |name: &str, wanted: f64| {
        let found = value(&text, name);
        assert!((found - wanted).abs() <= 1e-5 * wanted.abs(), "{name}: {found}, by hand {wanted}");
    };
    near("y_B", c + root);
    near("y′_B", c + c * c / root);
    near("φ′_rod", -c / root);
    near("a_y_t_B", value(&text, "y″_B") * (30.0 * std::f64::consts::PI).powi(2));
    assert!((value(&text, "M_bal") - value(&text, "M_bal_power")).abs() < 1e-3);
}

#[test]
fn without_loads_and_motion_there_are_no_forces() {
    let mut mechanism = scene("slider-crank");
    (mechanism.motion, mechanism.gravity) = (None, None);
    mechanism.loads.clear();
    let (linkage, loads) = compiled(mechanism);
    assert!(loads.is_none());
    let working = worked(&linkage, None, 3);
    assert!(working.reactions.is_empty() && working.balancing.is_none());
    assert!(!working.text(Language::english()).contains("Reactions of"));
}

#[test]
fn a_position_that_does_not_exist() {
    let (linkage, loads) = compiled(scene("slider-crank"));
    let (state, place) = (assur_force::LoadState::default(), PositionOrSample::Position(24));
    let error = Working::of(&Task {
        linkage: &linkage,
        loads: loads.as_ref(),
        state,
        place,
        drive: None,
        analyzer: None,
    })
    .unwrap_err();
    assert_eq!(error, WorkingError::Index { index: 24, last: 23 });
    assert_eq!(error.to_string(), "there is no position 24: the scene has positions 0 to 23");
}

/// The conveyor's pin B joins rod, rocker and connecting rod: two pairs, whose shares sum to the reaction on each link.
#[test]
fn a_share_of_a_multiple_joint_is_named_by_both_its_links() {
    let (linkage, loads) = compiled(scene("conveyor"));
    let working = worked(&linkage, loads.as_ref(), 2);
    let text = working.text(Language::english());
    let multiple = |pair: usize| linkage.structure.is_share(pair);
    let shares: Vec<_> = working.reactions.iter().filter(|reaction| multiple(reaction.pair)).collect();
    assert_eq!(shares.len(), 2);
    for reaction in shares {
        let pair = &linkage.structure.pairs[reaction.pair].pair;
        let [a, b, on] =
            [pair.a, pair.b, reaction.on].map(|link| linkage.mechanism.links[link].name.as_str());
        let name =
            format!("R_x_{}_{a}_{b}_{on}", linkage.structure.pair_name(&linkage.mechanism, reaction.pair));
        let wanted = reaction.force[0].value();
        assert!((value(&text, &name) - wanted).abs() <= 1e-5 * wanted.abs(), "{name}");
    }
    assert!(text.contains("is the share of links s and t alone"));
    let (simple, loads) = compiled(scene("slider-crank"));
    assert!(!worked(&simple, loads.as_ref(), 2).text(Language::english()).contains("share"));
}
