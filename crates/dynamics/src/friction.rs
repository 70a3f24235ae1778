//! Dry friction of the pairs in an equation of motion: it depends on the acceleration through the inertia loads, and the
//! acceleration on it, so that both are found together at every evaluation.

use std::sync::Arc;

use assur_force::{
    ForceAnalyzer, FreeMotion, FrictionSolution, LoadState, Loads, Phase, Piece, Reactions, tolerance,
};
use assur_group::Wrench;
use assur_integrator::{MotionError, Reduced};
use assur_kinematics::{Linkage, Position};
use assur_words::{number, text};

use crate::Regime;

/// Accelerations whose difference is below this part of them are one.
const SAME: f64 = 1e-9;

/// The friction of a mechanism, with its memory.
#[derive(Debug, Clone)]
pub(crate) struct Friction {
    /// `None`: no linked method supports friction.
    method: Option<&'static dyn ForceAnalyzer>,
    out: Reactions,
    wrenches: Vec<Wrench<f64>>,
    inertia: Vec<Wrench<f64>>,
    /// The motion is known, and friction is that of its accelerations; without one it is found with the acceleration.
    pub(crate) course: Option<KnownMotion>,
    /// Where the friction of that motion has kinks, ascending, and the cycle of these places.
    pub(crate) bends: (Vec<f64>, f64),
    /// The interval of the coordinate that was entered last.
    piece: [f64; 2],
    /// What was found last.
    pub(crate) found: FrictionMoment,
    /// The forces that pressed the faces of slides then, whose magnitudes gave their friction.
    pub(crate) pressing: Vec<f64>,
}

/// A motion over the coordinate.
#[derive(Debug, Clone)]
pub(crate) enum KnownMotion {
    /// At a constant speed.
    Uniform(f64),
    Regime(Arc<Regime>),
}

/// Friction at a state.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FrictionMoment {
    /// Its moment reduced to the input, N m (N).
    pub(crate) moment: f64,
    /// At rest no acceleration is possible in this direction, whatever its sign.
    pub(crate) jams: bool,
}

/// Where the friction is looked for, and by which formulas of the loads.
pub(crate) struct Configuration<'a> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) loads: &'a Loads,
    pub(crate) phase: &'a Phase,
    pub(crate) position: &'a Position,
}

impl KnownMotion {
    /// Speed and acceleration at a coordinate.
    pub(crate) fn at(&self, coordinate: f64) -> [f64; 2] {
        match self {
            Self::Uniform(speed) => [*speed, 0.0],
            Self::Regime(regime) => {
                let at = regime.state(coordinate);
                [at.speed, at.acceleration]
            }
        }
    }
}

impl Friction {
    /// The friction of the pairs; `None` where all are ideal.
    pub(crate) fn of(linkage: &Linkage, loads: &Loads) -> Option<Self> {
        loads.frictions()?;
        let method = assur_force::choose(None, true, !linkage.structure.passive.is_empty())
            .ok()
            .map(|plugin| plugin.instance);
        let mut out = Reactions { unit: None, ..Reactions::new(linkage).with_friction(loads, linkage) };
        if let Some(friction) = &mut out.friction {
            friction.are_certificates_wanted = false;
        }
        let none = vec![Wrench::ZERO; linkage.structure.links];
        let found = FrictionMoment::default();
        Some(Self {
            method,
            out,
            wrenches: none.clone(),
            inertia: none,
            course: None,
            found,
            pressing: Vec::new(),
            bends: (Vec::new(), 0.0),
            piece: [f64::NEG_INFINITY, f64::INFINITY],
        })
    }

    /// Takes the accelerations of a known motion from now on; without one those that it leaves possible.
    pub(crate) fn assume(&mut self, course: Option<KnownMotion>) {
        self.course = course;
        self.bends.0.clear();
    }

    /// Takes the senses on the side of a state, and cuts a piece to the states in which they hold.
    pub(crate) fn enter(&mut self, loads: &Loads, state: &LoadState, piece: &mut Piece) {
        if let Some(friction) = &mut self.out.friction {
            loads.enter_friction(state, &mut friction.senses, piece);
            friction.followed.left = 0;
        }
        self.cut(state, &mut piece.coordinate);
        self.piece = piece.coordinate;
    }

    /// Cuts an interval of the coordinate to the kinks around the place just ahead of a state.
    fn cut(&self, state: &LoadState, interval: &mut [f64; 2]) {
        let (bends, cycle) = &self.bends;
        let (Some(first), Some(last)) = (bends.first(), bends.last()) else { return };
        let ahead = state.coordinate + state.speed.signum() * tolerance(state.coordinate, Some(*cycle));
        let shift = ((ahead - first) / cycle).floor() * cycle;
        let after = bends.partition_point(|bend| bend + shift <= ahead);
        let low = after.checked_sub(1).map_or(last - cycle, |before| bends[before]) + shift;
        let high = bends.get(after).copied().unwrap_or(first + cycle) + shift;
        *interval = [interval[0].max(low), interval[1].min(high)];
    }

    /// The reduced moment of friction at a state of a motion with this drive; `ideal`: the coefficients without friction.
    pub(crate) fn moment(
        &mut self,
        place: &Configuration<'_>,
        state: &LoadState,
        ideal: &Reduced,
        drive: [f64; 2],
    ) -> Result<f64, MotionError> {
        self.found = if let Some(course) = &self.course {
            // At the ends of a piece the acceleration may jump: it is that inside.
            let [low, high] = self.piece;
            let near = 2.0 * tolerance(state.coordinate, place.linkage.mechanism.input.period());
            let inside = state.coordinate.min(high - near).max(low + near);
            let [speed, acceleration] = course.at(inside);
            let moment = self.in_known_motion(place, &LoadState { speed, acceleration, ..*state })?;
            FrictionMoment { moment, jams: false }
        } else {
            place.loads.evaluate_in_phase(place.phase, state, &place.position.bodies, &mut self.wrenches);
            let all = self.accelerations(place, drive)?;
            self.chosen(all, place, state, ideal, drive)?
        };
        Ok(self.found.moment)
    }

    fn in_known_motion(&mut self, place: &Configuration<'_>, state: &LoadState) -> Result<f64, MotionError> {
        let Configuration { linkage, loads, phase, position } = place;
        loads.evaluate_in_phase(phase, state, &position.bodies, &mut self.wrenches);
        let method = self.method.ok_or_else(no_method)?;
        let solved = method.solve(linkage, position, &mut self.wrenches, &mut self.out);
        solved.map_err(|error| MotionError::mechanism(&error))?;
        let Some(friction) = &self.out.friction else { return Ok(0.0) };
        self.pressing = friction.pressing(&position.bodies, &self.out.pairs);
        Ok(friction.frictions.powers(&friction.forces, &position.bodies).map(|(_, power)| power).sum())
    }

    /// The accelerations that are possible under the loads evaluated last.
    fn accelerations(
        &mut self,
        place: &Configuration<'_>,
        [drive, drive_inertia]: [f64; 2],
    ) -> Result<Vec<FrictionSolution>, MotionError> {
        self.inertia.fill(Wrench::ZERO);
        let unit =
            LoadState { coordinate: place.position.coordinate, acceleration: 1.0, ..LoadState::default() };
        place.loads.inertia(&unit, &place.position.bodies, &mut self.inertia);
        let motion = FreeMotion { loads: &self.wrenches, inertia: &self.inertia, drive, drive_inertia };
        let method = self.method.ok_or_else(no_method)?;
        let found = method.accelerations(place.linkage, place.position, &motion, &mut self.out);
        let found = found.ok_or_else(no_method)?.map_err(|error| MotionError::mechanism(&error))?;
        Ok(found.solutions)
    }

    /// The acceleration that a motion takes: the only one; at rest, the only one that leads in the direction of the phase.
    fn chosen(
        &mut self,
        mut all: Vec<FrictionSolution>,
        place: &Configuration<'_>,
        state: &LoadState,
        ideal: &Reduced,
        [drive, drive_inertia]: [f64; 2],
    ) -> Result<FrictionMoment, MotionError> {
        let (sense, rests) = (place.phase.sense, state.speed == 0.0);
        if rests && all.iter().any(|one| one.balancing * sense > 0.0) {
            all.retain(|one| one.balancing * sense > 0.0);
        } else if rests {
            let Some(fastest) =
                all.into_iter().max_by(|a, b| (a.balancing * sense).total_cmp(&(b.balancing * sense)))
            else {
                // Nothing moves: friction holds what acts.
                return Ok(FrictionMoment { moment: -(ideal.moment + drive), jams: true });
            };
            all = vec![fastest];
        }
        let size = (ideal.moment + drive).abs() / (ideal.inertia + drive_inertia);
        all.sort_by(|a, b| a.balancing.total_cmp(&b.balancing));
        all.dedup_by(|a, b| (a.balancing - b.balancing).abs() <= SAME * size.max(a.balancing.abs()));
        let shown = |one: &FrictionSolution| number(format_args!("{:.6e}", one.balancing));
        match &all[..] {
            [only] => {
                if let Some(friction) = &self.out.friction {
                    self.pressing = friction.pressing(&place.position.bodies, &only.pairs);
                }
                let frictions = place.loads.frictions().into_iter();
                let powers = frictions.flat_map(|all| all.powers(&only.forces, &place.position.bodies));
                Ok(FrictionMoment { moment: powers.map(|(_, power)| power).sum(), jams: false })
            }
            [] => Err(MotionError::Undetermined(text!("dynamics-friction-none"))),
            [first, .., last] => Err(MotionError::Undetermined(text!(
                "dynamics-friction-several",
                count = all.len(),
                least = shown(first),
                most = shown(last)
            ))),
        }
    }

    /// The acceleration at a state whose loads are those that the state itself selects.
    pub(crate) fn acceleration_at(
        &mut self,
        place: &Configuration<'_>,
        state: &LoadState,
        drive: [f64; 2],
    ) -> Result<Option<f64>, MotionError> {
        place.loads.evaluate(state, &place.position.bodies, &mut self.wrenches);
        Ok(self.accelerations(place, drive)?.first().map(|one| one.balancing))
    }
}

fn no_method() -> MotionError {
    MotionError::Mechanism(text!("dynamics-friction-no-method"))
}
