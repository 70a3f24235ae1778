//! One cycle from a given kinetic energy: collocation on each panel by Newton's method, with the derivatives of the
//! energy by its initial value, by the drive and by the flywheel (variational equation).

use super::arc::{Arc, Solution};
use super::collocation::{Nodal, S};
use super::newton::Failure;
use super::path::{Data, Datum, Panel, Road};
use crate::{DynamicsError, Shaft};

/// Number of quantities by which the energy is differentiated.
pub(crate) const PARAMETERS: usize = 3;

/// Initial energy.
pub(crate) const BY_ENERGY: usize = 0;
/// Ratio u, or the constant moment.
pub(crate) const BY_DRIVE: usize = 1;
/// Flywheel on its own shaft.
pub(crate) const BY_FLYWHEEL: usize = 2;

/// Panels are halved so often where Newton's method fails.
const MOST_HALVINGS: usize = 12;

/// What is on the shaft, and how its inertia follows from the unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Setup {
    pub(crate) shaft: Shaft,
    /// d(shaft inertia) by ratio and by flywheel.
    pub(crate) inertia_by: [f64; 2],
}

/// A run along the path.
#[derive(Debug)]
pub(crate) struct Sweep<'r, 'a> {
    pub(super) road: &'r mut Road<'a>,
    pub(super) setup: Setup,
    /// T and its derivatives at the place reached.
    pub(super) energy: f64,
    pub(super) derivatives: [f64; PARAMETERS],
    /// η or 1/η.
    pub(super) factor: f64,
    /// Speeds between which the present formulas hold.
    pub(super) bounds: [f64; 2],
    /// At a crossing of such a bound: 1 if upwards, -1 if downwards; else 0.
    pub(super) side: f64,
    /// Crossings so far.
    pub(super) crossings: usize,
    arcs: Vec<Arc>,
}

impl<'r, 'a> Sweep<'r, 'a> {
    /// Runs one cycle from the kinetic energy `energy`; `guess` is a run nearby.
    pub(crate) fn run(
        road: &'r mut Road<'a>,
        setup: Setup,
        panels: &[Panel],
        energy: f64,
        guess: Option<&Solution>,
    ) -> Result<Solution, DynamicsError> {
        let mut sweep = Self {
            road,
            setup,
            energy,
            derivatives: [1.0, 0.0, 0.0],
            factor: 1.0,
            bounds: [0.0, f64::INFINITY],
            side: 0.0,
            crossings: 0,
            arcs: Vec::with_capacity(panels.len() + 8),
        };
        let mut near = guess.map_or(&[][..], |solution| &solution.arcs);
        for panel in panels {
            while let [first, rest @ ..] = near
                && first.x < panel.x
            {
                near = rest;
            }
            let start = near.first().filter(|arc| arc.same_place(panel.x, panel.h)).map(|arc| &arc.energy);
            sweep.advance(panel.x, panel.h, &panel.data, start.copied(), 0)?;
        }
        let Self { energy: end, derivatives, arcs, .. } = sweep;
        Ok(Solution { setup, way: sweep.road.way, start: energy, end, derivatives, arcs })
    }

    pub(super) fn speed(&self, energy: f64, datum: &Datum) -> f64 {
        (2.0 * energy / (datum.inertia + self.setup.shaft.inertia)).sqrt()
    }

    /// The present speed; at a crossing, just beyond it.
    fn speed_beside(&self, at: &Datum) -> f64 {
        /// Far above rounding, far below any width between two rows of a table.
        const BESIDE: f64 = 1e-10;
        self.speed(self.energy, at) * (1.0 + self.side * BESIDE)
    }

    /// Chooses the branch of the drive, and the formulas of the loads if those of `data` don't hold at the speed.
    pub(super) fn choose(&mut self, x: f64, h: f64, data: &Data) -> Result<Data, DynamicsError> {
        let v = self.speed_beside(&data.start);
        let branch = self.setup.shaft.branch(v);
        self.factor = branch.factor;
        let [low, high] = data.speed;
        let data = if v >= low && v <= high { *data } else { self.road.data(x, h, v)? };
        self.bounds = [branch.speed[0].max(data.speed[0]), branch.speed[1].min(data.speed[1])];
        Ok(data)
    }

    /// Coefficients of a stretch that is no panel, near the speed at `at`.
    pub(super) fn data(&mut self, x: f64, h: f64, at: &Datum) -> Result<Data, DynamicsError> {
        let v = self.speed_beside(at);
        self.road.data(x, h, v)
    }

    /// Solves a stretch of the path and goes to its end; where the formulas change inside, in several arcs.
    pub(super) fn advance(
        &mut self,
        x: f64,
        h: f64,
        data: &Data,
        guess: Option<Nodal>,
        halvings: usize,
    ) -> Result<(), DynamicsError> {
        let data = self.choose(x, h, data)?;
        match self.solve(x, h, &data, guess) {
            Ok(arc) => match self.first_crossing(&arc) {
                None => {
                    self.keep(&arc);
                    Ok(())
                }
                Some((theta, side)) => self.cross(&arc, theta, side, halvings),
            },
            Err(_) if halvings < MOST_HALVINGS => {
                let half = 0.5 * h;
                let first = self.data(x, half, &data.start)?;
                self.advance(x, half, &first, None, halvings + 1)?;
                let at = self.arcs.last().map_or(data.start, |arc| arc.data.nodes[S - 1]);
                let second = self.data(x + half, half, &at)?;
                self.advance(x + half, half, &second, None, halvings + 1)
            }
            Err(Failure { stalled }) => {
                let coordinate = self.road.way.coordinate(x);
                let stall = DynamicsError::Stalled { coordinate };
                Err(if stalled { stall } else { DynamicsError::NoPath { coordinate } })
            }
        }
    }

    pub(super) fn keep(&mut self, arc: &Arc) {
        self.energy = arc.energy[S - 1];
        self.derivatives = std::array::from_fn(|p| arc.derivatives[p][S - 1]);
        self.side = 0.0;
        self.arcs.push(*arc);
    }
}
