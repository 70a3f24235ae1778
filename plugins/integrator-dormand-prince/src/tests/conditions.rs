//! The coefficients against the conditions that define them.

use crate::dop853_table as eight;
use crate::dopri5 as five;

fn sum(row: &[f64]) -> f64 {
    row.iter().sum()
}

/// Σ b c^k = 1/(k+1).
fn quadrature(b: &[f64], c: &[f64], degree: i32) {
    for k in 0..=degree {
        let found: f64 = b.iter().zip(c).map(|(b, c)| b * c.powi(k)).sum();
        super::assert_close(found, 1.0 / f64::from(k + 1), 1e-13);
    }
}

/// Σ e c^k = 0 up to a degree, and not beyond it.
fn error_weights(e: &[f64], c: &[f64], degree: i32) {
    let moment = |k: i32| e.iter().zip(c).map(|(e, c)| e * c.powi(k)).sum::<f64>();
    for k in 0..=degree {
        super::assert_close(moment(k), 0.0, 1e-14);
    }
    assert!(moment(degree + 1).abs() > 1e-6, "the error would not be seen");
}

/// Σ b a c^k = 1/((k+1)(k+2)): the simplest conditions that bind the stages.
fn stages(rows: &[&[f64]], b: &[f64], c: &[f64], degree: i32) {
    for k in 0..=degree {
        let inner = |row: &[f64]| row.iter().zip(c).map(|(a, c)| a * c.powi(k)).sum::<f64>();
        let found: f64 = b[1..].iter().zip(rows).map(|(b, row)| b * inner(row)).sum();
        super::assert_close(found, 1.0 / f64::from((k + 1) * (k + 2)), 1e-13);
    }
}

fn with_zero<const N: usize>(c: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| if i == 0 { 0.0 } else { c[i - 1] })
}

#[test]
fn dopri5_table_meets_its_conditions() {
    for (row, c) in five::A.into_iter().zip(five::C) {
        super::assert_close(sum(row), c, 1e-14);
    }
    let c: [f64; 7] = with_zero(&five::C);
    quadrature(five::A[5], &c, 4);
    stages(&five::A, five::A[5], &c, 3);
    error_weights(&five::E, &c, 3);
}

#[test]
fn dop853_table_meets_its_conditions() {
    for (row, c) in eight::A.into_iter().zip(eight::C) {
        super::assert_close(sum(row), c, 2e-14);
    }
    let c: [f64; 12] = with_zero(&eight::C);
    quadrature(&eight::B, &c, 7);
    stages(&eight::A, &eight::B, &c, 6);
    error_weights(&eight::E5, &c, 4);
    let three = [c[0], c[8], c[11]];
    quadrature(&eight::B3, &three, 2);
}

#[test]
fn dop853_dense_output_has_its_order() {
    for (row, c) in eight::A_DENSE.into_iter().zip(eight::C_DENSE) {
        super::assert_close(sum(row), c, 1e-14);
    }
    let inner: [f64; 12] = with_zero(&eight::C);
    let mut c = [1.0; 16];
    c[..12].copy_from_slice(&inner);
    c[13..].copy_from_slice(&eight::C_DENSE);
    // The coefficients after the fourth vanish for whatever a cubic represents: slopes 1, t and t².
    for row in &eight::D {
        for k in 0..3 {
            let found: f64 = row.iter().zip(c).map(|(d, c)| d * c.powi(k)).sum();
            super::assert_close(found, 0.0, 1e-12);
        }
    }
}
