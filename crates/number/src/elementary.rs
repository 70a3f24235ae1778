//! Elementary functions of f64 that give the same bits on every machine.
//!
//! Those of the standard library are the C library's, whose last bits differ from one library to another, and so would rows of
//! a sweep that goes on elsewhere. Sine, cosine and the angle of a point are ours; the others are those of the crate `libm`,
//! which is plain Rust.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::Real;
use crate::dd::{quick_two_sum, split_product, two_sum};

pub use libm::{acos, asin, atan, exp, exp2, hypot, log as ln, pow as powf, tan};

/// Sine and cosine of an angle, rad.
#[inline(always)]
pub fn sin_cos(angle: f64) -> (f64, f64) {
    Real::sin_cos(angle)
}

/// Sine of an angle, rad.
#[inline]
pub fn sin(angle: f64) -> f64 {
    sin_cos(angle).0
}

/// Cosine of an angle, rad.
#[inline]
pub fn cos(angle: f64) -> f64 {
    sin_cos(angle).1
}

/// Parts of 1 at which the arc tangent is tabulated.
const PARTS: f64 = 8.0;

/// The arc tangents of 0, 1/8, ... 1, and what their rounding leaves.
const ANGLES: [[f64; 2]; 9] = [
    [0.0, 0.0],
    [0.124_354_994_546_761_44, -3.125_324_142_453_938_3e-18],
    [0.244_978_663_126_864_14, 1.069_875_561_873_445_1e-17],
    [0.358_770_670_270_572_25, -2.462_381_558_263_863_5e-17],
    [0.463_647_609_000_806_1, 2.269_877_745_296_168_7e-17],
    [0.558_599_315_343_562_4, -5.455_630_548_591_626_4e-18],
    [0.643_501_108_793_284_4, 1.583_478_505_144_428_6e-17],
    [0.718_829_999_621_624_5, -2.147_838_844_445_698_3e-17],
    [FRAC_PI_4, 0.5 * FRAC_PI_2_REST],
];

/// pi/2 and pi beyond their 16 digits.
const FRAC_PI_2_REST: f64 = 6.123_233_995_736_766e-17;
const PI_REST: f64 = 2.0 * FRAC_PI_2_REST;

/// Coefficients of the arc tangent of a small z: z + T[0] z³ + T[1] z⁵ + ...; 1/16 to the 17th power is below rounding.
const T: [f64; 7] = [-1.0 / 3.0, 1.0 / 5.0, -1.0 / 7.0, 1.0 / 9.0, -1.0 / 11.0, 1.0 / 13.0, -1.0 / 15.0];

/// Adding 2^52 and subtracting it again rounds a number between 0 and 2^51 to an integer.
const TO_INTEGER: f64 = 4_503_599_627_370_496.0;

/// The angle of the point (`x`, `y`), rad, between -pi and pi; its error is below one unit in the last place.
///
/// The tangent t = num/den of the angle from the nearer axis goes to the next tabulated one, c = k/8:
/// atan t = atan c + atan z, z = (num - c den)/(den + c num), which is at most 1/16 and is carried in two parts.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    /// Between these neither a product of two coordinates nor its rounding leaves the range of a number.
    const PLAIN: [f64; 2] = [1e-140, 1e150];
    let [long, short] = if x.abs() < y.abs() { [y.abs(), x.abs()] } else { [x.abs(), y.abs()] };
    if !(long < PLAIN[1] && short > PLAIN[0]) {
        return beyond(y, x);
    }
    let part = (PARTS * short / long + TO_INTEGER) - TO_INTEGER;
    let c = part / PARTS;
    // The half of `long` with few digits and the rest have exact products with c, and the differences are exact.
    let upper = f64::from_bits(long.to_bits() & 0xffff_ffff_f800_0000);
    let num = (short - c * upper) - c * (long - upper);
    let across = split_product(c, short);
    let den = two_sum(long, across.hi);
    let z = num / den.hi;
    let product = split_product(z, den.hi);
    let rest = (((num - product.hi) - product.lo) - z * (den.lo + across.lo)) / den.hi;
    let square = z * z;
    let series = T.iter().rev().fold(0.0, |sum, term| sum * square + term);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number from 0 to 8")]
    let [angle, angle_rest] = ANGLES[part as usize];
    let near = two_sum(angle, z);
    let left = near.lo + (angle_rest + (rest + z * square * series));
    let away = |turn: f64, turn_rest: f64, sign: f64| {
        let sum = quick_two_sum(turn, sign * near.hi);
        sum.hi + (sum.lo + (turn_rest + sign * left))
    };
    let found = match (x.abs() < y.abs(), x < 0.0) {
        (false, false) => near.hi + left,
        (false, true) => away(PI, PI_REST, -1.0),
        (true, false) => away(FRAC_PI_2, FRAC_PI_2_REST, -1.0),
        (true, true) => away(FRAC_PI_2, FRAC_PI_2_REST, 1.0),
    };
    found.copysign(y)
}

/// The angle of a point with a coordinate that is zero, extremely small or large, or not a finite number.
#[cold]
#[inline(never)]
fn beyond(y: f64, x: f64) -> f64 {
    /// A ratio of the coordinates below which the angle is that of an axis, or the ratio itself, up to rounding.
    const THIN: f64 = 1e-30;
    /// 2^600, by which the coordinates are divided or multiplied.
    const FACTOR: f64 = 4.149_515_568_880_993e180;
    let [long, short] = [x.abs().max(y.abs()), x.abs().min(y.abs())];
    if x.is_finite() && y.is_finite() && short > THIN * long {
        let factor = if long > 1.0 { FACTOR.recip() } else { FACTOR };
        return atan2(factor * y, factor * x);
    }
    libm::atan2(y, x)
}
