//! Poses of links in the plane.

use assur_group::plane::{direction, minus, mirrored, plus, times};
use assur_number::elementary;

/// Where the frame of a link lies in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Its origin, m.
    pub at: [f64; 2],
    /// Angle of its x axis, rad.
    pub angle: f64,
}

impl Pose {
    /// The frame of the ground.
    pub const GROUND: Self = Self { at: [0.0; 2], angle: 0.0 };

    /// The pose at an angle (rad) in which a point of the link, m in its frame, is at a place of the plane, m.
    pub fn putting(own: [f64; 2], place: [f64; 2], angle: f64) -> Self {
        Self { at: minus(place, times(own, direction(angle))), angle }
    }

    /// The place in the plane of a point of the link, m.
    pub fn point(&self, own: [f64; 2]) -> [f64; 2] {
        plus(self.at, times(own, direction(self.angle)))
    }

    /// The coordinates in the frame of the link of a place of the plane, m.
    pub fn local(&self, place: [f64; 2]) -> [f64; 2] {
        self.turned_back(minus(place, self.at))
    }

    /// A vector of the plane in the frame of the link.
    pub fn turned_back(&self, vector: [f64; 2]) -> [f64; 2] {
        times(vector, mirrored(direction(self.angle)))
    }
}

/// A line of the plane: a point on it, m, and its direction, rad.
pub(crate) type Line = ([f64; 2], f64);

/// Angle of a vector, rad.
pub(crate) fn angle_of([x, y]: [f64; 2]) -> f64 {
    elementary::atan2(y, x)
}

/// The point of a line that is nearest to a place.
pub(crate) fn foot((through, angle): Line, place: [f64; 2]) -> [f64; 2] {
    let along = direction(angle);
    plus(through, assur_group::plane::scaled(way((through, angle), place), along))
}

/// How far along a line a place lies, m.
pub(crate) fn way((through, angle): Line, place: [f64; 2]) -> f64 {
    assur_group::plane::dot(minus(place, through), direction(angle))
}

/// How far to the left of a line a place lies, m.
pub(crate) fn off((through, angle): Line, place: [f64; 2]) -> f64 {
    assur_group::plane::cross(direction(angle), minus(place, through))
}

/// Distance of two places, m.
pub(crate) fn distance(one: [f64; 2], other: [f64; 2]) -> f64 {
    assur_group::plane::length(minus(one, other))
}

/// Whether a point is the origin of its frame.
pub(crate) fn is_origin(own: [f64; 2]) -> bool {
    own.iter().all(|part| *part == 0.0)
}

/// An angle between -pi and pi, rad.
pub(crate) fn reduced(angle: f64) -> f64 {
    angle - std::f64::consts::TAU * (angle / std::f64::consts::TAU).round()
}
