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

use assur_group::plane::{cross, dot, minus, mirrored, perp, plus, scaled, times};
use assur_group::{Body, BuildError, PinJoint, SeenPair, SlideJoint};
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
    /// Violation of the condition, m or rad; its derivative by the motion of the plate is this line.
    pub(crate) gap: T,
}

impl<T: Real> Line<T> {
    pub(crate) const NONE: Self = Self { f: [T::ZERO; 2], at: [T::ZERO; 2], moment: T::ZERO, gap: T::ZERO };
}

/// A leg with its lengths.
#[derive(Debug, Clone)]
pub(crate) struct Leg<T> {
    /// The link.
    pub(crate) link: usize,
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
        Ok(Self { link, hold })
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

    /// Rate of the violation for the present PF1 of base and plate.
    #[inline(always)]
    pub(crate) fn first(&self, bodies: &[Body<T>], line: &Line<T>) -> T {
        match &self.hold {
            Hold::Rr { outer, inner, .. } => {
                let relative =
                    minus(inner.motion(bodies, line.at)[0], outer.motion(bodies, outer.place(bodies))[0]);
                dot(line.f, relative)
            }
            Hold::Pr { outer, inner, .. } => {
                dot(line.f, minus(inner.motion(bodies, line.at)[0], outer.under(bodies, line.at)[0]))
            }
            Hold::Rp { outer, inner, .. } => {
                dot(line.f, minus(inner.under(bodies, line.at)[0], outer.motion(bodies, line.at)[0]))
            }
            Hold::Pp { outer, inner, .. } => bodies[inner.body].w1 - bodies[outer.body].w1,
        }
    }

    /// Second derivative of the violation for the present PF1 and PF2 of base and plate.
    #[inline(always)]
    pub(crate) fn second(&self, bodies: &[Body<T>], line: &Line<T>) -> T {
        match &self.hold {
            Hold::Rr { outer, inner, length, .. } => {
                let (p, a) = (inner.motion(bodies, line.at), outer.motion(bodies, outer.place(bodies)));
                let (v, e) = (minus(p[0], a[0]), minus(p[1], a[1]));
                dot(line.f, e) + dot(v, v) / *length
            }
            Hold::Pr { outer, inner, .. } => {
                let (p, under) = (inner.motion(bodies, line.at), outer.under(bodies, line.at));
                let (v, e) = (minus(p[0], under[0]), minus(p[1], under[1]));
                dot(line.f, e) - (bodies[outer.body].w1 * cross(v, line.f)).twice()
            }
            Hold::Rp { outer, inner, .. } => {
                let (a, under) = (outer.motion(bodies, line.at), inner.under(bodies, line.at));
                let (v, e) = (minus(a[0], under[0]), minus(a[1], under[1]));
                (bodies[inner.body].w1 * cross(v, line.f)).twice() - dot(line.f, e)
            }
            Hold::Pp { outer, inner, .. } => bodies[inner.body].w2 - bodies[outer.body].w2,
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

    /// Sets PF1 of the leg.
    #[inline(always)]
    pub(crate) fn put_first(&self, bodies: &mut [Body<T>]) {
        let (w, own, motion) = match &self.hold {
            Hold::Rr { outer, inner, rod, length, .. } => {
                let r = bodies[self.link].arm(*rod);
                let a = outer.motion(bodies, outer.place(bodies))[0];
                let p = inner.motion(bodies, inner.place(bodies))[0];
                (cross(r, minus(p, a)) / (*length * *length), outer.own, a)
            }
            Hold::Pr { outer, inner, .. } => {
                (bodies[outer.body].w1, inner.own, inner.motion(bodies, inner.place(bodies))[0])
            }
            Hold::Rp { outer, inner, .. } => {
                (bodies[inner.body].w1, outer.own, outer.motion(bodies, outer.place(bodies))[0])
            }
            Hold::Pp { outer, inner, .. } => {
                let w = bodies[outer.body].w1;
                (w, outer.own, self.crossing_first(bodies, outer, inner, w))
            }
        };
        let body = &mut bodies[self.link];
        body.w1 = w;
        let arm = body.arm(own);
        body.hang_first(arm, motion);
    }

    /// PF1 of the point on the outer guide of a leg of two slides.
    #[inline(always)]
    fn crossing_first(
        &self,
        bodies: &[Body<T>],
        outer: &SlideJoint<T>,
        inner: &SlideJoint<T>,
        w: T,
    ) -> [T; 2] {
        let Crossing { normals, places, apart } = self.crossing(bodies, outer, inner);
        let [o, i] = [outer.under(bodies, places[0])[0], inner.under(bodies, places[1])[0]];
        meet(normals, [dot(normals[0], o), dot(normals[1], minus(i, scaled(w, perp(apart))))])
    }

    /// Sets PF2 of the leg; its PF1 is set.
    #[inline(always)]
    pub(crate) fn put_second(&self, bodies: &mut [Body<T>]) {
        let (e, own, motion) = match &self.hold {
            Hold::Rr { outer, inner, rod, length, .. } => {
                let r = bodies[self.link].arm(*rod);
                let a = outer.motion(bodies, outer.place(bodies))[1];
                let p = inner.motion(bodies, inner.place(bodies))[1];
                (cross(r, minus(p, a)) / (*length * *length), outer.own, a)
            }
            Hold::Pr { outer, inner, .. } => {
                (bodies[outer.body].w2, inner.own, inner.motion(bodies, inner.place(bodies))[1])
            }
            Hold::Rp { outer, inner, .. } => {
                (bodies[inner.body].w2, outer.own, outer.motion(bodies, outer.place(bodies))[1])
            }
            Hold::Pp { outer, inner, .. } => {
                let e = bodies[outer.body].w2;
                (e, outer.own, self.crossing_second(bodies, outer, inner, e))
            }
        };
        let body = &mut bodies[self.link];
        body.w2 = e;
        let arm = body.arm(own);
        body.hang_second(arm, motion);
    }

    /// PF2 of the point on the outer guide of a leg of two slides.
    #[inline(always)]
    fn crossing_second(
        &self,
        bodies: &[Body<T>],
        outer: &SlideJoint<T>,
        inner: &SlideJoint<T>,
        e: T,
    ) -> [T; 2] {
        let Crossing { normals, places, apart } = self.crossing(bodies, outer, inner);
        let body = &bodies[self.link];
        let w = body.w1;
        let side = |slide: &SlideJoint<T>, place: [T; 2], n: [T; 2]| {
            let under = slide.under(bodies, place);
            let v = minus(body.first(minus(place, body.origin())), under[0]);
            dot(n, under[1]) + (w * cross(v, n)).twice()
        };
        let carried = minus(scaled(e, perp(apart)), scaled(w * w, apart));
        let [o, i] = [side(outer, places[0], normals[0]), side(inner, places[1], normals[1])];
        meet(normals, [o, i - dot(normals[1], carried)])
    }

    #[inline(always)]
    fn crossing(&self, bodies: &[Body<T>], outer: &SlideJoint<T>, inner: &SlideJoint<T>) -> Crossing<T> {
        let body = &bodies[self.link];
        let places = [body.point(outer.own), body.point(inner.own)];
        let normals = [perp(outer.guide(bodies)), perp(inner.guide(bodies))];
        Crossing { normals, places, apart: minus(places[1], places[0]) }
    }
}

/// A leg of two slides in one position: normals of its guides, its points on them, and from the first point to the second.
struct Crossing<T> {
    normals: [[T; 2]; 2],
    places: [[T; 2]; 2],
    apart: [T; 2],
}

/// The vector with given products with two normals.
#[inline(always)]
pub(crate) fn meet<T: Real>(n: [[T; 2]; 2], product: [T; 2]) -> [T; 2] {
    let inverse = T::ONE / cross(n[0], n[1]);
    let [a, b] = product;
    [(a * n[1][1] - b * n[0][1]) * inverse, (b * n[0][0] - a * n[1][0]) * inverse]
}

/// A vector with the length 1.
#[inline(always)]
pub(crate) fn unit<T: Real>(a: [T; 2]) -> [T; 2] {
    scaled(T::ONE / dot(a, a).sqrt(), a)
}
