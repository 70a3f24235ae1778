//! Passive links and pairs: those that repeat constraints of others.
//!
//! By count such a part takes a degree of freedom away, by rank of the constraints it does not. Whether it does is a question of lengths, and of the whole
//! motion: in a dead center or at a change point the rank is smaller although nothing repeats. So a part is passive if the
//! mechanism without it has the same mobility and fewer surplus constraints, and if the part then fits in every position of the
//! cycle.

pub(crate) mod hang;
mod misfit;
mod search;

use assur_mechanism::Mechanism;
use assur_structure::{Structure, StructureError};

pub(crate) use misfit::misfits;
pub use misfit::{Closing, Length, Misfit};

/// Decomposes a mechanism into Assur groups, without its passive parts where it counts constraints that repeat others.
///
/// # Errors
///
/// [`StructureError`] where its mobility is not 1.
pub fn decompose(mechanism: &Mechanism) -> Result<Structure, StructureError> {
    match Structure::of(mechanism) {
        Err(StructureError::Surplus { counted, pairs, links, .. }) => search::without_passive(mechanism)
            .map_err(|cause| StructureError::Surplus { counted, pairs, links, cause }),
        found => found,
    }
}
