//! The reactions: what each leg passes of its own load, the forces along their lines, and what the outer pairs hold.

use assur_group::plane::{cross, dot, minus, opposite, perp, plus, scaled};
use assur_group::{Body, Forces, GroupError, Wrench};
use assur_number::Real;

use crate::kernel::{Legged, Lines};
use crate::leg::{Hold, Leg, Line};
use crate::matrix::Inverse;
use crate::mover::{Hub, Mover};

impl<T: Real> Legged<T> {
    /// The reactions of a placed group under some loads, which are handed on to the outer bodies.
    #[inline(always)]
    pub(crate) fn balance(
        &self,
        bodies: &[Body<T>],
        (lines, inverse): (&Lines<T>, &Inverse<T>),
        forces: &mut Forces<'_, T>,
    ) -> Result<(), GroupError> {
        let loads = &*forces.loads;
        let mut passed = [Line::NONE; 3];
        let mut right =
            self.plate.share(&lines.plate, bodies[self.plate.link].origin(), &loads[self.plate.link]);
        if let (Some(base), Some(hub)) = (&self.base, &lines.base) {
            let own = base.share(hub, bodies[base.link].origin(), &loads[base.link]);
            right = [own[0], right[0], T::ZERO];
        }
        for (k, leg) in self.legs.iter().enumerate() {
            let load = &loads[leg.link];
            passed[k] = leg.passed(bodies, &lines.each[k], load);
            let share = self.row(&lines.plate, lines.base.as_ref(), &passed[k]);
            for (sum, part) in right.iter_mut().zip(share) {
                *sum += part;
            }
            if let (Some(base), Some(hub)) = (&self.base, &lines.base) {
                right[0] += base.share(hub, bodies[leg.link].origin(), load)[0];
            }
        }
        let sizes = inverse.solve_transposed(right.map(|part| -part));
        self.hand_on(bodies, (lines, &passed, &sizes), forces);
        GroupError::if_nan(sizes[0] + sizes[1] + sizes[2])
    }

    /// The load on a ternary link about its hub, with what the legs pass to it.
    #[inline(always)]
    fn gathered(
        mover: &Mover<T>,
        hub: &Hub<T>,
        bodies: &[Body<T>],
        loads: &[Wrench<T>],
        more: impl Iterator<Item = ([T; 2], [T; 2], T)>,
    ) -> Wrench<T> {
        let load = &loads[mover.link];
        let mut sum = Wrench::ZERO;
        sum.add_at(minus(bodies[mover.link].origin(), hub.place), load.force(), load.m);
        for (at, force, moment) in more {
            sum.add_at(minus(at, hub.place), force, moment);
        }
        sum
    }

    /// Stores all reactions for the forces along the lines, and hands the outer ones on.
    #[inline(always)]
    fn hand_on(
        &self,
        bodies: &[Body<T>],
        (lines, passed, sizes): (&Lines<T>, &[Line<T>; 3], &[T; 3]),
        forces: &mut Forces<'_, T>,
    ) {
        for (k, leg) in self.legs.iter().enumerate() {
            let outer = leg.store(bodies, (&lines.each[k], &passed[k], sizes[k]), forces);
            leg.store_outer(bodies, outer, self.base.is_none(), forces);
        }
        let (Some(base), Some(hub)) = (&self.base, &lines.base) else { return };
        let along = |k: usize, sign: T| {
            let line = &lines.each[k];
            let size = sign * sizes[k];
            (line.at, [size * line.f[0], size * line.f[1]], size * line.moment)
        };
        let beside = |k: usize, sign: T| {
            let Line { f, at, moment, .. } = passed[k];
            (at, [sign * f[0], sign * f[1]], sign * moment)
        };
        let count = self.legs.len();
        let on_plate = (0..count).flat_map(|k| [along(k, T::ONE), beside(k, T::ONE)]);
        let plate = Self::gathered(&self.plate, &lines.plate, bodies, forces.loads, on_plate);
        let own = |k: usize| {
            let load = &forces.loads[self.legs[k].link];
            (bodies[self.legs[k].link].origin(), load.force(), load.m)
        };
        let on_base = (0..count).flat_map(|k| [along(k, -T::ONE), beside(k, -T::ONE), own(k)]);
        let based = Self::gathered(base, hub, bodies, forces.loads, on_base);
        self.plate.hold(bodies, &lines.plate, &plate, forces);
        base.hold(bodies, hub, &based, forces);
    }
}

impl<T: Real> Leg<T> {
    /// What the leg passes to the plate of the load on itself, beside the force along its line: the force through a point, and the
    /// moment.
    #[inline(always)]
    fn passed(&self, bodies: &[Body<T>], line: &Line<T>, load: &Wrench<T>) -> Line<T> {
        let body = &bodies[self.link];
        match &self.hold {
            Hold::Rr { outer, rod, length, .. } => {
                let moment = load.about(body.arm(outer.own));
                let f = scaled(moment / (*length * *length), perp(body.arm(*rod)));
                Line { f, at: line.at, ..Line::NONE }
            }
            Hold::Pr { .. } => {
                let t = opposite(perp(line.f));
                Line { f: scaled(dot(t, load.force()), t), at: line.at, ..Line::NONE }
            }
            Hold::Rp { outer, .. } => {
                Line { at: line.at, moment: load.about(body.arm(outer.own)), ..Line::NONE }
            }
            Hold::Pp { outer, inner, .. } => {
                let (t, n) = (outer.guide(bodies), perp(inner.guide(bodies)));
                let f = scaled(dot(t, load.force()) / dot(t, n), n);
                Line { f, at: body.point(inner.own), ..Line::NONE }
            }
        }
    }

    /// Stores the reaction of the inner pair, on the leg, and returns that of the outer pair: force, and moment about the
    /// pin or the point on the guide.
    #[inline(always)]
    fn store(
        &self,
        bodies: &[Body<T>],
        (line, passed, size): (&Line<T>, &Line<T>, T),
        forces: &mut Forces<'_, T>,
    ) -> ([T; 2], T) {
        let (body, load, reactions) = (&bodies[self.link], &forces.loads[self.link], &mut *forces.reactions);
        let along = scaled(size, line.f);
        let on_plate = plus(along, passed.f);
        let outer_force = minus(on_plate, load.force());
        match &self.hold {
            Hold::Rr { inner, .. } => {
                inner.store(opposite(on_plate), reactions);
                (outer_force, T::ZERO)
            }
            Hold::Pr { outer, inner, .. } => {
                inner.store(opposite(on_plate), reactions);
                let own = body.arm(outer.own);
                let arm = minus(body.arm(inner.own), own);
                // Along the guide nothing is left but rounding.
                let force = scaled(dot(line.f, outer_force), line.f);
                (force, cross(arm, on_plate) - load.about(own))
            }
            Hold::Rp { outer, inner, .. } => {
                let arm = minus(body.arm(outer.own), body.arm(inner.own));
                inner.store(bodies, opposite(along), -(passed.moment + cross(arm, along)), reactions);
                (outer_force, T::ZERO)
            }
            Hold::Pp { outer, inner, .. } => {
                inner.store(bodies, opposite(passed.f), -size, reactions);
                let own = body.arm(outer.own);
                let arm = minus(body.arm(inner.own), own);
                let n = perp(outer.guide(bodies));
                (scaled(dot(n, outer_force), n), cross(arm, passed.f) + size - load.about(own))
            }
        }
    }

    /// Stores the reaction of the outer pair, on the leg, and hands its opposite on to an outer body.
    #[inline(always)]
    fn store_outer(
        &self,
        bodies: &[Body<T>],
        (force, moment): ([T; 2], T),
        is_outer_body: bool,
        forces: &mut Forces<'_, T>,
    ) {
        match &self.hold {
            Hold::Rr { outer, .. } | Hold::Rp { outer, .. } if is_outer_body => {
                outer.hand_on(bodies, force, forces);
            }
            Hold::Rr { outer, .. } | Hold::Rp { outer, .. } => outer.store(force, forces.reactions),
            Hold::Pr { outer, .. } | Hold::Pp { outer, .. } if is_outer_body => {
                outer.hand_on(bodies, force, moment, forces);
            }
            Hold::Pr { outer, .. } | Hold::Pp { outer, .. } => {
                outer.store(bodies, force, moment, forces.reactions);
            }
        }
    }
}
