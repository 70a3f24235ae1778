//! The mechanism with its loads, without its drive, as an equation of motion.

use std::ops::ControlFlow;
use std::sync::Arc;

use assur_force::{Loads, Phase};
use assur_group::{Body, Order};
use assur_integrator::{Dependence, EquationOfMotion, MotionError, Partials, Piece, Reduced, State, Stretch};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{LoadId, Name};
use assur_words::text;

use crate::Regime;
use crate::friction::{Configuration, Friction, FrictionMoment, KnownMotion};

/// The equation of motion of a compiled mechanism under its loads. Without dry friction in pairs evaluating it allocates nothing.
#[derive(Debug, Clone)]
pub struct Machine<'a> {
    linkage: &'a Linkage,
    loads: &'a Loads,
    position: Position,
    phase: Phase,
    dependence: Dependence,
    friction: Option<Friction>,
}

impl<'a> Machine<'a> {
    /// Takes a compiled mechanism and its compiled loads.
    pub fn new(linkage: &'a Linkage, loads: &'a Loads) -> Self {
        let dependence = loads.dependence();
        let friction = Friction::of(linkage, loads);
        Self { linkage, loads, position: linkage.position(), phase: loads.phase(), dependence, friction }
    }

    /// Takes the dry friction of a known motion from now on: the moment depends on the coordinate alone then, as far as friction
    /// goes. Without one friction is found with the acceleration.
    pub(crate) fn assume(&mut self, course: Option<KnownMotion>) {
        if let Some(friction) = &mut self.friction {
            friction.assume(course);
        }
    }

    /// The machine in a regime that was found, whose dry friction it takes.
    #[must_use]
    pub fn in_regime(mut self, regime: &Regime) -> Self {
        self.assume(Some(KnownMotion::Regime(Arc::new(regime.clone()))));
        self
    }

    /// Ends pieces where the friction of a known motion has kinks, at these coordinates of a cycle.
    pub(crate) fn bend_at(&mut self, coordinates: Vec<f64>, cycle: f64) {
        if let Some(friction) = &mut self.friction {
            friction.bends = (coordinates, cycle);
        }
    }

    /// Whether pairs have dry friction.
    pub(crate) fn has_friction(&self) -> bool {
        self.friction.is_some()
    }

    /// The dry friction at the state that was evaluated last.
    pub(crate) fn friction(&self) -> FrictionMoment {
        self.friction.as_ref().map(|friction| friction.found).unwrap_or_default()
    }

    /// The coefficients without dry friction.
    #[inline]
    pub(crate) fn ideal(&mut self, state: &State) -> Result<Reduced, MotionError> {
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

    /// The reduced moment of the loads at a state by the formulas that the state itself selects, without dry friction.
    pub(crate) fn load_moment(&mut self, state: &assur_force::LoadState) -> Result<f64, MotionError> {
        self.solve(state.coordinate)?;
        Ok(self.loads.reduced(state, &self.position.bodies).moment)
    }

    /// The acceleration with dry friction at a state by the formulas that the state itself selects; `None` where none is possible.
    pub(crate) fn acceleration_at(
        &mut self,
        state: &assur_force::LoadState,
        drive: [f64; 2],
    ) -> Result<Option<f64>, MotionError> {
        self.solve(state.coordinate)?;
        let Self { linkage, loads, position, phase, friction, .. } = self;
        let Some(friction) = friction else { return Ok(None) };
        friction.acceleration_at(&Configuration { linkage, loads, phase, position }, state, drive)
    }

    /// The coefficients at a state with a drive on the input: its moment, N m (N), along the coordinate, and its moment of inertia,
    /// kg m² (kg). Where the moment depends on the acceleration itself (dry friction through inertia loads) it is found here.
    #[inline]
    pub(crate) fn driven(
        &mut self,
        state: &State,
        [moment, inertia]: [f64; 2],
    ) -> Result<Reduced, MotionError> {
        let mut reduced = self.ideal(state)?;
        if let Some(friction) = &mut self.friction {
            let Self { linkage, loads, position, phase, .. } = self;
            let place = Configuration { linkage, loads, phase, position };
            let own = friction.moment(&place, &load_state(state), &reduced, [moment, inertia])?;
            reduced.moment += own;
        }
        reduced.inertia += inertia;
        reduced.moment += moment;
        Ok(reduced)
    }

    /// Potential energy of weights and springs at a coordinate, and the sum of the sizes of its terms, J.
    pub fn potential_energy(&mut self, coordinate: f64) -> Result<[f64; 2], MotionError> {
        let loads = self.loads;
        let bodies = self.bodies(coordinate)?;
        Ok([loads.potential_energy(bodies), loads.terms_of_potential_energy(bodies)])
    }

    /// The bodies at a coordinate, with their first derivatives.
    pub fn bodies(&mut self, coordinate: f64) -> Result<&[Body<f64>], MotionError> {
        self.solve(coordinate)?;
        Ok(&self.position.bodies)
    }

    /// Chooses the formulas of the loads on the side of a state, and returns the box in which they are smooth.
    pub(crate) fn enter_side(&mut self, state: &assur_force::LoadState) -> Piece {
        let mut piece = self.loads.enter(state, &mut self.phase);
        if let Some(friction) = &mut self.friction {
            friction.enter(self.loads, state, &mut piece);
        }
        piece
    }

    /// Takes the sides of switches over several variables to which a motion leads, see [`Loads::turn`].
    pub(crate) fn turn(&mut self, state: &assur_force::LoadState) -> Option<(LoadId, String, usize)> {
        self.loads.turn(state, &mut self.phase)
    }

    /// The name of a load.
    pub(crate) fn name_of(&self, load: LoadId) -> &Name {
        &self.linkage.mechanism.loads[load].name
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
        // The second derivatives are for dJ/dq alone, and for the inertia loads on which friction depends.
        let order = if self.dependence.inertia_constant && self.friction.is_none() {
            Order::First
        } else {
            Order::Second
        };
        let solved = self.linkage.solve(coordinate, order, &mut self.position);
        solved.map_err(|error| {
            self.position.coordinate = f64::NAN;
            MotionError::mechanism(&error)
        })
    }
}

#[inline]
pub(crate) fn load_state(&State { time, coordinate, speed }: &State) -> assur_force::LoadState {
    assur_force::LoadState { time, coordinate, speed, ..assur_force::LoadState::default() }
}

impl EquationOfMotion for Machine<'_> {
    fn dependence(&self) -> Dependence {
        let Some(friction) = &self.friction else { return self.dependence };
        let by_motion = friction.course.is_none();
        Dependence {
            moment_on_coordinate: true,
            moment_on_speed: self.dependence.moment_on_speed || by_motion,
            moment_on_acceleration: by_motion,
            ..self.dependence
        }
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        Ok(self.enter_side(&load_state(state)))
    }

    fn holds(&self, stretch: &Stretch) -> Option<bool> {
        self.loads.hold(&self.phase, stretch)
    }

    #[inline]
    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        self.driven(state, [0.0; 2])
    }

    /// Of the friction that was found last: at this state, under its drive.
    fn bends(&mut self, _: &State) -> Result<Vec<f64>, MotionError> {
        Ok(self.friction.as_ref().map_or_else(Vec::new, |friction| friction.pressing.clone()))
    }
}

/// Called with every state in which an equation of motion is evaluated; breaks to stop the solution.
pub type Watcher<'w> = dyn FnMut(&State) -> ControlFlow<()> + 'w;

/// An equation of motion and who watches it, if anybody.
pub(crate) struct Watched<'a, 'w> {
    pub(crate) motion: &'a mut dyn EquationOfMotion,
    pub(crate) watcher: Option<&'a mut Watcher<'w>>,
    /// The least and the greatest speed of all states that were evaluated, those within steps among them.
    pub(crate) speeds: [f64; 2],
}

impl<'a, 'w> Watched<'a, 'w> {
    pub(crate) fn new(motion: &'a mut dyn EquationOfMotion, watcher: Option<&'a mut Watcher<'w>>) -> Self {
        Self { motion, watcher, speeds: [f64::INFINITY, f64::NEG_INFINITY] }
    }
}

impl EquationOfMotion for Watched<'_, '_> {
    fn dependence(&self) -> Dependence {
        self.motion.dependence()
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.motion.enter(state)
    }

    fn holds(&self, stretch: &Stretch) -> Option<bool> {
        self.motion.holds(stretch)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        self.speeds = [self.speeds[0].min(state.speed), self.speeds[1].max(state.speed)];
        let flow = self.watcher.as_mut().map_or(ControlFlow::Continue(()), |watcher| watcher(state));
        if flow.is_break() {
            return Err(MotionError::Mechanism(text!("dynamics-stopped")));
        }
        self.motion.reduced(state)
    }

    fn bends(&mut self, state: &State) -> Result<Vec<f64>, MotionError> {
        self.motion.bends(state)
    }

    fn partials(&mut self, state: &State) -> Result<Option<Partials>, MotionError> {
        self.motion.partials(state)
    }
}
