//! The mechanism with its loads and its drive as an equation of motion.

use std::ops::ControlFlow;
use std::sync::Arc;

use assur_force::{LoadState, Loads, Phase};
use assur_group::{Body, Order};
use assur_integrator::{Dependence, EquationOfMotion, MotionError, Partials, Piece, Reduced, State, Stretch};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::LoadId;
use assur_words::{Text, name, text};

use crate::Regime;
use crate::drive::{InputDrive, TorqueSource};
use crate::friction::{Configuration, Friction, FrictionMoment, KnownMotion};

/// The equation of motion of a compiled mechanism under its loads and its drive. Without dry friction in pairs evaluating it
/// allocates nothing.
#[derive(Debug, Clone)]
pub struct Machine<'a> {
    linkage: &'a Linkage,
    loads: &'a Loads,
    position: Position,
    phase: Phase,
    /// Of the loads alone.
    dependence: Dependence,
    friction: Option<Friction>,
    /// The drive of the input link.
    pub drive: InputDrive,
    /// Whether all that moves the machine is known: then its own motion tells the sides of switches over several variables.
    is_driven: bool,
    /// Of the branch of the drive that was entered last.
    factor: f64,
}

impl<'a> Machine<'a> {
    /// Takes a compiled mechanism and its compiled loads, without the drive.
    pub fn new(linkage: &'a Linkage, loads: &'a Loads) -> Self {
        Self {
            linkage,
            loads,
            position: linkage.position(),
            phase: loads.phase(),
            dependence: loads.dependence(),
            friction: Friction::of(linkage, loads),
            drive: InputDrive::NONE,
            is_driven: false,
            factor: 1.0,
        }
    }

    /// The machine with a drive on its input link.
    #[must_use]
    pub fn with_drive(self, drive: InputDrive) -> Self {
        Self { drive, is_driven: true, ..self }
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

    /// The coefficients of the loads alone, without drive and dry friction.
    #[inline]
    fn of_loads(&mut self, state: &State) -> Result<Reduced, MotionError> {
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

    /// Moment and moment of inertia of the drive on the input at a state, by the formulas entered last.
    #[inline]
    fn of_drive(&self, state: &State) -> [f64; 2] {
        let sense = self.drive.sense;
        [sense * self.drive.moment(self.factor, sense * state.speed).value, self.drive.inertia]
    }

    /// The coefficients without the dry friction of pairs.
    pub(crate) fn ideal(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let [moment, inertia] = self.of_drive(state);
        let loads = self.of_loads(state)?;
        Ok(Reduced { inertia: loads.inertia + inertia, moment: loads.moment + moment, ..loads })
    }

    /// The reduced moment of the loads at a state by the formulas that the state itself selects, without dry friction.
    pub(crate) fn load_moment(&mut self, state: &LoadState) -> Result<f64, MotionError> {
        self.solve(state.coordinate)?;
        Ok(self.loads.reduced(state, &self.position.bodies).moment)
    }

    /// The acceleration with dry friction at a state by the formulas that the state itself selects; `None` where none is possible.
    pub(crate) fn acceleration_at(&mut self, state: &LoadState) -> Result<Option<f64>, MotionError> {
        let drive = [self.drive.torque(state), self.drive.inertia];
        self.solve(state.coordinate)?;
        let Self { linkage, loads, position, phase, friction, .. } = self;
        let Some(friction) = friction else { return Ok(None) };
        friction.acceleration_at(&Configuration { linkage, loads, phase, position }, state, drive)
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

    /// Chooses the formulas of loads and drive on the side of a state, and returns the box in which those of the loads are smooth.
    pub(crate) fn enter_side(&mut self, state: &LoadState) -> Result<Piece, MotionError> {
        let mut piece = self.loads.enter(state, &mut self.phase);
        if let Some(friction) = &mut self.friction {
            friction.enter(self.loads, state, &mut piece);
        }
        self.factor = self.drive.branch(self.drive.sense * state.speed).factor;
        // At rest itself there is no motion that leads anywhere.
        if self.is_driven && self.dependence.moment_switches && state.speed != 0.0 {
            self.follow(state)?;
        }
        Ok(piece)
    }

    /// Takes the sides of switches over several variables to which the motion on these sides itself leads.
    fn follow(&mut self, at: &LoadState) -> Result<(), MotionError> {
        /// More than a switch for each of some loads.
        const MOST: usize = 8;
        let LoadState { time, coordinate, speed, .. } = *at;
        let mut turned = None;
        for _ in 0..MOST {
            let acceleration = self.acceleration(&State { time, coordinate, speed })?;
            turned = self.loads.turn(&LoadState { acceleration, ..*at }, &mut self.phase);
            if turned.is_none() {
                return Ok(());
            }
        }
        let back = |(load, function, column): (LoadId, String, usize)| {
            let load = &self.linkage.mechanism.loads[load].name;
            text!("dynamics-driven-back", load, function = name(function), column)
        };
        Err(MotionError::Undetermined(turned.map_or_else(Text::default, back)))
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
pub(crate) fn load_state(&State { time, coordinate, speed }: &State) -> LoadState {
    LoadState { time, coordinate, speed, ..LoadState::default() }
}

impl EquationOfMotion for Machine<'_> {
    fn dependence(&self) -> Dependence {
        let mut dependence = self.dependence;
        if let Some(friction) = &self.friction {
            dependence.moment_on_coordinate = true;
            dependence.moment_on_acceleration = friction.course.is_none();
            dependence.moment_on_speed |= dependence.moment_on_acceleration;
        }
        dependence.moment_on_speed |= matches!(self.drive.source, TorqueSource::Motor { .. });
        dependence
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        let mut piece = self.enter_side(&load_state(state))?;
        let [low, high] = self.drive.branch(self.drive.sense * state.speed).speed;
        let own = if self.drive.sense < 0.0 { [-high, -low] } else { [low, high] };
        piece.speed = [piece.speed[0].max(own[0]), piece.speed[1].min(own[1])];
        Ok(piece)
    }

    fn holds(&self, stretch: &Stretch) -> Option<bool> {
        self.loads.hold(&self.phase, stretch)
    }

    #[inline]
    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let drive = self.of_drive(state);
        let mut reduced = self.of_loads(state)?;
        // Where the moment depends on the acceleration itself (dry friction through inertia loads) it is found here.
        if let Some(friction) = &mut self.friction {
            let Self { linkage, loads, position, phase, .. } = self;
            let place = Configuration { linkage, loads, phase, position };
            reduced.moment += friction.moment(&place, &load_state(state), &reduced, drive)?;
        }
        let [moment, inertia] = drive;
        reduced.inertia += inertia;
        reduced.moment += moment;
        Ok(reduced)
    }

    /// Of the friction at this state; of a known motion, of the friction that was found last.
    fn bends(&mut self, state: &State) -> Result<Vec<f64>, MotionError> {
        if self.dependence().moment_on_acceleration {
            self.reduced(state)?;
        }
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
