//! The positions block by block, by all threads, in their order.

use std::ops::Range;
use std::sync::Arc;

use rayon::prelude::*;

use crate::angles::Angles;
use crate::families::POSITIONS;
use crate::filler::{Filler, Obstacle};
use crate::progress::{Stopped, Watch, step};
use crate::results::{Failure, Schema, Table};
use crate::{Calculation, Progress};

/// Numbers in a block: half a megabyte, which the cache of a core holds.
const NUMBERS: usize = 1 << 16;

/// Some consecutive positions.
pub(crate) struct Block {
    /// Those that have a solution.
    pub(crate) table: Table,
    pub(crate) failures: Vec<Failure>,
    /// Positions at a change point, where reactions are not determined.
    pub(crate) at_change_points: Vec<usize>,
}

/// The positions of a calculation, divided into blocks. What a block contains does not depend on threads or on the
/// order in which blocks are calculated.
pub(crate) struct Blocks<'a> {
    calculation: &'a Calculation,
    pub(crate) schema: Arc<Schema>,
    /// Positions of a block.
    rows: usize,
}

impl<'a> Blocks<'a> {
    pub(crate) fn new(calculation: &'a Calculation) -> Self {
        let schema = Arc::new(Schema::of(calculation, POSITIONS));
        let rows = (NUMBERS / schema.columns().len().max(1)).max(1);
        Self { calculation, schema, rows }
    }

    /// How many blocks there are.
    pub(crate) fn len(&self) -> usize {
        self.positions().div_ceil(self.rows)
    }

    fn positions(&self) -> usize {
        self.calculation.linkage.mechanism.input.positions
    }

    /// Calculates a block; angles are in (-pi, pi].
    fn block(&self, filler: &mut Filler<'_>, number: usize) -> Block {
        let range = number * self.rows..((number + 1) * self.rows).min(self.positions());
        let mut block = Block { table: filler.table(), failures: Vec::new(), at_change_points: Vec::new() };
        let input = &self.calculation.linkage.mechanism.input;
        for index in range {
            let message = match filler.position(index, &mut block.table) {
                Ok(None) => continue,
                Ok(Some(Obstacle::ChangePoint)) => {
                    block.at_change_points.push(index);
                    continue;
                }
                Ok(Some(Obstacle::Refused(error))) => format!("position {index}: {error}"),
                Err(error) => error.to_string(),
            };
            block.failures.push(Failure { index, coordinate: input.coordinate(index), message });
        }
        block
    }

    /// Calculates all blocks; `work` makes something of each, on any thread, and `take` receives it in order.
    /// The inner error is that of `take`, which ends the work.
    pub(crate) fn each<T: Send, E>(
        &self,
        watch: &mut Watch<'_>,
        progress: fn(usize, usize) -> Progress,
        work: impl Fn(usize, Block) -> T + Sync,
        mut take: impl FnMut(T) -> Result<(), E>,
    ) -> Result<Result<(), E>, Stopped> {
        let filler =
            || Filler::new(self.calculation, POSITIONS, Arc::clone(&self.schema), self.with_forces());
        let total = self.positions();
        // Enough for all threads, and few enough to keep in memory.
        let wave = if self.len() > 1 { 4 * rayon::current_num_threads() } else { 1 };
        for first in (0..self.len()).step_by(wave) {
            step(watch, progress(first * self.rows, total))?;
            let numbers: Range<usize> = first..(first + wave).min(self.len());
            if wave == 1 {
                return Ok(take(work(first, self.block(&mut filler(), first))));
            }
            let blocks = numbers.into_par_iter().with_max_len(1);
            let found: Vec<T> =
                blocks.map_init(filler, |filler, number| work(number, self.block(filler, number))).collect();
            if let Err(error) = found.into_iter().try_for_each(&mut take) {
                return Ok(Err(error));
            }
        }
        Ok(Ok(()))
    }

    fn with_forces(&self) -> bool {
        self.calculation.positions_have_forces()
    }
}

/// The angles before each block, which let it continue those of the blocks before it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Starts(Vec<Angles>);

impl Starts {
    /// Makes the angles of the next block continuous, and keeps those before it.
    pub(crate) fn follow(&mut self, angles: &mut Angles, calculation: &Calculation, table: &mut Table) {
        self.0.push(angles.clone());
        angles.follow(&calculation.linkage, table);
    }

    /// Makes the angles of a block continuous again.
    pub(crate) fn continue_block(&self, number: usize, calculation: &Calculation, table: &mut Table) {
        if let Some(mut angles) = self.0.get(number).cloned() {
            angles.follow(&calculation.linkage, table);
        }
    }
}
