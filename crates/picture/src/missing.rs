//! What results lack of which there is no picture.

use assur_mechanism::Motion;
use assur_words::{Text, joined, text};

use crate::{Look, Picture, Results, ViewPart, motion, plans};

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Missing {
    /// The reason, with an example of what to add to the scene where something can be added.
    pub why: Text,
    /// Whether something can be added.
    pub can_be_added: bool,
}

impl Picture {
    /// Why a part of it has nothing to show.
    pub fn missing(self, results: &Results, look: &Look<'_>, part: ViewPart) -> Missing {
        let Some(found) = &results.found else { return Missing::only(text!("nothing-here")) };
        let is_transient = matches!(results.linkage.mechanism.motion, Some(Motion::Transient { .. }));
        let has_loads = found.plans.calculation().plan.forces;
        let not_determined = || text!("forces-not-determined");
        match (self, &found.analysis.no_motion) {
            (Self::Motion | Self::Drive, Some(reason)) => Missing::only(motion::not_found(reason, "\n")),
            (Self::Forces | Self::Plans, None) if is_transient => Missing::only(text!("forces-over-time")),
            (Self::Forces | Self::Plans, Some(reason)) => {
                Missing::only(joined("\n", [text!("no-forces-found"), reason.clone()]))
            }
            (Self::Motion, None) => Missing::addable(text!("add-motion")),
            (Self::Drive, None) if found.analysis.dynamics.is_some() => {
                Missing::only(text!("drive-no-motor"))
            }
            (Self::Drive, None) => Missing::addable(text!("add-drive")),
            (Self::Forces, None) if has_loads => Missing::only(not_determined()),
            (Self::Plans, None) if has_loads => {
                Missing::only(plans::missing(found, look, part).unwrap_or_else(not_determined))
            }
            (Self::Forces | Self::Plans, None) => Missing::addable(text!("add-loads")),
            _ => Missing::only(text!("nothing-here")),
        }
    }
}

impl Missing {
    fn only(why: Text) -> Self {
        Self { why, can_be_added: false }
    }

    fn addable(why: Text) -> Self {
        Self { why, can_be_added: true }
    }
}
