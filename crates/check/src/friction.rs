//! Dry friction: what each pair must give, from the named reactions and the motion of its links.

use assur_force::Reactions;
use assur_mechanism::{Friction, LinkId, Middle, PairId, Surfaces};

use crate::case::{Case, largest};
use crate::{check::Collector, kinetics::ROUNDINGS};

/// The friction of a slide along its guide, N; 0 for another pair.
pub(crate) fn along(reactions: &Reactions, pair: PairId) -> f64 {
    let Some(friction) = &reactions.friction else { return 0.0 };
    let each = friction.frictions.bearings.iter().zip(&friction.forces);
    each.filter(|(bearing, _)| bearing.pair == pair).map(|(_, force)| force).sum()
}

/// Virtual power of all friction for dq = 1.
pub(crate) fn power(case: &Case<'_>) -> f64 {
    let Some(friction) = &case.reactions.friction else { return 0.0 };
    let powers = friction.frictions.powers(&friction.forces, &case.one.position.bodies);
    powers.map(|(_, power)| power).sum()
}

/// Compares the friction of all pairs at a state.
pub(crate) fn compare(case: &Case<'_>, collector: &mut Collector) {
    let Some(friction) = &case.reactions.friction else { return };
    let mechanism = &case.subject.linkage.mechanism;
    let total = largest(&case.reactions.pairs, case.subject.linkage.structure.scale).max(f64::MIN_POSITIVE);
    let radius = friction
        .certificates
        .iter()
        .filter(|radius| radius.is_finite())
        .fold(0.0, |most: f64, r| most.max(*r));
    // Both sides follow from the same moduli z; what tells them apart is the rounding of the terms of a + W z. Their magnitudes
    // add up to z + 2 L z at most, L the lengths of W: in the norm of the eigenvector of L, 1 + 2 `radius` times z.
    let gain = 1.0 + 2.0 * radius;
    let limit = ROUNDINGS * f64::EPSILON * case.condition() * gain;
    let mut forces = friction.forces.iter().zip(&friction.senses);
    for friction in &mechanism.frictions {
        for [link, on] in mechanism.friction_links(friction) {
            let Some((force, sense)) = forces.next() else { return };
            let (expected, lever) = expected(case, friction, link, *sense);
            let moving = relative(case, friction.pair, [link, on]) * case.state.speed;
            // The sense may be that of a motion that begins there.
            let wrong = moving.abs() > 1e-9 && moving * force > 0.0 && force.abs() > limit * total;
            let off = if wrong { f64::INFINITY } else { (force - expected).abs() / (lever * total) };
            let place = || mechanism.pair_name(friction.pair).into();
            collector.offer(case.one.index, off, limit, place);
        }
    }
}

/// Moment or force of the friction of a pair on a link, and a length (1 for a force) that makes it comparable with forces.
fn expected(case: &Case<'_>, friction: &Friction, link: LinkId, sense: f64) -> (f64, f64) {
    let Some(joint) = case.joints.iter().find(|joint| joint.joint == friction.pair) else {
        return (f64::NAN, 1.0);
    };
    let force = joint.forces.iter().find(|(on, _)| *on == link).map_or([f64::NAN; 2], |(_, force)| *force);
    let factor = -sense * friction.coefficient;
    match (friction.pair, friction.surfaces) {
        (_, Surfaces::Journal { radius, .. }) => {
            let lever = if radius > 0.0 { radius } else { 1.0 };
            (factor * radius * force[0].hypot(force[1]), lever)
        }
        (PairId::Slide(id), surfaces) => {
            let (slide, bodies) = (&case.subject.linkage.mechanism.slides[id], &case.one.position.bodies);
            let (s, c) = slide.angle.sin_cos();
            let [x, y] = bodies[slide.on].turned([c, s]);
            let normal = x * force[1] - y * force[0];
            let Surfaces::Faces { length, middle, offset } = surfaces else {
                return (factor * normal.abs(), 1.0);
            };
            let whole = joint.moment.unwrap_or(f64::NAN);
            // The friction of both faces has a moment too.
            let mut moment = whole - factor * offset * normal;
            if middle == Middle::Through {
                let [p, q] = [bodies[slide.link].point(slide.point), bodies[slide.on].point(slide.through)];
                moment += (x * (p[0] - q[0]) + y * (p[1] - q[1])) * normal;
            }
            let ends = (0.5 * normal + moment / length).abs() + (0.5 * normal - moment / length).abs();
            let scale = case.subject.linkage.structure.scale;
            (factor * ends, 1.0 + scale / length)
        }
        (PairId::Pin(_), _) => (f64::NAN, 1.0),
    }
}

/// Relative speed of two links of a pair for dq = 1.
fn relative(case: &Case<'_>, pair: PairId, [link, on]: [LinkId; 2]) -> f64 {
    let bodies = &case.one.position.bodies;
    match pair {
        PairId::Pin(_) => bodies[link].w1 - bodies[on].w1,
        PairId::Slide(id) => {
            let slide = &case.subject.linkage.mechanism.slides[id];
            let (s, c) = slide.angle.sin_cos();
            let (body, carrier) = (&bodies[link], &bodies[on]);
            let place = body.point(slide.point);
            let v = body.first([place[0] - body.x, place[1] - body.y]);
            let under = carrier.first([place[0] - carrier.x, place[1] - carrier.y]);
            let [x, y] = carrier.turned([c, s]);
            x * (v[0] - under[0]) + y * (v[1] - under[1])
        }
    }
}
