//! Which formula of each load applies at a state.

use crate::law::Active;
use crate::loads::{ArcContact, Loads};
use crate::state::Selection;
use crate::state::Side;
use crate::{Phase, State};

/// The formulas of all loads on one side of a state, or in one smooth piece.
pub(crate) trait Formulas {
    /// The formula of a law.
    fn active(&self, loads: &Loads, law: usize, state: &State) -> Active;
    /// Whether a contact touches.
    fn touches(&self, loads: &Loads, contact: usize, state: &State) -> bool;
    /// Factor of the unit vector of PF1 for a force against the motion; 0 where the point is at rest. `lengths`: of PF1
    /// and PF2 of its point.
    fn against(&self, loads: &Loads, force: usize, state: &State, lengths: [f64; 2]) -> f64;
}

/// Says which formulas apply at a state.
pub(crate) trait Choice {
    /// The formulas of one side.
    type Formulas: Formulas;

    /// A number that the formulas at a state give: of one side, or of both sides by their shares where the motion is
    /// held between them.
    fn weigh(&self, loads: &Loads, state: &State, number: impl Fn(&Self::Formulas) -> f64) -> f64;
}

/// The formulas that the state itself selects.
pub(crate) struct Live;

impl Choice for Live {
    type Formulas = Selection;

    #[inline(always)]
    fn weigh(&self, loads: &Loads, state: &State, number: impl Fn(&Selection) -> f64) -> f64 {
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
    fn weigh(&self, _: &Loads, _: &State, number: impl Fn(&Self) -> f64) -> f64 {
        number(self)
    }
}

impl Formulas for Selection {
    #[inline(always)]
    fn active(&self, loads: &Loads, law: usize, state: &State) -> Active {
        loads.laws[law].at(state, self, loads.period)
    }

    #[inline(always)]
    fn touches(&self, loads: &Loads, contact: usize, state: &State) -> bool {
        let contact = &loads.contacts[contact];
        let ahead = self.coordinate(state, loads.period);
        let behind = 2.0 * state.coordinate - ahead;
        contact.touches(ahead) || (self.closed && contact.touches(behind))
    }

    #[inline(always)]
    fn against(&self, loads: &Loads, _: usize, _: &State, [first, second]: [f64; 2]) -> f64 {
        /// A rest within this distance of the coordinate is at the coordinate: the difference is rounding.
        const AT_REST: f64 = 1e-12;
        let rests = first <= loads.standing.max(AT_REST * second);
        if !self.moves || rests { 0.0 } else { -self.sense }
    }
}

impl Formulas for Phase {
    #[inline(always)]
    fn active(&self, _: &Loads, law: usize, _: &State) -> Active {
        self.actives[law]
    }

    #[inline(always)]
    fn touches(&self, _: &Loads, contact: usize, _: &State) -> bool {
        self.contacts[contact]
    }

    #[inline(always)]
    fn against(&self, _: &Loads, force: usize, state: &State, _: [f64; 2]) -> f64 {
        let [low, high] = self.sides[force];
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
    /// The formulas in use at a state: those of one side, or of both where the motion is held.
    #[inline(always)]
    pub(crate) fn selections(&self, state: &State) -> Selections {
        let (speed, acceleration) = (state.speed, state.acceleration);
        let sign = |value: f64| if value == 0.0 { 0.0 } else { value.signum() };
        let one = |ahead: f64| {
            let mut sense = if self.sense == 0.0 { 1.0 } else { self.sense };
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
            Side::Prescribed => {
                Selections::One(Selection { speed_side: 0.0, moves: speed != 0.0, closed: true, ..one(1.0) })
            }
        }
    }
}
