//! Dry friction of the pairs, compiled: which link slides on which in which sense, what friction depends on, and which groups it
//! couples.

use std::sync::Arc;

use assur_group::{Body, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::{Place, Surfaces};
use assur_number::Real;
use assur_words::Text;

use crate::loads::{Action, PointForce, Shoe};
use crate::{LoadState, Loads, Piece, Side, breaks::cut, choice::Selections, state::Selection};

mod bearing;
mod coupling;
mod unknown;

pub use bearing::Bearing;
pub use coupling::Block;
pub use unknown::{Unknown, UnknownKind};

/// The dry friction of all pairs of a mechanism.
#[derive(Debug, Clone, PartialEq)]
pub struct Frictions {
    /// Each link that turns or slides on another in a pair with friction.
    pub bearings: Vec<Bearing>,
    /// What friction depends on: the magnitudes of reactions, and normal forces themselves.
    pub unknowns: Vec<Unknown>,
    /// What has to be solved together, in solving order: the last groups first, the input link in the last one.
    pub blocks: Vec<Block>,
    /// The whole mechanism as one block, for a balancing load that acts elsewhere than on the input.
    pub whole: Block,
}

/// Friction in a force analysis: the senses that it has to take, and what was found.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionForces<T = f64> {
    /// The friction of the mechanism.
    pub frictions: Arc<Frictions>,
    /// For each bearing, the sign of its relative speed; 0 where it never moves. Given to the method.
    pub senses: Vec<T>,
    /// The load of the drive that made the motion, see [`LoadState::drive`]. Given to the method.
    pub drive: Option<f64>,
    /// For each bearing, the moment (N m, counter-clockwise) on the link that turns, or the force (N, along the guide) on the
    /// link that slides.
    pub forces: Vec<T>,
    /// Whether the certificates are looked for; without them a bound suffices to see that there is one solution. Given to the method.
    pub are_certificates_wanted: bool,
    /// For each group, the spectral radius of its friction: below 1 there is exactly one solution. NaN without friction, and it may
    /// be NaN where it is not wanted.
    pub certificates: Vec<T>,
    /// What is said of the positions (lanes) that have several solutions, or that may have others.
    pub doubts: Vec<(usize, Doubt)>,
    /// Scratch of a method: one wrench for each body.
    pub loads: Vec<Wrench<T>>,
    /// Memory of a method between the evaluations of a motion.
    pub followed: Followed,
}

/// The only solution that was found in a motion, which is followed from one evaluation to the next.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Followed {
    /// Its magnitudes of friction.
    pub moduli: Vec<f64>,
    /// How many evaluations may follow it before others are looked for again; 0: none.
    pub left: usize,
}

/// A position with several solutions, or where there may be others.
#[derive(Debug, Clone, PartialEq)]
pub struct Doubt {
    /// All solutions that were found, ascending by the balancing load.
    pub solutions: Vec<FrictionSolution>,
    /// Whether there are certainly no others.
    pub proved: bool,
    /// Whether they are the ends of a continuum.
    pub continuum: bool,
}

/// How the friction of groups that are solved together is found.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionIteration {
    /// The groups in words.
    pub what: Text,
    /// Indices of the unknowns that are magnitudes.
    pub unknowns: Vec<usize>,
    /// The magnitudes that the textbook iteration gives, N: without friction, then with that of the step before.
    pub steps: Vec<Vec<f64>>,
    /// The spectral radius: the rate of the iteration, and below 1 the proof of one solution.
    pub radius: f64,
    /// The magnitudes of the solution that is taken, N.
    pub solution: Option<Vec<f64>>,
}

/// One of several solutions with friction.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionSolution {
    /// Balancing moment (N m) or force (N).
    pub balancing: f64,
    /// Reactions in all pairs, as [`Reactions::pairs`](crate::Reactions::pairs).
    pub pairs: Vec<Wrench<f64>>,
    /// As [`FrictionForces::forces`].
    pub forces: Vec<f64>,
    /// Whether the results belong to this solution.
    pub taken: bool,
}

impl Frictions {
    /// The coordinates within an interval at which a bearing changes its sense, ascending.
    pub fn turns(&self, ends: [f64; 2]) -> Vec<f64> {
        let mut all: Vec<f64> =
            self.bearings.iter().flat_map(|bearing| bearing.sliding.turns(ends)).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// The virtual power of the friction of each bearing for dq = 1: its moment on the input (N m; force, N).
    pub fn powers<'a, T: Real>(
        &'a self,
        forces: &'a [T],
        bodies: &'a [Body<T>],
    ) -> impl Iterator<Item = (&'a Bearing, T)> {
        let each = self.bearings.iter().zip(forces);
        each.map(|(bearing, force)| (bearing, *force * bearing.relative(bodies)))
    }
}

impl<T: Real> FrictionForces<T> {
    /// Memory for the friction of a mechanism.
    pub fn new(frictions: Arc<Frictions>, linkage: &Linkage) -> Self {
        let bearings = frictions.bearings.len();
        Self {
            senses: vec![T::ZERO; bearings],
            drive: None,
            forces: vec![T::ZERO; bearings],
            are_certificates_wanted: true,
            certificates: vec![T::from_f64(f64::NAN); linkage.groups().len()],
            doubts: Vec::new(),
            loads: Vec::new(),
            followed: Followed::default(),
            frictions,
        }
    }
}

impl FrictionForces {
    /// Which of several solutions belongs to the motion, by their balancing loads on the input; `None` where no drive made it.
    pub fn driven(&self, balancing: impl Iterator<Item = f64>) -> Option<usize> {
        let drive = self.drive?;
        let off = balancing.map(|load| (load - drive).abs()).enumerate();
        off.min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(index, _)| index)
    }

    /// The forces that press the faces of slides, whose magnitudes give their friction, from reactions with friction.
    pub fn pressing(&self, bodies: &[Body<f64>], pairs: &[Wrench<f64>]) -> Vec<f64> {
        let Frictions { bearings, unknowns, .. } = self.frictions.as_ref();
        let of = |unknown: &Unknown| unknown.vector(&bearings[unknown.bearing], bodies, pairs)[0];
        let each = unknowns.iter().enumerate().filter_map(|(index, unknown)| match unknown.kind {
            UnknownKind::Normal => Some(of(unknown)),
            UnknownKind::End(sign) => {
                // The reaction has the moment of the friction of both faces, which presses neither end.
                let other = if sign > 0.0 { index + 1 } else { index - 1 };
                let normal = of(unknown) + of(&unknowns[other]);
                let bearing = &bearings[unknown.bearing];
                let Surfaces::Faces { length, offset, .. } = bearing.surfaces else { return None };
                let own = -self.senses[unknown.bearing] * bearing.coefficient * offset * normal;
                Some(of(unknown) - sign * own / length)
            }
            UnknownKind::Force | UnknownKind::Shift => None,
        });
        each.collect()
    }
}

impl Loads {
    /// The dry friction in pairs; `None` where all are ideal.
    pub fn frictions(&self) -> Option<&Arc<Frictions>> {
        self.frictions.as_ref()
    }

    /// Writes for each bearing the sign of its relative speed at a state, 0 where it never moves. At speed 0 of a prescribed motion
    /// it is as if the input moved along its direction, and a motion that starts has the sense of its acceleration; where the
    /// relative speed is zero, the sign just after the state holds (just before the end of a motion). Where a motion is held at
    /// rest, the friction of what else would move is not determined: NaN.
    pub fn senses(&self, state: &LoadState, bodies: &[Body<f64>], senses: &mut [f64]) {
        self.write_relative(bodies, senses);
        self.turn_to_senses(state, senses, |speed| speed);
    }

    /// Writes the relative speed of each bearing at dq/dt = 1.
    pub(crate) fn write_relative<T: Real>(&self, bodies: &[Body<T>], speeds: &mut [T]) {
        let bearings = self.frictions.iter().flat_map(|frictions| &frictions.bearings);
        speeds.iter_mut().zip(bearings).for_each(|(speed, bearing)| *speed = bearing.relative(bodies));
    }

    /// Puts the [`senses`](Self::senses) of a state (of a lane) in the place of the relative speeds.
    pub(crate) fn turn_to_senses<T>(
        &self,
        state: &LoadState,
        speeds: &mut [T],
        lane: impl Fn(&mut T) -> &mut f64,
    ) {
        let Some(frictions) = &self.frictions else { return };
        let side = self.side_of_friction(state);
        let ahead = side.coordinate(state, self.period);
        let rests = state.speed == 0.0 && matches!(state.side, Side::Held { .. });
        for (bearing, speed) in frictions.bearings.iter().zip(speeds) {
            let speed = lane(speed);
            let sign = bearing.sliding.sign(*speed, ahead);
            *speed = if rests && !bearing.rests() { f64::NAN } else { side.sense * sign };
        }
    }

    /// Makes the loads on the links on which a brake or a force against the motion acts unknown: beside the friction that
    /// [holds a motion at rest](Self::senses) they are not determined.
    pub(crate) fn leave_open(&self, wrenches: &mut [Wrench<f64>]) {
        for load in self.applied.iter().filter(|load| load.rests().is_some()) {
            let (Action::Force(PointForce { at: Place { link, .. }, .. }) | Action::Brake(Shoe { link, .. })) =
                load.action
            else {
                continue;
            };
            wrenches[link].m = f64::NAN;
        }
    }

    fn side_of_friction(&self, state: &LoadState) -> Selection {
        let mut side = match self.selections(state) {
            Selections::One(side) | Selections::Held([_, (_, side)]) => side,
        };
        if state.speed == 0.0 && state.side == Side::Prescribed {
            side.sense = self.direction();
        }
        side
    }

    /// As [`senses`](Self::senses), on the side of a state that moves, and cuts a piece to the states in which they hold.
    pub fn enter_friction(&self, state: &LoadState, senses: &mut [f64], piece: &mut Piece) {
        let Some(frictions) = &self.frictions else { return };
        let side = self.side_of_friction(state);
        let ahead = side.coordinate(state, self.period);
        for (bearing, found) in frictions.bearings.iter().zip(senses) {
            let (interval, sign) = bearing.sliding.at(ahead);
            *found = side.sense * sign;
            cut(&mut piece.coordinate, interval.ends);
        }
        let moving = if side.sense < 0.0 { [f64::NEG_INFINITY, 0.0] } else { [0.0, f64::INFINITY] };
        cut(&mut piece.speed, moving);
    }

    /// The speed of the input by which powers of friction are counted: 0 at rest in a motion; without a motion, 1 along the
    /// direction of the input.
    pub fn speed_of_friction(&self, state: &LoadState, moves: bool) -> f64 {
        if moves { state.speed } else { self.direction() }
    }
}

/// What acts on a mechanism whose acceleration is looked for.
#[derive(Debug, Clone, Copy)]
pub struct FreeMotion<'a> {
    /// All loads on the links at acceleration 0, the inertia loads of the speed among them, about the origins of their frames.
    pub loads: &'a [Wrench<f64>],
    /// The inertia loads of acceleration 1 at speed 0.
    pub inertia: &'a [Wrench<f64>],
    /// Moment (force) of the drive on the input link, along the coordinate, N m (N).
    pub drive: f64,
    /// Moment of inertia (mass) that the drive adds to the input link, kg m² (kg).
    pub drive_inertia: f64,
}

/// The accelerations that dry friction leaves possible.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Accelerations {
    /// Each with its reactions and friction; in place of the balancing load stands the acceleration, rad/s² (m/s²).
    pub solutions: Vec<FrictionSolution>,
    /// Whether there are certainly no others.
    pub proved: bool,
}
