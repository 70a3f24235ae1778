//! Transient motions of whole scenes.

use std::f64::consts::PI;

use approx::assert_relative_eq;

use super::{compiled, fixture};
use crate::{Transient, transient, transient_by};

fn solved(name: &str) -> Transient {
    let (linkage, loads) = compiled(&fixture(name));
    transient(&linkage, &loads).unwrap()
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

#[test]
fn the_run_up_of_example_1() {
    let found = solved("run-up");
    // E example 1: w = sqrt(2 * 50 pi / 0.1).
    assert_relative_eq!(found.trajectory.end.speed, (1000.0 * PI).sqrt(), max_relative = 1e-11);
    assert_relative_eq!(found.trajectory.end.coordinate, 10.0 * PI, max_relative = 1e-12);
}

/// 25-digit computation by two independent formulations.
const ANDREWS: [f64; 2] = [15.810_771_195_153_71, 1_139.920_302_259_106];

#[test]
fn andrews_to_the_tolerance() {
    let (linkage, loads) = compiled(&fixture("andrews"));
    for (integrator, tolerance, allowed) in
        [("auto", 1e-9, 1e-8), ("auto", 1e-14, 1e-11), ("dop853", 1e-9, 1e-8), ("dop853", 1e-14, 1e-11)]
    {
        let found = transient_by(&linkage, &loads, Some(integrator), Some(tolerance)).unwrap();
        let end = found.trajectory.end;
        eprintln!(
            "{integrator} {} {tolerance:e}: {:e} {:e} {:?}",
            found.integrator,
            end.coordinate / ANDREWS[0] - 1.0,
            end.speed / ANDREWS[1] - 1.0,
            found.trajectory.statistics
        );
        assert_relative_eq!(end.coordinate, ANDREWS[0], max_relative = allowed);
        assert_relative_eq!(end.speed, ANDREWS[1], max_relative = 10.0 * allowed);
    }
}

#[test]
fn parallelograms_keep_their_branch() {
    let (linkage, loads) = compiled(&fixture("n-four-bar-2"));
    let found = transient(&linkage, &loads).unwrap();
    let end = found.trajectory.end;
    eprintln!("{} {:?} {:e}", found.integrator, found.trajectory.statistics, found.energy.change);
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
