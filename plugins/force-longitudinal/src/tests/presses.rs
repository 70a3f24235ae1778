//! Other presses of the same kind: every method of forces agrees with the equations as printed.

use assur_force::{Reactions, find};
use assur_force_groups as _;
use assur_force_newton_euler as _;
use assur_force_virtual_power as _;

use super::press::Press;
use super::{compile, difference, fixture, reactions};

/// The press of the fixture with another contact angle (degrees), radius (mm), coefficient of friction and direction.
fn scene(angle: f64, radius: f64, friction: f64, direction: &str) -> String {
    let (from, to) = if direction == "cw" { (-70, -110) } else { (-110, -70) };
    fixture("press.toml")
        .replace("radius = \"750 mm\"", &format!("radius = \"{radius} mm\""))
        .replace("angle = \"4 deg\"", &format!("angle = \"{angle} deg\""))
        .replace("friction = 0.1 ", &format!("friction = {friction} "))
        .replace("from = \"-70 deg\"", &format!("from = \"{from} deg\""))
        .replace("to = \"-110 deg\"", &format!("to = \"{to} deg\""))
        .replace("direction = \"cw\"", &format!("direction = \"{direction}\""))
}

#[test]
fn all_methods_agree_with_the_print_whatever_the_contact() {
    let mut compared = 0;
    for angle in [-6.0, 0.0, 4.0, 11.0] {
        for (radius, friction) in [(600.0, 0.1), (750.0, -0.2), (800.0, 0.0), (900.0, 0.35)] {
            for direction in ["cw", "ccw"] {
                let linkage = compile(&scene(angle, radius, friction, direction));
                let press = Press {
                    crank: 0.04,
                    rod: 0.16,
                    center: 0.64,
                    radius: 1e-3 * radius,
                    force: 20e3,
                    friction,
                };
                for index in (0..linkage.mechanism.input.positions).step_by(4) {
                    let q = linkage.mechanism.input.coordinate(index);
                    let printed = press.at(q + std::f64::consts::FRAC_PI_2, 2.0 * angle.to_radians());
                    let by = |name: &str| -> Reactions {
                        reactions(find(name).unwrap().instance, &linkage, q).unwrap()
                    };
                    let whole = by("newton-euler");
                    let at = format!("{angle} {radius} {friction} {direction} {index}");
                    for name in ["groups", "longitudinal", "longitudinal-published"] {
                        let apart = difference(&linkage, &by(name), &whole);
                        assert!(apart < 1e-10, "{at} {name}: {apart}");
                    }
                    for name in ["newton-euler", "virtual-power"] {
                        let apart = (by(name).balancing + printed.balancing).abs();
                        assert!(apart < 1e-10 * 20e3 * 0.16, "{at} {name}: {apart}");
                    }
                    compared += 1;
                }
            }
        }
    }
    assert_eq!(compared, 4 * 4 * 2 * 9);
}

/// A scene whose numbers were not replaced would prove nothing.
#[test]
fn the_presses_differ() {
    let [one, two] = [scene(4.0, 750.0, 0.1, "cw"), scene(11.0, 900.0, -0.2, "ccw")];
    let differ = one.lines().zip(two.lines()).filter(|(one, two)| one != two).count();
    assert_eq!(differ, 6, "from, to, direction, radius, angle, friction");
}
