//! Loads by formula: values, and the pieces in which they are smooth.

use assur_mechanism::Mechanism;

use super::{applied, at, bodies, compiled, linkage, near};
use crate::{LoadFault, LoadState, Loads, Piece};

/// A slider-crank with a force on its slider; the piston moves between 0.1 and 0.3 m.
fn scene(value: &str, motion: &str) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\nmass = 1\ncenter = 0\ninertia = 0.1\n\
         [link.rod]\npoints = {{ A = 0, B = 0.2 }}\n[link.slider]\npoints = {{ B = 0 }}\n\
         [[slide]]\nlink = 'slider'\non = 'ground'\n[input]\nlink = 'crank'\n{motion}\n\
         [[force]]\nlink = 'slider'\nat = 'B'\nangle = 0\nvalue = {value}\n[assembly]\nB = [0.3, 0]"
    )
}

const TRANSIENT: &str = "[motion]\nkind = 'transient'\nspeed = 1\nuntil = '1 s'";

/// The force at a state.
fn force(text: &str, state: &LoadState) -> f64 {
    let (linkage, loads) = compiled(text);
    applied(&loads, state, &bodies(&linkage, state.coordinate))[3].fx
}

/// The box in which the loads are smooth, just after a state.
fn piece(text: &str, state: &LoadState) -> Piece {
    let (_, loads) = compiled(text);
    loads.enter(state, &mut loads.phase())
}

#[test]
fn a_formula_gives_the_size() {
    let value = "{ formula = '5 + 0.6*sin(2*q) + w*t', unit = 'kN' }";
    let state = LoadState { time: 0.5, ..at(0.4, 3.0) };
    near(force(&scene(value, TRANSIENT), &state), 6500.0 + 600.0 * 0.8_f64.sin(), 1e4);
    // The place along the axis, from one extreme (q = 180 degrees) to the other.
    let place = "{ formula = '100*x', axis = 0 }";
    let x = |q: f64| 0.1 * q.cos() + (0.04 - (0.1 * q.sin()).powi(2)).sqrt();
    for q in [0.0, 0.7, 2.5, 3.0, 5.5] {
        near(force(&scene(place, ""), &at(q, 0.0)), 100.0 * (x(q) - 0.1) / 0.2, 1e3);
    }
}

#[test]
fn a_jump_belongs_to_the_side_of_the_motion() {
    let text = scene("{ formula = '100*sign(sin(q)) + step(q - 1)' }", TRANSIENT);
    let pi = std::f64::consts::PI;
    for (speed, wanted) in [(1.0, -100.0 + 1.0), (-1.0, 100.0 + 1.0)] {
        near(force(&text, &at(pi, speed)), wanted, 100.0);
    }
    near(force(&text, &at(1.0, -2.0)), 100.0, 100.0);
    near(force(&text, &at(1.0, 2.0)), 101.0, 100.0);
    // The instant before the jump, in either direction.
    let before =
        |coordinate: f64, speed: f64| LoadState { side: crate::Side::Before, ..at(coordinate, speed) };
    near(force(&text, &before(1.0, 2.0)), 100.0, 100.0);
    near(force(&text, &before(1.0, -2.0)), 101.0, 100.0);
    near(force(&text, &before(pi, 1.0)), 101.0, 100.0);
}

#[test]
fn pieces_end_at_the_switches() {
    let state = LoadState { time: 0.2, ..at(0.5, 3.0) };
    let found = piece(&scene("{ formula = 'abs(sin(q)) + step(t - 0.75) + max(w, 5)' }", TRANSIENT), &state);
    near(found.coordinate[0], 0.0, 1e-3);
    near(found.coordinate[1], std::f64::consts::PI, 1.0);
    near(found.time[1], 0.75, 1.0);
    assert!(found.speed[0] < -1e5);
    near(found.speed[1], 5.0, 1.0);
    // The place is 1/2 where cos q makes it so; the next turn repeats it.
    let text = scene("{ formula = 'step(x - 0.5)', axis = 0 }", TRANSIENT);
    // r cos q + sqrt(l² - r² sin² q) = l: cos q = r / 2 l.
    let half = 0.25_f64.acos();
    for turn in [0.0, std::f64::consts::TAU] {
        let found = piece(&text, &at(0.5 + turn, 3.0));
        near(found.coordinate[1], half + turn, 10.0);
        near(found.coordinate[0], turn - half, 10.0);
    }
    assert!(
        (force(&text, &at(half - 1e-6, 1.0)) - 1.0).abs() + force(&text, &at(half + 1e-6, 1.0)).abs() < 1e-12
    );
}

#[test]
fn what_several_variables_switch_together_is_not_refused() {
    let refused = |value: &str, motion: &str| {
        let linkage = linkage(&scene(value, motion));
        let _: &Mechanism = &linkage.mechanism;
        Loads::compile(&linkage).err().map(|error| error.fault)
    };
    let mixed = "{ formula = '1 + sign(q - w)' }";
    // A motion that is calculated meets it on its way.
    assert_eq!(refused(mixed, "[motion]\nkind = 'steady'\nmean_speed = 1"), None);
    assert_eq!(refused(mixed, TRANSIENT), None);
    assert_eq!(refused(mixed, "[motion]\nspeed = 1"), None);
    for value in [
        "1 + max(t, x)",
        "abs(x - q/10)",
        "sign(x - q/10)",
        "max(t, x) + sign(t*w - x)",
        "abs(x - sin(q)/10)",
    ] {
        for motion in [TRANSIENT, "[motion]\nspeed = 1"] {
            assert_eq!(refused(&format!("{{ formula = '{value}', axis = 0 }}"), motion), None, "{value}");
        }
    }
}

/// A formula that changes too often is refused when it is read, with its function.
#[test]
fn what_changes_too_often_is_refused() {
    let motions = ["", "[motion]\nspeed = 0.5\nacceleration = 3", TRANSIENT];
    let refused = |formula: &str, motion: &str| {
        let found = Loads::compile(&linkage(&scene(&format!("{{ formula = '{formula}' }}"), motion)));
        found.err().map(|error| error.fault)
    };
    for motion in motions {
        for formula in [
            "1 + sign(sin(1e5*q))",
            "2 + abs(sin(1e6*q))",
            "q + step(sin(1e9*q))",
            "1 + sign(sin(1e30*q))",
            "1 + sign(tan(1e30*q))",
        ] {
            match refused(formula, motion) {
                Some(LoadFault::ChangesTooOften { column, most: 10_000, .. }) => assert_eq!(column, 5),
                other => panic!("{formula}: {other:?}"),
            }
        }
        // The last two are zero but for rounding, everywhere.
        for formula in ["sign(sin(4999*q))", "sign(sin(q)^2 + cos(q)^2 - 1)", "abs(0*q + 0.1 + 0.2 - 0.3)"] {
            assert_eq!(refused(formula, motion), None, "{formula}");
        }
    }
    // Under a known motion time passes with the coordinate; in any other its steps are counted.
    assert!(matches!(refused("sign(sin(1e5*t))", motions[1]), Some(LoadFault::ChangesTooOften { .. })));
    assert_eq!(refused("sign(sin(1e5*t))", TRANSIENT), None);
}

/// A load has the value of its formula on a bend, and on a jump that just ahead, however the motion passes it.
#[test]
fn a_switch_has_the_value_ahead() {
    use std::f64::consts::{FRAC_PI_2, PI, TAU};
    let known =
        |speed: f64, acceleration: f64| format!("[motion]\nspeed = {speed}\nacceleration = {acceleration}");
    let size = |formula: &str, motion: &str, q: f64| {
        let axis = if formula.contains('x') && !formula.contains("max(0") { ", axis = 0" } else { "" };
        let (linkage, loads) = compiled(&scene(&format!("{{ formula = '{formula}'{axis} }}"), motion));
        let state = LoadState::prescribed(&linkage.mechanism, q);
        applied(&loads, &state, &bodies(&linkage, q))[3].fx
    };
    let steady = &known(2.0, 0.0);
    for (formula, q, wanted) in [
        // Bends: the formula itself, with its rounding.
        ("100*abs(sin(q))", PI, 100.0 * 1.224_646_799_147_353_2e-16),
        ("100*max(0, sin(q))", PI, 100.0 * 1.224_646_799_147_353_2e-16),
        ("sqrt(abs(cos(q)))", FRAC_PI_2, 6.123_233_995_736_766e-17_f64.sqrt()),
        ("abs(q - pi)^0.5", PI, 0.0),
        // Jumps: the value ahead.
        ("sign(sin(q))", PI, -1.0),
        ("sign(sin(q))*sign(cos(q/2))", PI, 1.0),
        ("sign(cos(q) - 1)", 0.0, -1.0),
        ("step(sin(q) - 1)", FRAC_PI_2, 0.0),
        ("atan2(sin(q), cos(q))", PI, -PI),
        ("sign(x - 1)", TAU, -1.0),
        ("sign(x)", PI, 1.0),
        // Zero identically.
        ("3 + 5*sign(0) + step(0)", 1.0, 4.0),
        ("sign(max(0, sin(q)))", PI, 0.0),
        ("sign(max(0, sin(q)))", 4.0, 0.0),
        ("sign(q - 2*t) + 7*step(q - 2*t)", 1.3, 7.0),
        ("sign(w - 2)", 1.3, 0.0),
        // Several variables: along the motion q grows twice as fast as t.
        ("sign(q - 1 - (t - 0.5))", 1.0, 1.0),
        ("sign(q - 1 - 3*(t - 0.5))", 1.0, -1.0),
        ("sign((q - 1)*w - 7*(t - 0.5))", 1.0, -1.0),
        ("sign(x - t)", 0.0, 1.0),
        ("max(t, x)", 0.0, 1.0),
    ] {
        let found = size(formula, steady, q);
        assert!(
            (found - wanted).abs() <= 1e-15 * wanted.abs(),
            "{formula} at {q}: {found} instead of {wanted}"
        );
    }
    // Against the coordinate, without a motion too; in an accelerated motion; at rest.
    let back = &known(-2.0, 0.0);
    for (motion, formula, q, wanted) in [
        (back, "sign(sin(q))", -PI, 1.0),
        (back, "sign(q - 2*t)", 0.0, -1.0),
        (&"direction = 'cw'".to_owned(), "sign(sin(q))", -PI, 1.0),
        (&String::new(), "sign(sin(q))", PI, -1.0),
        (&known(2.0, 3.0), "sign(q - 2*t - 1.5*t^2)", 1.3, 0.0),
        (&known(2.0, 3.0), "sign(w - 2)", 1.3, 1.0),
        (&known(2.0, -0.1), "sign(w - 2)", 1.3, -1.0),
        (&known(0.0, 0.0), "sign(w)", 1.3, 0.0),
        (&known(0.0, 3.0), "sign(w)", 1.3, 1.0),
    ] {
        near(size(formula, motion, q), wanted, 1.0);
    }
}

/// The angle of a contact by formula: force and place follow it.
#[test]
fn a_contact_follows_its_angle() {
    let text = assur_fixtures::scene("press-compression");
    let (linkage, loads) = compiled(text);
    for q in [-1.3, -1.6, -1.9_f64] {
        let bodies = bodies(&linkage, q);
        let rod = bodies[linkage.mechanism.link("rod").unwrap()];
        let a = (8.0 * (-70.0_f64.to_radians() - q) / 40.0_f64.to_radians()).to_radians();
        let (s, c) = a.sin_cos();
        let force = [20e3 * (s + 0.1 * c), 20e3 * (c - 0.1 * s)];
        let arm = rod.arm([-0.64, 0.0]);
        let arm = [arm[0] - 0.75 * s, arm[1] - 0.75 * c];
        let found = applied(&loads, &at(q, -1.0), &bodies)[2];
        near(found.fx, force[0], 1e4);
        near(found.fy, force[1], 1e4);
        near(found.m, arm[0] * force[1] - arm[1] * force[0], 1e4);
    }
}

#[test]
fn a_brake_is_against_the_rotation_and_absent_at_rest() {
    let motion = "[motion]\nkind = 'transient'\nspeed = 1\nuntil = '1 s'\n\
                  [[brake]]\nlink = 'rod'\nradius = 0.2\nforce = { formula = '50 + t' }\nfriction = 0.3";
    let text = scene("0", motion);
    let (linkage, loads) = compiled(&text);
    for (q, speed) in [(0.4, 3.0), (0.4, -3.0), (2.6, 3.0), (2.6, -3.0)] {
        let bodies = bodies(&linkage, q);
        let wrench = applied(&loads, &LoadState { time: 10.0, ..at(q, speed) }, &bodies)[2];
        near(wrench.m, -(bodies[2].w1 * speed).signum() * 0.3 * 0.2 * 60.0, 10.0);
    }
    let bodies = bodies(&linkage, 0.4);
    near(
        applied(&loads, &LoadState { side: crate::Side::Prescribed, ..at(0.4, 0.0) }, &bodies)[2].m,
        0.0,
        1.0,
    );
    // The rod rests where the crank is normal to the guide; there the moment changes its sense.
    let found = piece(&text, &at(0.4, 3.0));
    near(found.coordinate[1], std::f64::consts::FRAC_PI_2, 1.0);
    assert!(found.speed[0].abs() <= 0.0, "the piece begins at rest: {:?}", found.speed);
}

#[test]
fn a_brake_resists_a_motion_that_begins_and_none_that_rests() {
    let motion = "[motion]\nkind = 'transient'\nspeed = 1\nuntil = '1 s'\n\
                  [[brake]]\nlink = 'rod'\nradius = 0.2\nforce = 50\nfriction = 0.3";
    let (linkage, loads) = compiled(&scene("0", motion));
    let bodies = bodies(&linkage, 0.4);
    let moment = |acceleration: f64, side: crate::Side| {
        applied(&loads, &LoadState { acceleration, side, ..at(0.4, 0.0) }, &bodies)[2].m
    };
    for acceleration in [2.0, -2.0] {
        let against = -(bodies[2].w1 * acceleration).signum() * 0.3 * 0.2 * 50.0;
        near(moment(acceleration, crate::Side::After), against, 10.0);
        // A motion that ends there came from the other side.
        near(moment(acceleration, crate::Side::Before), -against, 10.0);
    }
    near(moment(0.0, crate::Side::After), 0.0, 1.0);
}
