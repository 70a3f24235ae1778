//! Tables of positions and of samples of a motion, filled eight rows at a time.

use std::cell::OnceCell;
use std::sync::Arc;

use assur_check::Notable;
use assur_dynamics::Instant;
use assur_force::{ForceError, Kinetostatics, LaneKinetostatics, LoadState};
use assur_kinematics::{LanePosition, PositionError};
use assur_number::Lanes;

use crate::families::{Columns, Rows, TableRows};
use crate::results::{Mask, Table};
use crate::{Calculation, joints::Joints, several::Several};

/// A state of a motion that nothing holds.
pub(crate) fn instant(state: LoadState) -> Instant {
    Instant { state, holding: None, friction: 0.0 }
}

/// Fills tables; the scratch memory of one thread.
pub(crate) struct Filler<'a> {
    calculation: &'a Calculation,
    columns: &'a Columns,
    position: LanePosition,
    forces: Option<(LaneKinetostatics<'a>, Joints)>,
    /// Where rounding is greatest among the rows that were added.
    pub(crate) notable: Notable,
    /// Rows in which friction has several solutions, by their numbers.
    pub(crate) several: Vec<Several>,
}

/// Why there is no row, or none with reactions, though they are requested.
pub(crate) enum Obstacle {
    /// The position has no solution.
    Unsolved(PositionError),
    /// No forces are found: a load has no value, it is at a change point, or the method finds none there; where it jams by
    /// friction, up to which part of the coefficients there is a solution.
    Forceless(ForceError, Option<f64>),
}

impl<'a> Filler<'a> {
    /// `with_forces`: whether the rows have forces, if the calculation has them.
    pub(crate) fn new(calculation: &'a Calculation, columns: &'a Columns, with_forces: bool) -> Self {
        let Calculation { linkage, plan, .. } = calculation;
        let forces = match (&calculation.loads, calculation.analyzer) {
            (Some(loads), Some(analyzer)) if with_forces => {
                let single = Kinetostatics::new(linkage, loads, analyzer.instance, &plan.groups_carrying);
                Some((LaneKinetostatics::new(single), Joints::new(linkage, &plan.wanted.reactions)))
            }
            _ => None,
        };
        Self {
            calculation,
            columns,
            position: linkage.lane_position(),
            forces,
            notable: Notable::default(),
            several: Vec::new(),
        }
    }

    /// A table without rows.
    pub(crate) fn table(&self) -> Table {
        Table::new(Arc::clone(&self.columns.schema))
    }

    /// Adds the rows of the first `count` of eight instants, whose numbers follow `first`: of those that have a position.
    /// Returns the numbers without a position or without forces, in order.
    pub(crate) fn add(
        &mut self,
        first: usize,
        instants: &[Instant; Lanes::WIDTH],
        count: usize,
        table: &mut Table,
    ) -> Vec<(usize, Obstacle)> {
        let Calculation { linkage, plan, .. } = self.calculation;
        let mut rows: Mask = std::array::from_fn(|lane| lane < count);
        let mut obstacles = Vec::new();
        let coordinates = Lanes(instants.map(|instant| instant.state.coordinate));
        let unsolved = linkage.solve_lanes(coordinates, plan.order, &mut self.position).err();
        for (lane, error) in unsolved.into_iter().flatten() {
            if std::mem::take(&mut rows[lane]) {
                obstacles.push((first + lane, Obstacle::Unsolved(error)));
            }
        }
        if rows.contains(&true) {
            let more = self.fill(first, rows, instants, table);
            obstacles.extend(more.into_iter().map(|(lane, obstacle)| (first + lane, obstacle)));
            obstacles.sort_by_key(|(number, _)| *number);
        }
        obstacles
    }

    /// Adds some of the positions that are solved; returns the lanes that have no row or no reactions.
    fn fill(
        &mut self,
        first: usize,
        mut rows: Mask,
        instants: &[Instant; Lanes::WIDTH],
        table: &mut Table,
    ) -> Vec<(usize, Obstacle)> {
        let calculation = self.calculation;
        let Calculation { linkage, plan, loads, .. } = calculation;
        let states = instants.map(|instant| instant.state);
        let loads = loads.as_ref().filter(|_| plan.reduction);
        let reduced = loads.map(|loads| loads.reduced(&states, &self.position.bodies));
        let mut obstacles = Vec::new();
        for (loads, reduced) in loads.into_iter().zip(&reduced) {
            for lane in (0..Lanes::WIDTH).filter(|&lane| !reduced.moment.0[lane].is_finite()) {
                let bodies: Vec<_> = self.position.bodies.iter().map(|body| body.lane(lane)).collect();
                let finite = loads.finite(&linkage.mechanism, &states[lane], &bodies);
                if let (Err(error), true) = (finite, std::mem::take(&mut rows[lane])) {
                    obstacles.push((lane, Obstacle::Forceless(error.into(), None)));
                }
            }
        }
        let (determined, balancing, refused) = self.solve_forces(first, rows, &states);
        obstacles.extend(refused);
        let reactions = self.forces.as_ref().map(|(forces, joints)| (joints, &forces.reactions, determined));
        let found = reactions.map(|(_, reactions, determined)| (determined, reactions));
        let (position, instants) = (&self.position, *instants);
        self.notable.add(linkage, first, (rows, position), found);
        let (sizes, greatest_force) = (OnceCell::new(), OnceCell::new());
        let partials = linkage.partials(position);
        let known = Rows {
            calculation,
            instants,
            position,
            reduced,
            reactions,
            balancing,
            partials,
            sizes,
            greatest_force,
        };
        self.columns.of.emit(calculation, &mut TableRows(&known, table.rows(first, rows)));
        obstacles
    }

    /// Finds the forces in these lanes: where they are determined, the balancing loads, and why others have none.
    fn solve_forces(&mut self, first: usize, rows: Mask, states: &[LoadState; Lanes::WIDTH]) -> Forces {
        let Self { forces, position, several, calculation, .. } = self;
        let Some((forces, _)) = forces else { return (rows, [None; Lanes::WIDTH], Vec::new()) };
        let mut refused = forces.solve(states, position).err().unwrap_or_default();
        for lane in (0..Lanes::WIDTH).filter(|&lane| rows[lane] && calculation.rests_by_shares(&states[lane]))
        {
            if refused.iter().all(|(failed, _)| *failed != lane) {
                refused.extend(
                    forces.leave_shares_open(lane, &states[lane], position).err().map(|error| (lane, error)),
                );
            }
        }
        if let Some(friction) = &mut forces.reactions.friction {
            let doubts = friction.doubts.drain(..).filter(|(lane, _)| rows[*lane]);
            let open = |lane: usize| {
                let open = forces.reactions.open.iter();
                open.map(|open| !calculation.least_norm && open.0[lane] > 0.0).collect::<Vec<_>>()
            };
            let linkage = &calculation.linkage;
            several
                .extend(doubts.map(|(lane, doubt)| Several::of(linkage, first + lane, &doubt, &open(lane))));
        }
        let (mut determined, mut balancing) = (rows, forces.reactions.balancing.0.map(Some));
        let obstacle = |(lane, error): (usize, ForceError)| {
            (determined[lane], balancing[lane]) = (false, None);
            let mut limit = None;
            match error {
                ForceError::Jammed { .. } => limit = forces.jamming_limit(lane, &states[lane], position),
                ForceError::ChangePoint(_) => {
                    balancing[lane] = forces.balancing_alone(lane, &states[lane], position);
                }
                _ => {}
            }
            (lane, Obstacle::Forceless(error, limit))
        };
        let refused = refused.into_iter().filter(|(lane, _)| rows[*lane]).map(obstacle).collect();
        (determined, balancing, refused)
    }
}

/// The lanes in which forces are determined, the balancing load of each lane, and why there are none.
type Forces = (Mask, [Option<f64>; Lanes::WIDTH], Vec<(usize, Obstacle)>);
