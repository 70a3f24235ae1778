//! Tables of positions and of samples of a motion, filled row by row.

use std::sync::Arc;

use assur_dynamics::{Holding, Instant};
use assur_force::State;

use crate::Calculation;
use crate::families::{Family, Row};
use crate::reader::{Determined, Motions, Reader};
use crate::results::{Schema, Table};

/// Fills tables; the scratch memory of one thread.
pub(crate) struct Filler<'a> {
    calculation: &'a Calculation,
    families: Vec<Family>,
    schema: Arc<Schema>,
    reader: Reader<'a>,
    motions: Motions,
    with_forces: bool,
}

/// Why a row has no reactions, though they are requested.
pub(crate) enum Obstacle {
    /// It is at a change point.
    ChangePoint,
    /// The method fails there: why.
    Refused(String),
}

impl Schema {
    /// The columns of the families that apply.
    pub(crate) fn of(calculation: &Calculation, families: &[Family]) -> Self {
        let mut schema = Self::new(&calculation.linkage.mechanism);
        let families = families.iter().filter(|family| (family.applies)(calculation));
        families.for_each(|family| (family.columns)(calculation, &mut schema));
        schema
    }
}

impl<'a> Filler<'a> {
    /// `with_forces`: whether the rows have forces, if the calculation has them.
    ///
    /// `schema`: the columns of the families.
    pub(crate) fn new(
        calculation: &'a Calculation,
        families: &[Family],
        schema: Arc<Schema>,
        with_forces: bool,
    ) -> Self {
        let families = families.iter().filter(|family| (family.applies)(calculation)).copied().collect();
        let reader = Reader::new(calculation);
        Self { calculation, families, schema, reader, motions: Motions::default(), with_forces }
    }

    /// A table without rows.
    pub(crate) fn table(&self) -> Table {
        Table::new(Arc::clone(&self.schema))
    }

    /// Adds a position of the scene.
    ///
    /// # Errors
    ///
    /// The position has no solution, and gets no row.
    pub(crate) fn position(
        &mut self,
        index: usize,
        table: &mut Table,
    ) -> Result<Option<Obstacle>, assur_kinematics::PositionError> {
        self.reader.solve_index(index)?;
        let state = self.calculation.state(self.reader.position.coordinate);
        Ok(self.row(index, state, None, table))
    }

    /// Adds a sample of a motion.
    ///
    /// # Errors
    ///
    /// The position has no solution, and gets no row.
    pub(crate) fn sample(
        &mut self,
        number: usize,
        instant: &Instant,
        table: &mut Table,
    ) -> Result<Option<Obstacle>, assur_kinematics::PositionError> {
        self.reader.solve(instant.state.coordinate)?;
        Ok(self.row(number, instant.state, instant.holding, table))
    }

    /// Adds the position that is solved.
    fn row(
        &mut self,
        number: usize,
        state: State,
        holding: Option<Holding>,
        table: &mut Table,
    ) -> Option<Obstacle> {
        let calculation = self.calculation;
        self.motions.read(&calculation.linkage, &calculation.plan.wanted, &self.reader.position);
        let loads = calculation.loads.as_ref().filter(|_| calculation.plan.reduction);
        let reduced = loads.map(|loads| loads.reduced(&state, &self.reader.position.bodies));
        let (position, found) = self.reader.forces(&state, self.with_forces);
        let (mut balancing, mut reactions, mut obstacle) = (None, None, None);
        match found {
            Determined::Nothing => {}
            Determined::Balancing(found) => {
                (balancing, obstacle) = (found, Some(Obstacle::ChangePoint));
            }
            Determined::Failed(error) => obstacle = Some(Obstacle::Refused(error.to_string())),
            Determined::All { balancing: found, joints, reactions: pairs } => {
                (balancing, reactions) = (Some(found), Some((joints, pairs)));
            }
        }
        let motions = &self.motions;
        let row = Row { calculation, state, position, motions, reduced, reactions, balancing, holding };
        let mut cells = table.row(number);
        self.families.iter().for_each(|family| (family.fill)(&row, &mut cells));
        obstacle
    }
}
