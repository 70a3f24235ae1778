//! Which formula of each load applies at a state.

use assur_integrator::{Piece, Stretch};
use assur_mechanism::LoadId;

use crate::law::{Active, Law};
use crate::loads::{Action, Applied, ArcContact, Loads};
use crate::state::{Selection, Side};
use crate::{LoadState, breaks::cut, sliding::Sliding};

/// The formulas of all loads on one side of a state, or in one smooth piece.
pub(crate) trait Formulas {
    /// Of a law of a load: 0 is that of its size, 1 that of the angle of a contact.
    fn active(&self, loads: &Loads, law: (usize, usize, &Law), state: &LoadState) -> Active;
    fn touches(&self, loads: &Loads, load: usize, contact: &ArcContact, state: &LoadState) -> bool;
    /// Sign of the friction of a contact against its sliding, along (cos a, -sin a); 0 where nothing slides.
    fn friction_sense(&self, loads: &Loads, sliding: &Sliding, load: usize, state: &LoadState) -> f64;
    /// For a load against the motion of a point, factor of the unit vector of PF1, or where the point `turns`, at rest
    /// between two motions, of the unit vector of PF2, along which it moves on. 0 where nothing moves.
    fn against(&self, loads: &Loads, load: usize, state: &LoadState, turns: bool) -> f64;
}

/// Says which formulas apply at a state.
pub(crate) trait Choice {
    /// The formulas of one side.
    type Formulas: Formulas;

    /// A number that the formulas at a state give: of one side, or of both sides by their shares where the motion is
    /// held between them.
    fn weigh(&self, loads: &Loads, state: &LoadState, number: impl Fn(&Self::Formulas) -> f64) -> f64;
}

/// The formulas that the state itself selects.
pub(crate) struct Live;

impl Choice for Live {
    type Formulas = Selection;

    #[inline(always)]
    fn weigh(&self, loads: &Loads, state: &LoadState, number: impl Fn(&Selection) -> f64) -> f64 {
        match loads.selections(state) {
            Selections::One(selection) => number(&selection),
            Selections::Held([(below, lower), (above, upper)]) => {
                below * number(&lower) + above * number(&upper)
            }
        }
    }
}

impl Choice for Phase {
    type Formulas = Self;

    #[inline(always)]
    fn weigh(&self, _: &Loads, _: &LoadState, number: impl Fn(&Self) -> f64) -> f64 {
        number(self)
    }
}

impl Formulas for Selection {
    #[inline(always)]
    fn active(&self, loads: &Loads, (_, _, law): (usize, usize, &Law), state: &LoadState) -> Active {
        law.at(state, self, loads.period)
    }

    #[inline(always)]
    fn touches(&self, loads: &Loads, _: usize, contact: &ArcContact, state: &LoadState) -> bool {
        let ahead = self.coordinate(state, loads.period);
        let behind = 2.0 * state.coordinate - ahead;
        contact.touches(ahead) || (self.closed && contact.touches(behind))
    }

    #[inline(always)]
    fn friction_sense(&self, loads: &Loads, sliding: &Sliding, _: usize, state: &LoadState) -> f64 {
        // Without a motion, or at speed 0 of a prescribed one, it is as if the input moved along its direction.
        let sense = match (self.moves, self.closed) {
            (true, _) => self.sense,
            (false, true) => loads.direction(),
            (false, false) => return 0.0,
        };
        let side = Self { sense, ..*self };
        -sense * sliding.at(side.coordinate(state, loads.period)).1
    }

    #[inline(always)]
    fn against(&self, _: &Loads, _: usize, state: &LoadState, turns: bool) -> f64 {
        // Of a prescribed motion a point that turns has no force against it; nor where the input is held at rest.
        let held = state.speed == 0.0 && matches!(state.side, Side::Held { .. });
        match (self.moves, turns) {
            (false, _) => 0.0,
            (true, true) if self.closed || held => 0.0,
            (true, true) => -self.ahead,
            (true, false) => -self.sense,
        }
    }
}

impl Formulas for Phase {
    #[inline(always)]
    fn active(&self, _: &Loads, (load, law, _): (usize, usize, &Law), _: &LoadState) -> Active {
        self.loads[load].laws[law]
    }

    #[inline(always)]
    fn touches(&self, _: &Loads, load: usize, _: &ArcContact, _: &LoadState) -> bool {
        self.loads[load].touches
    }

    #[inline(always)]
    fn friction_sense(&self, _: &Loads, _: &Sliding, load: usize, _: &LoadState) -> f64 {
        self.loads[load].friction_sense
    }

    #[inline(always)]
    fn against(&self, _: &Loads, load: usize, state: &LoadState, turns: bool) -> f64 {
        let [low, high] = self.loads[load].stays;
        if turns {
            // The piece begins there, or ends.
            let [begin, end] = if self.sense < 0.0 { [high, low] } else { [low, high] };
            let begins = (state.coordinate - begin).abs() <= (state.coordinate - end).abs();
            return if begins { -1.0 } else { 1.0 };
        }
        // Beyond a rest PF1 has reversed; the formula of the piece has not.
        let within = state.coordinate >= low && state.coordinate <= high;
        if within { -self.sense } else { self.sense }
    }
}

impl ArcContact {
    /// Whether there is contact at a coordinate.
    #[inline(always)]
    fn touches(&self, coordinate: f64) -> bool {
        self.breaks.interval(coordinate).index == self.touching
    }
}

/// The formulas in use at a state.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Selections {
    /// Of one side.
    One(Selection),
    /// Of both sides, with their shares.
    Held([(f64, Selection); 2]),
}

impl Loads {
    /// Direction of the input, 1 or -1.
    pub(crate) fn direction(&self) -> f64 {
        if self.sense == 0.0 { 1.0 } else { self.sense }
    }

    /// The value of a law over time that is over the coordinate of the only drive; `None` of any other.
    #[inline(always)]
    pub(crate) fn by_drive(&self, law: &Law, state: &LoadState, point: [f64; 2]) -> Option<f64> {
        let drive = self.law.as_ref().filter(|_| law.is_of_input())?;
        let seen = state.of_drive(drive);
        let value = |side: &Selection| law.value(law.at(&seen, side, None), &seen, point);
        Some(Live.weigh(self, &seen, value))
    }

    /// The value of a law that has no place at a state.
    pub(crate) fn value_of(&self, law: &Law, state: &LoadState) -> f64 {
        let value = |side: &Selection| law.value(law.at(state, side, self.period), state, [0.0; 2]);
        self.by_drive(law, state, [0.0; 2]).unwrap_or_else(|| Live.weigh(self, state, value))
    }

    /// Angle of a contact of the mechanism at a state, rad, and its coefficient of friction with its sign along (cos a, -sin a);
    /// `None` where no link has it.
    pub fn contact(&self, id: LoadId, state: &LoadState) -> Option<[f64; 2]> {
        let index = self.applied.iter().position(|load| load.id == id)?;
        let Action::Contact(contact) = &self.applied[index].action else { return None };
        let sign = contact.sliding.as_ref().map_or(1.0, |sliding| {
            Live.weigh(self, state, |side| side.friction_sense(self, sliding, index, state))
        });
        Some([self.value_of(&contact.angle, state), sign * contact.friction])
    }

    /// The formulas in use at a state: those of one side, or of both where the motion is held.
    #[inline(always)]
    pub(crate) fn selections(&self, state: &LoadState) -> Selections {
        let (speed, acceleration) = (state.speed, state.acceleration);
        let sign = |value: f64| if value == 0.0 { 0.0 } else { value.signum() };
        let one = |ahead: f64| {
            let mut sense = self.direction();
            if acceleration != 0.0 {
                sense = sign(ahead * acceleration);
            }
            if speed != 0.0 {
                sense = sign(speed);
            }
            let moves = speed != 0.0 || acceleration != 0.0;
            Selection { sense, ahead, speed_side: ahead * sign(acceleration), moves, closed: false }
        };
        let held = |side: f64| Selection {
            sense: if speed == 0.0 { side } else { speed.signum() },
            speed_side: side,
            moves: true,
            ..one(1.0)
        };
        match state.side {
            Side::After => Selections::One(one(1.0)),
            Side::Before => Selections::One(one(-1.0)),
            Side::Held { upper } => Selections::Held([(1.0 - upper, held(-1.0)), (upper, held(1.0))]),
            Side::Prescribed => Selections::One(Selection { moves: speed != 0.0, closed: true, ..one(1.0) }),
        }
    }

    /// Whether the formulas of a phase hold throughout a stretch of a motion, apart from the bounds of its piece; see
    /// [`EquationOfMotion::holds`](assur_integrator::EquationOfMotion::holds).
    pub fn hold(&self, phase: &Phase, stretch: &Stretch) -> Option<bool> {
        let all = self.applied.iter().zip(&phase.loads);
        let mut laws = all.flat_map(|(load, phase)| load.laws().zip(phase.laws));
        laws.try_fold(true, |all, (law, active)| match law {
            Law::Formula(law) => Some(law.holds(active.sides, stretch)? && all),
            _ => Some(all),
        })
    }

    /// Takes the sides of switches over several variables just ahead of a state, to which its acceleration leads. Returns the load whose formula
    /// changes by that, if one does, with the function that switches and the character at which it stands.
    pub fn turn(&self, state: &LoadState, phase: &mut Phase) -> Option<(LoadId, String, usize)> {
        let side = match self.selections(&LoadState { acceleration: 0.0, ..*state }) {
            Selections::One(side) | Selections::Held([_, (_, side)]) => side,
        };
        let mut turned = None;
        for (load, phase) in self.applied.iter().zip(&mut phase.loads) {
            for (law, active) in load.laws().zip(&mut phase.laws) {
                let Law::Formula(law) = law else { continue };
                let found = law.turn(&mut active.sides, state, &side, self.period);
                turned = found.map(|(function, column)| (load.id, function, column)).or(turned);
            }
        }
        turned
    }

    /// A phase with room for all loads, not yet entered.
    pub fn phase(&self) -> Phase {
        let new = LoadPhase {
            laws: [Active::default(); 2],
            stays: [f64::NEG_INFINITY, f64::INFINITY],
            touches: true,
            friction_sense: 0.0,
        };
        Phase { loads: vec![new; self.applied.len()], sense: self.sense }
    }

    /// Chooses the formulas of the side of `state` (if the motion is held, of the side above its speed), and returns
    /// the bounds in which they are valid.
    ///
    /// The direction along the coordinate is the sign of the speed; at zero speed, that of the acceleration, else that
    /// of the input. At a row of a table over the speed the segment is the one towards which the acceleration leads,
    /// else the one above the row; for the other one, call this with a speed just beside the row. Allocates nothing.
    pub fn enter(&self, state: &LoadState, phase: &mut Phase) -> Piece {
        let side = match self.selections(state) {
            Selections::One(side) | Selections::Held([_, (_, side)]) => side,
        };
        let mut bounds = Piece::UNBOUNDED;
        phase.sense = side.sense;
        for (load, phase) in self.applied.iter().zip(&mut phase.loads) {
            phase.enter(self, load, state, &side, &mut bounds);
        }
        if self.applied.iter().any(Applied::turns_with_speed) {
            let side = if phase.sense < 0.0 { [f64::NEG_INFINITY, 0.0] } else { [0.0, f64::INFINITY] };
            cut(&mut bounds.speed, side);
        }
        bounds
    }
}

/// Which formula of each load is in use: segments of tables, strokes and their direction, contacts, sides of the rests
/// of loads against the motion. Created by [`Loads::phase`], set by [`Loads::enter`].
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    pub(crate) loads: Vec<LoadPhase>,
    /// The sense of the motion along the coordinate, 1 or -1.
    pub sense: f64,
}

/// Which formulas of one load are in use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LoadPhase {
    /// Of its size, and of the angle of a contact.
    laws: [Active; 2],
    /// The interval of the coordinate in which the point or link does not reverse against whose motion it is.
    stays: [f64; 2],
    pub(crate) touches: bool,
    /// Sign of the friction of a contact that is against its sliding.
    friction_sense: f64,
}

impl LoadPhase {
    /// Chooses the formulas of a load, and cuts the `bounds` to those in which they are valid.
    fn enter(
        &mut self,
        loads: &Loads,
        load: &Applied,
        state: &LoadState,
        side: &Selection,
        bounds: &mut Piece,
    ) {
        self.laws[0] = load.size.enter(state, side, loads.period, bounds);
        let ahead = side.coordinate(state, loads.period);
        if let Some(rests) = load.rests() {
            self.stays = rests.interval(ahead).ends;
            cut(&mut bounds.coordinate, self.stays);
        }
        if let Action::Contact(contact) = &load.action {
            self.laws[1] = contact.angle.enter(state, side, loads.period, bounds);
            let interval = contact.breaks.interval(ahead);
            self.touches = interval.index == contact.touching;
            cut(&mut bounds.coordinate, interval.ends);
            if let Some((interval, sign)) = contact.sliding.as_ref().map(|sliding| sliding.at(ahead)) {
                self.friction_sense = -side.sense * sign;
                cut(&mut bounds.coordinate, interval.ends);
            }
        }
    }
}
