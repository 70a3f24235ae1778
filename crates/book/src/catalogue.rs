//! What is known of a quantity whatever its owner.

use assur_analysis::results::{Column, Part, Quantity};

/// Whether the sign of a quantity says in which sense it acts, so that the greatest value is the one of greatest modulus: a
/// moment of -90 N m loads a guide more than one of 30 N m. The sign of a place, of an energy or of a modulus says where it is or
/// that it can't be negative.
pub fn sign_is_sense(column: Column) -> bool {
    let has_sense = !matches!(
        column.quantity,
        Quantity::Time
            | Quantity::Transfer(0)
            | Quantity::ReducedInertia
            | Quantity::DrivingWork
            | Quantity::ResistingWork
            | Quantity::KineticEnergy
            | Quantity::Offset
            | Quantity::Residual(_)
            | Quantity::Condition
    );
    has_sense && column.part != Part::Modulus
}
