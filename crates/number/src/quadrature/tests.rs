//! Integrals against known ones.

use super::*;

fn of(known: &[f64], most: usize, value: impl Fn(f64) -> f64) -> Integrals {
    let rows = |places: &[f64; PLACES]| Some(places.iter().map(|at| [value(*at)]).collect());
    integrals(panels([0.0, 1.0], 4, known, 1e-14), 1e-12, most, rows).unwrap()
}

/// The finer rule integrates polynomials up to degree 22 exactly (Kronrod), the coarser one up to 13.
#[test]
fn polynomials_are_integrated_exactly() {
    for degree in 0..=22 {
        let rows = |places: &[f64; PLACES]| Some(places.iter().map(|at| [at.powi(degree)]).collect());
        let found = integrals([[0.0, 1.0]], 1.0, 0, rows).unwrap();
        assert!((found.values[0] * f64::from(degree + 1) - 1.0).abs() < 1e-14, "{degree}: {found:?}");
        assert!(degree > 13 || found.error < 1e-14, "{degree}: {found:?}");
    }
}

#[test]
fn a_corner_costs_nothing_where_it_is_known_and_is_found_where_it_is_not() {
    let peak = |x: f64| (0.01 - (x - 0.3137).abs()).max(0.0);
    let known = of(&[0.3037, 0.3137, 0.3237], 0, peak);
    assert!((known.values[0] / 1e-4 - 1.0).abs() < 1e-12 && known.error < 1e-16, "{known:?}");
    let found = of(&[], 1000, |x: f64| (x - 0.3137).abs());
    assert!((found.values[0] - 0.5 * (0.3137_f64.powi(2) + 0.6863_f64.powi(2))).abs() < 1e-12, "{found:?}");
}

/// What is not resolved is in the error.
#[test]
fn the_error_covers_what_is_missed() {
    let jump = |x: f64| f64::from(x > 0.3137);
    for most in [0, 3, 10, 1000] {
        let found = of(&[], most, jump);
        let missed = (found.values[0] - 0.6863).abs();
        assert!(missed <= found.error + 1e-14, "{most}: {missed} {found:?}");
    }
}

#[test]
fn without_a_value_there_is_no_integral() {
    let rows = |places: &[f64; PLACES]| (places[0] < 0.5).then(|| vec![[1.0]; PLACES]);
    assert_eq!(integrals([[0.0, 0.5], [0.5, 1.0]], 1e-9, 10, rows), None);
}
