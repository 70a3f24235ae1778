//! Many wishes for one machine: each is met, or refused with a reason.

use approx::assert_relative_eq;

use assur_fixtures::scene;

use super::compiled;
use crate::steady;

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
