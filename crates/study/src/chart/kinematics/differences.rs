//! The chart's row of numerical differentiation.

use std::hint::black_box;

use assur_number::{Dd, Real};

use super::groups_of;
use crate::chart::entry::{Contestant, Verdict};
use crate::chart::work::Work;
use crate::differences::{Differentiator, Stencil};

pub(super) struct Differences<'a> {
    work: &'a Work<'a>,
    differentiator: Differentiator<'a>,
}

impl<'a> Differences<'a> {
    /// `step`: rad, or parts of the scale for a sliding input.
    pub(super) fn new(work: &'a Work<'a>, stencil: Stencil, step: f64) -> Self {
        Self { work, differentiator: Differentiator::new(work.linkage, stencil, step) }
    }
}

impl Contestant for Differences<'_> {
    fn run(&mut self) {
        let work = self.work;
        for q in &work.coordinates {
            let _ = black_box(self.differentiator.solve(*q));
        }
    }

    fn judge(&mut self) -> Verdict {
        let work = self.work;
        let solutions = groups_of(work.linkage) * self.differentiator.points() as u64;
        work.verdict(solutions, |_, q| {
            let middle = self.differentiator.solve(q)?;
            Ok(middle.bodies.iter().map(|body| body.numbers().map(Dd::from_f64)).collect())
        })
    }
}
