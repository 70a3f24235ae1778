//! What had to be left out, and what of a request has no use.

use assur_mechanism::{Mechanism, Motion};

use crate::{Options, Study};

/// Where no forces are told, in words.
const LOST: &str = "the mechanism stands at a change point (nearer than 0.001 rad, or parts of its size): constraints of a \
                    group coincide there and its reactions are not determined";

impl Study {
    /// Notes for the results; `positions` and number of `samples` of a motion at which forces are not determined.
    pub(crate) fn notes(&self, positions: &[usize], samples: usize) -> Vec<String> {
        let mut notes = self.unused.clone();
        if !positions.is_empty() {
            let numbers: Vec<_> = positions.iter().map(ToString::to_string).collect();
            notes.push(format!("No forces in positions {}: {LOST}.", numbers.join(", ")));
        }
        if samples > 0 {
            notes.push(format!("No forces at {samples} samples of the motion: {LOST}."));
        }
        notes
    }
}

/// Parts of the scene and of the choice of methods that are not used.
pub(crate) fn unused(mechanism: &Mechanism, options: &Options) -> Vec<String> {
    let transient = matches!(mechanism.motion, Some(Motion::Transient { .. }));
    let steady = matches!(mechanism.motion, Some(Motion::Steady { .. }));
    let mut notes = Vec::new();
    if mechanism.drive.is_some() && !transient && !steady {
        notes.push(
            "`[drive]` is not used: the motion is prescribed or absent; take `kind = \"steady\"` or \"transient\"."
                .to_owned(),
        );
    }
    if let Some(name) = options.integrator.as_ref().filter(|_| !transient) {
        let why = if steady {
            "the steady regime is found by collocation over the cycle, not by steps in time"
        } else {
            "the scene asks for no motion from an initial state"
        };
        notes.push(format!("Integrator `{name}` is not used: {why}."));
    }
    notes
}
