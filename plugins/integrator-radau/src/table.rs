//! Coefficients of Radau IIA with three stages, from the square root of 6 (Hairer, Wanner II, IV.5, table 5.6).

use nalgebra::{Matrix3, Vector3};

/// √6.
const R: f64 = 2.449_489_742_783_178;

/// Nodes.
pub(crate) const C: Vector3<f64> = Vector3::new((4.0 - R) / 10.0, (4.0 + R) / 10.0, 1.0);

/// Stages; the last row is the solution.
pub(crate) const A: Matrix3<f64> = Matrix3::new(
    (88.0 - 7.0 * R) / 360.0,
    (296.0 - 169.0 * R) / 1800.0,
    (-2.0 + 3.0 * R) / 225.0,
    (296.0 + 169.0 * R) / 1800.0,
    (88.0 + 7.0 * R) / 360.0,
    (-2.0 - 3.0 * R) / 225.0,
    (16.0 - R) / 36.0,
    (16.0 + R) / 36.0,
    1.0 / 9.0,
);

/// Real eigenvalue of the inverse of [`A`]: 30/(6 + 81^(1/3) - 9^(1/3)).
pub(crate) const GAMMA: f64 = 3.637_834_252_744_496;

/// Weights of the stage increments in the error of order 3 (IV.8, with γ0 = 1/[`GAMMA`]).
pub(crate) const E: Vector3<f64> = Vector3::new(-(13.0 + 7.0 * R) / 3.0, (-13.0 + 7.0 * R) / 3.0, -1.0 / 3.0);
