//! Every kind of load on one turning link, by hand: the arm OA = 0.5 m turns about O; G = (1, 0).

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_6, PI};

use assur_group::Wrench;

use super::{applied, at, bodies, compiled, near};
use crate::{Cause, LoadState, Side};

fn arm(load: &str) -> String {
    format!(
        r#"
[ground]
points = {{ O = 0, G = [1, 0] }}
[link.arm]
points = {{ O = 0, A = 0.5 }}
mass = 2
center = 0.25
inertia = 0.1
[input]
link = "arm"
[motion]
speed = 3
{load}
"#
    )
}

fn moment(load: &str, state: LoadState) -> f64 {
    let (linkage, loads) = compiled(&arm(load));
    loads.reduced(&state, &bodies(&linkage, state.coordinate)).moment
}

#[test]
fn inertia_of_a_turning_link() {
    let (linkage, loads) = compiled(&arm(""));
    let found = loads.reduced(&at(0.7, 3.0), &bodies(&linkage, 0.7));
    near(found.inertia, 0.1 + 2.0 * 0.0625, 1.0);
    near(found.inertia_derivative, 0.0, 1.0);
}

#[test]
fn inertia_loads_are_against_the_acceleration() {
    let (linkage, loads) = compiled(&arm(""));
    let mut wrenches = vec![Wrench::ZERO; 2];
    let state =
        LoadState { coordinate: FRAC_PI_2, speed: 3.0, acceleration: 4.0, time: 0.0, ..LoadState::default() };
    loads.evaluate(&state, &bodies(&linkage, FRAC_PI_2), &mut wrenches);
    // Upright: a = (-0.25 * 4, -0.25 * 9); about O: -J e.
    near(wrenches[1].fx, 2.0, 1.0);
    near(wrenches[1].fy, 4.5, 1.0);
    near(wrenches[1].m, -0.225 * 4.0, 1.0);
}

#[test]
fn weight() {
    let (linkage, loads) = compiled(&format!("gravity = 10\n{}", arm("")));
    let bodies = bodies(&linkage, FRAC_PI_3);
    near(loads.reduced(&at(FRAC_PI_3, 0.0), &bodies).moment, -2.0 * 10.0 * 0.25 * 0.5, 1.0);
    near(loads.potential_energy(&bodies), 2.0 * 10.0 * 0.25 * FRAC_PI_3.sin(), 1.0);
}

#[test]
fn forces_by_their_directions() {
    let force = |direction: &str| format!("[[force]]\nlink = \"arm\"\nat = \"A\"\nvalue = 8\n{direction}\n");
    near(moment(&force("angle = 0"), at(FRAC_PI_6, 3.0)), -8.0 * 0.5 * 0.5, 1.0);
    near(moment(&force("angle = \"90 deg\"\nframe = \"link\""), at(0.3, 3.0)), 4.0, 1.0);
    let against = force("against_motion = true");
    near(moment(&against, at(0.3, 3.0)), -4.0, 1.0);
    near(moment(&against, at(0.3, -3.0)), 4.0, 1.0);
    near(moment(&against, at(0.3, 0.0)), 0.0, 1.0);
}

#[test]
fn the_size_of_a_force() {
    let size = |direction: &str, speed: f64| {
        let text = format!("[[force]]\nlink = \"arm\"\nat = \"A\"\nvalue = 8\n{direction}\n");
        let (linkage, loads) = compiled(&arm(&text));
        let mut found = Vec::new();
        loads.sizes(&at(0.3, speed), &bodies(&linkage, 0.3), |cause, size: f64| found.push((cause, size)));
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].0, Cause::Load(0));
        found[0].1
    };
    near(size("angle = 0", 3.0), 8.0, 1.0);
    for (speed, wanted) in [(3.0, 8.0), (-3.0, 8.0), (0.0, 0.0)] {
        near(size("against_motion = true", speed), wanted, 1.0);
    }
}

#[test]
fn the_speed_beside_another_is_the_next_that_rounding_tells_apart() {
    for speed in [100.0, 1e-300, 0.0, -3.0] {
        let [below, above] = [-1.0, 1.0].map(|side| crate::beside(speed, side));
        assert!(below < speed && speed < above, "{speed}");
        assert!(above - below <= 8.0 * f64::EPSILON * f64::abs(speed) + 4.0 * f64::MIN_POSITIVE, "{speed}");
    }
}

#[test]
fn a_point_that_stands_has_no_motion_to_be_against() {
    let text = "[[force]]\nlink = \"arm\"\nat = \"O\"\nvalue = 8\nagainst_motion = true\n";
    let (linkage, loads) = compiled(&arm(text));
    for q in [0.1, 1.0, 2.5] {
        let wrenches = applied(&loads, &at(q, 3.0), &bodies(&linkage, q));
        assert_eq!(wrenches[1], Wrench::ZERO);
    }
}

#[test]
fn a_moment() {
    near(moment("[[moment]]\nlink = \"arm\"\nvalue = 7\n", at(1.0, 0.0)), 7.0, 1.0);
}

#[test]
fn a_moment_against_the_motion_turns_with_its_sense() {
    let text = "[[moment]]\nlink = \"arm\"\nvalue = 7\nagainst_motion = true\n";
    for (speed, wanted) in [(3.0, -7.0), (-3.0, 7.0), (0.0, 0.0)] {
        near(moment(text, at(1.0, speed)), wanted, 1.0);
    }
    // A brake of this moment is the same load.
    let brake = "[[brake]]\nlink = \"arm\"\nforce = 35\nradius = 0.5\nfriction = 0.2\nlever = 2\n";
    near(moment(brake, at(1.0, -3.0)), 7.0, 1.0);
}

#[test]
fn spring_and_damper() {
    // Upright: A = (0, 0.5), d = G - A = (1, -0.5), PF1 of A = (-0.5, 0), dL/dq = 0.5 / L.
    let length = 1.25_f64.sqrt();
    let text = "[[spring]]\nbetween = [\"A\", \"G\"]\nstiffness = 100\nlength = 0.2\n";
    near(moment(text, at(FRAC_PI_2, 3.0)), -100.0 * (length - 0.2) * 0.5 / length, 100.0);
    let damper = "[[spring]]\nbetween = [\"G\", \"A\"]\ndamping = 30\n";
    near(moment(damper, at(FRAC_PI_2, 3.0)), -30.0 * 3.0 * 0.25 / 1.25, 100.0);
    let (linkage, loads) = compiled(&arm(text));
    let energy = loads.potential_energy(&bodies(&linkage, FRAC_PI_2));
    near(energy, 50.0 * (length - 0.2) * (length - 0.2), 100.0);
}

#[test]
fn a_spring_pulls_both_ends() {
    let (linkage, loads) = compiled(&arm("[[spring]]\nbetween = [\"A\", \"G\"]\nstiffness = 100\n"));
    let wrenches = applied(&loads, &at(FRAC_PI_2, 3.0), &bodies(&linkage, FRAC_PI_2));
    // k d with a free length of 0; about the origins of arm and ground.
    for (found, wanted) in wrenches.iter().zip([[-100.0, 50.0, 50.0], [100.0, -50.0, -50.0]]) {
        near(found.fx, wanted[0], 100.0);
        near(found.fy, wanted[1], 100.0);
        near(found.m, wanted[2], 100.0);
    }
}

#[test]
fn contact_of_an_arc() {
    let text = "[[contact]]\nlink = \"arm\"\ncenter = \"A\"\nradius = 0.1\nangle = \"30 deg\"\nforce = 10\nfriction = 0.2\n";
    let root = 0.75_f64.sqrt();
    let k = [-0.1 * 0.5, 0.5 - 0.1 * root];
    let f = [10.0 * (0.5 + 0.2 * root), 10.0 * (root - 0.2 * 0.5)];
    let wanted = k[0] * f[1] - k[1] * f[0];
    near(moment(text, at(FRAC_PI_2, 3.0)), wanted, 10.0);
    let during = format!("{text}during = [\"60 deg\", \"90 deg\"]\n");
    for (q, touches) in [(FRAC_PI_2, 1.0), (FRAC_PI_2 + 0.01, 0.0), (FRAC_PI_2 - 2.0 * PI, 1.0), (0.0, 0.0)] {
        near(moment(&during, at(q, 3.0)), touches * wanted, 10.0);
    }
}

#[test]
fn tables_over_the_angle_repeat_and_jump() {
    let table = |more: &str| {
        format!(
            "[[moment]]\nlink = \"arm\"\nvalue = {{ over = \"angle\", table = [[0, 0], [\"180 deg\", 40], [\"180 deg\", 10]]{more} }}\n"
        )
    };
    let of = |more: &str, degrees: f64| moment(&table(more), at(degrees.to_radians(), 3.0));
    for (degrees, wanted) in
        [(0.0, 0.0), (90.0, 20.0), (180.0, 10.0), (270.0, 10.0), (360.0, 0.0), (450.0, 20.0)]
    {
        near(of("", degrees), wanted, 40.0);
        near(of("", degrees - 1080.0), wanted, 40.0);
    }
    near(of(", repeat = false", 450.0), 10.0, 40.0);
    near(of(", repeat = false", -90.0), 0.0, 40.0);
    near(of(", shape = \"step\"", 90.0), 0.0, 40.0);
}

#[test]
fn tables_over_speed_and_time() {
    let table = |over: &str| {
        format!("[[moment]]\nlink = \"arm\"\nvalue = {{ over = \"{over}\", table = [[0, 60], [150, 0]] }}\n")
    };
    near(moment(&table("speed"), at(0.0, 50.0)), 40.0, 60.0);
    near(moment(&table("speed"), at(0.0, -50.0)), 60.0, 60.0);
    near(moment(&table("time"), LoadState { time: 100.0, ..at(0.0, 1.0) }), 20.0, 60.0);
    let (linkage, _) = compiled(&arm(""));
    near(LoadState::prescribed(&linkage.mechanism, 6.0).time, 2.0, 1.0);
}

#[test]
fn time_follows_from_speed_and_acceleration() {
    let (linkage, _) = compiled(&arm("").replace("speed = 3", "speed = 3\nacceleration = -0.5"));
    let time = |q: f64| LoadState::prescribed(&linkage.mechanism, q).time;
    // 3 t - t²/4 = 5 at t = 2; the motion turns back at 9 rad after 6 s.
    near(time(5.0), 2.0, 1.0);
    near(time(9.0), 6.0, 1.0);
    near(time(11.0), 6.0, 1.0);
    near(time(-3.25), -1.0, 1.0);
}

#[test]
fn causes_add_up_to_all_loads() {
    let (linkage, loads) = compiled(&super::fixture("stephenson3"));
    let state =
        LoadState { coordinate: 1.0, speed: 15.0, acceleration: 40.0, time: 0.0, ..LoadState::default() };
    let bodies = bodies(&linkage, 1.0);
    let mut all = vec![Wrench::ZERO; bodies.len()];
    loads.evaluate(&state, &bodies, &mut all);
    let mut names = Vec::new();
    loads.by_cause(&state, &bodies, &mut |cause, link, wrench| {
        all[link].add_at([0.0; 2], [-wrench.fx, -wrench.fy], -wrench.m);
        names.push(cause.name(&linkage.mechanism));
    });
    assert!(all.iter().all(|w| w.fx.abs() + w.fy.abs() + w.m.abs() < 1e-9), "{all:?}");
    assert!(names.iter().any(|name| name == "inertia of block"), "{names:?}");
    assert!(Cause::Weight(1) < Cause::Inertia(1));
}

/// The arc of the arm: K goes along the line by N' (cos a, -sin a) + R, to the left where the arm is high enough.
const AGAINST: &str = "[[contact]]\nlink = \"arm\"\ncenter = \"A\"\nradius = 0.1\nangle = \"30 deg\"\nforce = 10\nfriction = { against_sliding = 0.2 }\n";

#[test]
fn friction_against_the_sliding_changes_its_sign_with_it() {
    let given = |sign: f64| AGAINST.replace("{ against_sliding = 0.2 }", &(0.2 * sign).to_string());
    // s = -0.5 sin(q) cos(30) - 0.5 cos(q) sin(30) + 0.1 = 0.1 - 0.5 sin(q + 30).
    let turn = 0.2_f64.asin() - FRAC_PI_6;
    for q in [
        -3.0,
        -1.0,
        turn - 1e-9,
        turn + 1e-9,
        0.5,
        1.5,
        PI - FRAC_PI_6 - 0.2_f64.asin() + 1e-9,
        6.0,
        40.0_f64,
    ] {
        let slides = (0.1 - 0.5 * (q + FRAC_PI_6).sin()).signum();
        for speed in [3.0, -3.0] {
            near(moment(AGAINST, at(q, speed)), moment(&given(-slides * speed.signum()), at(q, speed)), 10.0);
        }
        // Without a speed it is as if the input moved along its direction.
        let rest = LoadState { side: Side::Prescribed, ..at(q, 0.0) };
        near(moment(AGAINST, rest), moment(&given(-slides), rest), 10.0);
    }
    // Where the arc rolls, the sign is the one just after the position in the direction of motion.
    near(moment(AGAINST, at(turn, 3.0)), moment(&given(1.0), at(turn, 3.0)), 10.0);
    near(moment(AGAINST, at(turn, -3.0)), moment(&given(1.0), at(turn, -3.0)), 10.0);
}

/// The pin of the arm as an arc of no radius.
#[test]
fn an_arc_that_never_slides_has_no_friction() {
    let (linkage, loads) =
        compiled(&arm(&AGAINST.replace("\"A\"", "\"O\"").replace("0.1\nangle", "0\nangle")));
    let found = applied(&loads, &at(1.0, 3.0), &bodies(&linkage, 1.0))[1];
    near(found.fx, 10.0 * FRAC_PI_6.sin(), 10.0);
    near(found.fy, 10.0 * FRAC_PI_6.cos(), 10.0);
}

/// The sliding turns, and turns again within much less than a cell of the search.
#[test]
fn two_turns_within_a_cell_are_found() {
    for depth in [1e-3, 1e-5, 1e-7_f64] {
        // s = R - 0.5 sin(q + a), R a little less than 0.5: it turns twice close to q + a = 90 degrees.
        let radius = 0.5 - depth;
        let text = AGAINST.replace("radius = 0.1", &format!("radius = {radius:?}"));
        let given = |sign: f64| text.replace("{ against_sliding = 0.2 }", &(0.2 * sign).to_string());
        let half = (radius / 0.5).acos();
        for (part, slides) in [(-1.01, 1.0), (-0.99, -1.0), (0.0, -1.0), (0.99, -1.0), (1.01, 1.0)] {
            let q = FRAC_PI_3 + part * half;
            near(moment(&text, at(q, 3.0)), moment(&given(-slides), at(q, 3.0)), 10.0);
        }
    }
}

/// In a range of the coordinate the sense is that of the range: at q = 0, far outside of it, this arc slides the other way.
#[test]
fn the_sense_of_sliding_in_a_range_is_found_in_the_range() {
    let press = assur_fixtures::SCENES.iter().find(|(name, _)| *name == "press-compression").unwrap().1;
    let text = press.replace("formula = \"8*", "formula = \"-8*");
    let reduced = |text: &str, degrees: f64| {
        let ((linkage, loads), q) = (compiled(text), f64::to_radians(degrees));
        loads.reduced(&at(q, -1.0), &bodies(&linkage, q)).moment
    };
    // By hand: K goes along (cos a, -sin a) by N' (cos a, -sin a) + R phi' > 0 over the whole range (0.0092 to 0.0121 m/rad), and
    // the coordinate falls, so that the friction against the sliding acts along +(cos a, -sin a): the sign of a given 0.1.
    let given = text.replace("{ against_sliding = 0.1 }", "0.1");
    for degrees in [-70.0, -80.0, -90.0, -100.0, -110.0] {
        near(reduced(&text, degrees), reduced(&given, degrees), 100.0);
    }
}

/// Positions beyond a gap, as many of which are reached by a whole turn from those before it.
#[test]
fn friction_is_against_the_sliding_beyond_a_gap() {
    let text = include_str!("../../../../tests/corpus/friction-after-gap-nan.toml");
    let (linkage, loads) = compiled(text);
    let bearings = &loads.frictions().unwrap().bearings;
    let mut seen = 0;
    for degrees in 0..360 {
        let q = f64::to_radians(f64::from(degrees) + 0.5);
        let mut position = linkage.position();
        if linkage.solve(q, assur_group::Order::Second, &mut position).is_err() {
            continue;
        }
        let mut senses = vec![0.0; bearings.len()];
        loads.senses(&at(q, 20.0), &position.bodies, &mut senses);
        for (bearing, sense) in bearings.iter().zip(senses) {
            assert!(sense * bearing.relative(&position.bodies) > 0.0, "{degrees} deg: {sense}");
            seen += 1;
        }
    }
    assert!(seen > 250, "{seen}");
}
