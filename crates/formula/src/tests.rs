#![expect(clippy::float_cmp, reason = "values of small whole numbers, ends and infinities are exact")]

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;

use crate::{Formula, Variable, Variables};

fn read(text: &str) -> Formula {
    Formula::read(text).unwrap_or_else(|error| panic!("{text}: {error:?}"))
}

fn at(coordinate: f64, speed: f64, time: f64, place: f64) -> Variables {
    Variables { coordinate, speed, time, place }
}

#[test]
fn operators_bind_as_in_mathematics() {
    let value = |text: &str| read(text).value(&at(3.0, -2.0, 0.5, 0.25));
    for (text, wanted) in [
        ("1 + 2*3", 7.0),
        ("(1 + 2) * 3", 9.0),
        ("2^3^2", 512.0),
        ("-q^2", -9.0),
        ("2^-1", 0.5),
        ("8/4/2", 1.0),
        ("1-2-3", -4.0),
        ("- 2 * - 3", 6.0),
        ("1.5e3 + .5", 1500.5),
        ("max(q, w) - min(q, w)", 5.0),
        ("atan2(1, 0)", FRAC_PI_2),
        ("abs(w) + sign(w) + step(t) + step(w)", 2.0),
        ("sqrt(16) + ln(exp(2)) + 4*x", 7.0),
        ("asin(1) + acos(1) + atan(tan(0.3)) - pi/2", 0.3),
        ("sign(0)", 0.0),
        (" q*t ", 1.5),
    ] {
        assert!((value(text) - wanted).abs() < 1e-14, "{text}: {}", value(text));
    }
}

#[test]
fn faults_point_into_the_text() {
    for (text, span, part) in [
        ("", 0..0, "ends too early"),
        ("2*", 2..2, "ends too early"),
        ("1 + 1e999", 5..6, "does not fit"),
        ("2*(q + 1", 8..8, "missing"),
        ("2*speed", 2..7, "`speed` is unknown"),
        ("sin(q, w)", 0..3, "takes 1 argument, got 2"),
        ("5 + sin", 4..7, "takes 1 argument, got 0"),
        ("q(2)", 0..1, "takes 0 arguments, got 1"),
        ("2 $ 3", 2..3, "`$` does not fit"),
        ("3 q", 2..3, "`q` does not fit"),
        ("min(q)", 0..3, "takes 2 arguments"),
        ("(1))", 3..4, "`)` does not fit"),
        ("1 · 2", 2..4, "`·` does not fit"),
    ] {
        let error = Formula::read(text).unwrap_err();
        assert!(error.what.contains(part), "{text}: {error:?}");
        assert_eq!(error.span, span, "{text}: {error:?}");
    }
    for text in [
        "(".repeat(1900),
        "-".repeat(1900),
        "2^".repeat(900),
        format!("1{}", "+1".repeat(999)),
        "q".repeat(3000),
    ] {
        assert!(Formula::read(&text).is_err());
    }
}

#[test]
fn a_branch_continues_beyond_its_switch() {
    let formula = read("abs(q) + 3*step(w - 1) + min(q, 2)");
    let inside = at(1.0, 0.0, 0.0, 0.0);
    let branches = formula.branches(&inside);
    assert_eq!(formula.value_on(&inside, branches), formula.value(&inside));
    // Continued to q = -1 and w = 5: abs is q, step 0, min q.
    assert_eq!(formula.value_on(&at(-1.0, 5.0, 0.0, 0.0), branches), -2.0);
    assert_eq!(formula.switches().len(), 3);
    assert!(formula.switches()[1].used.speed && !formula.switches()[1].used.coordinate);
}

#[test]
fn the_next_switch_is_found_to_rounding() {
    let next =
        |text: &str, variable, from: Variables, along| read(text).smooth_until(0, &from, variable, along);
    let zero = at(0.1, 0.1, 0.1, 0.0);
    for (text, wanted) in [
        ("sign(sin(q))", PI),
        ("step(q - 123.456)", 123.456),
        ("abs(q^2 - 2)", 2.0_f64.sqrt()),
        ("max(q, 5 - q)", 2.5),
        ("sign(exp(q) - 10)", 10.0_f64.ln()),
        ("sign(cos(1000*q))", (0.1_f64 * 1000.0 / PI + 0.5).floor() * PI / 1000.0 + PI / 2000.0),
        ("sign(atan2(q - 3, 1))", 3.0),
        ("step(sqrt(q) - 2)", 4.0),
        ("step(1/q - 0.25)", 4.0),
    ] {
        let found = next(text, Variable::Coordinate, zero, 1.0);
        assert!((found - wanted).abs() <= 4.0 * f64::EPSILON * wanted, "{text}: {found} instead of {wanted}");
    }
    assert_eq!(next("sign(q*q + 1)", Variable::Coordinate, zero, 1.0), f64::INFINITY);
    assert_eq!(next("sign(w)", Variable::Speed, zero, -1.0), 0.0);
    assert_eq!(next("sign(w)", Variable::Speed, zero, 1.0), f64::INFINITY);
    assert!((next("step(t - 1e-3)", Variable::Time, at(0.0, 0.0, 0.0, 0.0), 1.0) - 1e-3).abs() < 1e-17);
    // From just behind a switch the next one is found, not the same again.
    let after = at(PI + 1e-12, 0.0, 0.0, 0.0);
    assert!((next("sign(sin(q))", Variable::Coordinate, after, 1.0) - 2.0 * PI).abs() < 1e-14);
    // A place that is only touched ends the branch too.
    assert!((next("abs((q - 1)^2)", Variable::Coordinate, zero, 1.0) - 1.0).abs() < 1e-6);
}

/// Formulas of random shape over q.
fn formulas() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![Just("q".to_owned()), (-3.0..3.0_f64).prop_map(|x| format!("({x:.3})"))];
    leaf.prop_recursive(4, 24, 2, |inner| {
        let functions = ["sin", "cos", "exp", "atan", "abs", "sign", "step", "sqrt", "ln", "tan"];
        prop_oneof![
            (inner.clone(), inner.clone(), prop::sample::select(vec!["+", "-", "*", "/"]))
                .prop_map(|(a, b, op)| format!("({a} {op} {b})")),
            (inner.clone(), prop::sample::select(functions.to_vec())).prop_map(|(a, f)| format!("{f}({a})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("max({a}, {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("min({a}, {b})")),
            inner.prop_map(|a| format!("({a})^2")),
        ]
    })
}

proptest! {
    /// No switch changes its side before the place that was found.
    #[test]
    fn nothing_changes_before_the_next_switch(text in formulas(), from in -2.0..2.0_f64) {
        let formula = read(&text);
        let start = at(from, 0.0, 0.0, 0.0);
        for switch in 0..formula.switches().len() {
            let side = formula.argument(switch, &start);
            if side.is_nan() { continue; }
            let end = formula.smooth_until(switch, &start, Variable::Coordinate, 1.0).min(from + 20.0);
            for i in 0..200 {
                let q = from + (end - from) * f64::from(i) / 200.0;
                let here = formula.argument(switch, &at(q, 0.0, 0.0, 0.0));
                prop_assert!(here * side >= 0.0 || here.is_nan() || here.abs() < 1e-12, "{text} {switch}: {q} before {end}");
            }
        }
    }

    #[test]
    fn nothing_makes_the_reader_panic(text in "[-q w(),.0-9+*/^sincoabm]{0,60}") {
        let _ = Formula::read(&text);
    }
}

/// With `-w` written for `w` a formula has the values of its mirror image, on each side of its switches.
#[test]
fn a_mirrored_formula_takes_the_opposite_speed() {
    for text in ["2*w + q", "min(w, 3) - abs(w - q)*sign(w*q)", "5 + step(2 - w)^2", "q"] {
        let (mirrored, written) = (read(text).mirrored(), read(&text.replace('w', "(-w)")));
        assert_eq!(mirrored.used(), written.used());
        for speed in [-4.0, -0.5, 0.0, 3.0] {
            let at = Variables { coordinate: 1.5, speed, ..Variables::default() };
            assert_eq!(mirrored.value(&at), written.value(&at), "{text} {speed}");
            assert_eq!(mirrored.branches(&at), written.branches(&at), "{text} {speed}");
        }
    }
}
