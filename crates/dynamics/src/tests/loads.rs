//! Regimes under loads that depend on the speed, drives that brake, and drives without a motor; against the motion in
//! time, turn after turn.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use assur_integrator::{Request, State, Until, find};

use assur_fixtures::scene;

use super::compiled;
use crate::{DynamicsError, Machine, Regime, steady};

/// Speed at the start of a cycle after many turns from the mean speed, with what the regime has on its shaft.
fn speed_after(text: &str, regime: &Regime, turns: u32) -> f64 {
    let (linkage, loads) = compiled(text);
    let mut motion = Machine::new(&linkage, &loads).with_drive(regime.drive());
    let integrator = find("dop853").unwrap();
    let sense = linkage.mechanism.input.sign();
    let from = linkage.mechanism.input.from;
    let initial = State { time: 0.0, coordinate: from, speed: regime.figures.mean_speed };
    let until = Until::Coordinate(from + sense * 2.0 * PI * f64::from(turns));
    let request =
        Request { tolerance: 1e-12, samples: 1, max_steps: 1_000_000, ..Request::new(initial, until) };
    integrator.solve(&mut motion, &request).unwrap().end.speed
}

fn check(text: &str, turns: u32) -> Regime {
    let (linkage, loads) = compiled(text);
    let regime = steady(&linkage, &loads, None).unwrap().regime;
    let from = linkage.mechanism.input.from;
    assert!(regime.multiplier < 1.0);
    assert!(regime.multiplier.powi(i32::try_from(turns).unwrap()) < 1e-9, "{}", regime.multiplier);
    assert_relative_eq!(speed_after(text, &regime, turns), regime.state(from).speed, max_relative = 2e-9);
    regime
}

fn shaper(more: &str) -> String {
    format!("{}\n{more}", scene("shaper-drive"))
}

#[test]
fn a_damper() {
    let regime = check(
        &shaper("[[spring]]\nbetween = [\"D\", \"O\"]\ndamping = 300\nstiffness = 500\nlength = 0.4"),
        30,
    );
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-10);
    assert_relative_eq!(regime.figures.mean_speed, 2.0 * PI, max_relative = 1e-10);
}

#[test]
fn a_table_over_speed_with_kinks_inside_the_range() {
    let table = "[[moment]]\nlink = \"crank\"\nvalue = { over = \"speed\", table = [[0, 0], [6.2, -10], [6.3, -60], [9, -70]] }";
    let regime = check(&shaper(table), 30);
    assert!(regime.figures.speed_min < 6.2 && regime.figures.speed_max > 6.3);
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-10);
}

#[test]
fn a_table_over_speed_with_jumps_inside_the_range() {
    let table = "[[moment]]\nlink = \"crank\"\nvalue = { over = \"speed\", shape = \"step\", table = [[0, 0], [6.25, -25], [6.35, -10]] }";
    let regime = check(&shaper(table), 30);
    assert!(regime.figures.speed_min < 6.25 && regime.figures.speed_max > 6.35);
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-9);
}

#[test]
fn a_force_against_the_motion() {
    check(&shaper("[[force]]\nlink = \"ram\"\nat = \"E\"\nagainst_motion = true\nvalue = 200"), 30);
}

#[test]
fn a_load_that_drives_the_motor_beyond_synchronous_speed() {
    let table = "[[moment]]\nlink = \"crank\"\nvalue = { over = \"angle\", table = [[0, 400], [\"180 deg\", -300], [\"360 deg\", 400]] }";
    let regime = check(&shaper(table), 40);
    let synchronous = 50.0 * PI / regime.figures.ratio.unwrap();
    assert!(regime.figures.speed_max > synchronous && regime.figures.speed_min < synchronous);
}

#[test]
fn clockwise_with_everything() {
    let more = "[[force]]\nlink = \"ram\"\nat = \"E\"\nagainst_motion = true\nvalue = 200\n\
        [[moment]]\nlink = \"crank\"\nvalue = { over = \"speed\", table = [[-9, 70], [-6.3, 60], [-6.2, 10], [0, 0]] }\n\
        [[spring]]\nbetween = [\"D\", \"O\"]\ndamping = 300";
    let text = shaper(more).replace("positions = 48", "positions = 48\ndirection = \"cw\"");
    let regime = check(&text, 30);
    assert_relative_eq!(regime.figures.mean_speed, -2.0 * PI, max_relative = 1e-10);
}

/// The shaper with another drive.
fn driven_by(drive: &str, more: &str) -> String {
    let text = scene("shaper-drive");
    let (machine, _) = text.split_once("[drive]").unwrap();
    format!("{machine}\n[drive]\n{drive}\n{more}")
}

#[test]
fn balance_makes_the_work_of_a_cycle_zero() {
    let text = driven_by("torque = \"balance\"\nflywheel = \"solve\"", "");
    let (linkage, loads) = compiled(&text);
    let found = steady(&linkage, &loads, None).unwrap();
    let regime = &found.regime;
    assert_relative_eq!(
        regime.figures.torque.unwrap() * 2.0 * PI,
        found.regime.resistance_work,
        max_relative = 1e-12
    );
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-10);
    assert_relative_eq!(regime.figures.mean_speed, 2.0 * PI, max_relative = 1e-10);
    // Moments of the coordinate alone: the energy-mass diagram is exact.
    let wittenbauer = regime.flywheel_by_method.iter().find(|row| row.method == "wittenbauer").unwrap();
    assert_relative_eq!(wittenbauer.flywheel, regime.flywheel, max_relative = 1e-9);
    // Nothing restores the speed, and no turn changes it: that of the mean speed ends with the mean speed.
    assert_relative_eq!(speed_after(&text, regime, 1), regime.figures.mean_speed, max_relative = 1e-9);
}

#[test]
fn balance_with_a_damper() {
    let damper = "[[spring]]\nbetween = [\"D\", \"O\"]\ndamping = 60000";
    let regime = check(&driven_by("torque = \"balance\"\nflywheel = \"solve\"", damper), 100);
    assert_relative_eq!(regime.figures.mean_speed, 2.0 * PI, max_relative = 1e-10);
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-10);
}

#[test]
fn a_constant_moment_against_a_damper_finds_its_own_speed() {
    let damper = "[[spring]]\nbetween = [\"D\", \"O\"]\ndamping = 60000";
    let regime = check(&driven_by("torque = 800\nflywheel = 20", damper), 100);
    assert!((regime.figures.mean_speed - 2.0 * PI).abs() > 0.01);
    assert_relative_eq!(regime.figures.torque.unwrap(), 800.0);
}

#[test]
fn no_drive_and_no_work() {
    // Weights only: the energy is kept, the mean speed is a matter of choice.
    let text = scene("shaper-drive");
    let (head, tail) = text.split_once("[[force]]").unwrap();
    let (_, tail) = tail.split_once("[assembly]").unwrap();
    let (assembly, _) = tail.split_once("[drive]").unwrap();
    let text = format!("{head}\n[assembly]{assembly}\n[drive]\nflywheel = \"solve\"");
    let (linkage, loads) = compiled(&text);
    let regime = steady(&linkage, &loads, None).unwrap().regime;
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-10);
    assert_relative_eq!(regime.figures.mean_speed, 2.0 * PI, max_relative = 1e-10);
    assert_relative_eq!(speed_after(&text, &regime, 1), regime.figures.mean_speed, max_relative = 1e-9);
}

#[test]
fn a_constant_moment_that_does_work_has_no_regime() {
    let (linkage, loads) = compiled(&driven_by("torque = 200", ""));
    let error = steady(&linkage, &loads, None).unwrap_err();
    assert!(matches!(error, DynamicsError::NoRegime { .. }));
    assert!(error.to_string().starts_with("there is no steady regime: the work per cycle is"), "{error}");
}

#[test]
fn a_weak_motor_says_so() {
    let (linkage, loads) = compiled(&scene("shaper-drive").replace("1.1 kW", "0.2 kW"));
    let error = steady(&linkage, &loads, None).unwrap_err();
    assert!(matches!(error, DynamicsError::TooWeak { .. }), "{error}");
    let (linkage, loads) = compiled(
        &scene("shaper-drive")
            .replace("ratio = \"solve\"", "ratio = 3")
            .replace("flywheel = \"solve\"", "flywheel = 5"),
    );
    let error = steady(&linkage, &loads, None).unwrap_err();
    assert!(matches!(error, DynamicsError::Stalled(_)), "{error}");
}
