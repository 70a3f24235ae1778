//! The point of a link by which its pose is set.

use assur_number::Real;

use crate::Body;
use crate::plane::is_zero;

/// A point of a link whose motion is known first: the motion of the link follows from it and from the link's direction.
///
/// Most links have their origin there, which saves the arm.
#[derive(Debug, Clone, Copy)]
pub struct Anchor<T> {
    /// In the frame of the link, m.
    at: [T; 2],
    is_origin: bool,
}

impl<T: Real> Anchor<T> {
    /// A point in the frame of its link, m.
    pub fn new(at: [T; 2]) -> Self {
        Self { at, is_origin: is_zero(at) }
    }

    /// Arm from the origin of the link to the point, m.
    #[inline(always)]
    pub fn arm(&self, body: &Body<T>) -> [T; 2] {
        if self.is_origin { [T::ZERO; 2] } else { body.arm(self.at) }
    }

    /// Sets the direction of the link, and its origin such that the point is at `place`; returns the arm of the point.
    #[inline(always)]
    pub fn put(&self, body: &mut Body<T>, direction: [T; 2], place: [T; 2]) -> [T; 2] {
        if self.is_origin {
            [body.c, body.s] = direction;
            [body.x, body.y] = place;
            return [T::ZERO; 2];
        }
        body.put(direction, self.at, place)
    }

    /// Sets the first derivative of the link's angle, and that of its origin such that the point, with this arm, has this
    /// PF1.
    #[inline(always)]
    pub fn put_first(&self, body: &mut Body<T>, w1: T, arm: [T; 2], pf1: [T; 2]) {
        body.w1 = w1;
        if self.is_origin {
            [body.x1, body.y1] = pf1;
        } else {
            body.hang_first(arm, pf1);
        }
    }

    /// Sets the second derivative of the link's angle, and that of its origin such that the point, with this arm, has this
    /// PF2.
    #[inline(always)]
    pub fn put_second(&self, body: &mut Body<T>, w2: T, arm: [T; 2], pf2: [T; 2]) {
        body.w2 = w2;
        if self.is_origin {
            [body.x2, body.y2] = pf2;
        } else {
            body.hang_second(arm, pf2);
        }
    }
}
