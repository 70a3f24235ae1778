//! Calculation of all positions.

use assur_group::Order;

use crate::angles::Angles;
use crate::families::POSITIONS;
use crate::filler::{Filler, Obstacle};
use crate::progress::{Stopped, Watch, step};
use crate::results::{Analysis, Cycle, Failure, InputReport, Table};
use crate::{Calculation, Progress, structure};

/// The positions of a scene.
struct Positions {
    table: Table,
    failures: Vec<Failure>,
    /// Positions at a change point, where reactions are not determined.
    at_change_points: Vec<usize>,
}

impl Calculation {
    /// The positions that can't be assembled; nothing else is calculated.
    pub fn failures(&self) -> Vec<Failure> {
        let mut position = self.linkage.position();
        let indices = 0..self.linkage.mechanism.input.positions;
        let failed = indices.filter_map(|index| {
            let error = self.linkage.solve_index(index, Order::Place, &mut position).err()?;
            Some(Failure { index, coordinate: error.coordinate, message: error.to_string() })
        });
        failed.collect()
    }

    /// Calculates the results of the scene, without [`checks`](Self::checks). A position without a solution is among
    /// the failures; one without forces too, and keeps the other results.
    ///
    /// # Errors
    ///
    /// [`Stopped`] where `watch` breaks.
    pub fn analyze(&self, watch: &mut Watch<'_>) -> Result<Analysis, Stopped> {
        let found = self.analyze_positions(watch)?;
        Ok(Analysis { cycle: self.cycle(&found.positions), ..found })
    }

    /// Calculates the positions and the motion without the results over the whole cycle (extremes of the reactions,
    /// sides of the guides, contacts): for grids of many scenes, which do not use them.
    ///
    /// # Errors
    ///
    /// [`Stopped`] where `watch` breaks.
    pub fn analyze_positions(&self, watch: &mut Watch<'_>) -> Result<Analysis, Stopped> {
        let mechanism = &self.linkage.mechanism;
        let positions = self.positions(watch)?;
        let (trajectory, without_forces) = self.trajectory(watch)?;
        Ok(Analysis {
            title: mechanism.title.clone(),
            input: InputReport {
                link: mechanism.links[mechanism.input.link].name.clone(),
                angular: self.linkage.angular(),
                balancing_is_moment: mechanism.balances_by_moment(),
            },
            structure: structure::report(&self.linkage, !self.plan.is_partial()),
            cycle: Cycle::default(),
            positions: positions.table,
            failures: positions.failures,
            trajectory,
            dynamics: self.dynamics(),
            integration: self.integration(),
            no_motion: self.no_motion.as_ref().map(ToString::to_string),
            notes: self.notes(&positions.at_change_points, &without_forces),
            checks: Vec::new(),
        })
    }

    fn positions(&self, watch: &mut Watch<'_>) -> Result<Positions, Stopped> {
        let mut filler = Filler::new(self, POSITIONS, self.positions_have_forces());
        let mut found =
            Positions { table: filler.table(), failures: Vec::new(), at_change_points: Vec::new() };
        let input = &self.linkage.mechanism.input;
        let total = input.positions;
        for index in 0..total {
            step(watch, Progress::Positions { done: index, total })?;
            let message = match filler.position(index, &mut found.table) {
                Ok(None) => continue,
                Ok(Some(Obstacle::ChangePoint)) => {
                    found.at_change_points.push(index);
                    continue;
                }
                Ok(Some(Obstacle::Refused(error))) => format!("position {index}: {error}"),
                Err(error) => error.to_string(),
            };
            found.failures.push(Failure { index, coordinate: input.coordinate(index), message });
        }
        Angles::new(found.table.schema()).follow(&self.linkage, &mut found.table);
        Ok(found)
    }
}
