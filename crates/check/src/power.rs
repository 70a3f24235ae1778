//! Power: the equation of motion written out over every load (S stage 8, "Pogr1"), and virtual power against the balancing
//! load of the force analysis (S stage 10).

use assur_force::{Cause, JointReaction, Loads, Reactions, State, UnitBalance, power};
use assur_group::Wrench;
use assur_mechanism::{Balance, InputPair, Mechanism, PairId};

use crate::forces::{NO_ANSWER, SOLUTION};
use crate::kinetics;
use crate::subject::{Solved, Subject};
use crate::worst::{Check, Worst};
use crate::written::Items;

/// Whether the balancing load is a moment.
pub(crate) fn balances_by_moment(mechanism: &Mechanism) -> bool {
    match mechanism.balance {
        Some(Balance::Moment(_)) => true,
        Some(Balance::Force { .. }) => false,
        None => matches!(mechanism.input.pair, InputPair::Pin(_)),
    }
}

pub(crate) struct Power<'a> {
    subject: &'a Subject<'a>,
    lagrange: Worst,
    lever: Worst,
    reduced: Worst,
}

impl<'a> Power<'a> {
    pub(crate) fn new(subject: &'a Subject<'a>) -> Self {
        let lagrange = Worst::new(
            "Lagrange-d'Alembert",
            "Mb + Q - J e - J' w^2/2 = 0 written out over every load, relative to its terms; limit: 64 rounding units of the \
             terms and of the power that each reaction exchanges, by the sum of 1/determinant over the groups",
        );
        let lever = Worst::new(
            "virtual power",
            "power of all loads and inertia loads against that of the balancing load; limit as for Lagrange-d'Alembert",
        );
        let reduced = Worst::new(
            "reduced quantities",
            "J, J' and Q written out once more; limit: 64 rounding units of their terms",
        );
        Self { subject, lagrange, lever, reduced }
    }

    pub(crate) fn add(
        &mut self,
        one: &Solved,
        state: &State,
        loads: &Loads,
        items: &Items,
        reactions: &Reactions,
        joints: &[JointReaction],
    ) {
        let linkage = self.subject.linkage;
        let bodies = &one.position.bodies;
        let scale = linkage.structure.scale;
        let unit_power = UnitBalance::of(&linkage.mechanism, bodies).map_or(1.0, |unit| unit.power(bodies));
        let balancing = reactions.balancing * unit_power;
        let [inertia, slope] = kinetics::reduced(&linkage.mechanism, bodies);
        let terms = [-inertia * state.acceleration, -0.5 * slope * state.speed * state.speed];
        let (mut moment, mut sizes) = (0.0, 0.0);
        for ((cause, link), item) in items {
            let body = &bodies[*link];
            // Rounding of a power: that of the load by the fastest motion of the link's neighborhood.
            sizes += item.size * (body.x1.hypot(body.y1) + body.w1.abs() * scale);
            if !matches!(cause, Cause::Inertia(_)) {
                moment += power(&item.wrench, body);
            }
        }
        let own = loads.reduced(state, bodies);
        self.compare_reduced(
            one,
            [inertia, slope, moment],
            [own.inertia, own.inertia_derivative, own.moment],
            sizes,
        );
        let exchanged = self.exchanged(one, joints);
        let total = balancing.abs() + moment.abs() + terms[0].abs() + terms[1].abs() + sizes + exchanged;
        let total = total.max(f64::MIN_POSITIVE);
        let limit = SOLUTION * f64::EPSILON * one.condition;
        let off = (balancing + moment + terms[0] + terms[1]).abs();
        self.lagrange.offer(one.index, off / total, limit, || "all loads".to_owned());
        let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
        loads.apply(state, bodies, &mut wrenches);
        loads.inertia(state, bodies, &mut wrenches);
        let sum: f64 = wrenches.iter().zip(bodies).map(|(wrench, body)| power(wrench, body)).sum();
        self.lever.offer(one.index, (balancing + sum).abs() / total, limit, || "all loads".to_owned());
    }

    /// Power that the joints take from one link and give to another: it cancels but for rounding.
    fn exchanged(&self, one: &Solved, joints: &[JointReaction]) -> f64 {
        let mechanism = &self.subject.linkage.mechanism;
        let mut sum = 0.0;
        for joint in joints {
            for (link, force) in &joint.forces {
                let body = &one.position.bodies[*link];
                let at = match joint.joint {
                    PairId::Pin(point) => mechanism.place_in(point, *link).unwrap_or_default(),
                    PairId::Slide(id) => mechanism.slides[id].point,
                };
                let lever = at[0].hypot(at[1]);
                let fast = body.x1.hypot(body.y1) + body.w1.abs() * lever;
                sum += force[0].hypot(force[1]) * fast + joint.moment.unwrap_or(0.0).abs() * body.w1.abs();
            }
        }
        sum
    }

    fn compare_reduced(&mut self, one: &Solved, mine: [f64; 3], theirs: [f64; 3], sizes: f64) {
        let unit = self.subject.linkage.coordinate_unit();
        let mechanism = &self.subject.linkage.mechanism;
        // J' is the sum of terms that cancel; their sizes are those of products of PF1 and PF2.
        let slopes = kinetics::slope_terms(mechanism, &one.position.bodies);
        let names = ["J", "J'", "Q"];
        for (k, size) in [mine[0], slopes + mine[0] / unit, sizes].into_iter().enumerate() {
            if size > 0.0 {
                let off = (mine[k] - theirs[k]).abs() / size;
                self.reduced.offer(one.index, off, SOLUTION * f64::EPSILON, || names[k].to_owned());
            }
        }
    }

    pub(crate) fn leave_out(&mut self, at: usize) {
        for worst in [&mut self.lagrange, &mut self.lever] {
            worst.leave_out(at, NO_ANSWER);
        }
    }

    pub(crate) fn into_checks(self) -> Vec<Check> {
        let all = [self.reduced, self.lagrange, self.lever];
        all.into_iter().filter_map(Worst::into_check).collect()
    }
}
