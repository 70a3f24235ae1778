//! The angle of a point against double-double, and at the borders of what it treats alike.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::elementary::atan2;
use crate::{Dd, Real};

/// The angle by Newton's method in 32 digits, twice from a guess by the standard library.
fn reference(y: f64, x: f64) -> Dd {
    let [x_dd, y_dd] = [x, y].map(Dd::from_f64);
    let length = (x_dd * x_dd + y_dd * y_dd).sqrt();
    let mut angle = Dd::from_f64(y.atan2(x));
    for _ in 0..2 {
        let (s, c) = angle.sin_cos();
        angle += (y_dd * c - x_dd * s) / length;
    }
    angle
}

/// Distance from a number to the next greater one in size.
fn ulp(value: f64) -> f64 {
    let size = value.abs();
    f64::from_bits(size.to_bits() + 1) - size
}

#[test]
fn an_angle_is_right_to_one_unit_in_the_last_place() {
    let mut worst: f64 = 0.0;
    let mut judge = |y: f64, x: f64| {
        let (found, wanted) = (atan2(y, x), reference(y, x));
        let off = (Dd::from_f64(found) - wanted).to_f64().abs() / ulp(wanted.hi);
        assert!(off <= 1.0, "atan2({y:e}, {x:e}) = {found:e}: {off} ulp");
        worst = worst.max(off);
    };
    for i in 0..60_000 {
        let angle = f64::from(i) * 0.618_033_988_749_894_9 * 2.0 * PI;
        // All sizes, and all ratios of both.
        let size = 10.0_f64.powi(i % 250 - 125);
        let flat = 10.0_f64.powi(-(i % 13));
        judge(size * angle.sin() * flat, size * angle.cos());
        judge(size * angle.sin(), size * angle.cos() * flat);
        // Beside the ends of the parts of the table.
        let t = (f64::from(i % 9) + 0.5 * f64::from(i / 9 % 2)) / 8.0
            * (1.0 + f64::from(i % 7 - 3) * f64::EPSILON);
        judge(t, 1.0);
        judge(-1.0, -t);
    }
    assert!(worst < 0.52, "{worst}");
}

#[test]
fn an_angle_of_axes_and_of_no_finite_point_is_that_of_the_standard_library() {
    let all = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        5e-324,
        -5e-324,
        f64::MAX,
        1e-300,
        1e-140,
    ];
    for y in all {
        for x in all {
            let (found, wanted) = (atan2(y, x), y.atan2(x));
            let same = found.to_bits() == wanted.to_bits() || (found.is_nan() && wanted.is_nan());
            assert!(
                same || (found - wanted).abs() <= ulp(wanted),
                "atan2({y:e}, {x:e}) = {found:e}, not {wanted:e}"
            );
        }
    }
    let exact = [(1.0, 1.0, FRAC_PI_4), (1.0, -1.0, 3.0 * FRAC_PI_4), (-2.0, 0.0, -FRAC_PI_2)];
    assert!(exact.iter().all(|(y, x, angle)| atan2(*y, *x).to_bits() == angle.to_bits()));
}
