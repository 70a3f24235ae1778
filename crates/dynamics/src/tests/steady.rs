//! Steady regimes of whole scenes.

use std::f64::consts::PI;

use approx::assert_relative_eq;

use assur_fixtures::scene;

use super::compiled;
use crate::{Method, steady, transient};

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

/// A slider-crank under a load over the angle, and its mirror image in the axis of x, which turns the other way.
fn pump(mirrored: bool, damping: f64, drive: &str, motion: &str) -> String {
    let (side, direction) = if mirrored { (-1.0, "cw") } else { (1.0, "ccw") };
    format!(
        "gravity = [0, {}]\n[ground]\npoints = {{ O = 0 }}\n\
         [link.crank]\npoints = {{ O = 0, A = 0.1 }}\nmass = 2\ncenter = [0.03, {}]\ninertia = 0.5\n\
         [link.rod]\npoints = {{ A = 0, B = 0.4 }}\nmass = 1\ncenter = [0.15, {}]\ninertia = 0.02\n\
         [link.piston]\npoints = {{ B = 0 }}\nmass = 3\n[[slide]]\nlink = 'piston'\non = 'ground'\nthrough = [0, {}]\n\
         [[spring]]\nbetween = ['O', 'B']\nstiffness = 0\ndamping = {damping}\n\
         [[moment]]\nlink = 'crank'\nvalue = {{ formula = '{side}*(-40 + 9*cos(q)) + 5*sin(q)', unit = 'N*m' }}\n\
         [input]\nlink = 'crank'\ndirection = '{direction}'\npositions = 12\n[assembly]\nB = [0.5, {}]\n\
         [motion]\n{motion}\n[drive]\n{drive}\nflywheel = 2\n",
        -9.81 * side,
        0.02 * side,
        0.01 * side,
        0.05 * side,
        0.05 * side,
    )
}

const STEADY: &str = "kind = 'steady'\nmean_speed = 12";

/// The moment that balances is given along the direction of the motion, as the key takes it: as a number it makes the same
/// regime, found or integrated in time.
#[test]
fn the_moment_that_balances_makes_the_same_motion_as_a_number() {
    for mirrored in [false, true] {
        for damping in [0.0, 20.0] {
            let (linkage, loads) = compiled(&pump(mirrored, damping, "torque = 'balance'", STEADY));
            let wanted = steady(&linkage, &loads, None).unwrap().regime;
            let torque = wanted.figures.torque.unwrap();
            assert!(torque > 30.0, "it drives along the direction: {torque}");
            let drive = format!("torque = {torque:?}");
            let (linkage, loads) = compiled(&pump(mirrored, damping, &drive, STEADY));
            let found = steady(&linkage, &loads, None).unwrap().regime;
            for i in 0..12 {
                let [wanted, found] =
                    [&wanted, &found].map(|at| at.state(linkage.mechanism.input.coordinate(i)));
                assert_relative_eq!(found.speed, wanted.speed, max_relative = 1e-9);
                assert_relative_eq!(found.acceleration, wanted.acceleration, max_relative = 1e-8);
            }
            let speed = wanted.state(0.0).speed.abs();
            let motion = format!("kind = 'transient'\nspeed = {speed:?}\nuntil = '1 rev'\ntolerance = 1e-12");
            let (linkage, loads) = compiled(&pump(mirrored, damping, &drive, &motion));
            let turn = transient(&linkage, &loads, &Method::default(), None).unwrap().trajectory;
            assert_relative_eq!(turn.samples.last().unwrap().speed.abs(), speed, max_relative = 1e-9);
        }
    }
}

#[test]
fn a_mirrored_machine_needs_the_same_moment() {
    for damping in [0.0, 20.0] {
        let [one, other] = [false, true].map(|mirrored| {
            let (linkage, loads) = compiled(&pump(mirrored, damping, "torque = 'balance'", STEADY));
            steady(&linkage, &loads, None).unwrap().regime.figures
        });
        assert_relative_eq!(one.torque.unwrap(), other.torque.unwrap(), max_relative = 1e-11);
        assert_relative_eq!(one.unevenness, other.unevenness, max_relative = 1e-9);
        assert_relative_eq!(one.speed_max, -other.speed_max, max_relative = 1e-11);
    }
}
