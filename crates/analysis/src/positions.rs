//! Calculation of all positions.

use std::sync::Arc;

use assur_group::Order;

use crate::progress::{Stopped, Watch, step};
use crate::reader::Reader;
use crate::results::{Analysis, Cycle, Failure, InputReport, Named, PositionResult};
use crate::{Calculation, Progress, structure};

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
    /// the failures, and keeps the results that could still be calculated there.
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
        let mut positions = Positions::new(self);
        let total = mechanism.input.positions;
        for index in 0..total {
            step(watch, Progress::Positions { done: index, total })?;
            positions.add(index);
        }
        let (trajectory, without_forces) = self.trajectory(watch)?;
        let angular = self.linkage.angular();
        Ok(Analysis {
            format: Analysis::FORMAT,
            title: mechanism.title.clone(),
            input: InputReport {
                link: mechanism.links[mechanism.input.link].name.clone(),
                angular,
                balancing_is_moment: mechanism.balances_by_moment(),
            },
            structure: structure::report(&self.linkage, !self.plan.is_partial()),
            cycle: Cycle::default(),
            positions: positions.found,
            failures: positions.failures,
            trajectory,
            dynamics: self.dynamics(),
            integration: self.integration(),
            no_motion: self.no_motion.clone(),
            notes: self.notes(&positions.without_forces, &without_forces),
            checks: Vec::new(),
        })
    }
}

/// The results of the positions as they are added.
struct Positions<'a> {
    calculation: &'a Calculation,
    groups: Vec<Arc<str>>,
    reader: Reader<'a>,
    found: Vec<PositionResult>,
    failures: Vec<Failure>,
    /// Positions at a change point, where reactions are not determined.
    without_forces: Vec<usize>,
}

impl<'a> Positions<'a> {
    fn new(calculation: &'a Calculation) -> Self {
        let linkage = &calculation.linkage;
        Self {
            calculation,
            groups: (0..linkage.structure.groups.len()).map(|index| index.to_string().into()).collect(),
            reader: Reader::new(calculation),
            found: Vec::with_capacity(linkage.mechanism.input.positions),
            failures: Vec::new(),
            without_forces: Vec::new(),
        }
    }

    fn add(&mut self, index: usize) {
        if let Err(error) = self.reader.solve_index(index) {
            let (coordinate, message) = (error.coordinate, error.to_string());
            self.failures.push(Failure { index, coordinate, message });
            return;
        }
        let mut result = self.motion(index);
        let calculation = self.calculation;
        let state = calculation.state(result.coordinate);
        if let (true, Some(loads)) = (calculation.plan.reduction, &calculation.loads) {
            result.reduced = Some(loads.reduced(&state, &self.reader.position.bodies));
        }
        if self.reader.has_forces() && calculation.positions_have_forces() {
            if calculation.linkage.is_at_change_point(&self.reader.position) {
                result.balancing = self.reader.balancing_alone(&state);
                self.without_forces.push(index);
            } else {
                match self.reader.forces(&state) {
                    Some(Ok((reactions, balancing))) => {
                        (result.reactions, result.balancing) = (reactions, Some(balancing));
                    }
                    Some(Err(error)) => {
                        let message = format!("position {index}: {error}");
                        self.failures.push(Failure { index, coordinate: result.coordinate, message });
                    }
                    None => {}
                }
            }
        }
        self.found.push(result);
    }

    /// Transfer functions, rates and condition.
    fn motion(&mut self, index: usize) -> PositionResult {
        let (calculation, coordinate) = (self.calculation, self.reader.position.coordinate);
        let found = self.reader.transfers();
        let moves = calculation.motion.moves(&calculation.linkage.mechanism);
        let state = calculation.state(coordinate);
        let rates = (moves && calculation.plan.velocities).then(|| found.rates(&state));
        let [velocities, accelerations] = rates.map_or([None, None], |rates| rates.map(Some));
        PositionResult {
            index,
            coordinate,
            speed: moves.then_some(state.speed),
            acceleration: moves.then_some(state.acceleration),
            velocities,
            accelerations,
            reduced: None,
            reactions: None,
            balancing: None,
            by_cause: None,
            condition: self.condition(),
            links: found.links,
            points: found.points,
            slides: found.slides,
        }
    }

    /// 1 / |health| of the groups that are solved; a group in a singular position has none that is a number.
    fn condition(&self) -> Named<f64> {
        let health = &self.reader.position.health;
        let each = self.groups.iter().zip(health).zip(&self.calculation.plan.groups_needed);
        each.filter(|((_, health), needed)| **needed && health.abs() > f64::MIN_POSITIVE)
            .map(|((name, health), _)| (Arc::clone(name), 1.0 / health.abs()))
            .collect()
    }
}
