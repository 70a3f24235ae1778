//! Force and moment on a link.

use assur_number::{Lanes, Real};

/// A force (in the ground's frame) and a moment about a stated point, acting on a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrench<T> {
    /// Force along x, N.
    pub fx: T,
    /// Force along y, N.
    pub fy: T,
    /// Moment, N m, counter-clockwise positive. For loads it is about the origin of the link's frame; for reactions
    /// about the pin, or about the sliding link's point on the guide.
    pub m: T,
}

impl<T: Copy> Wrench<T> {
    /// Force and moment in another number type.
    pub fn map<U>(&self, number: impl Fn(T) -> U) -> Wrench<U> {
        Wrench { fx: number(self.fx), fy: number(self.fy), m: number(self.m) }
    }
}

impl Wrench<Lanes> {
    /// The wrench of one lane.
    pub fn lane(&self, lane: usize) -> Wrench<f64> {
        self.map(|number| number.0[lane])
    }

    /// Sets the wrench of one lane.
    pub fn set_lane(&mut self, lane: usize, wrench: &Wrench<f64>) {
        (self.fx.0[lane], self.fy.0[lane], self.m.0[lane]) = (wrench.fx, wrench.fy, wrench.m);
    }
}

impl<T: Real> Wrench<T> {
    /// No force and no moment.
    pub const ZERO: Self = Self { fx: T::ZERO, fy: T::ZERO, m: T::ZERO };

    /// Adds a moment, and a force that acts at `arm` (m, from the point of reference).
    #[inline(always)]
    pub fn add_at(&mut self, arm: [T; 2], force: [T; 2], moment: T) {
        self.fx += force[0];
        self.fy += force[1];
        self.m += moment + arm[0] * force[1] - arm[1] * force[0];
    }

    /// Moment about the point at `arm` from the point of reference.
    #[inline(always)]
    pub fn about(&self, arm: [T; 2]) -> T {
        self.m - arm[0] * self.fy + arm[1] * self.fx
    }

    /// The force as a vector.
    #[inline(always)]
    pub fn force(&self) -> [T; 2] {
        [self.fx, self.fy]
    }
}
