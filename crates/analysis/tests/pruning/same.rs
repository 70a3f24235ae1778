//! Comparison of results bit for bit.

use assur_analysis::results::{
    Analysis, MotionSample, Named, PairReaction, PointMotion, PositionResult, Rates, ScalarMotion,
};

/// How many numbers were compared.
#[derive(Default)]
pub(crate) struct Count(pub(crate) usize);

impl Count {
    fn number(&mut self, where_: &str, part: f64, whole: f64) {
        assert_eq!(part.to_bits(), whole.to_bits(), "{where_}: {part:e} is not {whole:e}");
        self.0 += 1;
    }

    fn numbers<const N: usize>(&mut self, where_: &str, part: [f64; N], whole: [f64; N]) {
        part.into_iter().zip(whole).for_each(|(a, b)| self.number(where_, a, b));
    }

    fn optional(&mut self, where_: &str, part: Option<f64>, whole: Option<f64>) {
        if let Some(part) = part {
            self.number(where_, part, whole.unwrap());
        }
    }

    /// Everything that the part tells is in the whole.
    fn each<T>(&mut self, part: &Named<T>, whole: &Named<T>, mut same: impl FnMut(&mut Self, &str, &T, &T)) {
        for (name, value) in part.iter() {
            same(self, name, value, whole.get(name).unwrap());
        }
    }

    fn derivatives(&mut self, part: &Named<ScalarMotion>, whole: &Named<ScalarMotion>) {
        self.each(part, whole, |all, name, a, b| {
            all.numbers(name, [a.pf0, a.pf1, a.pf2], [b.pf0, b.pf1, b.pf2]);
        });
    }

    fn transfer(&mut self, part: &Named<PointMotion>, whole: &Named<PointMotion>) {
        self.each(part, whole, |all, name, a, b| {
            all.numbers(name, a.pf0, b.pf0);
            all.numbers(name, a.pf1, b.pf1);
            all.numbers(name, a.pf2, b.pf2);
        });
    }

    fn rates(&mut self, part: Option<&Rates>, whole: Option<&Rates>) {
        let Some(part) = part else { return };
        let whole = whole.unwrap();
        self.each(&part.links, &whole.links, |all, name, a, b| all.number(name, *a, *b));
        self.each(&part.points, &whole.points, |all, name, a, b| all.numbers(name, *a, *b));
        self.each(&part.slides, &whole.slides, |all, name, a, b| all.number(name, *a, *b));
    }

    /// Where the whole has no reactions (a change point of a group that the part does without), the part may have some.
    fn reactions(&mut self, part: Option<&Named<PairReaction>>, whole: Option<&Named<PairReaction>>) {
        let (Some(part), Some(whole)) = (part, whole) else { return };
        self.each(part, whole, |all, name, a, b| {
            for (one, other) in a.forces.iter().zip(&b.forces) {
                assert_eq!(one.0, other.0);
                all.numbers(name, one.1, other.1);
            }
            all.optional(name, a.moment, b.moment);
            all.optional(name, a.offset, b.offset);
        });
    }

    fn position(&mut self, part: &PositionResult, whole: &PositionResult) {
        assert_eq!(part.index, whole.index);
        self.number("coordinate", part.coordinate, whole.coordinate);
        self.optional("speed", part.speed, whole.speed);
        self.optional("acceleration", part.acceleration, whole.acceleration);
        self.derivatives(&part.links, &whole.links);
        self.transfer(&part.points, &whole.points);
        self.derivatives(&part.slides, &whole.slides);
        self.rates(part.velocities.as_ref(), whole.velocities.as_ref());
        self.rates(part.accelerations.as_ref(), whole.accelerations.as_ref());
        if let Some(part) = part.reduced {
            let whole = whole.reduced.unwrap();
            let each = |r: assur_analysis::results::Reduced| [r.inertia, r.inertia_derivative, r.moment];
            self.numbers("reduced", each(part), each(whole));
        }
        self.reactions(part.reactions.as_ref(), whole.reactions.as_ref());
        if whole.balancing.is_some() {
            self.optional("balancing", part.balancing, whole.balancing);
        }
    }

    fn row(&mut self, part: &MotionSample, whole: &MotionSample) {
        let state = |row: &MotionSample| [row.time, row.coordinate, row.speed, row.acceleration];
        self.numbers("state", state(part), state(whole));
        self.derivatives(&part.links, &whole.links);
        self.derivatives(&part.slides, &whole.slides);
        self.each(&part.points, &whole.points, |all, name, a, b| all.numbers(name, a.pf0, b.pf0));
        self.rates(part.velocities.as_ref(), whole.velocities.as_ref());
        self.rates(part.accelerations.as_ref(), whole.accelerations.as_ref());
        self.reactions(part.reactions.as_ref(), whole.reactions.as_ref());
        if whole.balancing.is_some() {
            self.optional("balancing", part.balancing, whole.balancing);
        }
    }

    /// Compares all positions and samples; both must have the same.
    pub(crate) fn analyses(&mut self, part: &Analysis, whole: &Analysis) {
        assert_eq!(part.positions.len(), whole.positions.len());
        part.positions.iter().zip(&whole.positions).for_each(|(a, b)| self.position(a, b));
        assert_eq!(part.trajectory.len(), whole.trajectory.len());
        part.trajectory.iter().zip(&whole.trajectory).for_each(|(a, b)| self.row(a, b));
    }
}
