//! Smooth pieces of the loads, for integration.

use assur_integrator::Piece;

use crate::State;
use crate::law::{Active, cut};
use crate::loads::{Along, Loads};
use crate::visit::Selections;

/// Which formula of each load holds: segments of tables, strokes and their direction, contacts, turns of the loads against
/// the motion. Made by [`Loads::phase`], set by [`Loads::enter`].
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    pub(crate) actives: Vec<Active>,
    /// Of each force: the coordinates between which its point does not turn round.
    pub(crate) sides: Vec<[f64; 2]>,
    pub(crate) contacts: Vec<bool>,
    pub(crate) sense: f64,
}

const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl Loads {
    /// A phase of the right size, to be entered.
    pub fn phase(&self) -> Phase {
        Phase {
            actives: vec![Active::ONLY; self.laws.len()],
            sides: vec![EVERYWHERE; self.forces.len()],
            contacts: vec![true; self.contacts.len()],
            sense: self.sense,
        }
    }

    /// Chooses the formulas that hold on the side of `state` (of a held one, above its speed), and returns the box in which they
    /// do.
    ///
    /// The direction along the coordinate is the sign of the speed; of a speed that is exactly zero, that in which the
    /// acceleration leads, else the sense of the input. At a row of a table over the speed the segment is that to which the
    /// acceleration leads, else from the row up: ask with a speed beside the row to get the other one. Allocates nothing.
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
        for (force, side) in self.forces.iter().zip(&mut phase.sides) {
            *side = force.rests.interval(ahead).ends;
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

    /// Whether a load depends on the sign of the speed: a force against the motion, or a stroke.
    pub fn turns_with_speed(&self) -> bool {
        let against = self.forces.iter().any(|force| force.along == Along::AgainstMotion);
        against || self.laws.iter().any(|law| matches!(law, crate::law::Law::Stroke(_)))
    }
}
