//! Calculation of all positions.

use std::convert::Infallible;
use std::sync::Arc;

use assur_check::Notable;
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_words::Describe;

use crate::angles::{Angles, Starts};
use crate::blocks::{Block, Blocks};
use crate::progress::{Stopped, Watch};
use crate::results::{Analysis, Failure, InputReport, Peaks, Schema, Survey, Table};
use crate::warnings::{Listed, MOST_FAILURES, Seen};
use crate::{Calculation, Progress, several::Several};

struct Positions {
    kept: Table,
    starts: Starts,
    survey: Survey,
    failures: Vec<Failure>,
    /// Positions at a change point, where reactions are not determined.
    at_change_points: Listed,
    notable: Notable,
    several: Vec<Several>,
}

/// The positions of a mechanism that can't be assembled, at most [`MOST_FAILURES`] of them, and how many there are; nothing
/// else is calculated.
pub fn lost_positions(linkage: &Linkage) -> (Vec<Failure>, usize) {
    let mut position = linkage.position();
    let (mut failures, mut count) = (Vec::new(), 0);
    for index in 0..linkage.mechanism.input.positions {
        let Err(error) = linkage.solve_index(index, Order::Place, &mut position) else { continue };
        count += 1;
        if failures.len() < MOST_FAILURES {
            let (coordinate, message) = (error.coordinate, error.describe());
            failures.push(Failure { index, coordinate, message, key: None, limit: None });
        }
    }
    (failures, count)
}

impl Calculation {
    /// Calculates the results of the scene, without [`checks`](Self::checks). A position without a solution is among
    /// the failures; one without forces too, and keeps the other results.
    ///
    /// Of more than [`Mechanism::most_kept`](assur_mechanism::Mechanism::most_kept) positions only every so many are kept; [`each_block`](Self::each_block) gives all.
    pub fn analyze(&self, watch: &mut Watch<'_>) -> Result<Analysis, Stopped> {
        let mechanism = &self.linkage.mechanism;
        let driver = mechanism.input.first();
        let positions = self.positions(mechanism.input.positions.div_ceil(mechanism.most_kept()), watch)?;
        let samples = self.trajectory(watch)?;
        self.notable.get_or_init(|| [positions.notable.numbers(), samples.notable.numbers()]);
        let warnings = self.warnings(&Seen {
            at_change_points: &positions.at_change_points,
            survey: &positions.survey,
            several: &positions.several,
            without_forces: &samples.without,
        });
        Ok(Analysis {
            title: mechanism.title.clone(),
            input: InputReport {
                link: mechanism.named_link(driver.link),
                pair: driver.is_relative().then(|| mechanism.named_pair(driver.pair_id())),
                kind: self.linkage.kind(),
                angular: !mechanism.input.is_list && mechanism.input.first().is_angle(),
                balancing_is_moment: mechanism.balances_by_moment(),
            },
            structure: crate::results::structure::report(&self.linkage, !self.plan.is_partial()),
            cycle: self.cycle(&positions.survey),
            positions: positions.kept,
            starts: positions.starts,
            survey: positions.survey,
            peaks: Peaks::default(),
            failures: positions.failures,
            trajectory: samples.table,
            dynamics: self.dynamics(),
            integration: self.integration(),
            no_motion: self.no_motion.as_ref().map(Describe::describe),
            friction: self.tells_friction_cycle.then(|| self.friction_cycle()).flatten(),
            several: positions.several,
            warnings,
            checks: Vec::new(),
            residuals: Table::default(),
        })
    }

    /// The numbers of the positions, and of the samples of the motion, in which rounding is greatest.
    pub(crate) fn notable(&self, watch: &mut Watch<'_>) -> Result<&[Vec<usize>; 2], Stopped> {
        if self.notable.get().is_none() {
            let positions = self.positions(usize::MAX, watch)?.notable;
            let samples = self.trajectory(watch)?.notable;
            self.notable.get_or_init(|| [positions.numbers(), samples.numbers()]);
        }
        Ok(self.notable.get_or_init(Default::default))
    }

    /// The columns of the positions.
    pub fn columns(&self) -> Arc<Schema> {
        self.columns_of_positions().schema
    }

    /// The rows of all positions, and nothing else.
    pub fn rows(&self, watch: &mut Watch<'_>) -> Result<Table, Stopped> {
        Ok(self.positions(1, watch)?.kept)
    }

    /// All positions, of which every `stride`-th is kept.
    fn positions(&self, stride: usize, watch: &mut Watch<'_>) -> Result<Positions, Stopped> {
        let blocks = Blocks::new(self);
        let schema = &blocks.columns.schema;
        let mut angles = Angles::new(schema);
        let mut found = Positions {
            kept: Table::new(schema.clone()),
            starts: Starts::default(),
            survey: Survey::new(schema),
            failures: Vec::new(),
            at_change_points: Listed::default(),
            notable: Notable::default(),
            several: Vec::new(),
        };
        let progress = |done, total| Progress::Positions { done, total };
        let add = |(mut block, not_finite): (Block, Option<(usize, usize)>)| {
            found.starts.push(&angles);
            angles.follow(&self.linkage, &mut block.table);
            found.survey.add(&block.table, not_finite);
            found.survey.failures += block.failures.len();
            found.kept.append(&block.table, |number| number.is_multiple_of(stride));
            let room = MOST_FAILURES - found.failures.len();
            found.failures.extend(block.failures.into_iter().take(room));
            block.at_change_points.into_iter().for_each(|index| found.at_change_points.add(index));
            found.notable.append(&block.notable);
            let keeps = |one: &Several| one.index.is_multiple_of(stride);
            found.several.extend(block.several.into_iter().filter(keeps));
            Ok::<_, Infallible>(())
        };
        let examined = |_, block: Block| {
            let not_finite = block.table.not_finite();
            (block, not_finite)
        };
        blocks.each(watch, progress, examined, add).map(|Ok(())| found)
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
        let continued = |number, mut block: Block| {
            let mut angles = analysis.starts.of(number, block.table.schema());
            angles.follow(&self.linkage, &mut block.table);
            block.table.join(&analysis.residuals);
            work(&block.table)
        };
        Blocks::new(self).each(watch, progress, continued, &mut take)
    }
}
