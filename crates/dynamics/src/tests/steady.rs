//! Steady regimes of whole scenes.

use std::f64::consts::PI;

use approx::assert_relative_eq;

use assur_fixtures::scene;

use super::compiled;
use crate::steady;

#[test]
fn the_engine_of_example_2() {
    let (linkage, loads) = compiled(scene("flywheel"));
    let found = steady(&linkage, &loads, None).unwrap();
    let regime = &found.regime;
    // E example 2, in closed form.
    assert_relative_eq!(regime.figures.torque.unwrap(), -20.0, max_relative = 1e-12);
    assert_relative_eq!(regime.flywheel, PI / 20.0, max_relative = 1e-11);
    assert_relative_eq!(regime.figures.coordinate_at_min, 0.5 * PI, max_relative = 1e-9);
    assert_relative_eq!(regime.figures.coordinate_at_max, 1.5 * PI, max_relative = 1e-9);
    assert_relative_eq!(regime.figures.excess_work, 10.0 * PI, max_relative = 1e-11);
    assert_relative_eq!(regime.figures.dynamic_unevenness.unwrap(), 0.04 / PI, max_relative = 1e-9);
    assert_relative_eq!(regime.figures.mean_speed, 100.0, max_relative = 1e-11);
    assert_relative_eq!(regime.figures.unevenness, 0.02, max_relative = 1e-11);
}

#[test]
fn the_shaper_with_its_drive() {
    let (linkage, loads) = compiled(scene("shaper-drive"));
    let found = steady(&linkage, &loads, None).unwrap();
    let regime = &found.regime;
    // An independent solution.
    assert_relative_eq!(regime.flywheel, 101.9001, max_relative = 1e-6);
    assert_relative_eq!(regime.figures.ratio.unwrap(), 24.33661, max_relative = 3e-7);
    assert_relative_eq!(regime.figures.mean_speed, 2.0 * PI, max_relative = 1e-11);
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-11);
}

/// A press at 180 rpm under 20000 + 9500 sin 2q - 5700 cos 2q N m: the excess work is the amplitude of the variable part.
#[test]
fn a_flywheel_under_a_moment_by_formula() {
    let text = "[ground]\npoints = { O = 0 }\n[link.shaft]\npoints = { O = 0 }\n\
        [[moment]]\nlink = 'shaft'\nvalue = { formula = '20000 + 9500*sin(2*q) - 5700*cos(2*q)', unit = 'N*m' }\n\
        [input]\nlink = 'shaft'\n[motion]\nkind = 'steady'\nmean_speed = '180 rpm'\nunevenness = 0.01\n\
        [drive]\ntorque = 'balance'\nflywheel = 'solve'\n";
    let (linkage, loads) = compiled(text);
    let regime = steady(&linkage, &loads, None).unwrap().regime;
    let work = 9500.0_f64.hypot(5700.0);
    assert_relative_eq!(regime.figures.excess_work, work, max_relative = 1e-10);
    assert_relative_eq!(regime.figures.torque.unwrap(), -20000.0, max_relative = 1e-10);
    // The periodic regime itself: J = A / (w² delta), since w² swings by 2 w² delta about w_mean² (1 + delta²/4).
    let speed = 6.0 * std::f64::consts::PI;
    assert_relative_eq!(regime.flywheel, work / (speed * speed * 0.01), max_relative = 1e-10);
}
