//! Pose of a link and its derivatives.

use assur_number::{Lanes, Real};

use crate::plane::is_zero;

/// Pose of a link (PF0) and its first and second derivatives with respect to the input coordinate (PF1, PF2).
///
/// The direction of the link's x axis is a unit vector, not an angle. Derivatives are per unit of the coordinate:
/// per rad, or per m for a sliding input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body<T> {
    /// Origin of the link's frame, x, m.
    pub x: T,
    /// Origin of the link's frame, y, m.
    pub y: T,
    /// Cosine of the angle of the link's x axis.
    pub c: T,
    /// Sine of that angle.
    pub s: T,
    /// dx/dq.
    pub x1: T,
    /// dy/dq.
    pub y1: T,
    /// d(angle)/dq.
    pub w1: T,
    /// d²x/dq².
    pub x2: T,
    /// d²y/dq².
    pub y2: T,
    /// d²(angle)/dq².
    pub w2: T,
}

impl<T: Copy> Body<T> {
    /// All numbers of the body, in the order of its fields.
    #[inline(always)]
    pub fn numbers(&self) -> [T; 10] {
        [self.x, self.y, self.c, self.s, self.x1, self.y1, self.w1, self.x2, self.y2, self.w2]
    }

    /// A body from all its numbers, in the order of its fields.
    #[inline(always)]
    pub fn of_numbers([x, y, c, s, x1, y1, w1, x2, y2, w2]: [T; 10]) -> Self {
        Self { x, y, c, s, x1, y1, w1, x2, y2, w2 }
    }

    /// Pose and derivatives in another number type.
    #[inline(always)]
    pub fn map<U: Copy>(&self, number: impl FnMut(T) -> U) -> Body<U> {
        Body::of_numbers(self.numbers().map(number))
    }
}

impl Body<Lanes> {
    /// The body of one lane.
    pub fn lane(&self, lane: usize) -> Body<f64> {
        self.map(|number| number.0[lane])
    }

    /// Sets the body of one lane.
    pub fn set_lane(&mut self, lane: usize, body: &Body<f64>) {
        let mut numbers = self.numbers();
        for (all, one) in numbers.iter_mut().zip(body.numbers()) {
            all.0[lane] = one;
        }
        *self = Self::of_numbers(numbers);
    }
}

impl<T: Real> Body<T> {
    /// The ground: at the origin, at rest.
    pub fn ground() -> Self {
        Self { c: T::ONE, ..Self::of_numbers([T::ZERO; 10]) }
    }

    /// Arm from the origin of the link to a point of it, m: the point's vector in the link's frame, rotated into the
    /// ground's frame.
    #[inline(always)]
    pub fn arm(&self, at: [T; 2]) -> [T; 2] {
        [self.c * at[0] - self.s * at[1], self.s * at[0] + self.c * at[1]]
    }

    /// Position of a point of the link, m (PF0).
    #[inline(always)]
    pub fn point(&self, at: [T; 2]) -> [T; 2] {
        let [x, y] = self.arm(at);
        [self.x + x, self.y + y]
    }

    /// First derivative of a point whose arm is given (PF1).
    #[inline(always)]
    pub fn first(&self, arm: [T; 2]) -> [T; 2] {
        [self.x1 - self.w1 * arm[1], self.y1 + self.w1 * arm[0]]
    }

    /// Second derivative of a point whose arm is given (PF2).
    #[inline(always)]
    pub fn second(&self, arm: [T; 2]) -> [T; 2] {
        let square = self.w1 * self.w1;
        [self.x2 - self.w2 * arm[1] - square * arm[0], self.y2 + self.w2 * arm[0] - square * arm[1]]
    }

    /// First and second derivative of a point whose arm is given (PF1, PF2).
    #[inline(always)]
    pub fn motion(&self, arm: [T; 2]) -> [[T; 2]; 2] {
        [self.first(arm), self.second(arm)]
    }

    /// Origin of the link's frame, m.
    #[inline(always)]
    pub fn origin(&self) -> [T; 2] {
        [self.x, self.y]
    }

    /// Direction of the link's x axis turned by a fixed unit vector (cos, sin).
    #[inline(always)]
    pub fn turned(&self, by: [T; 2]) -> [T; 2] {
        self.arm(by)
    }

    /// Sets the direction of the link, and its origin such that the point `at` of the link is at `place`; returns the
    /// arm of that point.
    #[inline(always)]
    pub fn put(&mut self, direction: [T; 2], at: [T; 2], place: [T; 2]) -> [T; 2] {
        [self.c, self.s] = direction;
        let arm = self.arm(at);
        self.hang_place(arm, place);
        arm
    }

    /// Sets the origin such that the point with this arm is at this place.
    #[inline(always)]
    pub fn hang_place(&mut self, arm: [T; 2], pf0: [T; 2]) {
        self.x = pf0[0] - arm[0];
        self.y = pf0[1] - arm[1];
    }

    /// Sets the first derivative of the origin such that the point with this arm has this PF1.
    #[inline(always)]
    pub fn hang_first(&mut self, arm: [T; 2], pf1: [T; 2]) {
        self.x1 = pf1[0] + self.w1 * arm[1];
        self.y1 = pf1[1] - self.w1 * arm[0];
    }

    /// Sets the second derivative of the origin such that the point with this arm has this PF2.
    #[inline(always)]
    pub fn hang_second(&mut self, arm: [T; 2], pf2: [T; 2]) {
        let square = self.w1 * self.w1;
        self.x2 = pf2[0] + self.w2 * arm[1] + square * arm[0];
        self.y2 = pf2[1] - self.w2 * arm[0] + square * arm[1];
    }
}

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

/// What the reactions of a group are calculated from and written to.
#[derive(Debug)]
pub struct Forces<'a, T> {
    /// The load on each body, about the origin of its frame.
    pub loads: &'a mut [Wrench<T>],
    /// The reaction in each pair of the chain.
    pub reactions: &'a mut [Wrench<T>],
}

impl<'a, T> Forces<'a, T> {
    /// Each of several sets of loads with its reactions, which stand one after the other.
    #[inline(always)]
    pub fn sets(
        loads: &'a mut [Wrench<T>],
        reactions: &'a mut [Wrench<T>],
        sets: usize,
    ) -> impl Iterator<Item = Self> {
        // A division takes about as long as the reactions of a small group: one set goes without.
        let part = |all: usize| if sets > 1 { all / sets } else { all }.max(1);
        let (loaded, pairs) = (part(loads.len()), part(reactions.len()));
        let each = loads.chunks_mut(loaded).zip(reactions.chunks_mut(pairs));
        each.map(|(loads, reactions)| Self { loads, reactions })
    }
}

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

/// Order up to which transfer functions are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Places only (PF0).
    Place,
    /// Places and first derivatives (PF0, PF1).
    First,
    /// Places, first and second derivatives (PF0, PF1, PF2).
    Second,
}
