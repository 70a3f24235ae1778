//! What acts on a machine at an instant of its motion, reduced to the input, and its works.

use std::ops::AddAssign;

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

/// Works of the driving and of the resisting moments, and of each moment, J; or the moments or powers of which they are.
#[derive(Debug, Clone, Default)]
pub(crate) struct Works {
    /// The work of the driving and of the resisting moments, and of the dry friction of all pairs, which is neither.
    pub(crate) sums: [f64; 3],
    /// The works of the moments in the order of [`Acting::each`].
    pub(crate) each: Vec<f64>,
}

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
        Works { sums: [sum(direction), sum(-direction), self.friction], each: self.each.clone() }
    }

    /// The powers of what acts.
    fn powers(&self) -> Works {
        self.moments(if self.speed < 0.0 { -1.0 } else { 1.0 }).scaled(self.speed)
    }
}

impl Works {
    /// Zero for so many moments.
    pub(crate) fn none(count: usize) -> Self {
        Self { each: vec![0.0; count], ..Self::default() }
    }

    fn scaled(self, factor: f64) -> Self {
        let scaled = |work| factor * work;
        Self { sums: self.sums.map(scaled), each: self.each.into_iter().map(scaled).collect() }
    }

    /// A number made of the values of each of them in a row of instants.
    pub(crate) fn over(rows: &[Self], made: impl Fn(&[f64]) -> f64) -> Self {
        let of = |part: &dyn Fn(&Self) -> f64| made(&rows.iter().map(part).collect::<Vec<_>>());
        let count = rows.first().map_or(0, |first| first.each.len());
        Self {
            sums: [0, 1, 2].map(|sum| of(&|row| row.sums[sum])),
            each: (0..count).map(|place| of(&|row| row.each[place])).collect(),
        }
    }

    /// A work divided among them in the ratio of their sizes.
    pub(crate) fn shares(&self, work: f64) -> Self {
        // If neither sum varies, the correction is split evenly between them; friction, which varies whenever it acts, gets none.
        let [driving, resisting, friction] = self.sums;
        let both = driving + resisting + friction;
        let all: f64 = self.each.iter().sum();
        let part = |own: f64, sum: f64, count: usize| {
            if sum > 0.0 { work * own / sum } else { work / count.max(1) as f64 }
        };
        let of_friction = if both > 0.0 { work * friction / both } else { 0.0 };
        Self {
            sums: [part(driving, both, 2), part(resisting, both, 2), of_friction],
            each: self.each.iter().map(|own| part(*own, all, self.each.len())).collect(),
        }
    }
}

impl AddAssign for Works {
    fn add_assign(&mut self, other: Self) {
        self.sums.iter_mut().zip(other.sums).for_each(|(sum, work)| *sum += work);
        if self.each.is_empty() {
            self.each = other.each;
        } else {
            self.each.iter_mut().zip(other.each).for_each(|(sum, work)| *sum += work);
        }
    }
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
            works += Works::over(&powers[index..index + 3], |values| simpson(step, values));
            continue;
        }
        let mut from = &three[0];
        let end = [three[2].clone(), three[2].clone()];
        for [before, after] in inside.chain([&end]) {
            let way = before.coordinate - from.coordinate;
            let both = [from, before].map(|acting| acting.moments(way));
            works += Works::over(&both, |values| 0.5 * way * values.iter().sum::<f64>());
            from = after;
        }
    }
    [works, Works::over(&powers, change)]
}

/// The sum of the sizes of all changes from value to value.
pub(crate) fn change(values: &[f64]) -> f64 {
    values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum()
}
