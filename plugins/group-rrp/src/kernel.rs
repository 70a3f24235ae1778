//! The closed forms of type 2.

use assur_group::plane::{dot, minus, mirrored, opposite, perp, plus, scaled, times};
use assur_group::{
    Anchor, Body, BuildError, ClosedForm, Forces, GroupError, GroupFrame, Order, PinJoint, SlideJoint,
};
use assur_number::Real;
use assur_words::text;

use crate::PATTERN;

/// Rounding of a length, in units of the last place, up to which the group can still be assembled.
const SLACK: f64 = 8.0;

/// One group RRP, with its lengths in the number type `T`.
#[derive(Debug, Clone)]
pub struct Rrp<T> {
    /// The rod, and the sliding link.
    pub(crate) links: [usize; 2],
    pub(crate) end: PinJoint<T>,
    pub(crate) inner: PinJoint<T>,
    pub(crate) slide: SlideJoint<T>,
    /// The outer pin on the rod, and the inner one on the sliding link.
    anchors: [Anchor<T>; 2],
    /// From the point of the slide to the inner pin, along and across the guide, m.
    lever: [T; 2],
    /// From the outer to the inner pin, in the frame of the rod, m.
    rod: [T; 2],
    /// Factor that turns this vector, rotated into the ground's frame, into the direction of the rod: mirrored vector
    /// / length².
    unrod: [T; 2],
    length: T,
    inverse_length: T,
    /// Height of the inner pin's line above the origin of the body with the guide, m.
    height: T,
    /// Rounding of a length, m.
    slack: f64,
    /// Size of the coordinates / length², 1/m: times `delta`, the effect of their rounding on the square of the
    /// determinant.
    sensitivity: T,
}

/// The right triangle of rod and guide in one position.
#[derive(Debug)]
pub struct Triangle<T> {
    /// A and C.
    pins: [[T; 2]; 2],
    /// Arm of A on the rod, and of C on the sliding link.
    arms: [[T; 2]; 2],
    /// Directions along and across the guide.
    t: [T; 2],
    n: [T; 2],
    /// C - A.
    r: [T; 2],
    /// Its components across and along the guide, and 1 / sigma.
    delta: T,
    sigma: T,
    inverse: T,
}

impl<T: Real> Rrp<T> {
    /// Directions along and across the guide.
    #[inline(always)]
    fn guide(&self, bodies: &[Body<T>]) -> [[T; 2]; 2] {
        let t = self.slide.guide(bodies);
        [t, perp(t)]
    }

    #[cold]
    fn refusal(&self, delta: T) -> GroupError {
        let gap_m = delta.abs().greatest() - self.length.to_f64();
        if gap_m.is_nan() { GroupError::Singular { health: gap_m } } else { GroupError::NoAssembly { gap_m } }
    }
}

impl<T: Real> ClosedForm<T> for Rrp<T> {
    type Position = Triangle<T>;
    const WAYS: usize = 2;

    fn new(frame: &GroupFrame) -> Result<Self, BuildError> {
        let group = PATTERN.read(frame)?;
        let end = PinJoint::<T>::new(&group.outer[0])?;
        let inner = PinJoint::<T>::new(&group.inner[0])?;
        let slide = SlideJoint::<T>::new(&group.outer[1])?;
        let rod = minus(inner.own, end.own);
        let square = dot(rod, rod);
        let length = square.sqrt();
        if length.to_f64().is_nan() || length.to_f64() <= 0.0 {
            return Err(BuildError::new(text!("group-rrp-no-rod")).of_link(group.links[0]));
        }
        let size = frame.scale.max(length.to_f64());
        Ok(Self {
            links: [group.links[0], group.links[1]],
            anchors: [end.own, inner.at].map(Anchor::new),
            end,
            inner,
            lever: slide.lever(inner.at),
            slide,
            rod,
            unrod: scaled(T::ONE / square, mirrored(rod)),
            length,
            inverse_length: T::ONE / length,
            height: slide.height() + slide.offset(inner.at),
            slack: SLACK * T::EPSILON * size,
            sensitivity: T::from_f64(size) / square,
        })
    }

    #[inline(always)]
    fn close(&self, bodies: &mut [Body<T>], way: usize) -> Result<Triangle<T>, GroupError> {
        let carrier = &bodies[self.slide.body];
        let [t, n] = self.guide(bodies);
        let a = self.end.place(bodies);
        let delta = dot(n, minus(carrier.origin(), a)) + self.height;
        let (ahead, behind) = (self.length - delta, self.length + delta);
        if !(ahead.at_least(-self.slack) && behind.at_least(-self.slack)) {
            return Err(self.refusal(delta));
        }
        let square = (ahead * behind).clamp_negative();
        let root = square.sqrt();
        let sigma = if way == 0 { root } else { -root };
        // sigma / sigma²: the division does not have to wait for the root.
        let inverse = sigma * (T::ONE / square);
        let r = plus(scaled(delta, n), scaled(sigma, t));
        let c = plus(a, r);
        let direction = self.slide.carried(bodies, self.slide.turn);
        let [rod, slider] = self.links;
        let arms = [
            self.anchors[0].put(&mut bodies[rod], times(r, self.unrod), a),
            self.anchors[1].put(&mut bodies[slider], direction, c),
        ];
        Ok(Triangle { pins: [a, c], arms, t, n, r, delta, sigma, inverse })
    }

    #[inline(always)]
    fn read(&self, bodies: &[Body<T>]) -> Triangle<T> {
        let [t, n] = self.guide(bodies);
        let [rod, slider] = [&bodies[self.links[0]], &bodies[self.links[1]]];
        let a = self.end.place(bodies);
        let r = rod.arm(self.rod);
        let arms = [self.anchors[0].arm(rod), self.anchors[1].arm(slider)];
        let sigma = dot(t, r);
        let inverse = T::ONE / sigma;
        Triangle { pins: [a, plus(a, r)], arms, t, n, r, delta: dot(n, r), sigma, inverse }
    }

    #[inline(always)]
    fn health(&self, position: &Triangle<T>) -> T {
        (position.sigma * self.inverse_length).abs()
    }

    #[inline(always)]
    fn determined(&self, position: &Triangle<T>) -> Result<(), GroupError> {
        let condition = self.sensitivity * position.delta;
        GroupError::if_lost(position.sigma * self.inverse_length, condition * condition)
    }

    #[inline(always)]
    fn differentiate(&self, bodies: &mut [Body<T>], position: &Triangle<T>, order: Order) -> T {
        let Triangle { pins, arms, t, n, r, delta, inverse, .. } = position;
        let [rod, slider] = self.links;
        let carrier = &bodies[self.slide.body];
        let [a1, a2] = self.end.motion(bodies, pins[0]);
        let [v, under] = self.slide.under(bodies, pins[1]);
        let (turning1, turning2) = (carrier.w1, carrier.w2);
        let relative = minus(v, a1);
        let w = dot(*n, relative) * *inverse;
        let c1 = plus(a1, scaled(w, perp(*r)));
        self.anchors[0].put_first(&mut bodies[rod], w, arms[0], a1);
        self.anchors[1].put_first(&mut bodies[slider], turning1, arms[1], c1);
        if order < Order::Second {
            return w;
        }
        let square = w * w;
        // C slides with t (C' - v) = -(t relative + w delta), which does not have to wait for C'.
        let sliding = dot(*t, relative) + w * *delta;
        let carried = dot(*n, minus(under, a2)) - turning1.twice() * sliding;
        let e = (carried + square * *delta) * *inverse;
        let c2 = minus(plus(a2, scaled(e, perp(*r))), scaled(square, *r));
        self.anchors[0].put_second(&mut bodies[rod], e, arms[0], a2);
        self.anchors[1].put_second(&mut bodies[slider], turning2, arms[1], c2);
        e
    }

    fn resolution(&self, _: &[Body<T>]) -> f64 {
        // The determinant is sqrt(ahead behind) / l; the factor that is not small is 2 l.
        (2.0 * self.slack * self.inverse_length.to_f64()).sqrt()
    }

    #[inline(always)]
    fn balance(&self, bodies: &[Body<T>], position: &Triangle<T>, forces: &mut Forces<'_, T>) -> T {
        let &Triangle { arms, t, n, delta, inverse, .. } = position;
        let [ahead, left] = self.lever;
        let [one, two] = [forces.loads[self.links[0]], forces.loads[self.links[1]]];
        // Along the guide the inner reaction balances link 2; the moment about A then gives the component across.
        let along = dot(t, two.force());
        let across = (delta * along - one.about(arms[0])) * inverse;
        let force = plus(scaled(along, t), scaled(across, n));
        self.inner.store(force, forces.reactions);
        self.end.hand_on(bodies, opposite(plus(one.force(), force)), forces);
        // The guide carries the rest of the load on link 2. The lever of the inner pin is one of the lengths, so a
        // large component across the guide adds no rounding where its lever is zero.
        let normal = across - dot(n, two.force());
        let on_line = bodies[self.links[1]].arm(self.slide.own);
        let moment = ahead * across - left * along - two.about(on_line);
        self.slide.hand_on(bodies, scaled(normal, n), moment, forces);
        across + normal
    }
}
