//! What acts on a machine at an instant of its motion, reduced to the input, and its works.

use assur_force::{Cause, LoadState, Loads};
use assur_group::Body;
use assur_mechanism::Mechanism;
use assur_number::quadrature::simpson;

/// What acts at an instant of a motion: moments on the input (forces), N m (N).
#[derive(Debug, Clone)]
pub(crate) struct Acting {
    time: f64,
    coordinate: f64,
    speed: f64,
    /// The moments of the drive, of all weights, and of each load of the scene in the order of the results.
    pub(crate) each: Vec<f64>,
    /// The moment of the dry friction of all pairs.
    friction: f64,
}

/// Works, J, or the moments or powers of which they are: of all that drives and of all that resists; of the dry friction of all pairs,
/// which is neither; then of each moment in the order of [`Acting::each`].
pub(crate) type Works = Vec<f64>;

/// How many sums stand before the works of each moment.
pub(crate) const SUMS: usize = 3;

impl Acting {
    /// Index of the drive in [`Acting::each`].
    pub(crate) const DRIVE: usize = 0;
    /// Index of the weights in [`Acting::each`].
    pub(crate) const WEIGHTS: usize = 1;
    /// Index of the first load in [`Acting::each`].
    pub(crate) const LOADS: usize = 2;

    /// What acts at a state, with these moments of the drive and of the dry friction of all pairs.
    pub(crate) fn of(
        loads: &Loads,
        mechanism: &Mechanism,
        state: &LoadState,
        bodies: &[Body<f64>],
        [torque, friction]: [f64; 2],
    ) -> Self {
        let mut each = vec![0.0; Self::LOADS + mechanism.loads.len()];
        each[Self::DRIVE] = torque;
        loads.by_cause(state, bodies, &mut |cause, link, wrench| {
            let place = match cause {
                Cause::Inertia(_) => return,
                Cause::Weight(_) => Self::WEIGHTS,
                Cause::Load(id) => Self::LOADS + id,
            };
            each[place] += assur_force::power(&wrench, &bodies[link]);
        });
        let LoadState { time, coordinate, speed, .. } = *state;
        Self { time, coordinate, speed, each, friction }
    }

    /// The moments, and the sums of those that drive a motion in a direction of the coordinate and of those that resist it.
    pub(crate) fn moments(&self, direction: f64) -> Works {
        let sum = |sense: f64| self.each.iter().filter(|moment| **moment * sense > 0.0).sum();
        let sums = [sum(direction), sum(-direction), self.friction];
        sums.into_iter().chain(self.each.iter().copied()).collect()
    }

    /// The powers of what acts.
    fn powers(&self) -> Works {
        let moments = self.moments(if self.speed < 0.0 { -1.0 } else { 1.0 });
        moments.into_iter().map(|moment| self.speed * moment).collect()
    }
}

/// A number made of the values of each work in a row of instants.
pub(crate) fn over(rows: &[Works], made: impl Fn(&[f64]) -> f64) -> Works {
    let count = rows.first().map_or(0, Vec::len);
    (0..count).map(|place| made(&rows.iter().map(|row| row[place]).collect::<Vec<_>>())).collect()
}

/// A work divided in the ratio of some works: among the sums, and among those of each moment.
pub(crate) fn shares(works: &[f64], work: f64) -> Works {
    let (sums, each) = works.split_at(SUMS);
    let part = |own: f64, sum: f64, count: usize| {
        if sum > 0.0 { work * own / sum } else { work / count.max(1) as f64 }
    };
    let (both, all): (f64, f64) = (sums.iter().sum(), each.iter().sum());
    // If neither sum varies, the correction is split evenly between them; friction, which varies whenever it acts, gets none.
    let of_friction = if both > 0.0 { work * sums[2] / both } else { 0.0 };
    let of_sums = [part(sums[0], both, 2), part(sums[1], both, 2), of_friction];
    of_sums.into_iter().chain(each.iter().map(|own| part(*own, all, each.len()))).collect()
}

/// Adds works to a sum, which is empty at first.
pub(crate) fn add(sum: &mut Works, more: &[f64]) {
    sum.resize(sum.len().max(more.len()), 0.0);
    sum.iter_mut().zip(more).for_each(|(sum, work)| *sum += work);
}

/// The works over equally spaced instants, and how much their rates change: by Simpson's rule over time, or by trapezoids over the
/// coordinate where the moments jump.
pub(crate) fn over_time(nodes: &[Acting], jumps: &[[Acting; 2]]) -> [Works; 2] {
    let powers: Vec<_> = nodes.iter().map(Acting::powers).collect();
    let mut works = Works::default();
    for (index, three) in nodes.windows(3).enumerate().step_by(2) {
        let inside = |[before, _]: &&[Acting; 2]| before.time > three[0].time && before.time <= three[2].time;
        let mut inside = jumps.iter().filter(inside).peekable();
        if inside.peek().is_none() {
            let step = three[1].time - three[0].time;
            add(&mut works, &over(&powers[index..index + 3], |values| simpson(step, values)));
            continue;
        }
        let mut from = &three[0];
        let end = [three[2].clone(), three[2].clone()];
        for [before, after] in inside.chain([&end]) {
            let way = before.coordinate - from.coordinate;
            let both = [from, before].map(|acting| acting.moments(way));
            add(&mut works, &over(&both, |values| 0.5 * way * values.iter().sum::<f64>()));
            from = after;
        }
    }
    [works, over(&powers, change)]
}

/// The sum of the sizes of all changes from value to value.
pub(crate) fn change(values: &[f64]) -> f64 {
    values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum()
}
