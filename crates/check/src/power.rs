//! Power: the equation of motion as a sum over every load (S stage 8, "Pogr1"), and virtual power and the drive against the
//! balancing load of the force analysis (S stage 10).

use assur_force::{Cause, LoadState, Side, UnitBalance, power, tolerance};
use assur_group::Body;
use assur_mechanism::{CoordinateKind, PairId};
use assur_words::{Text, name, quantity, text};

use crate::kinetics::{self, ROUNDINGS, rounding_of_sum};
use crate::{case::Case, check::Collector};

/// Why the drive is not compared there.
const ON_A_JUMP: Text = text!("check-on-a-jump");

/// Compares the reduced quantities, the equation of motion, virtual power and the drive at one state; returns the residuals of the
/// equation of motion and of the global check, and what is left of the equation of motion, N m or N. Where the motion was found, they
/// are those of the drive that made it: the balancing load of the force analysis follows any acceleration.
pub(crate) fn compare(
    case: &Case<'_>,
    [reduced, lagrange, lever, drive]: [&mut Collector; 4],
) -> ([f64; 2], f64) {
    let (one, state, loads) = (case.one, case.state, case.loads);
    let linkage = case.subject.linkage;
    let bodies = &one.position.bodies;
    let unit_power = UnitBalance::of(&linkage.mechanism).map_or(1.0, |unit| unit.power(bodies));
    let friction = crate::friction::power(case);
    let own = case.reactions.balancing * unit_power;
    let balancing = own + friction;
    let [inertia, slope] = kinetics::reduced(&linkage.mechanism, state.coordinate, bodies);
    let terms = [-inertia * state.acceleration, -0.5 * slope * state.speed * state.speed];
    let Sums { moment, sizes, added, carried, .. } = sums(case, bodies);
    compare_reduced(case, [inertia, slope, moment], [sizes, added], reduced);
    let exchanged = exchanged(case);
    let total =
        balancing.abs() + friction.abs() + moment.abs() + terms[0].abs() + terms[1].abs() + sizes + exchanged;
    let rounding = 4.0 * f64::EPSILON * carried;
    // Where every power is zero or rounding, the sum is measured by what the loads would do on the fastest link.
    let total = if total > rounding { total } else { carried.max(f64::MIN_POSITIVE) };
    let limit = (rounding_of_sum(added, total) + rounding / total) * case.condition();
    let mut left = balancing + moment + terms[0] + terms[1];
    let of_motion = left.abs() / total;
    let unit = match linkage.kind() {
        CoordinateKind::Angle => "N m",
        CoordinateKind::Length => "N",
        CoordinateKind::Time => "W",
    };
    let told =
        || text!("check-remainder", symbol = name("Pogr1"), left = quantity(format!("{left:.1e}"), unit));
    lagrange.offer(one.index, of_motion, limit, told);
    let sum: f64 =
        loads.total(state, bodies).iter().zip(bodies).map(|(wrench, body)| power(wrench, body)).sum();
    let of_powers = (balancing + sum).abs() / total;
    lever.offer(one.index, of_powers, limit, || text!("check-all-loads"));
    compare_drives(case, lever);
    let mut residuals = [of_motion, of_powers];
    if let Some(given) = case.subject.drive.map(|given| given(state)) {
        let total = total.max(given.value.abs());
        let off = (own - given.value).abs() / total;
        match uncertain(case, given.accuracy, limit * total) {
            Some(uncertain) => {
                let limit = limit + (given.error + uncertain) / total;
                drive.offer(one.index, off, limit, || text!("check-input-link"));
                left = given.value + friction + moment + terms[0] + terms[1];
                residuals = [left.abs() / total, off];
            }
            None => drive.leave_out(one.index, ON_A_JUMP),
        }
    }
    (residuals, left)
}

/// Over time compares the load of each drive with the virtual power of everything else, the other drives at rest.
fn compare_drives(case: &Case<'_>, lever: &mut Collector) {
    let (one, linkage) = (case.one, case.subject.linkage);
    let drives = case.reactions.of_drives(&linkage.mechanism).filter(|_| linkage.kind().is_time());
    for (drive, (driver, load)) in drives.enumerate() {
        let mut bodies = one.position.bodies.clone();
        if linkage.derive_by(drive, one.position.coordinate, &mut bodies).is_err() {
            continue;
        }
        let friction = case.reactions.friction.iter().flat_map(|friction| {
            friction.frictions.powers(&friction.forces, &bodies).map(|(_, power)| power).collect::<Vec<_>>()
        });
        let friction: Vec<f64> = friction.collect();
        let Sums { all, sizes, added, carried, .. } = sums(case, &bodies);
        let left = load + all + friction.iter().sum::<f64>();
        let sizes = sizes + load.abs() + friction.iter().map(|power| power.abs()).sum::<f64>();
        let rounding = 4.0 * f64::EPSILON * carried;
        let total = if sizes > rounding { sizes } else { carried.max(f64::MIN_POSITIVE) };
        let limit = (rounding_of_sum(added, total) + rounding / total) * case.condition();
        lever.offer(one.index, left.abs() / total, limit, || Text::from(&driver.label));
    }
}

/// The powers of the items of a state, added up.
#[derive(Default)]
struct Sums {
    /// Of all.
    all: f64,
    /// Of all but inertia loads.
    moment: f64,
    /// Sizes of the powers.
    sizes: f64,
    /// Sizes of the partial sums.
    added: f64,
    /// What all would do on the fastest link.
    carried: f64,
}

/// Adds up the powers with these velocities of the links.
fn sums(case: &Case<'_>, bodies: &[Body<f64>]) -> Sums {
    let scale = case.subject.linkage.structure.scale;
    let moves = |body: &Body<f64>| body.x1.hypot(body.y1) + body.w1.abs() * scale;
    let links = case.subject.linkage.structure.links;
    let motion = bodies.iter().take(links).map(moves).fold(0.0, f64::max);
    let mut found = Sums::default();
    for ((cause, link), item) in case.items {
        let body = &bodies[*link];
        found.sizes += item.size * moves(body);
        // A link that rests has the rounding of the motion of others for its motion.
        found.carried += item.size * motion;
        let own = power(&item.wrench, body);
        found.all += own;
        if !matches!(cause, Cause::Inertia(_)) {
            found.moment += own;
        }
        found.added += f64::max(found.all.abs(), found.moment.abs());
    }
    found
}

/// How far the reduced moment of the loads may be off where the motion was found: on a steep line by what it gains over the
/// rounding of the coordinate, and where the motion is held by the rounding of the values on both sides, whose mean it is.
/// `None` at rest on a jump over coordinate or time, within the `accuracy` of both, which is more than `rounding`.
fn uncertain(case: &Case<'_>, accuracy: [f64; 2], rounding: f64) -> Option<f64> {
    let (state, loads, bodies) = (case.state, case.loads, &case.one.position.bodies);
    let period = case.subject.linkage.mechanism.input.period();
    let of_rounding = [tolerance(state.coordinate, period), 0.0];
    let states = |[coordinate, time]: [f64; 2]| {
        [-1.0, 1.0].map(|side| LoadState {
            coordinate: state.coordinate + side * coordinate,
            time: state.time + side * time,
            ..*state
        })
    };
    let difference = |[before, after]: [f64; 2]| (after - before).abs();
    // By the formulas of either side: at a kink the steeper line tells, at a jump neither does.
    let gained = |off| {
        let sides = states(off);
        let by = |side: &LoadState| {
            let mut phase = loads.phase();
            loads.enter(side, &mut phase);
            difference(sides.map(|at| loads.reduced_in_phase(&phase, &at, bodies).moment))
        };
        sides.iter().map(by).fold(0.0, f64::max)
    };
    if state.speed == 0.0 {
        let off = [accuracy[0].max(of_rounding[0]), accuracy[1]];
        let across = difference(states(off).map(|at| loads.reduced(&at, bodies).moment));
        if across > 2.0 * gained(off) + rounding {
            return None;
        }
    }
    let side =
        |upper| loads.reduced(&LoadState { side: Side::Held { upper }, ..*state }, bodies).moment.abs();
    let sides = if matches!(state.side, Side::Held { .. }) { side(0.0) + side(1.0) } else { 0.0 };
    Some(gained(of_rounding) + ROUNDINGS * f64::EPSILON * sides)
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

/// J, J' and Q computed here against those of the compiled loads; `sizes`: of the terms of Q, `added`: of its partial sums.
fn compare_reduced(case: &Case<'_>, mine: [f64; 3], [sizes, added]: [f64; 2], collector: &mut Collector) {
    let (linkage, bodies) = (case.subject.linkage, &case.one.position.bodies);
    let found = case.loads.reduced(case.state, bodies);
    let theirs = [found.inertia, found.inertia_derivative, found.moment];
    // J' is a sum of terms that cancel; their sizes are those of products of PF1 and PF2. Of a moment of inertia by formula the
    // rounding may be greater than that of its value.
    let [inertia, slope] = kinetics::sizes(&linkage.mechanism, case.state.coordinate, bodies);
    let names = ["J", "J'", "Q"];
    for (k, size) in
        [inertia.max(mine[0]), slope + mine[0] / linkage.coordinate_unit(), sizes].into_iter().enumerate()
    {
        if size > 0.0 {
            let off = (mine[k] - theirs[k]).abs() / size;
            let of_loads = if k == 2 { added } else { 0.0 };
            collector.offer(case.one.index, off, rounding_of_sum(of_loads, size), || name(names[k]));
        }
    }
}
