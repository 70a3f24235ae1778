//! Sine and cosine of an f64, by the same operations in every lane and on every machine.
//!
//! The argument is reduced by multiples of pi/2 in four parts (Cody and Waite), so that the rest keeps its digits; sine
//! and cosine of the rest are the polynomials of Sun's fdlibm. The result has an error below one unit in the last place.
//! There is no branch and no fused multiply-add: the compiler can put lanes side by side, and the bits are the same for
//! every set of instructions.

use crate::{Dd, Real};

/// Greatest angle of the quick reduction, rad: beyond it, multiples of the parts of pi/2 would be rounded.
const QUICK: f64 = 1_073_741_824.0;

/// pi/2 in four parts. The first three have 23 bits, so that their multiples up to 2^30 are exact.
const PARTS: [f64; 4] =
    [1.570_796_251_296_997, 7.549_789_415_861_596e-8, 5.390_302_529_957_765e-15, 3.282_003_542_873_500_5e-22];

/// Adding 1.5 * 2^52 and subtracting it again rounds to an integer.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// The error of the four parts for each multiple is about 2^-122: with a rest greater than this for each multiple,
/// it is no error of the result.
const CLOSEST: f64 = 1.355_252_715_606_880_5e-20;

/// Coefficients of the sine: x + S[0] x³ + S[1] x⁵ + ...
const S: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

/// Coefficients of the cosine: 1 - x²/2 + C[0] x⁴ + C[1] x⁶ + ...
const C: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine of an angle in rad, and whether they are right: if not, [`precise`] has to give them.
#[inline(always)]
pub(crate) fn quick(angle: f64) -> ([f64; 2], bool) {
    let count = (angle * std::f64::consts::FRAC_2_PI + TO_INTEGER) - TO_INTEGER;
    let near = (angle - count * PARTS[0]) - count * PARTS[1];
    let third = count * PARTS[2];
    let sum = near - third;
    let left = ((near - sum) - third) - count * PARTS[3];
    // rest + tail is the angle between -pi/4 and pi/4.
    let rest = sum + left;
    let tail = (sum - rest) + left;
    let is_right = (angle.abs() <= QUICK) & (rest.abs() >= (count * CLOSEST).abs());

    // Polynomials by pairs of terms, which takes less time than one term after the other.
    let square = rest * rest;
    let fourth = square * square;
    let upper = (S[1] + square * S[2]) + fourth * ((S[3] + square * S[4]) + fourth * S[5]);
    let cube = square * rest;
    let sine = rest - ((square * (0.5 * tail - cube * upper) - tail) - cube * S[0]);
    let half = 0.5 * square;
    let lower = (C[0] + square * C[1]) + fourth * ((C[2] + square * C[3]) + fourth * (C[4] + square * C[5]));
    let first = 1.0 - half;
    let cosine = first + (((1.0 - first) - half) + (fourth * lower - rest * tail));

    // The part of a turn by quarters, 0 to 3/4: (s, c), (c, -s), (-s, -c), (-c, s). Sine and cosine go through the same
    // operations, so that the compiler writes both by one instruction, which whoever reads both does not have to wait for.
    let turns = count * 0.25;
    let part = turns - ((turns - 0.375 + TO_INTEGER) - TO_INTEGER);
    let is_odd = ((part - 0.5).abs() - 0.25).abs() < 0.125;
    let signed = |even: f64, odd: f64, middle: f64| {
        let number = if is_odd { odd } else { even };
        if (part - middle).abs() < 0.3 { -number } else { number }
    };
    ([signed(sine, cosine, 0.75), signed(cosine, sine, 0.375)], is_right)
}

/// Sine and cosine by way of 32 digits, for angles that are very large or extremely close to a multiple of pi/2.
#[cold]
#[inline(never)]
pub(crate) fn precise(angle: f64) -> [f64; 2] {
    /// Beyond it, rad, 32 digits leave less than 16 of the part of a turn; `libm` reduces any angle.
    const GREATEST: f64 = 1e15;
    if angle.abs() > GREATEST {
        return [libm::sin(angle), libm::cos(angle)];
    }
    let (sine, cosine) = Dd::from_f64(angle).sin_cos();
    [sine.to_f64(), cosine.to_f64()]
}
