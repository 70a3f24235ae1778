//! Motions with dry friction in pairs, against closed forms and integrations of their own.

use approx::assert_relative_eq;
use assur_integrator::EventKind;
use assur_words::Describe;

use super::compiled;
use crate::{Method, Transient, transient};

mod crank;
mod pendulum;

const G: f64 = 9.81;

pub(super) fn moved(scene: &str) -> Transient {
    let (linkage, loads) = compiled(scene);
    transient(&linkage, &loads, &Method::default(), None).unwrap()
}

/// The error of a motion that can't go on.
fn stopped(scene: &str) -> String {
    let (linkage, loads) = compiled(scene);
    transient(&linkage, &loads, &Method::default(), None).unwrap_err().describe().to_string()
}

/// A block of 2 kg on a guide.
fn block(angle: f64, [speed, coefficient]: [f64; 2], until: &str, more: &str) -> String {
    format!(
        "gravity = \"9.81 m/s^2\"\n[ground]\npoints = {{ O = [0, 0] }}\n\
         [link.block]\npoints = {{ P = 0 }}\nmass = \"2 kg\"\n\
         [[slide]]\nlink = \"block\"\non = \"ground\"\nthrough = \"O\"\nangle = {angle}\nname = \"guide\"\n\
         [input]\nlink = \"block\"\nto = 1\npositions = 2\n\
         [motion]\nkind = \"transient\"\nspeed = {speed}\nuntil = \"{until}\"\nsamples = 20\n\
         [[friction]]\npair = \"guide\"\ncoefficient = {coefficient}\n{more}"
    )
}

#[test]
fn a_block_runs_down_and_stays() {
    for (speed, force) in [(3.0, 0.0), (-3.0, 0.0), (3.0, 4.0), (-3.0, 4.0)] {
        let load = format!("[[force]]\nlink = \"block\"\nat = \"P\"\nangle = 0\nvalue = {force}\n");
        let found = moved(&block(0.0, [speed, 0.3], "rest", &load));
        let delay = 0.3 * G - force / 2.0 * speed.signum();
        let end = found.trajectory.end;
        assert_relative_eq!(end.time, speed.abs() / delay, max_relative = 1e-12);
        assert_relative_eq!(end.coordinate, 0.5 * speed * speed.abs() / delay, max_relative = 1e-12);
        assert!(end.speed == 0.0, "{}", end.speed);
        // The force is held by friction that could be greater.
        let holding = found.instants.last().unwrap().holding.unwrap();
        assert_relative_eq!(holding.moment, -force, epsilon = 1e-12);
        assert_relative_eq!(holding.bound, 0.3 * 2.0 * G, max_relative = 1e-12);
    }
}

#[test]
fn on_an_incline_friction_holds_below_the_angle_of_friction() {
    let angle: f64 = 0.5;
    let (s, c) = angle.sin_cos();
    for (coefficient, slides) in [(angle.tan() + 1e-9, false), (angle.tan() - 1e-9, true)] {
        let found = moved(&block(angle, [1.5, coefficient], "3 s", ""));
        let kinds: Vec<EventKind> = found.trajectory.events.iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [if slides { EventKind::Reversal } else { EventKind::Rest }]);
        let top = found.trajectory.events[0].state;
        let delay = G * (s + coefficient * c);
        assert_relative_eq!(top.time, 1.5 / delay, max_relative = 1e-12);
        let left = 3.0 - top.time;
        let back = if slides { G * (s - coefficient * c) * left } else { 0.0 };
        assert_relative_eq!(found.trajectory.end.speed, -back, max_relative = 1e-6, epsilon = 1e-15);
    }
    // From rest in the direction of the acceleration that is possible.
    let found = moved(&block(angle, [0.0, 0.3], "2 s", ""));
    assert_relative_eq!(found.trajectory.end.speed, -2.0 * G * (s - 0.3 * c), max_relative = 1e-12);
    assert!(found.instants[0].state.acceleration < 0.0);
}

#[test]
fn a_force_that_grows_releases_a_block_and_a_pulse_moves_it_back() {
    let load = "[[force]]\nlink = \"block\"\nat = \"P\"\nangle = 0\nvalue = { over = \"time\", table = [[0, 0], [2, 10]] }\n";
    let found = moved(&block(0.0, [0.0, 0.3], "1.5 s", load));
    let events: Vec<_> = found.trajectory.events.iter().map(|event| event.kind).collect();
    assert_eq!(events, [EventKind::Rest, EventKind::Release]);
    // 5 t = f m g.
    let release = 0.3 * 2.0 * G / 5.0;
    assert_relative_eq!(found.trajectory.events[1].state.time, release, max_relative = 1e-9);
    let after = 1.5 - release;
    assert_relative_eq!(found.trajectory.end.speed, 0.5 * 2.5 * after * after, max_relative = 1e-8);
}

/// A spring of stiffness k and friction F: from turn to turn the amplitude falls by 2 F/k.
#[test]
fn the_amplitude_on_a_spring_falls_by_the_same_at_each_turn() {
    let scene =
        block(0.0, [0.0, 0.1], "rest", "[[spring]]\nbetween = [\"S\", \"P\"]\nstiffness = 100\nlength = 1\n")
            .replace("O = [0, 0]", "O = [0, 0], S = [-1, 0]")
            .replace("[input]\n", "[input]\nfrom = 0.455\n");
    let found = moved(&scene);
    let falls = 2.0 * 0.1 * 2.0 * G / 100.0;
    let turns: Vec<_> = found.trajectory.events.iter().map(|event| event.state).collect();
    // It stays where the spring is weaker than friction: 0.455 - 12 falls = -0.0159, in size below half a fall.
    assert_eq!(turns.len(), 12);
    let half = std::f64::consts::PI * (2.0_f64 / 100.0).sqrt();
    for (number, turn) in (1_u8..).zip(&turns) {
        let number = f64::from(number);
        let sign = if number % 2.0 == 0.0 { 1.0 } else { -1.0 };
        assert_relative_eq!(turn.coordinate, sign * (0.455 - number * falls), epsilon = 3e-9);
        assert_relative_eq!(turn.time, number * half, max_relative = 1e-7);
    }
    assert_eq!(found.trajectory.events.last().unwrap().kind, EventKind::Rest);
}

/// A drawer without weight whose center of mass lies h beside the guide: the inertia load presses both ends with m e h / l, and
/// m e = P - k m |e| with k = 2 f h / l.
fn drawer([speed, force, coefficient]: [f64; 3], until: &str) -> String {
    let more = format!("length = 0.1\n[[force]]\nlink = \"block\"\nat = \"P\"\nangle = 0\nvalue = {force}\n");
    block(0.0, [speed, coefficient], until, &more)
        .replace("gravity = \"9.81 m/s^2\"\n", "")
        .replace("mass = \"2 kg\"", "mass = \"2 kg\"\ncenter = [0, 0.1]\ninertia = 0.05")
}

#[test]
fn the_friction_of_a_drawer_by_its_own_inertia() {
    let k = 0.8;
    let braked = moved(&drawer([1.0, -6.0, 0.4], "turn"));
    assert_relative_eq!(braked.trajectory.end.time, (1.0 - k) / 3.0, max_relative = 1e-12);
    let driven = moved(&drawer([1.0, 6.0, 0.4], "1 s"));
    assert_relative_eq!(driven.trajectory.end.speed, 1.0 + 3.0 / (1.0 + k), max_relative = 1e-12);
    let started = moved(&drawer([0.0, -6.0, 0.4], "1 s"));
    assert_relative_eq!(started.trajectory.end.speed, -3.0 / (1.0 + k), max_relative = 1e-12);
}

/// For k above 1 the factor of the acceleration changes its sign: against the motion no acceleration is possible, along it two are,
/// P / m (1 + k) and P / m (1 - k).
#[test]
fn where_no_acceleration_is_possible_or_several_are_the_motion_ends_with_an_error() {
    let none = stopped(&drawer([1.0, -6.0, 0.6], "rest"));
    assert!(none.contains("no acceleration is possible") && none.contains("t = 0.000000000"), "{none}");
    let several = stopped(&drawer([1.0, 6.0, 0.6], "1 s"));
    for part in ["2 accelerations", "-1.500000e1", "1.363636e0", "q = 0.000000000"] {
        assert!(several.contains(part), "{several}");
    }
    // A place later on: the force turns round on the way.
    let way = drawer([1.0, 0.0, 0.6], "rest")
        .replace("value = 0", "value = { over = \"angle\", table = [[0, 0], [0.5, 0], [0.5, -6], [9, -6]] }");
    let later = stopped(&way);
    assert!(later.contains("t = 0.500000000 s, q = 0.500000000"), "{later}");
}
