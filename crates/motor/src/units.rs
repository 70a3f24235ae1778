//! The one unit that catalogues and people use beside SI.

use std::f64::consts::PI;

/// Speed in rad/s of a speed in 1/min.
pub fn rad_per_s(rpm: f64) -> f64 {
    rpm * PI / 30.0
}

/// Speed in 1/min of a speed in rad/s.
pub fn rpm(rad_per_s: f64) -> f64 {
    rad_per_s * 30.0 / PI
}
