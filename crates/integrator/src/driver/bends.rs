//! Landing where the equation bends inside a piece: where a force whose modulus gives friction changes its sign.

use assur_number::search::try_bisect;

use super::{Drive, Plan};
use crate::{Dense, IntegrationError, MotionError, Node, Stepper};

/// A number below this part of the greatest is where it changes its sign: a step has landed there.
const LANDED: f64 = 1e-7;

/// Width of the part of a step to which a change of sign is found.
const WIDTH: f64 = 1e-12;

impl<S: Stepper> Drive<'_, S> {
    /// The bends at the present state, where there are any.
    pub(super) fn note_bends(&mut self) -> Result<(), IntegrationError> {
        if self.run.equation.depends_on_acceleration() {
            let found = self.run.equation.bends(&self.run.node.state);
            self.bends[0] = found.map_err(|source| self.run.failed(source))?;
        }
        Ok(())
    }

    /// Whether a step has to be repeated up to a bend inside it; then it is planned.
    pub(super) fn bends_within(&mut self, plan: &Plan, to: &Node) -> Result<bool, IntegrationError> {
        if self.bends[0].is_empty() || S::PARABOLIC {
            return Ok(false);
        }
        let Ok(after) = self.run.equation.bends(&to.state) else { return Ok(false) };
        let size = after.iter().chain(&self.bends[0]).fold(0.0_f64, |most, bend| most.max(bend.abs()));
        let turns = |(before, after): (&f64, &f64)| before * after < 0.0 && before.abs() > LANDED * size;
        let changed = self.bends[0].iter().zip(&after).position(turns);
        let Some(which) = changed.filter(|_| !plan.to_bend) else {
            self.bends[1] = after;
            return Ok(false);
        };
        let dense = self.dense(to)?;
        let found = self.bend_in(&dense, which);
        let theta = found.map_err(|source| self.run.failed(source))?;
        self.run.statistics.rejected += 1;
        self.redo = Some((theta * plan.h, None));
        Ok(true)
    }

    /// The part of a step after which a number changes its sign.
    fn bend_in(&mut self, dense: &Dense, which: usize) -> Result<f64, MotionError> {
        let before = self.bends[0][which];
        let [_, after] = try_bisect(0.0, 1.0, WIDTH, |theta| {
            Ok(self.run.equation.bends(&dense.at(theta))?[which] * before > 0.0)
        })?;
        Ok(after)
    }
}
