//! Curvature of the path of a point.

use assur_group::plane::{cross, perp, plus, scaled};
use assur_kinematics::PointMotion;
use serde::Serialize;

/// Sine of the angle between PF1 and PF2 below which the path is straight there.
const STRAIGHT: f64 = 1e-13;

/// Curvature of the path of a point in one position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Curvature {
    /// Signed curvature, 1/m: positive where the path turns left while the coordinate grows.
    pub curvature: f64,
    /// The center of curvature, m; `None` where the path is straight.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub center: Option<[f64; 2]>,
}

impl Curvature {
    /// Curvature from the motion of a point; `None` where the point rests (`speed`: the greatest modulus of its PF1).
    pub fn of(motion: &PointMotion, speed: f64) -> Option<Self> {
        let [pf1, pf2] = [motion.pf1, motion.pf2];
        let size = pf1[0].hypot(pf1[1]);
        if size <= 1e-9 * speed {
            return None;
        }
        let turn = cross(pf1, pf2);
        if turn.abs() <= STRAIGHT * size * (pf2[0].hypot(pf2[1])).max(speed) {
            return Some(Self { curvature: 0.0, center: None });
        }
        let center = plus(motion.pf0, scaled(size * size / turn, perp(pf1)));
        Some(Self { curvature: turn / size.powi(3), center: Some(center) })
    }
}
