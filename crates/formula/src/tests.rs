#![expect(clippy::float_cmp, reason = "values of small whole numbers, ends and infinities are exact")]

mod slope;

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;

use crate::{Branches, Formula, Sign, Variable, Variables};

fn read(text: &str) -> Formula {
    Formula::read(text).unwrap_or_else(|error| panic!("{text}: {error:?}"))
}

fn at(coordinate: f64, speed: f64, time: f64, place: f64) -> Variables {
    Variables { coordinate, speed, time, place }
}

/// The sides of all switches at a place.
fn sides(formula: &Formula, at: &Variables) -> Branches {
    let mut found = Branches::default();
    for switch in 0..formula.switches().len() {
        let side = formula.side_ahead(switch, |_| *at).0;
        if let Some(side) = side {
            found.set(switch, side);
        }
    }
    found
}

/// Where a switch of a formula over one variable changes next.
fn next(formula: &Formula, switch: usize, from: f64, along: f64, at: impl Fn(f64) -> Variables) -> f64 {
    let side = Sign::of(formula.argument(switch, &at(from)));
    formula.smooth_until(switch, side, from, along, at)
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
        ("1 + 1e999*q", 4..9, "the number 1e999 is too large"),
        ("2*(q + 1", 8..8, "missing"),
        ("2*speed", 2..7, "`speed` is unknown"),
        ("sin(q, w)", 0..3, "takes 1 argument, got 2"),
        ("5 + sin", 4..7, "takes 1 argument, got 0"),
        ("q(2)", 0..1, "takes 0 arguments, got 1"),
        ("2 $ 3", 2..3, "`$` is out of place"),
        ("3 q", 2..3, "write `*`"),
        ("min(q)", 0..3, "takes 2 arguments"),
        ("(1))", 3..4, "`)` is out of place"),
        ("1 · 2", 2..4, "`·` is not allowed"),
    ] {
        let error = Formula::read(text).unwrap_err();
        assert!(error.to_string().contains(part), "{text}: {error:?}");
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
    let branches = sides(&formula, &inside);
    assert_eq!(formula.value_on(&inside, branches), formula.value(&inside));
    // Continued to q = -1 and w = 5: abs is q, step 0, min q.
    assert_eq!(formula.value_on(&at(-1.0, 5.0, 0.0, 0.0), branches), -2.0);
    assert_eq!(formula.switches().len(), 3);
    assert!(formula.switches()[1].used.speed && !formula.switches()[1].used.coordinate);
}

#[test]
fn the_next_switch_is_found_to_rounding() {
    let coordinate = |q: f64| at(q, 0.1, 0.1, 0.0);
    let speed = |w: f64| at(0.1, w, 0.1, 0.0);
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
        let found = next(&read(text), 0, 0.1, 1.0, coordinate);
        assert!((found - wanted).abs() <= 4.0 * f64::EPSILON * wanted, "{text}: {found} instead of {wanted}");
    }
    assert_eq!(next(&read("sign(q*q + 1)"), 0, 0.1, 1.0, coordinate), f64::INFINITY);
    assert_eq!(next(&read("sign(w)"), 0, 0.1, -1.0, speed), 0.0);
    assert_eq!(next(&read("sign(w)"), 0, 0.1, 1.0, speed), f64::INFINITY);
    assert!((next(&read("step(t - 1e-3)"), 0, 0.0, 1.0, |t| at(0.0, 0.0, t, 0.0)) - 1e-3).abs() < 1e-17);
    // From just behind a switch the next one is found, not the same again.
    assert!((next(&read("sign(sin(q))"), 0, PI + 1e-12, 1.0, coordinate) - 2.0 * PI).abs() < 1e-14);
    // A place that is only touched ends the branch too.
    assert!((next(&read("abs((q - 1)^2)"), 0, 0.1, 1.0, coordinate) - 1.0).abs() < 1e-6);
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
            let end = next(&formula, switch, from, 1.0, |q| at(q, 0.0, 0.0, 0.0)).min(from + 20.0);
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
            assert_eq!(sides(&mirrored, &at), sides(&written, &at), "{text} {speed}");
        }
    }
}

/// At a bend, also where it lies under a root, the formula has its own value, whichever side is given.
#[test]
fn a_formula_is_finite_at_its_bends() {
    for (text, place) in [
        ("sqrt(abs(cos(q)))", FRAC_PI_2),
        ("abs(sin(q))^1.5", PI),
        ("abs(sin(q))^0.3", PI),
        ("max(0, sin(q))^0.5", PI),
        ("sqrt(sign(cos(q))*cos(q))", FRAC_PI_2),
        ("sqrt(1 - sin(q)^2)", FRAC_PI_2),
        ("acos(cos(q)^2 + sin(q)^2)", 0.7),
        ("sqrt(0.1 + 0.2 - 0.3 - 1e-16)", 0.0),
    ] {
        let formula = read(text);
        for off in [-4e-16, 0.0, 4e-16] {
            let here = at(place + off, 0.0, 0.0, 0.0);
            let mut given = vec![formula.value(&here)];
            for side in [Sign::Negative, Sign::Positive] {
                let mut branches = Branches::default();
                for switch in 0..formula.switches().len() {
                    branches.set(switch, side);
                }
                given.push(formula.value_on(&here, branches));
            }
            // The third root of a rounding is the greatest of them.
            assert!(given.iter().all(|value| (0.0..4e-5).contains(&value.abs())), "{text}: {given:?}");
        }
    }
    assert!(!read("1/sin(q)").value(&at(0.0, 0.0, 0.0, 0.0)).is_finite());
    assert!(read("sqrt(-1e-10)").value(&at(0.0, 0.0, 0.0, 0.0)).is_nan());
    assert!(read("sign(sqrt(-1)) + max(1, sqrt(-1))").value(&at(0.0, 0.0, 0.0, 0.0)).is_nan());
}

/// The side of a switch on which the formula is just ahead of a zero of its argument.
#[test]
fn the_side_is_that_ahead() {
    use Sign::{Negative, Positive, Zero};
    for (text, place, behind, wanted) in [
        ("sign(sin(q))", PI, Positive, Negative),
        ("sign(sin(q))", 0.0, Negative, Positive),
        // What only touches zero is not zero identically, even where all digits are lost.
        ("sign(cos(q) - 1)", 0.0, Negative, Negative),
        ("step(1 - sin(q))", FRAC_PI_2, Positive, Positive),
        ("sign(abs(sin(q)))", PI, Positive, Positive),
        // What is zero over an interval is.
        ("sign(max(0, sin(q)))", PI, Positive, Zero),
        ("sign(max(0, sin(q)))", 0.0, Zero, Positive),
        ("sign(max(0, sin(q)))", -1e-5, Zero, Zero),
        ("sign(0)", 1.0, Zero, Zero),
        ("step(q - q)", 1.0, Zero, Zero),
        ("sign(sin(q)^2 + cos(q)^2 - 1)", 1.0, Zero, Zero),
        ("sign(sqrt(2)^2 - 2)", 1.0, Zero, Zero),
    ] {
        let formula = read(text);
        for (along, wanted) in [(-1.0, behind), (1.0, wanted)] {
            for off in [-4e-16, 0.0, 4e-16] {
                let path = |distance: f64| at(place + off + along * 1e-12 * distance, 0.0, 0.0, 0.0);
                let outer = formula.switches().len() - 1;
                assert_eq!(formula.side_ahead(outer, path).0, Some(wanted), "{text} {along} {off}");
            }
        }
    }
}

#[test]
fn a_range_of_zeros_is_passed_in_one_step() {
    let formula = read("sign(max(0, sin(q)))");
    let path = |q: f64| at(q, 0.0, 0.0, 0.0);
    assert!((next(&formula, 1, 4.0, 1.0, path) - 2.0 * PI).abs() < 1e-14);
    assert!((next(&formula, 1, 4.0, -1.0, path) - PI).abs() < 1e-14);
    assert_eq!(next(&read("step(q - q)"), 0, 4.0, 1.0, path), f64::INFINITY);
}

/// The bound of the rounding holds the difference from what the formula is in mathematics, and is no more than some thousand
/// times greater than the rounding of its terms.
#[test]
fn rounding_is_bounded() {
    /// A formula, what it is in mathematics, and the size of its terms.
    type Known = (&'static str, fn(f64) -> f64, f64);
    let pairs: [Known; 9] = [
        ("(q + 1e8) - 1e8", |q| q, 1e8),
        ("sqrt(q^2)", f64::abs, 1.0),
        ("exp(ln(q + 9))", |q| q + 9.0, 20.0),
        ("tan(atan(q))", |q| q, 10.0),
        ("(q + 1)^2 - q^2 - 2*q", |_| 1.0, 10.0),
        ("sin(q)/cos(q) - tan(q)", |_| 0.0, 1e3),
        ("max(q, q + 1e-9)/3*3 - 1e-9", |q| q, 10.0),
        ("atan2(sin(q), cos(q))", |q| q, 3.0),
        ("abs(sin(q + pi)) - abs(sin(q))", |_| 0.0, 3.0),
    ];
    for (text, exact, size) in pairs {
        let formula = read(text);
        for i in 0..1000 {
            let q = -1.5 + 3.0 * f64::from(i) / 999.0;
            let here = at(q, 0.0, 0.0, 0.0);
            let bound = formula.rounding(&here, Branches::default());
            let off = (formula.value(&here) - exact(q)).abs();
            assert!(off <= bound && bound <= 1e3 * f64::EPSILON * size, "{text} at {q}: {off} of {bound}");
        }
    }
    // Where the sum is zero, its terms are not.
    assert!(read("5*abs(sin(q))").rounding(&at(PI, 0.0, 0.0, 0.0), Branches::default()) > f64::EPSILON);
}

#[test]
fn changes_are_counted() {
    let count = |text: &str, most| {
        read(text).changes_between(0, [0.1, 0.1 + 2.0 * PI], most, |q| at(q, 0.0, 0.0, 0.0))
    };
    assert_eq!(count("sign(sin(q))", 10_000), 2);
    assert_eq!(count("sign(sin(50*q))", 10_000), 100);
    assert_eq!(count("sign(q^2 + 1)", 10_000), 0);
    assert_eq!(count("sign(sin(4999*q))", 10_000), 9_998);
    // Intervals don't show that these pass zero as seldom as they do.
    assert_eq!(count("step(q - q)", 10_000), 0);
    assert_eq!(count("min(cos(q), cos(q) + (2.6 - 2.6))", 10_000), 0);
    assert_eq!(count("max(exp(q)*sin(q), exp(q)*sin(q) + cos(q))", 10_000), 2);
    for text in ["sign(sin(6e3*q))", "abs(sin(1e6*q))", "step(tan(1e12*q))"] {
        assert_eq!(count(text, 10_000), 10_001, "{text}");
    }
}

/// The angle of a point jumps by a turn where the point passes the negative half of the axis.
#[test]
fn the_jump_of_an_angle_is_a_switch() {
    let formula = read("atan2(sin(q), cos(q))");
    for (along, wanted) in [(-1.0, PI), (1.0, -PI)] {
        let here = at(PI, 0.0, 0.0, 0.0);
        let side = formula.side_ahead(0, |distance| at(PI + along * 1e-12 * distance, 0.0, 0.0, 0.0)).0;
        let mut branches = Branches::default();
        if let Some(side) = side {
            branches.set(0, side);
        }
        assert!((formula.value_on(&here, branches) - wanted).abs() < 1e-15);
        // Continued smoothly.
        let on = |q: f64| formula.value_on(&at(q, 0.0, 0.0, 0.0), branches);
        assert!((on(PI + 0.1) - on(PI - 0.1) - 0.2).abs() < 1e-15);
    }
}

/// Along q = t, w = cos t, in stretches of a motion: what bounds show, and what the derivative shows where they don't.
#[test]
fn a_stretch_keeps_a_side_or_changes_it_once() {
    use Sign::{Negative, Positive};
    let stays = |text: &str, side: Sign, [from, to]: [f64; 2]| {
        let along = |name| match name {
            Variable::Time | Variable::Coordinate => [[from, to], [1.0; 2]],
            // Cosine falls up to a half turn.
            _ => [[to.cos(), from.cos()], [-1.0, -from.sin().min(to.sin())]],
        };
        let formula = read(text);
        // The outermost is read last.
        formula.stays(formula.switches().len() - 1, side, along, &at(to, to.cos(), to, f64::NAN))
    };
    assert_eq!(stays("sign(w + t)", Positive, [0.0, 1.0]), Some(true));
    assert_eq!(stays("sign(w - q)", Positive, [0.0, 0.7]), Some(true));
    // cos t = t at 0.739.
    assert_eq!(stays("sign(w - q)", Positive, [0.7, 0.8]), Some(false));
    assert_eq!(stays("max(w, t)", Positive, [0.7, 0.8]), Some(false));
    // It begins at zero.
    assert_eq!(stays("step(w - q - 1)", Negative, [0.0, 0.5]), Some(true));
    // Two changes, or a bend of the argument inside.
    assert_eq!(stays("sign(q*(1 - t) - 0.1)", Negative, [0.0, 1.5]), None);
    assert_eq!(stays("sign(abs(q - 0.5) - w + 0.6)", Positive, [0.3, 0.7]), None);
    // Identically zero but for rounding.
    assert_eq!(stays("sign(3*q - 2*t - t)", Sign::Zero, [0.2, 0.7]), Some(true));
}
