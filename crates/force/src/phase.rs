//! Smooth pieces of the loads, for integration.

use assur_integrator::Piece;

use crate::State;
use crate::choice::Selections;
use crate::law::{Active, cut};
use crate::loads::{Along, Loads};

/// Which formula of each load is in use: segments of tables, strokes and their direction, contacts, sides of the rests
/// of loads against the motion. Created by [`Loads::phase`], set by [`Loads::enter`].
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    pub(crate) actives: Vec<Active>,
    /// For each force, then for each moment: the interval of the coordinate in which its point or link does not reverse.
    pub(crate) sides: Vec<[f64; 2]>,
    pub(crate) contacts: Vec<bool>,
    pub(crate) sense: f64,
}

const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl Loads {
    /// A phase with room for all loads, not yet entered.
    pub fn phase(&self) -> Phase {
        Phase {
            actives: vec![Active::ONLY; self.laws.len()],
            sides: vec![EVERYWHERE; self.forces.len() + self.moments.len()],
            contacts: vec![true; self.contacts.len()],
            sense: self.sense,
        }
    }

    /// Chooses the formulas of the side of `state` (if the motion is held, of the side above its speed), and returns
    /// the bounds in which they are valid.
    ///
    /// The direction along the coordinate is the sign of the speed; at zero speed, that of the acceleration, else that
    /// of the input. At a row of a table over the speed the segment is the one towards which the acceleration leads,
    /// else the one above the row; for the other one, call this with a speed just beside the row. Allocates nothing.
    pub fn enter(&self, state: &State, phase: &mut Phase) -> Piece {
        let side = match self.selections(state) {
            Selections::One(side) | Selections::Held([_, (_, side)]) => side,
        };
        let mut bounds = Piece::UNBOUNDED;
        phase.sense = side.sense;
        for (law, active) in self.laws.iter().zip(&mut phase.actives) {
            *active = law.enter(state, &side, self.period, &mut bounds);
        }
        let ahead = side.coordinate(state, self.period);
        let rests = self.forces.iter().map(|force| Some(&force.rests));
        let rests =
            rests.chain(self.moments.iter().map(|moment| moment.brake.as_ref().map(|(_, rests)| rests)));
        for (rests, side) in rests.zip(&mut phase.sides) {
            *side = rests.map_or(EVERYWHERE, |rests| rests.interval(ahead).ends);
            cut(&mut bounds.coordinate, *side);
        }
        for (contact, touches) in self.contacts.iter().zip(&mut phase.contacts) {
            let interval = contact.breaks.interval(ahead);
            *touches = interval.index == contact.touching;
            cut(&mut bounds.coordinate, interval.ends);
        }
        if self.turns_with_speed() {
            let side = if phase.sense < 0.0 { [f64::NEG_INFINITY, 0.0] } else { [0.0, f64::INFINITY] };
            cut(&mut bounds.speed, side);
        }
        bounds
    }

    /// Whether a load depends on the sign of the speed: a load against the motion, or a stroke.
    pub fn turns_with_speed(&self) -> bool {
        let against = self.forces.iter().any(|force| force.along == Along::AgainstMotion);
        let brakes = self.moments.iter().any(|moment| moment.brake.is_some());
        against || brakes || self.laws.iter().any(|law| matches!(law, crate::law::Law::Stroke(_)))
    }
}
