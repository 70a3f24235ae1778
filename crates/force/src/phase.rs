//! Smooth pieces of the loads, for integration.

use assur_integrator::Piece;

use crate::State;
use crate::breaks::tolerance;
use crate::law::{Active, cut};
use crate::loads::{Along, Loads};

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

    /// Chooses the formulas that hold just after `state` in the direction of motion, and returns the box in which they do.
    ///
    /// The direction along the coordinate is the sign of the speed; of a speed that is exactly zero, the sense of the input.
    /// At a row of a table over the speed the segment is that of the speed itself (from the row up), whatever the
    /// acceleration: ask with a speed beside the row to get the other one. Allocates nothing.
    pub fn enter(&self, state: &State, phase: &mut Phase) -> Piece {
        let mut bounds = Piece::UNBOUNDED;
        let sense = self.sense_of(state);
        phase.sense = sense;
        for (law, active) in self.laws.iter().zip(&mut phase.actives) {
            *active = law.enter(state, sense, self.period, &mut bounds);
        }
        let ahead = state.coordinate + sense * tolerance(state.coordinate, self.period);
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
            let side = if sense < 0.0 { [f64::NEG_INFINITY, 0.0] } else { [0.0, f64::INFINITY] };
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
