//! The period of a pendulum by the arithmetic-geometric mean: independent of any integrator.

use std::f64::consts::PI;

/// Complete elliptic integral of the first kind K(k), modulus k below 1.
pub fn complete_elliptic(modulus: f64) -> f64 {
    let (mut a, mut g) = (1.0, (1.0 - modulus * modulus).sqrt());
    for _ in 0..10 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    0.5 * PI / a
}

/// Period of q'' = -sin q with that amplitude, rad.
pub fn pendulum_period(amplitude: f64) -> f64 {
    4.0 * complete_elliptic((0.5 * amplitude).sin())
}
