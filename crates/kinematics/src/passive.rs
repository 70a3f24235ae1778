//! Passive links and pairs: those that repeat what others say.

use assur_mechanism::Mechanism;
use assur_structure::{Structure, StructureError};

/// Decomposes a mechanism into Assur groups.
///
/// # Errors
///
/// Those of [`Structure::of`].
pub fn decompose(mechanism: &Mechanism) -> Result<Structure, StructureError> {
    Structure::of(mechanism)
}
