//! The motion over time: every sample of a transient motion, one cycle of a steady one.

use assur_check::Notable;
use assur_dynamics::Instant;
use assur_force::{ForceError, LoadState};
use assur_number::Lanes;
use assur_words::{Describe, Text};

use crate::filler::{Filler, Obstacle, instant};
use crate::progress::{Stopped, Watch, step};
use crate::{Calculation, InputMotion, Progress, angles::Angles, motion::CYCLE_INTERVALS, results::Table};

pub(crate) struct Samples {
    pub(crate) table: Table,
    pub(crate) without: WithoutForces,
    pub(crate) notable: Notable,
}

/// Samples of a motion that have no forces.
#[derive(Debug, Default)]
pub(crate) struct WithoutForces {
    pub(crate) at_change_points: usize,
    /// For how many of them the method fails, or a load has no value.
    pub(crate) refused: usize,
    /// Why at the first of them.
    pub(crate) reason: Option<Text>,
}

impl WithoutForces {
    fn add(&mut self, obstacle: &Obstacle) {
        match obstacle {
            // Does not occur in a state that an integrator has reached.
            Obstacle::Unsolved(_) => {}
            Obstacle::Forceless(ForceError::ChangePoint(_), _) => self.at_change_points += 1,
            Obstacle::Forceless(why, _) => {
                self.refused += 1;
                self.reason.get_or_insert_with(|| why.describe());
            }
        }
    }
}

impl Calculation {
    /// The states of a trajectory, in order of time; empty with a prescribed motion.
    pub(crate) fn states(&self) -> Vec<LoadState> {
        self.instants().into_iter().map(|instant| instant.state).collect()
    }

    fn instants(&self) -> Vec<Instant> {
        match &self.motion {
            InputMotion::Prescribed => Vec::new(),
            InputMotion::Transient(found) => found.instants.clone(),
            InputMotion::Steady(found) => {
                let input = &self.linkage.mechanism.input;
                let cycle = input.sign() * input.period().unwrap_or(0.0);
                let end = found.regime.cycle_time;
                let each = (0..=CYCLE_INTERVALS).map(|i| {
                    let state = self.state(input.from + cycle * (f64::from(i) / f64::from(CYCLE_INTERVALS)));
                    // The end of the cycle is its start, one cycle later.
                    let time = if i == CYCLE_INTERVALS { end } else { state.time };
                    instant(LoadState { time, ..state })
                });
                each.collect()
            }
        }
    }

    /// The samples, with forces for a transient motion, because its positions have none; and where they are missing.
    pub(crate) fn trajectory(&self, watch: &mut Watch<'_>) -> Result<Samples, Stopped> {
        let transient = matches!(self.motion, InputMotion::Transient(_));
        let columns = self.columns_of_motion();
        let mut filler = Filler::new(self, &columns, transient);
        let (mut table, mut without) = (filler.table(), WithoutForces::default());
        let instants = self.instants();
        for first in (0..instants.len()).step_by(Lanes::WIDTH) {
            step(watch, Progress::Samples { done: first, total: instants.len() })?;
            let eight = std::array::from_fn(|lane| instants[(first + lane).min(instants.len() - 1)]);
            let obstacles = filler.add(first, &eight, instants.len() - first, &mut table);
            for (_, obstacle) in &obstacles {
                without.add(obstacle);
            }
        }
        Angles::new(table.schema()).follow(&self.linkage, &mut table);
        table.join(&self.energies());
        Ok(Samples { table, without, notable: filler.notable })
    }
}
