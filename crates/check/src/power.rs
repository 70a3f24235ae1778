//! Power: the equation of motion as a sum over every load (S stage 8, "Pogr1"), and virtual power against the balancing
//! load of the force analysis (S stage 10).

use assur_force::{Cause, UnitBalance, power};
use assur_mechanism::PairId;

use crate::case::{Case, ROUNDINGS};
use crate::check::Collector;
use crate::kinetics;

/// The checks of the reduced quantities, of the equation of motion, and of virtual power.
pub(crate) fn collectors() -> [Collector; 3] {
    [
        Collector::new(
            "reduced quantities",
            "J, J' and Q written out once more; limit: 64 rounding units of their terms",
        ),
        Collector::new(
            "Lagrange-d'Alembert",
            "Mb + Q - J e - J' w^2/2 = 0 written out over every load, relative to its terms; limit: 64 rounding units of the \
             terms and of the power that each reaction exchanges, by the sum of 1/determinant over the groups",
        ),
        Collector::new(
            "virtual power",
            "power of all loads and inertia loads against that of the balancing load; limit as for Lagrange-d'Alembert",
        ),
    ]
}

/// Compares one state; returns the residuals of the equation of motion and of virtual power.
pub(crate) fn compare(case: &Case<'_>, [reduced, lagrange, lever]: &mut [Collector; 3]) -> [f64; 2] {
    let (one, state, loads) = (case.one, case.state, case.loads);
    let linkage = case.subject.linkage;
    let bodies = &one.position.bodies;
    let scale = linkage.structure.scale;
    let unit_power = UnitBalance::of(&linkage.mechanism).map_or(1.0, |unit| unit.power(bodies));
    let balancing = case.reactions.balancing * unit_power;
    let [inertia, slope] = kinetics::reduced(&linkage.mechanism, bodies);
    let terms = [-inertia * state.acceleration, -0.5 * slope * state.speed * state.speed];
    let (mut moment, mut sizes) = (0.0, 0.0);
    for ((cause, link), item) in case.items.iter() {
        let body = &bodies[*link];
        // Rounding of a power: that of the load times the greatest motion of the link and its neighbors.
        sizes += item.size * (body.x1.hypot(body.y1) + body.w1.abs() * scale);
        if !matches!(cause, Cause::Inertia(_)) {
            moment += power(&item.wrench, body);
        }
    }
    compare_reduced(case, [inertia, slope, moment], sizes, reduced);
    let exchanged = exchanged(case);
    let total = balancing.abs() + moment.abs() + terms[0].abs() + terms[1].abs() + sizes + exchanged;
    let total = total.max(f64::MIN_POSITIVE);
    let limit = ROUNDINGS * f64::EPSILON * one.condition;
    let of_motion = (balancing + moment + terms[0] + terms[1]).abs() / total;
    lagrange.offer(one.index, of_motion, limit, || "all loads".to_owned());
    let sum: f64 =
        loads.total(state, bodies).iter().zip(bodies).map(|(wrench, body)| power(wrench, body)).sum();
    let of_powers = (balancing + sum).abs() / total;
    lever.offer(one.index, of_powers, limit, || "all loads".to_owned());
    [of_motion, of_powers]
}

/// Power that the joints transfer from one link to another: the sum is zero but for rounding.
fn exchanged(case: &Case<'_>) -> f64 {
    let mechanism = &case.subject.linkage.mechanism;
    let mut sum = 0.0;
    for joint in &case.joints {
        for (link, force) in &joint.forces {
            let body = &case.one.position.bodies[*link];
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

/// J, J' and Q computed here against those of the compiled loads; `sizes`: of the terms of Q.
fn compare_reduced(case: &Case<'_>, mine: [f64; 3], sizes: f64, collector: &mut Collector) {
    let (linkage, bodies) = (case.subject.linkage, &case.one.position.bodies);
    let found = case.loads.reduced(case.state, bodies);
    let theirs = [found.inertia, found.inertia_derivative, found.moment];
    // J' is a sum of terms that cancel; their sizes are those of products of PF1 and PF2.
    let slopes = kinetics::slope_terms(&linkage.mechanism, bodies);
    let names = ["J", "J'", "Q"];
    for (k, size) in [mine[0], slopes + mine[0] / linkage.coordinate_unit(), sizes].into_iter().enumerate() {
        if size > 0.0 {
            let off = (mine[k] - theirs[k]).abs() / size;
            collector.offer(case.one.index, off, ROUNDINGS * f64::EPSILON, || names[k].to_owned());
        }
    }
}
