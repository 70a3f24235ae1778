//! Calculation of all positions.

use std::convert::Infallible;

use assur_group::Order;

use crate::angles::Angles;
use crate::blocks::{Blocks, Starts};
use crate::notes::Listed;
use crate::progress::{Stopped, Watch};
use crate::results::{Analysis, Failure, InputReport, Survey, Table};
use crate::{Calculation, Progress, structure};

/// Most positions that an [`Analysis`] keeps; of more, every so many.
pub const MOST_KEPT: usize = 4096;
/// Most failures that are kept in full.
pub const MOST_FAILURES: usize = 1000;

/// The positions of a scene.
struct Positions {
    kept: Table,
    starts: Starts,
    survey: Survey,
    failures: Vec<Failure>,
    /// Positions at a change point, where reactions are not determined.
    at_change_points: Listed,
}

impl Calculation {
    /// The positions that can't be assembled, at most [`MOST_FAILURES`] of them, and how many there are; nothing else is
    /// calculated.
    pub fn failures(&self) -> (Vec<Failure>, usize) {
        let mut position = self.linkage.position();
        let (mut failures, mut count) = (Vec::new(), 0);
        for index in 0..self.linkage.mechanism.input.positions {
            let Err(error) = self.linkage.solve_index(index, Order::Place, &mut position) else { continue };
            count += 1;
            if failures.len() < MOST_FAILURES {
                failures.push(Failure { index, coordinate: error.coordinate, message: error.to_string() });
            }
        }
        (failures, count)
    }

    /// Calculates the results of the scene, without [`checks`](Self::checks). A position without a solution is among
    /// the failures; one without forces too, and keeps the other results.
    ///
    /// Of more than [`MOST_KEPT`] positions only every so many are kept; [`each_block`](Self::each_block) gives all.
    ///
    /// # Errors
    ///
    /// [`Stopped`] where `watch` breaks.
    pub fn analyze(&self, watch: &mut Watch<'_>) -> Result<Analysis, Stopped> {
        let mechanism = &self.linkage.mechanism;
        let positions = self.positions(mechanism.input.positions.div_ceil(MOST_KEPT), watch)?;
        let (trajectory, without_forces) = self.trajectory(watch)?;
        let mut notes = self.notes(&positions.at_change_points, &without_forces);
        // A load may act in a position that is not kept.
        if mechanism.input.positions <= MOST_KEPT {
            notes.extend(self.idle_loads(&positions.kept));
        }
        if let Some(more) = positions.survey.failures.checked_sub(MOST_FAILURES).filter(|more| *more > 0) {
            notes.push(format!("{more} more failures are not listed."));
        }
        Ok(Analysis {
            title: mechanism.title.clone(),
            input: InputReport {
                link: mechanism.links[mechanism.input.link].name.clone(),
                angular: self.linkage.angular(),
                balancing_is_moment: mechanism.balances_by_moment(),
            },
            structure: structure::report(&self.linkage, !self.plan.is_partial()),
            cycle: self.cycle(&positions.survey),
            positions: positions.kept,
            starts: positions.starts,
            survey: positions.survey,
            failures: positions.failures,
            trajectory,
            dynamics: self.dynamics(),
            integration: self.integration(),
            no_motion: self.no_motion.as_ref().map(ToString::to_string),
            notes,
            checks: Vec::new(),
            residuals: Table::default(),
        })
    }

    /// All positions, of which every `stride`-th is kept.
    fn positions(&self, stride: usize, watch: &mut Watch<'_>) -> Result<Positions, Stopped> {
        let blocks = Blocks::new(self);
        let mut angles = Angles::new(&blocks.schema);
        let mut found = Positions {
            kept: Table::new(blocks.schema.clone()),
            starts: Starts::default(),
            survey: Survey::new(&blocks.schema),
            failures: Vec::new(),
            at_change_points: Listed::default(),
        };
        let progress = |done, total| Progress::Positions { done, total };
        blocks
            .each(
                watch,
                progress,
                |_, block| block,
                |mut block| {
                    found.starts.follow(&mut angles, self, &mut block.table);
                    found.survey.add(&block.table);
                    found.survey.failures += block.failures.len();
                    found.kept.append(&block.table, |number| number.is_multiple_of(stride));
                    let room = MOST_FAILURES - found.failures.len();
                    found.failures.extend(block.failures.into_iter().take(room));
                    block.at_change_points.into_iter().for_each(|index| found.at_change_points.add(index));
                    Ok::<_, Infallible>(())
                },
            )
            .map(|Ok(())| found)
    }

    /// All positions of an analysis in their order: `work` makes something of each block of rows, on any thread, and
    /// `take` receives it in order; an error of `take` ends it.
    ///
    /// Where the analysis keeps all positions they are one block, and nothing is calculated again.
    ///
    /// # Errors
    ///
    /// [`Stopped`] where `watch` breaks; the inner error is that of `take`.
    pub fn each_block<T: Send, E>(
        &self,
        analysis: &Analysis,
        watch: &mut Watch<'_>,
        work: impl Fn(&Table) -> T + Sync,
        mut take: impl FnMut(T) -> Result<(), E>,
    ) -> Result<Result<(), E>, Stopped> {
        if analysis.is_complete() {
            return Ok(take(work(&analysis.positions)));
        }
        let progress = |done, total| Progress::Writing { done, total };
        let continued = |number, mut block: crate::blocks::Block| {
            analysis.starts.continue_block(number, self, &mut block.table);
            block.table.join(&analysis.residuals);
            work(&block.table)
        };
        Blocks::new(self).each(watch, progress, continued, &mut take)
    }
}
