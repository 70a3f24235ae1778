//! The positions block by block, by all threads, in their order.

use assur_check::Notable;
use assur_force::ForceError;
use assur_kinematics::PositionError;
use assur_number::Lanes;
use assur_words::{Describe, text};
use rayon::prelude::*;

use crate::filler::{Filler, Obstacle, instant};
use crate::progress::{Stopped, Watch, step};
use crate::results::{Failure, Table};
use crate::{Calculation, Progress, families::Columns, friction::jammed, several::Several};

/// Numbers in a block: a quarter of a megabyte, which the cache of a core holds together with their text.
const NUMBERS: usize = 1 << 15;
/// Blocks by thread that are calculated before any of them is written: enough to keep all threads busy, and few enough
/// to keep in memory.
const BLOCKS: usize = 2;

/// Some consecutive positions.
pub(crate) struct Block {
    /// Those that have a solution; angles are in (-pi, pi].
    pub(crate) table: Table,
    pub(crate) failures: Vec<Failure>,
    /// Positions at a change point, where reactions are not determined.
    pub(crate) at_change_points: Vec<usize>,
    pub(crate) notable: Notable,
    /// Positions in which friction has several solutions.
    pub(crate) several: Vec<Several>,
}

/// The positions of a calculation, divided into blocks. What a block contains does not depend on threads or on the
/// order in which blocks are calculated.
pub(crate) struct Blocks<'a> {
    calculation: &'a Calculation,
    pub(crate) columns: Columns,
    /// Positions of a block.
    rows: usize,
}

impl<'a> Blocks<'a> {
    pub(crate) fn new(calculation: &'a Calculation) -> Self {
        let columns = calculation.columns_of_positions();
        let rows = NUMBERS / columns.schema.columns().len().max(1);
        Self { calculation, columns, rows: rows.next_multiple_of(Lanes::WIDTH).max(Lanes::WIDTH) }
    }

    fn positions(&self) -> usize {
        self.calculation.linkage.mechanism.input.positions
    }

    fn filler(&self) -> Filler<'_> {
        Filler::new(self.calculation, &self.columns, self.calculation.positions_have_forces())
    }

    fn block(&self, filler: &mut Filler<'_>, number: usize) -> Block {
        let end = ((number + 1) * self.rows).min(self.positions());
        let (mut table, mut failures, mut at_change_points) = (filler.table(), Vec::new(), Vec::new());
        table.reserve(self.rows);
        let mechanism = &self.calculation.linkage.mechanism;
        let input = &mechanism.input;
        filler.notable = Notable::default();
        for first in (number * self.rows..end).step_by(Lanes::WIDTH) {
            let state = |lane: usize| self.calculation.state(input.coordinate((first + lane).min(end - 1)));
            let instants = std::array::from_fn(|lane| instant(state(lane)));
            for (index, obstacle) in filler.add(first, &instants, end - first, &mut table) {
                let at = |error| text!("analysis-at-position", number = index, error);
                let (message, key, limit) = match obstacle {
                    Obstacle::Unsolved(error) => {
                        (PositionError { index: Some(index), ..error }.describe(), None, None)
                    }
                    Obstacle::Forceless(ForceError::ChangePoint(_), _) => {
                        at_change_points.push(index);
                        continue;
                    }
                    Obstacle::Forceless(error, limit) => {
                        let key =
                            if let ForceError::Load(load) = &error { load.key(mechanism) } else { None };
                        (at(jammed(mechanism, error.describe(), limit)), key, limit)
                    }
                };
                failures.push(Failure { index, coordinate: input.coordinate(index), message, key, limit });
            }
        }
        Block {
            table,
            failures,
            at_change_points,
            notable: std::mem::take(&mut filler.notable),
            several: std::mem::take(&mut filler.several),
        }
    }

    /// Calculates all blocks; `work` makes something of each, on any thread, and `take` receives it in order, while the
    /// next blocks are calculated. The inner error is that of `take`, which ends the work.
    pub(crate) fn each<T: Send, E>(
        &self,
        watch: &mut Watch<'_>,
        progress: fn(usize, usize) -> Progress,
        work: impl Fn(usize, Block) -> T + Sync,
        mut take: impl FnMut(T) -> Result<(), E>,
    ) -> Result<Result<(), E>, Stopped> {
        let total = self.positions();
        step(watch, progress(0, total))?;
        let count = total.div_ceil(self.rows);
        if count <= 1 {
            // No threads are started for little work.
            let mut only = (0..count).map(|number| work(number, self.block(&mut self.filler(), number)));
            return Ok(only.try_for_each(take));
        }
        let together = BLOCKS * rayon::current_num_threads();
        let calculated = |first: usize| -> Vec<T> {
            let blocks = (first..(first + together).min(count)).into_par_iter().with_max_len(1);
            let one = |filler: &mut Filler<'_>, number| work(number, self.block(filler, number));
            blocks.map_init(|| self.filler(), one).collect()
        };
        let mut found = calculated(0);
        for next in (together..count + together).step_by(together) {
            let (now, mut following) = (std::mem::take(&mut found), Vec::new());
            let taken = rayon::in_place_scope(|scope| {
                scope.spawn(|_| following = calculated(next.min(count)));
                now.into_iter().try_for_each(&mut take)
            });
            if taken.is_err() {
                return Ok(taken);
            }
            found = following;
            if next < count {
                step(watch, progress(next * self.rows, total))?;
            }
        }
        Ok(Ok(()))
    }
}
