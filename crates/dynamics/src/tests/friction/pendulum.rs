//! A pendulum with friction in its pin: the reaction depends on speed and acceleration.

use approx::assert_relative_eq;
use assur_integrator::EventKind;

use super::{G, moved};

const MASS: f64 = 1.5;
const ARM: f64 = 0.4;
/// About the pin.
const INERTIA: f64 = 0.05 + MASS * ARM * ARM;
/// Coefficient times radius.
const LEVER: f64 = 0.3 * 0.06;

/// J e = -m g a sin q - s f r |R|, R = m (a e + g sin q, a w^2 + g cos q): by iteration, whose rate is f r m a / J.
fn acceleration(q: f64, w: f64, sense: f64) -> f64 {
    let (s, c) = q.sin_cos();
    let mut e = 0.0;
    for _ in 0..60 {
        let force = MASS * (ARM * e + G * s).hypot(ARM * w * w + G * c);
        e = (-MASS * G * ARM * s - sense * LEVER * force) / INERTIA;
    }
    e
}

/// A step of the classical method of order 4.
fn step([q, w]: [f64; 2], h: f64, sense: f64) -> [f64; 2] {
    let rate = |[q, w]: [f64; 2]| [w, acceleration(q, w, sense)];
    let after = |k: [f64; 2], part: f64| [q + part * h * k[0], w + part * h * k[1]];
    let k1 = rate([q, w]);
    let k2 = rate(after(k1, 0.5));
    let k3 = rate(after(k2, 0.5));
    let k4 = rate(after(k3, 1.0));
    let sum = |i: usize| h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
    [q + sum(0), w + sum(1)]
}

/// The next turning point: time and coordinate.
fn turn(mut now: [f64; 2], mut time: f64, sense: f64) -> [f64; 2] {
    let mut h = 5e-4;
    while h > 1e-13 {
        let next = step(now, h, sense);
        if next[1] * sense > 0.0 {
            (now, time) = (next, time + h);
        } else {
            h *= 0.5;
        }
    }
    [time, now[0]]
}

#[test]
fn a_pendulum_swings_out() {
    // The angle is from the horizontal: the link hangs at -90 degrees.
    let scene = "gravity = \"9.81 m/s^2\"\n[ground]\npoints = { O = [0, 0] }\n\
                 [link.rod]\npoints = { O = 0, C = 0.4 }\nmass = 1.5\ncenter = \"C\"\ninertia = 0.05\n\
                 [input]\nlink = \"rod\"\nfrom = \"-90 deg\"\n\
                 [motion]\nkind = \"transient\"\nspeed = 9\nuntil = \"rest\"\nsamples = 40\ntolerance = 1e-11\n\
                 [[friction]]\npair = \"O\"\ncoefficient = 0.3\nradius = 0.06\n";
    let found = moved(scene);
    let (mut state, mut time, mut sense) = ([0.0, 9.0], 0.0, 1.0);
    let events = &found.trajectory.events;
    assert!(events.len() > 10, "{events:?}");
    for event in events {
        let [at, q] = turn(state, time, sense);
        assert_relative_eq!(event.state.time, at, max_relative = 1e-8);
        assert_relative_eq!(event.state.coordinate, q - std::f64::consts::FRAC_PI_2, epsilon = 1e-8);
        // It stays where friction in the sense of the way back is stronger than the weight.
        let back = acceleration(q, 0.0, -sense) * -sense;
        assert_eq!(event.kind == EventKind::Rest, back <= 0.0, "{event:?}");
        (state, time, sense) = ([q, 0.0], at, -sense);
    }
    assert_eq!(events.last().unwrap().kind, EventKind::Rest);
}
