//! Many wishes for one machine: each is met, or refused with a reason.

use approx::assert_relative_eq;

use assur_fixtures::scene;

use super::compiled;
use crate::{SteadyMotor, steady};

/// Whether the motor does its work without being overloaded.
fn is_fit(motor: &SteadyMotor) -> bool {
    motor.warnings.iter().all(|warning| warning.unfit.is_none())
}

#[test]
fn a_grid_of_wishes_is_met() {
    let mut met = 0;
    for speed in [20.0, 45.0, 60.0, 80.0] {
        for unevenness in [0.001, 0.01, 0.03, 0.09, 0.3] {
            for characteristic in ["kloss", "linear"] {
                for direction in ["ccw", "cw"] {
                    for place in ["crank", "motor"] {
                        let text = scene("shaper-drive")
                            .replace("60 rpm", &format!("{speed} rpm"))
                            .replace("unevenness = 0.05", &format!("unevenness = {unevenness}"))
                            .replace("\"kloss\"", &format!("\"{characteristic}\""))
                            .replace(
                                "positions = 48",
                                &format!("positions = 48\ndirection = \"{direction}\""),
                            )
                            .replace("flywheel_on = \"crank\"", &format!("flywheel_on = \"{place}\""));
                        let (linkage, loads) = compiled(&text);
                        match steady(&linkage, &loads, None) {
                            Ok(found) => {
                                let regime = &found.regime;
                                let wanted = speed * std::f64::consts::PI / 30.0;
                                assert_relative_eq!(
                                    regime.figures.mean_speed.abs(),
                                    wanted,
                                    max_relative = 1e-9
                                );
                                if regime.flywheel_needless {
                                    assert!(regime.figures.unevenness <= unevenness);
                                } else {
                                    assert_relative_eq!(
                                        regime.figures.unevenness,
                                        unevenness,
                                        max_relative = 1e-9
                                    );
                                }
                                met += 1;
                            }
                            Err(error) => eprintln!(
                                "{speed} {unevenness} {characteristic} {direction} {place}: {error}"
                            ),
                        }
                    }
                }
            }
        }
    }
    assert_eq!(met, 160);
}

/// A chosen motor is the first of those that have the power, in their order, that does its work without being overloaded.
#[test]
fn a_chosen_motor_is_fit_for_its_work() {
    let (mut passed_over, mut told, mut suitable) = (0, 0, 0);
    for catalogue in ["4A", "AIR"] {
        for speed in ["1000 rpm", "1500 rpm", "3000 rpm"] {
            let given = |motor: &str| {
                let scene = scene("shaper-drive");
                let (before, rest) = scene.split_once("motor = {").unwrap();
                let (_, after) = rest.split_once('\n').unwrap();
                let drive = format!(
                    "motor = \"{motor}\"\ncatalogue = \"{catalogue}\"\nmax_motor_speed = \"{speed}\"\n"
                );
                let (linkage, loads) = compiled(&format!("{before}{drive}{after}"));
                steady(&linkage, &loads, None).map(|found| found.motor.unwrap())
            };
            let chosen = given("auto").unwrap();
            assert!(is_fit(&chosen), "{catalogue} {speed}: {:?}", chosen.warnings);
            // What is told to be suitable beside it starts the load in a regime of its own.
            let stalls = |motor: &SteadyMotor| {
                let reasons = motor.warnings.iter().filter_map(|warning| warning.unfit.as_ref());
                reasons.into_iter().any(|why| why.identity() == Some("motor-passed-start"))
            };
            for other in chosen.runners_up.iter().take(8) {
                let starts = given(&other.motor.designation).is_ok_and(|found| !stalls(&found));
                assert!(starts, "{catalogue} {speed}: {}", other.motor.designation);
                suitable += 1;
            }
            let power = chosen.motor.rated_power;
            for passed in &chosen.passed_over {
                assert!(passed.motor.rated_power <= power, "{passed:?}");
                let why = passed.why.identity().unwrap_or_default();
                let tried =
                    ["motor-passed-hot", "motor-passed-start", "motor-beyond-breakdown"].contains(&why);
                let again = given(&passed.motor.designation);
                assert!(!tried || again.is_ok_and(|other| !is_fit(&other)), "{passed:?}");
                told += usize::from(tried);
            }
            let all = assur_motor::list_motors(
                &assur_motor::catalogues().unwrap(),
                &assur_motor::MotorFilter {
                    catalogue: Some(catalogue.to_owned()),
                    min_power: Some(497.4),
                    max_power: Some(0.999 * power),
                    ..assur_motor::MotorFilter::default()
                },
            );
            let limit =
                assur_motor::rad_per_s(speed.split_once(' ').unwrap().0.parse().unwrap()) * (1.0 + 1e-9);
            let known = |motor: &&&assur_motor::Motor| {
                motor.max_torque_ratio.is_some() && motor.synchronous_speed <= limit
            };
            for smaller in all.unwrap().iter().filter(known) {
                let other = given(&smaller.designation);
                assert!(!other.is_ok_and(|other| is_fit(&other)), "{} is fit", smaller.designation);
                passed_over += 1;
            }
        }
    }
    assert!(passed_over > 0 && told > 0 && suitable > 0);
}
