//! Derivatives, 32 digits, and where a formula is not positive.

use std::f64::consts::{FRAC_PI_2, PI};

use assur_number::{Dd, Real};

use super::read;

/// A formula and its derivative, both in text.
const KNOWN: [(&str, &str); 16] = [
    ("0.02 + 0.01*cos(q)", "-0.01*sin(q)"),
    ("3", "0"),
    ("q^3 - 2*q", "3*q^2 - 2"),
    ("(q - 4)^2", "2*(q - 4)"),
    ("q^2.5", "2.5*q^1.5"),
    ("2^q", "ln(2)*2^q"),
    ("q^q", "(ln(q) + 1)*q^q"),
    ("sin(2*q)/q", "2*cos(2*q)/q - sin(2*q)/q^2"),
    ("tan(q/9)", "(1 + tan(q/9)^2)/9"),
    ("asin(q/9)", "1/(9*sqrt(1 - (q/9)^2))"),
    ("acos(q/9)", "-1/(9*sqrt(1 - (q/9)^2))"),
    ("atan(3*q)", "3/(1 + 9*q^2)"),
    ("sqrt(1 + q^2)", "q/sqrt(1 + q^2)"),
    ("exp(-q^2/8)", "-q/4*exp(-q^2/8)"),
    ("ln(1 + q^2)", "2*q/(1 + q^2)"),
    ("1/(2 - cos(q))", "-sin(q)/(2 - cos(q))^2"),
];

/// The derivative of the known derivative is the second one.
#[test]
fn derivatives_over_time_are_those_of_the_known_ones() {
    for (text, derivative) in KNOWN {
        let (formula, derivative) = (read(&over_time(text)), read(derivative));
        for i in 1..80 {
            let t = 0.1 * f64::from(i);
            let [wanted, second] = derivative.with_slope(t);
            let [value, speed, acceleration] = formula.over_time(t);
            let near = |found: f64, wanted: f64| (found - wanted).abs() <= 1e-12 * (1.0 + wanted.abs());
            assert!(
                near(speed, wanted) && near(acceleration, second),
                "{text} at {t}: {acceleration} {second}"
            );
            assert_eq!(value.to_bits(), read(text).with_slope(t)[0].to_bits(), "{text}");
        }
    }
}

#[test]
fn derivatives_over_time_are_slopes() {
    for text in ["0.15 + 0.02*sin(pi*t/2)", "0.8 - 0.6*cos(3*t)", "exp(-t)*abs(t - 9)", "max(t^2, 1)*t"] {
        let (formula, step) = (read(text), 1e-4);
        for i in 11..60 {
            let t = 0.1 * f64::from(i) + 0.003;
            let [before, here, after] = [t - step, t, t + step].map(|t| formula.over_time(t));
            for of in [0, 1] {
                let wanted = (after[of] - before[of]) / (2.0 * step);
                assert!(
                    (here[of + 1] - wanted).abs() < 1e-6 * (1.0 + wanted.abs()),
                    "{text} at {t}: {here:?}"
                );
            }
        }
    }
}

/// The formula over the time in the place of the coordinate.
fn over_time(text: &str) -> String {
    text.replace("sqrt", "s_rt").replace('q', "t").replace("s_rt", "sqrt")
}

#[test]
fn slopes_are_derivatives() {
    for (text, derivative) in KNOWN {
        let (formula, derivative) = (read(text), read(derivative));
        for i in 1..80 {
            let q = 0.1 * f64::from(i);
            let [value, slope] = formula.with_slope(q);
            let wanted = [&formula, &derivative].map(|of| of.with_slope(q)[0]);
            let near = |found: f64, wanted: f64| (found - wanted).abs() <= 1e-13 * (1.0 + wanted.abs());
            assert!(near(value, wanted[0]) && near(slope, wanted[1]), "{text} at {q}: {slope} {wanted:?}");
        }
    }
}

/// Central differences in 32 digits, whose error is that of their step alone; and both ways to write a derivative agree in 32 digits.
#[test]
fn thirty_two_digits_are_kept() {
    let step = 1e-8;
    for (text, derivative) in KNOWN {
        let (formula, derivative) = (read(text), read(derivative));
        for i in 1..40 {
            let q = 0.2 * f64::from(i);
            let at = |off: f64| formula.precise(Dd::from_f64(q) + Dd::from_f64(off))[0];
            let difference = (at(step) - at(-step)) / Dd::from_f64(2.0 * step);
            let [value, slope] = formula.precise(Dd::from_f64(q));
            let exact = derivative.precise(Dd::from_f64(q))[0];
            let off = |one: Dd, other: Dd| (one - other).to_f64().abs();
            let size = 1.0 + slope.to_f64().abs() + value.to_f64().abs();
            assert!(
                off(slope, difference) < 1e-13 * size * size,
                "{text} at {q}: {}",
                off(slope, difference)
            );
            assert!(off(slope, exact) < 1e-28 * size * size, "{text} at {q}: {}", off(slope, exact));
            let double = formula.with_slope(q);
            assert!((value.to_f64() - double[0]).abs() < 1e-13 * size, "{text} at {q}");
        }
    }
}

#[test]
fn functions_of_thirty_two_digits_undo_each_other() {
    for text in
        ["ln(exp(q))", "exp(ln(q))", "tan(atan(q))", "asin(sin(q/9))*9", "acos(cos(q/9))*9", "(q^0.5)^2"]
    {
        for i in 1..60 {
            let q = 0.13 * f64::from(i);
            let found = read(text).precise(Dd::from_f64(q))[0];
            assert!((found - Dd::from_f64(q)).to_f64().abs() < 1e-28 * (1.0 + q), "{text} at {q}");
        }
    }
}

#[test]
fn a_zero_between_samples_is_found() {
    let range = [0.0, 2.0 * PI];
    for positive in
        ["0.02 + 0.01*cos(q)", "1e-9 + (q - 3)^2", "1 + q^2 - q", "exp(q) - q", "2 + sin(q)*cos(q)"]
    {
        assert_eq!(read(positive).not_positive_to(1e3, range), None, "{positive}");
    }
    let (at, value) = read("0.01 + 0.02*cos(q)").not_positive_to(1e3, range).unwrap();
    assert!((2.0 * FRAC_PI_2 / 1.5..=PI).contains(&at) && value <= 0.0, "{at} {value}");
    // Negative over a thousandth of the range, between two places of any coarse grid.
    let (at, value) = read("(q - 1.2345)^2 - 1e-5").not_positive_to(1e3, range).unwrap();
    assert!((at - 1.2345).abs() < 4e-3 && value <= 0.0, "{at} {value}");
    for bad in [
        "-1",
        "0",
        "1/0",
        "sqrt(q - 3)",
        "ln(q)",
        "cos(q) + 1 - 1e-12",
        "1001",
        "1e300^2",
        "1/(1.001 + cos(q))^2",
    ] {
        assert!(read(bad).not_positive_to(1e3, range).is_some(), "{bad}");
    }
}
