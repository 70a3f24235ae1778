//! The mechanism with its loads, without its drive, as an equation of motion.

use std::ops::ControlFlow;

use assur_force::{Loads, Phase};
use assur_group::{Body, Order};
use assur_integrator::{Dependence, Motion, MotionError, Partials, Piece, Reduced, State};
use assur_kinematics::{Linkage, Position};
use assur_words::text;

/// The equation of motion of a compiled mechanism under its loads. Evaluating it allocates nothing.
#[derive(Debug, Clone)]
pub struct Machine<'a> {
    linkage: &'a Linkage,
    loads: &'a Loads,
    position: Position,
    phase: Phase,
    dependence: Dependence,
}

impl<'a> Machine<'a> {
    /// Takes a compiled mechanism and its compiled loads.
    pub fn new(linkage: &'a Linkage, loads: &'a Loads) -> Self {
        let dependence = loads.dependence();
        Self { linkage, loads, position: linkage.position(), phase: loads.phase(), dependence }
    }

    /// Potential energy of weights and springs at a coordinate, and the sum of the sizes of its terms, J.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if there is no such position.
    pub fn potential_energy(&mut self, coordinate: f64) -> Result<[f64; 2], MotionError> {
        let loads = self.loads;
        let bodies = self.bodies(coordinate)?;
        Ok([loads.potential_energy(bodies), loads.terms_of_potential_energy(bodies)])
    }

    /// The bodies at a coordinate, with their first derivatives.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if there is no such position.
    pub fn bodies(&mut self, coordinate: f64) -> Result<&[Body<f64>], MotionError> {
        self.solve(coordinate)?;
        Ok(&self.position.bodies)
    }

    /// Chooses the formulas of the loads on the side of a state, and returns the box in which they are smooth.
    pub(crate) fn enter_side(&mut self, state: &assur_force::State) -> Piece {
        self.loads.enter(state, &mut self.phase)
    }

    #[inline]
    fn solve(&mut self, coordinate: f64) -> Result<(), MotionError> {
        if !coordinate.is_finite() {
            return Err(MotionError::OutOfRange);
        }
        // Often what is asked for next is at the same coordinate.
        if coordinate.to_bits() == self.position.coordinate.to_bits() {
            return Ok(());
        }
        // The second derivatives are for dJ/dq alone.
        let order = if self.dependence.inertia_constant { Order::First } else { Order::Second };
        let solved = self.linkage.solve(coordinate, order, &mut self.position);
        solved.map_err(|error| {
            self.position.coordinate = f64::NAN;
            MotionError::mechanism(&error)
        })
    }
}

/// The state as the loads see it.
#[inline]
pub(crate) fn load_state(&State { time, coordinate, speed }: &State) -> assur_force::State {
    assur_force::State { time, coordinate, speed, ..assur_force::State::default() }
}

impl Motion for Machine<'_> {
    fn dependence(&self) -> Dependence {
        self.dependence
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        Ok(self.enter_side(&load_state(state)))
    }

    #[inline]
    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        self.solve(state.coordinate)?;
        let Self { linkage, loads, position, phase, .. } = self;
        let reduced = loads.reduced_in_phase(phase, &load_state(state), &position.bodies);
        if !reduced.moment.is_finite() {
            loads
                .finite(&linkage.mechanism, &load_state(state), &position.bodies)
                .map_err(|error| MotionError::mechanism(&error))?;
        }
        Ok(reduced)
    }
}

/// Called with every state in which an equation of motion is evaluated; breaks to stop the solution.
pub type Watcher<'w> = dyn FnMut(&State) -> ControlFlow<()> + 'w;

/// An equation of motion and who watches it, if anybody.
pub(crate) struct Watched<'a, 'w> {
    pub(crate) motion: &'a mut dyn Motion,
    pub(crate) watcher: Option<&'a mut Watcher<'w>>,
}

impl Motion for Watched<'_, '_> {
    fn dependence(&self) -> Dependence {
        self.motion.dependence()
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.motion.enter(state)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let flow = self.watcher.as_mut().map_or(ControlFlow::Continue(()), |watcher| watcher(state));
        if flow.is_break() {
            return Err(MotionError::Mechanism(text!("dynamics-stopped")));
        }
        self.motion.reduced(state)
    }

    fn partials(&mut self, state: &State) -> Result<Option<Partials>, MotionError> {
        self.motion.partials(state)
    }
}
