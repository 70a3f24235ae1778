//! What a ternary link may still do once its outer pair is satisfied.

use assur_group::plane::{cross, dot, minus, perp, plus, scaled, times};
use assur_group::{Body, BuildError, Forces, PinJoint, SeenPair, SlideJoint, Wrench};
use assur_number::Real;

use crate::leg::{Line, hang};

/// A ternary link with its freedom in the absence of the legs.
#[derive(Debug, Clone)]
pub(crate) struct Mover<T> {
    pub(crate) link: usize,
    pub(crate) freedom: Freedom<T>,
    /// 1 / a typical distance of its joints, 1/m: it makes moments dimensionless.
    pub(crate) inverse_size: T,
}

/// How a ternary link is held by its outer pair.
#[derive(Debug, Clone)]
pub(crate) enum Freedom<T> {
    /// It has none: three freedoms. The point is one of its joints, in its frame, m; moments are taken about it.
    Free([T; 2]),
    /// A pin: it turns.
    Turn(PinJoint<T>),
    /// A slide: it shifts.
    Shift(SlideJoint<T>),
}

/// The freedoms of a ternary link in one position.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hub<T> {
    /// The joint or the point about which it turns, m.
    pub(crate) place: [T; 2],
    /// Direction of the guide; only of a slide.
    along: [T; 2],
}

impl<T: Real> Mover<T> {
    /// A link with its outer pair, if it has one.
    pub(crate) fn new(
        (link, outer): (usize, Option<&SeenPair>),
        anchor: [T; 2],
        size: f64,
    ) -> Result<Self, BuildError> {
        let freedom = match outer {
            None => Freedom::Free(anchor),
            Some(seen) if seen.pair.is_slide() => Freedom::Shift(SlideJoint::new(seen)?),
            Some(seen) => Freedom::Turn(PinJoint::new(seen)?),
        };
        Ok(Self { link, freedom, inverse_size: T::from_f64(1.0 / size) })
    }

    /// The joint or the point about which it turns, in its frame, m.
    #[inline(always)]
    pub(crate) fn own(&self) -> [T; 2] {
        match &self.freedom {
            Freedom::Free(anchor) => *anchor,
            Freedom::Turn(pin) => pin.own,
            Freedom::Shift(slide) => slide.own,
        }
    }

    #[inline(always)]
    pub(crate) fn hub(&self, bodies: &[Body<T>]) -> Hub<T> {
        let body = &bodies[self.link];
        let along = match &self.freedom {
            Freedom::Shift(slide) => slide.guide(bodies),
            _ => [T::ZERO; 2],
        };
        Hub { place: body.point(self.own()), along }
    }

    /// What a line of action does on each freedom: two displacements and a rotation where the link is free, else its one
    /// freedom alone.
    #[inline(always)]
    pub(crate) fn column(&self, hub: &Hub<T>, line: &Line<T>) -> [T; 3] {
        let turning = cross(minus(line.at, hub.place), line.f) + line.moment;
        match self.freedom {
            Freedom::Free(_) => [line.f[0], line.f[1], turning],
            Freedom::Turn(_) => [turning, T::ZERO, T::ZERO],
            Freedom::Shift(_) => [dot(line.f, hub.along), T::ZERO, T::ZERO],
        }
    }

    /// The same of a wrench, given about the origin of a body.
    #[inline(always)]
    pub(crate) fn share(&self, hub: &Hub<T>, origin: [T; 2], load: &Wrench<T>) -> [T; 3] {
        let line = Line { f: load.force(), at: origin, moment: load.m, gap: T::ZERO };
        self.column(hub, &line)
    }

    /// Satisfies the outer pair where it does not quite hold: the freedom itself stays as it is.
    #[inline(always)]
    pub(crate) fn settle(&self, bodies: &mut [Body<T>]) {
        match &self.freedom {
            Freedom::Free(_) => {}
            Freedom::Turn(pin) => {
                let place = pin.place(bodies);
                let arm = bodies[self.link].arm(pin.own);
                bodies[self.link].hang_place(arm, place);
            }
            Freedom::Shift(slide) => {
                let (direction, along) = (slide.carried(bodies, slide.turn), slide.guide(bodies));
                let through = bodies[slide.body].point(slide.through);
                let body = &mut bodies[self.link];
                let reach = dot(along, minus(body.point(slide.own), through));
                body.put(direction, slide.own, plus(through, scaled(reach, along)));
            }
        }
    }

    /// Moves the link by its freedoms.
    #[inline(always)]
    pub(crate) fn step(&self, bodies: &mut [Body<T>], hub: &Hub<T>, by: [T; 3]) {
        let body = &mut bodies[self.link];
        match &self.freedom {
            Freedom::Free(anchor) => {
                turn(body, by[2]);
                let arm = body.arm(*anchor);
                body.hang_place(arm, plus(hub.place, [by[0], by[1]]));
            }
            Freedom::Turn(pin) => {
                turn(body, by[0]);
                let arm = body.arm(pin.own);
                body.hang_place(arm, hub.place);
            }
            Freedom::Shift(_) => {
                let [x, y] = plus(body.origin(), scaled(by[0], hub.along));
                (body.x, body.y) = (x, y);
            }
        }
    }

    /// Size of a step, the sum of its parts in rad and in the size of the link.
    #[inline(always)]
    pub(crate) fn size_of(&self, by: [T; 3]) -> T {
        let [a, b, c] = by.map(T::abs);
        match self.freedom {
            Freedom::Free(_) => (a + b) * self.inverse_size + c,
            Freedom::Turn(_) => a,
            Freedom::Shift(_) => a * self.inverse_size,
        }
    }

    /// Sets PF1 for given speeds of the freedoms, or PF2 for given rates of them, where PF1 is set with these speeds.
    #[inline(always)]
    pub(crate) fn set(&self, bodies: &mut [Body<T>], hub: &Hub<T>, speed: [T; 3], rate: Option<[T; 3]>) {
        let (order, given) = (usize::from(rate.is_some()), rate.unwrap_or(speed));
        let (turning, motion) = match &self.freedom {
            Freedom::Free(_) => (given[2], [given[0], given[1]]),
            Freedom::Turn(pin) => (given[0], pin.motion(bodies, hub.place)[order]),
            Freedom::Shift(slide) => {
                let (carrier, under) = (&bodies[slide.body], slide.under(bodies, hub.place));
                let turned = || scaled((carrier.w1 * speed[0]).twice(), perp(hub.along));
                let under = if order == 0 { under[0] } else { plus(under[1], turned()) };
                ([carrier.w1, carrier.w2][order], plus(under, scaled(given[0], hub.along)))
            }
        };
        hang(&mut bodies[self.link], order, self.own(), turning, motion);
    }

    /// Stores the reaction of the outer pair, which balances a load on the link, and hands it on; `load` is about the hub.
    #[inline(always)]
    pub(crate) fn hold(
        &self,
        bodies: &[Body<T>],
        hub: &Hub<T>,
        load: &Wrench<T>,
        forces: &mut Forces<'_, T>,
    ) {
        match &self.freedom {
            Freedom::Free(_) => {}
            Freedom::Turn(pin) => pin.hand_on(bodies, [-load.fx, -load.fy], forces),
            Freedom::Shift(slide) => {
                let normal = perp(hub.along);
                let force = scaled(-dot(normal, load.force()), normal);
                slide.hand_on(bodies, force, -load.m, forces);
            }
        }
    }
}

/// Turns a body about its origin by a small angle, rad.
#[inline(always)]
fn turn<T: Real>(body: &mut Body<T>, by: T) {
    // The angle of (1 - a²/12 ..., ...) differs from a in the third order only, which the next step takes up.
    let [c, s] = times([body.c, body.s], [T::ONE, by]);
    let inverse = T::ONE / (c * c + s * s).sqrt();
    (body.c, body.s) = (c * inverse, s * inverse);
}
