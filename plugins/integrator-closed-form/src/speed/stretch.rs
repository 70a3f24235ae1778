//! A stretch of the motion: through a panel, or at a speed that stays.

use assur_integrator::{State, Stretch};

use super::panel::Panel;

/// A stretch of the motion.
#[derive(Debug, Clone)]
pub(super) enum Part {
    /// Through a panel.
    Moving {
        /// Its polynomials.
        panel: Box<Panel>,
        /// State at its start.
        from: State,
        /// Parameters at its ends; the last may be infinite.
        ends: [f64; 2],
        /// Time at its end, s.
        end: f64,
    },
    /// At the speed of this state, up to a time, s.
    Steady(State, f64),
}

/// The state `time` after another at the same speed.
pub(super) fn steady(from: &State, time: f64) -> State {
    State { time, coordinate: from.coordinate + from.speed * (time - from.time), ..*from }
}

impl Stretch for Part {
    fn end(&self) -> f64 {
        match self {
            Self::Moving { end, .. } | Self::Steady(_, end) => *end,
        }
    }

    fn at(&self, time: f64) -> State {
        match self {
            Self::Moving { panel, from, ends, .. } => {
                let place = panel.at(panel.at_time(time - from.time, *ends));
                State { time, coordinate: from.coordinate + place.way, speed: place.speed }
            }
            Self::Steady(from, _) => steady(from, time),
        }
    }

    fn middle(&self) -> Option<State> {
        match self {
            Self::Moving { from, end, .. } => Some(self.at(0.5 * (from.time + end))),
            Self::Steady(..) => None,
        }
    }
}
