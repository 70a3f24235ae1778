use assur_force::{Reactions, joints};
use serde_json::Value;

use super::press::{Answer, Press};
use super::{compile, fixture, reactions};
use crate::Longitudinal;

pub(super) const PRESS: Press =
    Press { crank: 0.04, rod: 0.16, center: 0.64, radius: 0.75, force: 20e3, friction: 0.1 };

/// Twice the angle at which the contact acts, at f1 in degrees: of the scenes of the press.
pub(super) type Alpha = fn(f64) -> f64;
pub(super) const CONSTANT: Alpha = |_| 8.0_f64.to_radians();
const COMPRESSION: Alpha = |degrees| (2.0 * (20.0 - degrees) / 5.0).to_radians();

fn at(alpha: Alpha, degrees: f64) -> Answer {
    PRESS.at(degrees.to_radians(), alpha(degrees))
}

/// The working way of fig. 2, from 20 to -20 degrees, in 33 positions.
fn way() -> impl Iterator<Item = f64> {
    (0..33).map(|index| 20.0 - 40.0 * f64::from(index) / 32.0)
}

#[test]
fn equations_as_printed_give_the_reference_of_the_press() {
    let file: Value = serde_json::from_str(&fixture("press.json")).unwrap();
    for position in file["positions"].as_array().unwrap() {
        let q = position["coordinate"].as_f64().unwrap();
        let answer = at(CONSTANT, q.to_degrees() + 90.0);
        let force = |pin: &str| [0, 1].map(|k| position["reactions"][pin]["rod"][k].as_f64().unwrap());
        let (a, b) = (force("A"), force("B"));
        assert!((answer.ra - a[0].hypot(a[1])).abs() < 1e-7, "{q}");
        assert!((answer.r3 + b[0]).abs() < 1e-7, "{q}");
        assert!((answer.balancing + position["balancing"].as_f64().unwrap()).abs() < 1e-8, "{q}");
    }
}

#[test]
fn both_forms_give_what_the_print_gives_for_each_scene() {
    let scenes =
        [("press.toml", CONSTANT), ("press-f1.toml", CONSTANT), ("press-compression.toml", COMPRESSION)];
    for (name, alpha) in scenes {
        let linkage = compile(&fixture(name));
        let all = joints(&linkage.mechanism, &linkage.structure);
        let of = |found: &Reactions, pin: &str| {
            let named = |joint: &&assur_force::Joint| super::agreement::name_of(&linkage, joint.id) == pin;
            let forces = all.iter().find(named).map(|joint| joint.reaction(&found.pairs).forces);
            let rod = linkage.mechanism.link("rod");
            forces
                .into_iter()
                .flatten()
                .find(|(link, _)| Some(*link) == rod)
                .map_or([f64::NAN; 2], |(_, force)| force)
        };
        for (index, degrees) in way().enumerate() {
            let wanted = at(alpha, degrees);
            let q = linkage.mechanism.input.coordinate(index);
            for form in [Longitudinal::Stable, Longitudinal::Published] {
                let found = reactions(&form, &linkage, q).unwrap();
                let (a, b) = (of(&found, "A"), of(&found, "B"));
                assert!((a[0].hypot(a[1]) - wanted.ra).abs() < 1e-10 * 2e4, "{name} {degrees}");
                assert!((b[0] + wanted.r3).abs() < 1e-10 * 2e4, "{name} {degrees}: {b:?} {}", wanted.r3);
                assert!((found.balancing + wanted.balancing).abs() < 1e-10 * 1e3, "{name} {degrees}");
            }
        }
    }
}

/// What fig. 2 shows and the text of L says of it, with a contact that stays in its place.
#[test]
fn with_a_constant_angle_the_reactions_go_as_in_figure_2() {
    let all: Vec<Answer> = way().map(|degrees| at(CONSTANT, degrees)).collect();
    assert!(all.windows(2).all(|pair| pair[0].r1 < pair[1].r1 && pair[0].ra < pair[1].ra), "R1 and RA grow");
    assert!(all[16..].windows(2).all(|pair| pair[0].balancing_force > pair[1].balancing_force), "Fb falls");
    assert!((all[16].balancing_force - 7576.0).abs() < 0.5 && (all[32].balancing_force - 6702.0).abs() < 0.5);
    // RB changes its side where F, at the angle of friction beyond a, passes through A.
    let friction_angle = PRESS.friction.atan();
    let lean =
        4.0_f64.to_radians() + friction_angle - (PRESS.radius * friction_angle.sin() / PRESS.center).asin();
    let f1 = (PRESS.rod * lean.sin() / PRESS.crank).asin().to_degrees();
    assert!((f1 - 12.14).abs() < 5e-3 && at(CONSTANT, f1).r3.abs() < 1e-9 * PRESS.force, "{f1}");
    assert!(all.iter().zip(way()).all(|(answer, degrees)| (answer.r3 > 0.0) == (degrees > f1)), "one change");
}

/// The same with a contact whose angle grows with the compression: Fb grows to the end, RA from 10.5 degrees on.
#[test]
fn with_a_growing_angle_the_balancing_force_grows_to_the_end() {
    let all: Vec<Answer> = way().map(|degrees| at(COMPRESSION, degrees)).collect();
    assert!(all.windows(2).all(|pair| pair[0].balancing_force < pair[1].balancing_force), "Fb grows");
    assert!((all[0].balancing_force - 944.0).abs() < 0.5 && (all[32].balancing_force - 13_162.0).abs() < 0.5);
    let side = |degrees: f64| at(COMPRESSION, degrees).r3 > 0.0;
    assert!(
        way().all(|degrees| side(degrees) == (degrees > 6.71)) && side(6.715) && !side(6.705),
        "one change"
    );
    let ra = |degrees: f64| at(COMPRESSION, degrees).ra;
    let grid = (0..4000).map(|step| 20.0 - 0.01 * f64::from(step));
    let least = grid.min_by(|a, b| ra(*a).total_cmp(&ra(*b))).unwrap();
    assert!((least - 10.5).abs() < 0.05, "{least}");
    assert!(way().filter(|degrees| *degrees < least).is_sorted_by(|a, b| ra(*a) < ra(*b)));
}

#[test]
fn across_the_guide_the_print_has_no_answer() {
    // cos(pi/2) is not zero in binary, but nothing is left of the digits.
    let of = |f1: f64| PRESS.at(f1, CONSTANT(0.0));
    let (answer, near) = (of(std::f64::consts::FRAC_PI_2), of(std::f64::consts::FRAC_PI_2 - 1e-3));
    assert!(!answer.r1.is_finite() || (answer.r1 - near.r1).abs() > 1e2, "{} {}", answer.r1, near.r1);
}
