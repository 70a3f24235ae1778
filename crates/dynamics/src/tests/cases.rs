//! The five cases of the equation of motion (D 3.21), each by a shipped scene with a solution in closed form; and the last by hand.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use assur_fixtures::scene;

use super::compiled;
use crate::{Method, transient};

/// The moment of inertia of the scenes of the cases 3 and 5.
fn inertia(q: f64) -> f64 {
    0.02 + 0.01 * q.cos()
}

/// Of y' + rate y = mean + swing cos q from `start` at 0: y at `q`.
fn linear(rate: f64, [mean, swing]: [f64; 2], start: f64, q: f64) -> f64 {
    let sine = swing / (1.0 + rate * rate);
    let at = |q: f64| mean / rate + sine * (rate * q.cos() + q.sin());
    at(q) + (start - at(0.0)) * (-rate * q).exp()
}

#[test]
fn each_case_has_a_scene_whose_end_is_known() {
    // D 3.22; E example 1; J w²/2 = T0 + q + sin(q)/2; the linear equations of w² and of J w².
    let half = (inertia(0.0) * 3.5 * 3.5 + 2.0 * (PI + 0.5 * PI.sin())) / inertia(PI);
    let fan = linear(0.4, [40.0, -10.0], 9.0, 10.0 * PI);
    let vane = linear(0.2, [2.0, 1.0], inertia(0.0) * 3.5 * 3.5, 10.0 * PI) / inertia(10.0 * PI);
    let squares = [
        (1, "brake", 0.0),
        (2, "run-up", 1000.0 * PI),
        (3, "disc-case-3", half),
        (4, "disc-case-4", fan),
        (5, "disc-case-5", vane),
    ];
    for (case, name, square) in squares {
        let (linkage, loads) = compiled(scene(name));
        let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
        assert_eq!(found.dependence.case(), case, "{name}");
        assert_relative_eq!(found.trajectory.end.speed, square.sqrt(), max_relative = 2e-8, epsilon = 1e-9);
    }
}

/// Case 2 with M(w) and with M(t): speed and angle after 20 s, by one quadrature each and by a method of steps.
#[test]
fn the_quadratures_of_case_two_have_scenes_whose_ends_are_known() {
    // 0.4 w' = 5 - w/10; 0.4 w' = 1 + 2 sin 3t.
    let fading = (-5.0_f64).exp();
    let of_speed = [50.0 * (1.0 - fading), 50.0 * (20.0 - 4.0 * (1.0 - fading))];
    let [sin, cos] = [60.0_f64.sin(), 60.0_f64.cos()];
    let of_time = [(2.0 / 3.0 * (1.0 - cos) + 20.0) / 0.4, (200.0 + 2.0 / 3.0 * (20.0 - sin / 3.0)) / 0.4];
    assert_relative_eq!(of_speed[0], 49.6631, epsilon = 5e-5);
    assert_relative_eq!(of_time[0], 53.2540, epsilon = 5e-5);
    for (name, [speed, angle]) in [("disc-case-2-speed", of_speed), ("disc-case-2-time", of_time)] {
        for integrator in ["quadrature", "dop853"] {
            let by = format!("{}integrator = \"{integrator}\"\n", scene(name));
            let (linkage, loads) = compiled(&by);
            let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
            assert_eq!(found.dependence.case(), 2, "{name}");
            assert_relative_eq!(found.trajectory.end.speed, speed, max_relative = 2e-8);
            assert_relative_eq!(found.trajectory.end.coordinate, angle, max_relative = 2e-8);
        }
    }
}

/// Case 3 for a motor that is stopped by a spring, out and back: the speed at each sample is that of the energy.
#[test]
fn the_energy_of_case_three_is_kept_through_a_turn_back() {
    let scene = scene("disc-case-3")
        .replace("1 + 0.5*cos(q)", "0.5 - 0.2*q")
        .replace("until = \"0.5 rev\"", "until = \"3 s\"");
    let (linkage, loads) = compiled(&scene);
    let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
    let energy = |q: f64, w: f64| 0.5 * inertia(q) * w * w - 0.5 * q + 0.1 * q * q;
    let start = energy(0.0, 3.5);
    let back = found.trajectory.samples.iter().filter(|sample| sample.speed < 0.0).count();
    assert!(back > 20, "{back}");
    for sample in &found.trajectory.samples {
        assert!((energy(sample.coordinate, sample.speed) - start).abs() < 1e-8 * start, "{sample:?}");
    }
}

/// A wheel with a pendulum and a motor, written as an ordinary differential equation by hand and solved by the classical method of
/// Runge and Kutta.
#[test]
fn an_equation_written_by_hand_has_the_same_motion() {
    let scene = "gravity = 10\n[ground]\npoints = { O = 0 }\n[link.wheel]\npoints = { O = 0 }\nmass = 0.4\ncenter = 0.15\n\
        inertia = { formula = \"0.05/(1.3 - cos(2*q)) + 0.01*exp(sin(q))\", unit = \"kg*m^2\" }\n\
        [[moment]]\nlink = \"wheel\"\nvalue = { formula = \"2 - 0.1*w\", unit = \"N*m\" }\n\
        [input]\nlink = \"wheel\"\n[motion]\nkind = \"transient\"\nspeed = 1\nuntil = \"2 s\"\nsamples = 8\n";
    let rate = |[q, w]: [f64; 2]| {
        let about_pin = 0.05 / (1.3 - (2.0 * q).cos()) + 0.01 * q.sin().exp() + 0.4 * 0.15 * 0.15;
        let slope = -0.1 * (2.0 * q).sin() / (1.3 - (2.0 * q).cos()).powi(2) + 0.01 * q.cos() * q.sin().exp();
        [w, (2.0 - 0.1 * w - 0.4 * 10.0 * 0.15 * q.cos() - 0.5 * slope * w * w) / about_pin]
    };
    let (linkage, loads) = compiled(scene);
    let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
    assert_eq!(found.dependence.case(), 5);
    let (mut state, step) = ([0.0, 1.0], 1e-4);
    let after = |state: [f64; 2], k: [f64; 2], by: f64| [state[0] + by * k[0], state[1] + by * k[1]];
    for sample in &found.trajectory.samples[1..] {
        for _ in 0..2500 {
            let a = rate(state);
            let b = rate(after(state, a, 0.5 * step));
            let c = rate(after(state, b, 0.5 * step));
            let d = rate(after(state, c, step));
            let mean = [0, 1].map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0);
            state = after(state, mean, step);
        }
        assert_relative_eq!(sample.coordinate, state[0], max_relative = 1e-7);
        assert_relative_eq!(sample.speed, state[1], max_relative = 1e-7);
    }
}

/// Beyond the way that the scene names the formula may stop being a moment of inertia: the motion ends there, and says where.
#[test]
fn a_moment_of_inertia_that_vanishes_on_the_way_is_told() {
    let scene = scene("disc-case-3")
        .replace("0.02 + 0.01*cos(q)", "0.02 - 0.002*q")
        .replace("until = \"0.5 rev\"", "until = \"100 s\"");
    let (linkage, loads) = compiled(&scene);
    let error = transient(&linkage, &loads, &Method::default(), None).unwrap_err().to_string();
    assert!(error.contains("not finite") || error.contains("moment of inertia"), "{error}");
}
