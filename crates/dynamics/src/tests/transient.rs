//! Transient motions of whole scenes.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use assur_integrator::{AUTO, Dependence, Reduced, Request, State, Until};
use assur_problems::Example;
use assur_words::Describe;

use assur_fixtures::scene;

use super::compiled;
use crate::{Method, Transient, transient};

fn solved(name: &str) -> Transient {
    let (linkage, loads) = compiled(scene(name));
    transient(&linkage, &loads, &Method::default(), None).unwrap()
}

#[test]
fn the_brake_of_d() {
    let found = solved("brake");
    let end = found.trajectory.end;
    // D 3.22 in closed form: t = w0 J/M, way = w0²J/(2 M).
    assert_relative_eq!(end.time, 50.0, max_relative = 1e-12);
    assert_relative_eq!(end.coordinate, 2500.0, max_relative = 1e-12);
    assert_eq!(found.integrator, "closed-form");
}

/// The shoe of the brake as the line of the ground, on which an arc about the pin slides.
#[test]
fn a_contact_against_the_sliding_brakes_as_the_brake_of_d() {
    let brake = scene("brake").split_once("[[brake]]").unwrap();
    let contact = "[[contact]]\nlink = \"disc\"\ncenter = \"O\"\nradius = 0.1\nforce = 40\nfriction = { against_sliding = 0.2 }\n";
    for speed in ["100", "-100"] {
        let rest =
            brake.1.split_once("[input]").unwrap().1.replace("speed = 100", &format!("speed = {speed}"));
        let (linkage, loads) = compiled(&format!("{}{contact}[input]{rest}", brake.0));
        let end = transient(&linkage, &loads, &Method::default(), None).unwrap().trajectory.end;
        assert_relative_eq!(end.time, 50.0, max_relative = 1e-9);
        assert_relative_eq!(end.coordinate.abs(), 2500.0, max_relative = 1e-9);
    }
}

#[test]
fn the_run_up_of_example_1() {
    let found = solved("run-up");
    // E example 1: w = sqrt(2 * 50 pi / 0.1).
    assert_relative_eq!(found.trajectory.end.speed, (1000.0 * PI).sqrt(), max_relative = 1e-11);
    assert_relative_eq!(found.trajectory.end.coordinate, 10.0 * PI, max_relative = 1e-12);
}

#[test]
fn a_moment_over_time_is_one_quadrature() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.disc]\npoints = { O = 0 }\nmass = 2\ninertia = 0.5\n\
        [[moment]]\nlink = \"disc\"\nvalue = { over = \"time\", table = [[0, 0], [1, 5], [3, 5], [4, 0]] }\n\
        [input]\nlink = \"disc\"\n[motion]\nkind = \"transient\"\nspeed = 0.5\nuntil = \"6 s\"\n";
    let (linkage, loads) = compiled(scene);
    let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
    // The impulse is 2.5 + 10 + 2.5 N m s: w = 0.5 + 15 / 0.5. The trapezoid turns about t = 2, so that from 0 to 4 the mean
    // speed is that of t = 2: 15.5 rad/s.
    assert_eq!(found.integrator, "quadrature");
    assert_relative_eq!(found.trajectory.end.speed, 30.5, max_relative = 1e-14);
    assert_relative_eq!(found.trajectory.end.coordinate, 4.0 * 15.5 + 2.0 * 30.5, max_relative = 1e-14);
}

#[test]
fn a_motor_on_a_disc_is_one_quadrature_over_the_speed() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.disc]\npoints = { O = 0 }\nmass = 2\ninertia = 0.5\n\
        [[moment]]\nlink = \"disc\"\nvalue = { over = \"speed\", table = [[0, 6], [12, 0], [20, -4]] }\n\
        [input]\nlink = \"disc\"\n[motion]\nkind = \"transient\"\nspeed = 0\nuntil = \"3 s\"\n";
    let (linkage, loads) = compiled(scene);
    let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
    assert_eq!(
        (found.integrator, found.dependence.describe().to_string().as_str()),
        ("quadrature", "J constant, M(w)")
    );
    // w' = 12 - w.
    let (end, gone) = (found.trajectory.end, -(-3.0_f64).exp_m1());
    assert_relative_eq!(end.speed, 12.0 * gone, max_relative = 1e-13);
    assert_relative_eq!(end.coordinate, 12.0 * (3.0 - gone), max_relative = 1e-13);
}

/// What a method finds to be beyond it on the way, `auto` gives to the next.
#[test]
fn auto_falls_back_where_no_polynomial_follows_the_moment() {
    let dependence = Dependence { inertia_constant: true, moment_on_speed: true, ..Dependence::default() };
    // Waves in the moment so short that panels would have to be, too: w' = 2 + 0.0004 sin(1e7 w).
    let mut motion = Example::new(dependence, |_, at| Reduced {
        inertia: 1.0,
        inertia_derivative: 0.0,
        moment: 2.0 + 4e-4 * (1e7 * at.speed).sin(),
    });
    let initial = State { speed: 1.0, ..State::default() };
    let request = Request { tolerance: 1e-6, ..Request::new(initial, Until::Time(1.0)) };
    let found = assur_integrator::solve(AUTO, &mut motion, &request).unwrap();
    assert_eq!(found.integrator.name, "dop853");
    assert!(
        found.reason.to_string().contains("; `quadrature` was tried before: no polynomial in the speed"),
        "{}",
        found.reason
    );
    // The waves cancel.
    assert_relative_eq!(found.trajectory.end.speed, 3.0, max_relative = 1e-4);
}

/// 25-digit computation by two independent formulations.
const ANDREWS: [f64; 2] = [15.810_771_195_153_71, 1_139.920_302_259_106];

#[test]
fn andrews_to_the_tolerance() {
    let (linkage, loads) = compiled(scene("andrews"));
    for (integrator, tolerance, allowed) in
        [("auto", 1e-9, 1e-8), ("auto", 1e-14, 1e-11), ("dop853", 1e-9, 1e-8), ("dop853", 1e-14, 1e-11)]
    {
        let found = transient(
            &linkage,
            &loads,
            &Method { integrator: Some(integrator), tolerance: Some(tolerance) },
            None,
        )
        .unwrap();
        let end = found.trajectory.end;
        assert_relative_eq!(end.coordinate, ANDREWS[0], max_relative = allowed);
        assert_relative_eq!(end.speed, ANDREWS[1], max_relative = 10.0 * allowed);
    }
}

#[test]
fn parallelograms_keep_their_branch() {
    let (linkage, loads) = compiled(scene("n-four-bar-2"));
    let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
    let end = found.trajectory.end;
    // A published benchmark.
    assert_relative_eq!(end.coordinate.cos(), 0.328_458_111_540_815, epsilon = 1e-6);
    assert_relative_eq!(end.coordinate.sin(), 0.944_518_538_178_601, epsilon = 1e-6);
    assert!(found.energy.conservative);
    assert!(found.energy.change < 1e-7, "{}", found.energy.change);
}

#[test]
fn forty_parallelograms() {
    let found = solved("n-four-bar-40");
    assert_relative_eq!(found.trajectory.end.time, 20.0, max_relative = 1e-12);
    assert!(found.energy.change < 1e-7, "{}", found.energy.change);
}

/// A mechanism that moves clockwise: the torque of the drive and tables over the speed are counted along the motion.
#[test]
fn direction_cw_turns_torque_and_speed() {
    let ends = |load: &str| {
        let scene = format!(
            "[ground]\npoints = {{ O = 0 }}\n[link.disc]\npoints = {{ O = 0 }}\nmass = 2\ninertia = 0.5\n{load}\n\
             [input]\nlink = 'disc'\ndirection = 'cw'\n[motion]\nkind = 'transient'\nspeed = 0\nuntil = '3 s'\n"
        );
        let (linkage, loads) = compiled(&scene);
        transient(&linkage, &loads, &Method::default(), None).unwrap().trajectory.end.speed
    };
    assert_relative_eq!(ends("[drive]\ntorque = 6"), -36.0, max_relative = 1e-12);
    let table = "[[moment]]\nlink = 'disc'\nvalue = { over = 'speed', table = [[0, -6], [12, 0], [20, 4]] }";
    assert_relative_eq!(ends(table), 12.0 * (-3.0_f64).exp_m1(), max_relative = 1e-9);
}

/// A moment that jumps in time and one that turns with the sign of the speed, in closed form.
#[test]
fn jumps_of_formulas_are_stepped_onto() {
    let end = |value: &str, speed: f64| {
        let scene = format!(
            "[ground]\npoints = {{ O = 0 }}\n[link.disc]\npoints = {{ O = 0 }}\nmass = 2\ninertia = 0.5\n\
             [[moment]]\nlink = 'disc'\nvalue = {{ formula = '{value}' }}\n[input]\nlink = 'disc'\n\
             [motion]\nkind = 'transient'\nspeed = {speed}\nuntil = '3 s'\n"
        );
        let (linkage, loads) = compiled(&scene);
        transient(&linkage, &loads, &Method::default(), None).unwrap().trajectory.end
    };
    assert_relative_eq!(
        end("5*step(t - 1.2) - 2", 7.0).speed,
        7.0 + (1.8 * 5.0 - 6.0) / 0.5,
        max_relative = 1e-12
    );
    // 4 - 2 sign(w): from -3 rad/s with 12 rad/s² to rest in 0.25 s, then with 4 rad/s².
    let found = end("4 - 2*sign(w)", -3.0);
    assert_relative_eq!(found.speed, 4.0 * 2.75, max_relative = 1e-10);
    assert_relative_eq!(found.coordinate, -0.375 + 0.5 * 4.0 * 2.75 * 2.75, max_relative = 1e-10);
    // Driven until the coordinate is 2 rad: w² / 2 = 2 * 6 / 0.5 - then coasting.
    let found = end("6*step(2 - q)", 0.0);
    assert_relative_eq!(found.speed, 48.0_f64.sqrt(), max_relative = 1e-9);
}
