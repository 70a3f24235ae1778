use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use proptest::prelude::*;

use crate::search::{bisect, least, root, try_bisect, try_least, try_newton_root};

#[test]
fn bisection_ends_at_neighbors_in_either_order() {
    let [below, above] = bisect(0.0, 9.0, 0.0, |x| x * x < 2.0);
    assert_eq!(above.to_bits(), below.to_bits() + 1);
    assert!(below <= SQRT_2 && SQRT_2 <= above);
    assert_eq!(bisect(9.0, 0.0, 0.0, |x| x * x >= 2.0).map(f64::to_bits), [above, below].map(f64::to_bits));
}

#[test]
fn bisection_to_a_width_asks_no_more_than_needed() {
    let asked = Cell::new(0);
    let [below, above] = bisect(0.0, 1.0, 1e-3, |x| {
        asked.set(asked.get() + 1);
        x < 0.3
    });
    assert!(below < 0.3 && 0.3 <= above && above - below <= 1e-3);
    assert_eq!(asked.get(), 10);
}

#[test]
fn bisection_ends_between_the_greatest_numbers_and_at_zero() {
    assert!(bisect(f64::MIN, f64::MAX, 0.0, |x| x < 1.0)[1] >= 1.0);
    assert!(bisect(-1.0, 1.0, 0.0, |x| x < 0.0)[1].abs() < f64::MIN_POSITIVE);
}

#[test]
fn the_first_error_ends_a_search() {
    assert_eq!(try_bisect(0.0, 1.0, 0.0, |x| if x > 0.6 { Err("far") } else { Ok(true) }), Err("far"));
    assert_eq!(
        try_newton_root(0.0, 1.0, |x| if x < 1.0 { Err("near") } else { Ok((1.0, 1.0)) }),
        Err("near")
    );
    assert_eq!(try_least(0.0, 1.0, 5, |_| Err::<f64, _>("none")), Err("none"));
}

#[test]
fn newton_is_exact_even_where_it_is_thrown_out_of_the_bracket() {
    let cube = |x: f64| Ok::<_, ()>((x * x * x - 2.0, 3.0 * x * x));
    assert!((try_newton_root(-5.0, 9.0, cube).unwrap() - 2.0_f64.cbrt()).abs() <= 2.0 * f64::EPSILON);
    // A root in the end of the bracket.
    let end = |x: f64| Ok::<_, ()>((x * x - 4.0, 2.0 * x));
    assert!((try_newton_root(0.5, 2.0, end).unwrap() - 2.0).abs() < f64::EPSILON);
    // No slope given: bisection alone.
    let line = |x: f64| Ok::<_, ()>((0.3 - x, 0.0));
    assert!((try_newton_root(-5.0, 9.0, line).unwrap() - 0.3).abs() <= 2.0 * f64::EPSILON);
}

#[test]
fn a_minimum_is_found_to_the_root_of_rounding() {
    let (at, value) = least(0.0, PI, 90, |x| -x.sin());
    assert!((at - FRAC_PI_2).abs() < 3e-8 && value + 1.0 < 1e-15, "{at}");
    // A minimum with a corner is found to rounding.
    assert!((least(0.0, 1.0, 90, |x| (x - 0.3).abs()).0 - 0.3).abs() < 1e-15);
}

proptest! {
    #[test]
    fn a_root_lies_within_its_width(wanted in -3.0..3.0_f64, steep in 0.1..50.0_f64, turned: bool) {
        let f = |x: f64| (steep * (wanted - x)).sinh();
        let found = if turned { root(5.0, -5.0, 1e-14, |x| -f(x)) } else { root(-5.0, 5.0, 1e-14, f) };
        prop_assert!((found - wanted).abs() <= 1e-13, "{found} instead of {wanted}");
    }
}
