use serde_json::Value;

use super::fixture;
use super::press::Press;

const PRESS: Press = Press {
    crank: 0.04,
    rod: 0.16,
    center: 0.06,
    radius: 0.3,
    alpha: 8.0 * std::f64::consts::PI / 180.0,
    force: 20e3,
    friction: 0.1,
};

#[test]
fn equations_as_printed_give_the_reference_of_the_press() {
    let file: Value = serde_json::from_str(&fixture("press.json")).unwrap();
    for position in file["positions"].as_array().unwrap() {
        let q = position["coordinate"].as_f64().unwrap();
        let answer = PRESS.at(std::f64::consts::FRAC_PI_2 - q);
        let force = |pin: &str| [0, 1].map(|k| position["reactions"][pin]["rod"][k].as_f64().unwrap());
        let (a, b) = (force("A"), force("B"));
        assert!((answer.ra - a[0].hypot(a[1])).abs() < 1e-7, "{q}");
        assert!((answer.r3 + b[0]).abs() < 1e-7, "{q}");
        assert!((answer.balancing - position["balancing"].as_f64().unwrap()).abs() < 1e-8, "{q}");
    }
}

#[test]
fn reaction_at_b_changes_its_sign_where_the_force_passes_through_a() {
    // With little friction the change lies within the interval of the press. F passes through A where the moment about A is
    // zero: r2 sin(gamma - theta) sqrt(1 + f^2) + R f = 0, gamma the angle of F, theta that of the rod.
    let press = Press { friction: 0.01, ..PRESS };
    let f = press.friction;
    let gamma = std::f64::consts::FRAC_PI_2 - (0.5 * press.alpha + f.atan());
    let theta = gamma + (press.radius * f / (press.center * f.hypot(1.0))).asin();
    let f1 = (-theta.cos() * press.rod / press.crank).asin();
    assert!(f1.abs() < 40.0_f64.to_radians());
    assert!(press.at(f1).r3.abs() < 1e-9 * press.force);
    assert!(press.at(f1 - 0.1).r3 * press.at(f1 + 0.1).r3 < 0.0);
}

#[test]
fn across_the_guide_the_print_has_no_answer() {
    // cos(pi/2) is not zero in binary, but nothing is left of the digits.
    let answer = PRESS.at(std::f64::consts::FRAC_PI_2);
    let near = PRESS.at(std::f64::consts::FRAC_PI_2 - 1e-3);
    assert!(!answer.r1.is_finite() || (answer.r1 - near.r1).abs() > 1e2, "{} {}", answer.r1, near.r1);
}
