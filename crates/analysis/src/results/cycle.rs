//! The reactions as a whole, contacts, and plans.

use assur_diagram::{Enveloping, Extreme, Hodograph, Sheet, SignChange};
use serde::Serialize;

use crate::results::Named;

/// Reactions over the cycle, geometry of the contacts, plans of the requested positions. Sections that don't apply are
/// absent.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Cycle {
    /// Greatest modulus and root mean square of each reaction.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub reaction_extremes: Vec<Extreme>,
    /// By slide that carries a force: where the force changes the side of the guide. A slide without a change has an
    /// empty list.
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub sign_changes: Named<Vec<SignChange>>,
    /// The straight line that the arc of each contact envelopes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub enveloping: Vec<Enveloping>,
    /// Polar diagrams of the reactions, if requested.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hodographs: Vec<Hodograph>,
    /// The plans of the requested positions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub plans: Vec<PositionPlans>,
}

/// The plans of one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PositionPlans {
    /// Number of the position.
    pub index: usize,
    /// All plans.
    #[serde(flatten)]
    pub sheet: Sheet,
}
