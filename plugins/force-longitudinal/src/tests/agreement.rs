use assur_force::{ForceAnalyzer, ForceError};
use assur_force_newton_euler::NewtonEuler;
use proptest::prelude::*;
use serde_json::Value;

use super::{compile, difference, fixture, reactions};
use crate::Longitudinal;

const STABLE: Longitudinal = Longitudinal::Stable;
const PUBLISHED: Longitudinal = Longitudinal::Published;

/// A slider-crank or four-bar with loads on every link, all geometry oblique.
fn oblique(third: &str, numbers: [f64; 6]) -> String {
    let [crank, rod, angle, load, turn, offset] = numbers;
    let (ground, third) = if third == "slider" {
        let slide = format!(
            "[[slide]]\nlink = 'third'\non = 'ground'\nthrough = [0, {offset}]\nangle = {angle}\npoint = [0.02, 0.01]\ntilt = 0.3\n"
        );
        (String::new(), format!("points = {{ B = [0.07, -0.02] }}\n{MASS}{slide}"))
    } else {
        (", C = [0.4, -0.05]".to_owned(), format!("points = {{ C = 0, B = 0.33 }}\n{MASS}"))
    };
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0.01, 0.02]{ground} }}\n\
         [link.crank]\npoints = {{ O = [0.01, 0.02], A = [{crank}, 0.03] }}\n{MASS}\
         [link.rod]\npoints = {{ A = [0.01, -0.01], B = {rod} }}\n{MASS}\
         [link.third]\n{third}\
         [input]\nlink = 'crank'\n[motion]\nspeed = 12\nacceleration = -50\n\
         [[force]]\nlink = 'rod'\nat = [0.1, 0.05]\nangle = {turn}\nvalue = {load}\n\
         [[force]]\nlink = 'third'\nat = [0.04, 0.03]\nangle = {load}\nvalue = 250\n\
         [[force]]\nlink = 'crank'\nat = 'A'\nangle = 2\nvalue = 90\n\
         [[moment]]\nlink = 'rod'\nvalue = 7\n[[moment]]\nlink = 'third'\nvalue = -5\n[[moment]]\nlink = 'crank'\nvalue = 3\n"
    )
}

const MASS: &str = "mass = 2\ncenter = [0.05, 0.02]\ninertia = 0.01\n";

fn numbers() -> impl Strategy<Value = [f64; 6]> {
    (0.06..0.12, 0.38..0.5, -3.0..3.0, 100.0..900.0, -3.0..3.0, -0.05..0.05)
        .prop_map(|(crank, rod, angle, load, turn, offset)| [crank, rod, angle, load, turn, offset])
}

proptest! {
    #[test]
    fn both_forms_agree_with_newton_euler(slides in any::<bool>(), numbers in numbers(), q in 0.0..std::f64::consts::TAU) {
        let linkage = compile(&oblique(if slides { "slider" } else { "rocker" }, numbers));
        let whole = reactions(&NewtonEuler, &linkage, q).unwrap();
        let stable = reactions(&STABLE, &linkage, q).unwrap();
        prop_assert!(difference(&linkage, &stable, &whole) < 1e-10);
        let at = setting(&linkage, q);
        let sine = super::super::drawing::Pole::of(&at).weight.abs();
        prop_assume!(sine > 1e-2);
        let published = reactions(&PUBLISHED, &linkage, q).unwrap();
        prop_assert!(difference(&linkage, &published, &whole) < 1e-9);
    }
}

fn setting(linkage: &assur_kinematics::Linkage, q: f64) -> crate::layout::Setting {
    let (position, loads) = super::loaded(linkage, q);
    let layout = crate::layout::Layout::of(linkage).unwrap();
    crate::layout::Setting::of(&layout, &position.bodies, &loads)
}

fn press_full_turn() -> String {
    fixture("press.toml").replace(
        "from = \"-70 deg\"\nto = \"-110 deg\"\npositions = 33\ndirection = \"cw\"",
        "positions = 48",
    )
}

#[test]
fn stable_form_agrees_over_the_full_turn_of_the_press_and_at_its_failing_positions() {
    let linkage = compile(&press_full_turn());
    let half = std::f64::consts::PI;
    let near = [0.0, half, -half, 1e-13, 1e-9, 1e-6, half - 1e-12, half + 1e-7];
    let turn = (0..48).map(|index| linkage.mechanism.input.coordinate(index));
    for q in near.into_iter().chain(turn) {
        let whole = reactions(&NewtonEuler, &linkage, q).unwrap();
        let stable = reactions(&STABLE, &linkage, q).unwrap();
        assert!(difference(&linkage, &stable, &whole) < 1e-10, "{q}");
    }
}

#[test]
fn published_form_fails_exactly_across_the_guide_and_says_so() {
    let linkage = compile(&press_full_turn());
    for (q, shown) in [(0.0, "0.000000000"), (std::f64::consts::PI, "3.141592654")] {
        let error = reactions(&PUBLISHED, &linkage, q).unwrap_err();
        let ForceError::Parallel { angle, .. } = error else { panic!("{error}") };
        assert!(angle < 1e-15);
        assert_eq!(
            error.to_string(),
            format!(
                "coordinate {shown}: the crank `crank` and the normal to the guide of `slider` are parallel (angle between \
                 them {angle:.3e} rad), so the pole is at infinity and this form has no solution there; use `longitudinal`"
            )
        );
    }
}

#[test]
fn published_form_tells_how_much_it_magnifies_rounding() {
    let linkage = compile(&press_full_turn());
    let condition = |form: Longitudinal, q: f64| form.condition(&linkage, &super::loaded(&linkage, q).0);
    assert!((condition(Longitudinal::Stable, 0.001) - 1.0).abs() < f64::EPSILON);
    // The crank makes the angle q with the normal to the guide.
    assert!((condition(Longitudinal::Published, 0.001) * 0.001_f64.sin() - 1.0).abs() < 1e-12);
    for q in [1e-6, 1e-4, 1e-3, 1e-2] {
        let whole = reactions(&NewtonEuler, &linkage, q).unwrap();
        let off = difference(&linkage, &reactions(&PUBLISHED, &linkage, q).unwrap(), &whole);
        assert!(off < 64.0 * f64::EPSILON * condition(Longitudinal::Published, q), "{q} {off}");
    }
}

#[test]
fn published_form_loses_digits_towards_the_failing_position() {
    let linkage = compile(&press_full_turn());
    let at = |q: f64| {
        let whole = reactions(&NewtonEuler, &linkage, q).unwrap();
        difference(&linkage, &reactions(&PUBLISHED, &linkage, q).unwrap(), &whole)
    };
    assert!(at(0.3) < 1e-12);
    // Close by, the numerator of R1 is a difference of equal numbers.
    let worst = (1..20).map(|k| at(1e-9 * f64::from(k))).fold(0.0, f64::max);
    assert!(worst > 1e-10, "{worst}");
}

/// Every reaction of the reference file.
fn reference(name: &str, analyzer: Longitudinal) {
    let linkage = compile(&fixture(&format!("{name}.toml")));
    let file: Value = serde_json::from_str(&fixture(&format!("{name}.json"))).unwrap();
    let mut compared = 0;
    for position in file["positions"].as_array().unwrap() {
        let q = position["coordinate"].as_f64().unwrap();
        let found = match reactions(&analyzer, &linkage, q) {
            Ok(found) => found,
            Err(ForceError::Parallel { .. }) => continue,
            Err(error) => panic!("{error}"),
        };
        let balancing = position["balancing"].as_f64().unwrap();
        assert!((found.balancing - balancing).abs() < 1e-10 * balancing.abs().max(1e3), "{q}");
        for joint in assur_force::joints(&linkage.mechanism, &linkage.structure)
            .iter()
            .map(|joint| joint.reaction(&found.pairs))
        {
            let name = name_of(&linkage, joint.joint);
            for (link, force) in joint.forces {
                let wanted = &position["reactions"][name][linkage.mechanism.links[link].name.as_str()];
                for k in 0..2 {
                    let wanted = wanted[k].as_f64().unwrap();
                    assert!((force[k] - wanted).abs() < 1e-10 * 2e4, "{q} {name}: {} {wanted}", force[k]);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 300, "{compared}");
}

pub(super) fn name_of(linkage: &assur_kinematics::Linkage, id: assur_mechanism::PairId) -> &str {
    match id {
        assur_mechanism::PairId::Pin(point) => &linkage.mechanism.points[point].name,
        assur_mechanism::PairId::Slide(slide) => &linkage.mechanism.slides[slide].name,
    }
}

#[test]
fn reference_files_of_press_and_slider_crank() {
    for analyzer in [STABLE, PUBLISHED] {
        reference("press", analyzer);
        reference("slider-crank", analyzer);
    }
}

#[test]
fn four_bar_with_loaded_coupler_and_rocker() {
    let linkage = compile(&fixture("four-bar.toml"));
    for index in 0..linkage.mechanism.input.positions {
        let q = linkage.mechanism.input.coordinate(index);
        let whole = reactions(&NewtonEuler, &linkage, q).unwrap();
        for analyzer in [STABLE, PUBLISHED] {
            let found = reactions(&analyzer, &linkage, q).unwrap();
            assert!(difference(&linkage, &found, &whole) < 1e-10, "{index} {analyzer:?}");
        }
    }
}
