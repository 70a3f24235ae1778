//! The stroke of the central slider-crank in closed form: y = r sin q + sqrt(l² - r² cos² q), extremes at +-90 degrees.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;

use super::{applied, at, bodies, compiled, fixture, near};
use crate::LoadFault;
use crate::grid::{Bodies, GRID, Span};
use crate::stroke::Stroke;
use assur_kinematics::PositionError;
use assur_mechanism::Place;

const R: f64 = 0.06;
const L: f64 = 0.24;

/// The compressor with the gas force alone.
fn compressor() -> String {
    fixture("slider-crank").replace("gravity = \"9.81 m/s^2\"", "")
}

/// Height of the piston and its PF1.
fn piston(q: f64) -> [f64; 2] {
    let root = (L * L - R * R * q.cos() * q.cos()).sqrt();
    [R * q.sin() + root, R * q.cos() + R * R * q.cos() * q.sin() / root]
}

/// The gas force of the scene by its printed table.
fn gas(place: f64, forward: bool) -> f64 {
    match (forward, place) {
        (true, p) if p < 0.5 => 1400.0 * p,
        (true, p) if p < 0.8 => 700.0 + 2300.0 * (p - 0.5) / 0.3,
        (true, _) => 3000.0,
        (false, p) => (3000.0 * (p - 0.8) / 0.2).max(0.0),
    }
}

fn share(q: f64) -> f64 {
    (piston(q)[0] - (L - R)) / (2.0 * R)
}

proptest! {
    #[test]
    fn gas_force_follows_the_stroke_both_ways(q in -9.0..9.0f64, turns in prop::bool::ANY) {
        let (linkage, loads) = compiled(&compressor());
        let speed = if turns { 90.0 } else { -90.0 };
        let forward = piston(q)[1] * speed > 0.0;
        let wanted = -gas(share(q), forward) * piston(q)[1];
        let found = loads.reduced(&at(q, speed), &bodies(&linkage, q)).moment;
        prop_assert!((found - wanted).abs() < 1e-9, "{} instead of {}", found, wanted);
    }
}

/// Where the place reaches `share` on the way up: l² = r² + y² - 2 r y sin q.
fn upward(share: f64) -> f64 {
    let y = L - R + 2.0 * R * share;
    ((R * R + y * y - L * L) / (2.0 * R * y)).asin()
}

#[test]
fn pieces_end_at_the_rows_of_the_stroke() {
    let (_, loads) = compiled(&compressor());
    let mut phase = loads.phase();
    let mut ends = |q: f64, speed: f64| loads.enter(&at(q, speed), &mut phase).coordinate;
    let check = |found: [f64; 2], wanted: [f64; 2]| {
        near(found[0], wanted[0], 10.0);
        near(found[1], wanted[1], 10.0);
    };
    let (half, most) = (upward(0.5), upward(0.8));
    check(ends(-1.0, 90.0), [-FRAC_PI_2, half]);
    check(ends(half, 90.0), [half, most]);
    check(ends(most, 90.0), [most, FRAC_PI_2]);
    check(ends(FRAC_PI_2, 90.0), [FRAC_PI_2, PI - most]);
    check(ends(PI, 90.0), [PI - most, 1.5 * PI]);
    // Backwards the downstroke of before is the upstroke.
    check(ends(PI + 1.0, -90.0), [PI - half, 1.5 * PI]);
    check(ends(FRAC_PI_2, -90.0), [most, FRAC_PI_2]);
    check(ends(4.0 * PI + half, -90.0), [3.5 * PI, 4.0 * PI + most]);
}

#[test]
fn an_extreme_belongs_to_the_stroke_that_begins() {
    let text = compressor().replace("back = [[0, 0], [0.8, 0], [1, 3000]]", "back = 5");
    let (linkage, loads) = compiled(&text);
    let force = |q: f64, speed: f64| applied(&loads, &at(q, speed), &bodies(&linkage, q))[3].fy;
    for speed in [90.0, -90.0] {
        near(force(FRAC_PI_2, speed), -5.0, 5.0);
        near(force(-FRAC_PI_2, speed), 0.0, 1e-6);
        near(force(10.0 * PI + FRAC_PI_2, speed), -5.0, 5.0);
    }
}

#[test]
fn a_range_of_a_mechanism_that_cannot_turn_is_its_stroke() {
    // The rod is too short for a full turn: from 60 to 120 degrees the piston rises and falls.
    let text = compressor()
        .replace("\"240 mm\"", "\"59 mm\"")
        .replace("\"80 mm\"", "\"30 mm\"")
        .replace("B = [0, 0.23]", "B = [0, 0.11]")
        .replace("positions = 24", "positions = 5\nfrom = \"60 deg\"\nto = \"120 deg\"");
    let (linkage, loads) = compiled(&text);
    let height = |q: f64| bodies(&linkage, q)[3].y;
    let (low, high) = (height(PI / 3.0), height(FRAC_PI_2));
    let q = 1.2;
    let place = (height(q) - low) / (high - low);
    let found = loads.reduced(&at(q, 90.0), &bodies(&linkage, q)).moment;
    near(found, -gas(place, true) * bodies(&linkage, q)[3].y1, 100.0);
}

#[test]
fn a_dead_point_in_the_first_position_is_found() {
    // Rounding gives PF1 either sign at either end of the cycle; among these are all four cases.
    for from in (-15..16).map(|half_turns| 90 + 180 * half_turns) {
        let text = compressor().replace("positions = 24", &format!("positions = 24\nfrom = \"{from} deg\""));
        let (_, loads) = compiled(&text.replace("B = [0, 0.23]", "B = [0, 1]"));
        let mut phase = loads.phase();
        for dead in [0.5 * PI, 1.5 * PI] {
            near(loads.enter(&at(dead - 0.01, 90.0), &mut phase).coordinate[1], dead, 10.0);
            near(loads.enter(&at(dead, 90.0), &mut phase).coordinate[0], dead, 10.0);
        }
    }
}

#[test]
fn two_reversals_close_together_are_found() {
    // x' = (q - c)² - d²: both signs within 1/2880 of the range.
    let (c, d) = (0.5003, 1e-4);
    let mut body = |q: f64| {
        let mut body = assur_group::Body::<f64>::ground();
        let u = q - c;
        (body.x, body.x1, body.x2) = (u * u * u / 3.0 - d * d * u, u * u - d * d, 2.0 * u);
        Ok::<_, PositionError>(body)
    };
    let flat = assur_mechanism::LawTable::constant(1.0);
    let span = Span { from: 0.0, length: 1.0, periodic: false, cells: GRID };
    let stroke = Stroke::find(&mut body, [0.0; 2], 0.0, [&flat, &flat], [&span, &span], 1.0).unwrap();
    let (piece, ends) = stroke.piece(c, 1.0);
    assert!(piece.back);
    near(ends[0], c - d, 1.0);
    near(ends[1], c + d, 1.0);
    assert!(!stroke.piece(c + 2.0 * d, 1.0).0.back && !stroke.piece(c - 2.0 * d, 1.0).0.back);
    assert!(stroke.piece(c + 2.0 * d, -1.0).0.back);
}

#[test]
fn a_point_that_runs_through_infinity_has_no_stroke() {
    // x = 1/(c - q): on both sides of c the point moves in one direction; and x = 1/(q - c)²: it comes back from where it went.
    let c = 0.3037;
    let motions: [fn(f64) -> [f64; 3]; 2] = [
        |u| [-1.0 / u, 1.0 / (u * u), -2.0 / (u * u * u)],
        |u| [1.0 / (u * u), -2.0 / (u * u * u), 6.0 / (u * u * u * u)],
    ];
    let flat = assur_mechanism::LawTable::constant(1.0);
    for motion in motions {
        let mut body = |q: f64| {
            let mut body = assur_group::Body::<f64>::ground();
            [body.x, body.x1, body.x2] = motion(q - c);
            Ok::<_, PositionError>(body)
        };
        let span = Span { from: 0.0, length: 1.0, periodic: false, cells: GRID };
        match Stroke::find(&mut body, [0.0; 2], 0.0, [&flat, &flat], [&span, &span], 1.0) {
            Err(LoadFault::InfiniteStroke(q)) => near(q, c, 1.0),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn few_cells_find_the_reversals_of_many() {
    for (name, link, at, axis) in [
        ("slider-crank", 3, [0.0; 2], FRAC_PI_2),
        ("shaper", 5, [0.0; 2], 0.0),
        ("four-bar", 3, [0.1, 0.05], 1.0),
    ] {
        let (linkage, _) = compiled(&fixture(name));
        let at = Place { link, at };
        let many = Span { from: 0.0123, length: TAU, periodic: true, cells: GRID };
        let few = many.for_stroke(&linkage, at, axis);
        assert!(few.cells < many.cells, "{name}: nothing is proved");
        let flat = assur_mechanism::LawTable::constant(1.0);
        let [one, other] = [few, many].map(|span| {
            let mut bodies = Bodies::new(&linkage, span);
            let mut body = |q| bodies.at(q, link);
            Stroke::find(&mut body, at.at, axis, [&flat, &flat], [&span, &span], linkage.structure.scale)
                .unwrap()
        });
        for q in (0..50).map(|i| f64::from(i) * 0.123) {
            let [(_, a), (_, b)] = [&one, &other].map(|stroke| stroke.piece(q, 1.0));
            near(a[0], b[0], 10.0);
            near(a[1], b[1], 10.0);
        }
    }
}
