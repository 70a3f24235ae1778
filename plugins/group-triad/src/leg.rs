//! A leg: a link between the base and the plate, which takes one freedom of one against the other.
//!
//! Its condition is one equation, and its multiplier a force along one line, or a moment:
//!
//! | outer, inner | condition | line |
//! | --- | --- | --- |
//! | R, R | the pins keep their distance | through both pins |
//! | P, R | the pin of the plate stays on a line of the base | across the guide, through the pin |
//! | R, P | the pin of the base stays on a line of the plate | across the guide, through the pin |
//! | P, P | the plate keeps its angle to the base | a moment |

use assur_group::plane::{cross, dot, meet, minus, mirrored, perp, plus, scaled, times};
use assur_group::{Body, BuildError, PinJoint, SeenPair, SlideJoint, motion_at};
use assur_number::Real;
use assur_words::text;

/// The line of action of a leg, and by how much its condition is violated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line<T> {
    /// Direction of the force on the plate; zero for a moment.
    pub(crate) f: [T; 2],
    /// A point of the line, m.
    pub(crate) at: [T; 2],
    /// 1 for a moment.
    pub(crate) moment: T,
    /// Violation of the condition, m or rad; its derivative with respect to the motion of the plate is this line.
    pub(crate) gap: T,
}

impl<T: Real> Line<T> {
    pub(crate) const NONE: Self = Self { f: [T::ZERO; 2], at: [T::ZERO; 2], moment: T::ZERO, gap: T::ZERO };
}

/// A leg with its lengths.
#[derive(Debug, Clone)]
pub(crate) struct Leg<T> {
    pub(crate) link: usize,
    /// The bodies at its ends.
    base: usize,
    plate: usize,
    pub(crate) hold: Hold<T>,
}

/// Outer pair (with the base) and inner pair (with the plate), each with the leg as its own link.
#[derive(Debug, Clone)]
pub(crate) enum Hold<T> {
    Rr { outer: PinJoint<T>, inner: PinJoint<T>, rod: [T; 2], unrod: [T; 2], length: T },
    Pr { outer: SlideJoint<T>, inner: PinJoint<T>, offset: T },
    Rp { outer: PinJoint<T>, inner: SlideJoint<T>, offset: T },
    Pp { outer: SlideJoint<T>, inner: SlideJoint<T>, turn: [T; 2] },
}

impl<T: Real> Leg<T> {
    pub(crate) fn new(link: usize, outer: &SeenPair, inner: &SeenPair) -> Result<Self, BuildError> {
        let (base, plate) = (outer.pair.b, inner.pair.b);
        let hold = match (outer.pair.is_slide(), inner.pair.is_slide()) {
            (false, false) => {
                let (outer, inner) = (PinJoint::<T>::new(outer)?, PinJoint::<T>::new(inner)?);
                let rod = minus(inner.own, outer.own);
                let square = dot(rod, rod);
                let length = square.sqrt();
                if length.to_f64().is_nan() || length.to_f64() <= 0.0 {
                    return Err(BuildError::new(text!("group-triad-no-leg")).of_link(link));
                }
                Hold::Rr { outer, inner, rod, unrod: scaled(T::ONE / square, mirrored(rod)), length }
            }
            (true, false) => {
                let (outer, inner) = (SlideJoint::<T>::new(outer)?, PinJoint::<T>::new(inner)?);
                Hold::Pr { offset: outer.offset(inner.own), outer, inner }
            }
            (false, true) => {
                let (outer, inner) = (PinJoint::<T>::new(outer)?, SlideJoint::<T>::new(inner)?);
                Hold::Rp { offset: inner.offset(outer.own), outer, inner }
            }
            (true, true) => {
                let (outer, inner) = (SlideJoint::<T>::new(outer)?, SlideJoint::<T>::new(inner)?);
                Hold::Pp { turn: times(outer.turn, mirrored(inner.turn)), outer, inner }
            }
        };
        Ok(Self { link, base, plate, hold })
    }

    /// The sine of the angle between the guides of a leg of two slides, which is constant; 1 for others.
    pub(crate) fn spread(&self) -> T {
        match &self.hold {
            Hold::Pp { outer, inner, .. } => cross(outer.tilt, inner.tilt),
            _ => T::ONE,
        }
    }

    /// The joint of the plate in the frame of the plate, and that of the base in the frame of the base, m.
    pub(crate) fn ends(&self) -> [[T; 2]; 2] {
        match &self.hold {
            Hold::Rr { outer, inner, .. } => [inner.at, outer.at],
            Hold::Pr { outer, inner, .. } => [inner.at, outer.through],
            Hold::Rp { outer, inner, .. } => [inner.through, outer.at],
            Hold::Pp { outer, inner, .. } => [inner.through, outer.through],
        }
    }

    #[inline(always)]
    pub(crate) fn line(&self, bodies: &[Body<T>]) -> Line<T> {
        match &self.hold {
            Hold::Rr { outer, inner, length, .. } => {
                let at = inner.place(bodies);
                let r = minus(at, outer.place(bodies));
                let inverse = T::ONE / *length;
                let gap = ((dot(r, r) - *length * *length) * inverse).half();
                Line { f: scaled(inverse, r), at, moment: T::ZERO, gap }
            }
            Hold::Pr { outer, inner, offset } => {
                let (f, at) = (perp(outer.guide(bodies)), inner.place(bodies));
                let through = bodies[outer.body].point(outer.through);
                Line { f, at, moment: T::ZERO, gap: dot(f, minus(at, through)) - *offset }
            }
            Hold::Rp { outer, inner, offset } => {
                let (f, at) = (perp(inner.guide(bodies)), outer.place(bodies));
                let through = bodies[inner.body].point(inner.through);
                Line { f, at, moment: T::ZERO, gap: *offset - dot(f, minus(at, through)) }
            }
            Hold::Pp { outer, inner, turn } => {
                let plate = &bodies[inner.body];
                let gap = cross(outer.carried(bodies, *turn), [plate.c, plate.s]);
                Line { f: [T::ZERO; 2], at: plate.origin(), moment: T::ONE, gap }
            }
        }
    }

    /// PF1 and PF2 of the joint of the plate, seen from the point of the base under it, or from the pin of the base of two pins.
    #[inline(always)]
    fn relative(&self, bodies: &[Body<T>], line: &Line<T>) -> [[T; 2]; 2] {
        let from = match &self.hold {
            Hold::Rr { outer, .. } => outer.place(bodies),
            _ => line.at,
        };
        let (p, a) = (motion_at(bodies, self.plate, line.at), motion_at(bodies, self.base, from));
        [minus(p[0], a[0]), minus(p[1], a[1])]
    }

    /// Rate of the violation for the present PF1 of base and plate.
    #[inline(always)]
    pub(crate) fn first(&self, bodies: &[Body<T>], line: &Line<T>) -> T {
        match &self.hold {
            Hold::Pp { .. } => bodies[self.plate].w1 - bodies[self.base].w1,
            _ => dot(line.f, self.relative(bodies, line)[0]),
        }
    }

    /// Second derivative of the violation for the present PF1 and PF2 of base and plate.
    #[inline(always)]
    pub(crate) fn second(&self, bodies: &[Body<T>], line: &Line<T>) -> T {
        let [v, e] = self.relative(bodies, line);
        let guided = |carrier: usize| dot(line.f, e) - (bodies[carrier].w1 * cross(v, line.f)).twice();
        match &self.hold {
            Hold::Rr { length, .. } => dot(line.f, e) + dot(v, v) / *length,
            Hold::Pr { .. } => guided(self.base),
            Hold::Rp { .. } => guided(self.plate),
            Hold::Pp { .. } => bodies[self.plate].w2 - bodies[self.base].w2,
        }
    }

    /// Places the leg between base and plate.
    #[inline(always)]
    pub(crate) fn put(&self, bodies: &mut [Body<T>]) {
        match &self.hold {
            Hold::Rr { outer, inner, unrod, .. } => {
                let a = outer.place(bodies);
                let direction = unit(times(minus(inner.place(bodies), a), *unrod));
                bodies[self.link].put(direction, outer.own, a);
            }
            Hold::Pr { outer, inner, .. } => {
                let (direction, place) = (outer.carried(bodies, outer.turn), inner.place(bodies));
                bodies[self.link].put(direction, inner.own, place);
            }
            Hold::Rp { outer, inner, .. } => {
                let (direction, place) = (inner.carried(bodies, inner.turn), outer.place(bodies));
                bodies[self.link].put(direction, outer.own, place);
            }
            Hold::Pp { outer, inner, .. } => {
                let direction = outer.carried(bodies, outer.turn);
                let normals = [perp(outer.guide(bodies)), perp(inner.guide(bodies))];
                let [o, i] = [outer, inner].map(|slide| bodies[slide.body].point(slide.through));
                let arm = times(minus(inner.own, outer.own), direction);
                let place = meet(normals, [T::ZERO, dot(normals[1], minus(minus(i, o), arm))]);
                bodies[self.link].put(direction, outer.own, plus(o, place));
            }
        }
    }

    /// Sets PF1 (order 0) or PF2 (order 1) of the leg; for PF2 its PF1 is set.
    #[inline(always)]
    pub(crate) fn put_rates(&self, bodies: &mut [Body<T>], order: usize) {
        let turning = |carrier: usize| [bodies[carrier].w1, bodies[carrier].w2][order];
        let of_pin = |pin: &PinJoint<T>| pin.motion(bodies, pin.place(bodies))[order];
        let (rate, own, motion) = match &self.hold {
            Hold::Rr { outer, inner, rod, length, .. } => {
                let (r, a, p) = (bodies[self.link].arm(*rod), of_pin(outer), of_pin(inner));
                (cross(r, minus(p, a)) / (*length * *length), outer.own, a)
            }
            Hold::Pr { inner, .. } => (turning(self.base), inner.own, of_pin(inner)),
            Hold::Rp { outer, .. } => (turning(self.plate), outer.own, of_pin(outer)),
            Hold::Pp { outer, inner, .. } => {
                (turning(self.base), outer.own, self.crossing(bodies, [outer, inner], order))
            }
        };
        hang(&mut bodies[self.link], order, own, rate, motion);
    }

    /// PF1 or PF2 of the point on the outer guide of a leg of two slides.
    #[inline(always)]
    fn crossing(&self, bodies: &[Body<T>], slides: [&SlideJoint<T>; 2], order: usize) -> [T; 2] {
        let (body, base) = (&bodies[self.link], &bodies[self.base]);
        let places = slides.map(|slide| body.point(slide.own));
        let normals = slides.map(|slide| perp(slide.guide(bodies)));
        let apart = minus(places[1], places[0]);
        let under = [0, 1].map(|k| slides[k].under(bodies, places[k]));
        if order == 0 {
            let carried = scaled(base.w1, perp(apart));
            return meet(
                normals,
                [dot(normals[0], under[0][0]), dot(normals[1], minus(under[1][0], carried))],
            );
        }
        let w = body.w1;
        let [o, i] = [0, 1].map(|k| {
            let v = minus(body.first(minus(places[k], body.origin())), under[k][0]);
            dot(normals[k], under[k][1]) + (w * cross(v, normals[k])).twice()
        });
        let carried = minus(scaled(base.w2, perp(apart)), scaled(w * w, apart));
        meet(normals, [o, i - dot(normals[1], carried)])
    }
}

/// Sets PF1 (order 0) or PF2 (order 1) of a body from the rate of its angle and those of one of its points.
#[inline(always)]
pub(crate) fn hang<T: Real>(body: &mut Body<T>, order: usize, own: [T; 2], rate: T, motion: [T; 2]) {
    let arm = body.arm(own);
    if order == 0 {
        body.w1 = rate;
        body.hang_first(arm, motion);
    } else {
        body.w2 = rate;
        body.hang_second(arm, motion);
    }
}

/// A vector with the length 1.
#[inline(always)]
pub(crate) fn unit<T: Real>(a: [T; 2]) -> [T; 2] {
    scaled(T::ONE / dot(a, a).sqrt(), a)
}
