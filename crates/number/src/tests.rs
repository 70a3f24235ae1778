mod elementary;
mod search;
mod statistic;

use proptest::prelude::*;

use crate::{Dd, Intervals, Lanes, Real};

fn close(a: Dd, b: Dd, limit: f64) -> bool {
    (a - b).abs().to_f64() <= limit
}

#[test]
fn double_double_knows_32_digits_of_sqrt_2() {
    // sqrt 2 = 1.41421356237309504880168872420969807857; hi + lo of it.
    let root = Dd::from_f64(2.0).sqrt();
    assert!(close(root * root, Dd::from_f64(2.0), 1e-31));
    assert!((root.lo - -9.667_293_313_452_913e-17).abs() < 1e-31);
}

#[test]
fn sine_of_known_angles() {
    // sin(1) = 0.84147098480789650665250232163029899962256...; sin(1) - fl(sin(1)) from these digits.
    let (s, c) = Dd::ONE.sin_cos();
    let digits = Dd::from_f64(0.841_470_984_807_896_5);
    let rest = s - digits;
    // 0.84147098480789650665250232163029900 - 0.8414709848078965048756572286947630345821380615234375
    assert!((rest.to_f64() - 1.776_845_092_935_6e-18).abs() < 1e-30, "{rest:?}");
    assert!(close(s * s + c * c, Dd::ONE, 1e-31));
}

#[test]
fn a_nan_lane_is_not_hidden() {
    let x = Lanes([1.0, f64::NAN, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    assert!(x.least().is_nan() && x.greatest().is_nan());
    assert!(Lanes::from_f64(-1.0).sqrt().least().is_nan());
}

/// Angles of all sizes up to `limit`, and those closest to multiples of pi/4.
fn angles(limit: f64) -> impl Iterator<Item = f64> {
    let spread = (0..40_000).map(move |i| (f64::from(i) * 0.618_033_988_749_894_9).fract() * limit);
    let sizes = (-60..=30).flat_map(|power| {
        (0..40).map(move |i| (1.0 + (f64::from(i) * 0.754_877_666_246_692_8).fract()) * 2.0_f64.powi(power))
    });
    let eighths = (1..3000).chain((3000..2_000_000_000).step_by(999_983)).flat_map(move |i| {
        let eighth = (f64::from(i) * std::f64::consts::FRAC_PI_4).min(limit);
        [eighth, eighth.next_up(), eighth.next_down()]
    });
    spread
        .chain(sizes)
        .chain(eighths)
        .filter(move |angle| angle.abs() <= limit)
        .flat_map(|angle| [angle, -angle])
}

/// The difference of a number from its value in 32 digits, in units in the last place.
fn ulps(found: f64, exact: Dd) -> f64 {
    let value = exact.to_f64().abs();
    (Dd::from_f64(found) - exact).to_f64().abs() / (value.next_up() - value)
}

#[test]
fn sine_and_cosine_are_within_one_unit_in_the_last_place() {
    let mut greatest = 0.0_f64;
    // 1e9 rad is the greatest coordinate of a scene; beyond 2^30 rad every angle is reduced in 32 digits.
    for limit in [1.0, 7.0, 1e3, 1e9, 1e12] {
        for angle in angles(limit) {
            let (sine, cosine) = Real::sin_cos(angle);
            let (s, c) = Dd::from_f64(angle).sin_cos();
            let off = ulps(sine, s).max(ulps(cosine, c));
            assert!(off < 0.85, "{angle:e}: {off} units");
            greatest = greatest.max(off);
        }
    }
    assert!(greatest > 0.5, "no rounding at all: {greatest}");
    assert_eq!(Real::sin_cos(0.0_f64), (0.0, 1.0));
    for none in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (sine, cosine) = Real::sin_cos(none);
        assert!(sine.is_nan() && cosine.is_nan(), "{none}");
    }
}

#[test]
fn every_lane_has_the_sine_and_cosine_of_its_angle() {
    let mut all: Vec<f64> = angles(1e12).collect();
    all.extend([f64::NAN, f64::INFINITY, 0.0, -0.0, 1e300]);
    for shift in [0, 3] {
        for eight in all[shift..].chunks_exact(Lanes::WIDTH) {
            let (sine, cosine) = Lanes::of(|lane| eight[lane]).sin_cos();
            for (lane, angle) in eight.iter().enumerate() {
                let (s, c) = Real::sin_cos(*angle);
                assert!(sine.0[lane].to_bits() == s.to_bits() || s.is_nan() && sine.0[lane].is_nan());
                assert!(cosine.0[lane].to_bits() == c.to_bits() || c.is_nan() && cosine.0[lane].is_nan());
            }
        }
    }
}

proptest! {
    #[test]
    fn addition_theorem_holds_in_double_double(a in -300.0..300.0f64, b in -3.0..3.0f64) {
        let (sa, ca) = Dd::from_f64(a).sin_cos();
        let (sb, cb) = Dd::from_f64(b).sin_cos();
        let (s, c) = (Dd::from_f64(a) + Dd::from_f64(b)).sin_cos();
        prop_assert!(close(s, sa * cb + ca * sb, 1e-29));
        prop_assert!(close(c, ca * cb - sa * sb, 1e-29));
        prop_assert!((s.to_f64() - (a + b).sin()).abs() < 1e-13);
    }

    #[test]
    fn division_undoes_multiplication(a in -1e3..1e3f64, b in 0.1..1e3f64) {
        let (x, y) = (Dd::ratio(a, 3.0), Dd::ratio(b, 7.0));
        prop_assert!(close(x * y / y, x, 1e-28));
    }

    #[test]
    fn lanes_do_what_each_number_does(a in prop::array::uniform8(0.1..9.0f64), b in prop::array::uniform8(0.1..9.0f64)) {
        let x = (Lanes(a) * Lanes(b) + Lanes(a)) / Lanes(b) - Lanes(b).sqrt();
        for i in 0..Lanes::WIDTH {
            prop_assert_eq!(x.0[i].to_bits(), ((a[i] * b[i] + a[i]) / b[i] - b[i].sqrt()).to_bits());
        }
        prop_assert_eq!(Lanes(a).least().to_bits(), a.iter().copied().fold(f64::INFINITY, f64::min).to_bits());
    }

    #[test]
    fn intervals_enclose_what_their_numbers_give(
        a in prop::array::uniform8(-3.0..3.0f64),
        b in prop::array::uniform8(1.0..3.0f64),
        width in 0.0..0.9f64,
        part in -1.0..1.0f64,
    ) {
        /// Every operation.
        fn formula<T: Real>(a: T, b: T) -> [T; 4] {
            let (s, c) = a.sin_cos();
            [a * b - s, (a + b) / b, b.sqrt() * c.abs(), -(a - b).clamp_negative()]
        }
        let (x, y) = (Lanes(a), Lanes(b));
        let radius = Lanes::from_f64(width);
        let wide = formula(Intervals { middle: x, radius }, Intervals { middle: y, radius });
        let shift = Lanes::from_f64(width * part);
        for (enclosed, number) in wide.into_iter().zip(formula(x + shift, y - shift)) {
            for lane in 0..Lanes::WIDTH {
                let away = (number.0[lane] - enclosed.middle.0[lane]).abs();
                prop_assert!(away <= enclosed.radius.0[lane] + 1e-13, "{away} {enclosed:?}");
            }
        }
    }

    #[test]
    fn nothing_is_known_of_a_quotient_by_an_interval_with_zero_or_of_its_root(a in -0.5..0.5f64) {
        let wide = Intervals { middle: Lanes::from_f64(a), radius: Lanes::from_f64(0.5) };
        for unknown in [Intervals::ONE / wide, wide.sqrt()] {
            prop_assert!(!unknown.exceeds(f64::NEG_INFINITY));
        }
    }
}
