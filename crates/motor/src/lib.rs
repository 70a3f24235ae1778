//! Asynchronous motors as data and as functions of speed: the contract of a catalogue and its registry,
//! the mechanical characteristic, the motor seen from the input shaft, selection, and flywheel sizes.
//!
//! Knows no catalogue, no scene file and no terminal. SI units: W, rad/s, N·m, kg·m², m, kg.
//! The formulas are those of the working section and of Kloss (theory of the asynchronous machine); each
//! stands at the function that uses it.
//!
//! A catalogue is a plugin: a CSV file, a [`CatalogueTable`] and one `inventory::submit!` of a
//! [`CataloguePlugin`].

mod catalogue;
mod characteristic;
mod designation;
mod error;
mod filter;
mod flag;
mod flywheel;
mod lookup;
mod motor;
mod plausibility;
mod rated;
mod selection;
mod shaft;
mod table;
mod units;
mod warning;

pub use catalogue::{CataloguePlugin, MotorCatalogue, catalogues, find_catalogue, find_motor};
pub use characteristic::{Characteristic, CharacteristicKind, Kloss, Linear};
pub use designation::{latin_designation, normalize_designation, same_designation};
pub use error::{CatalogueError, LookupError, RowFault};
pub use filter::{MotorFilter, list_motors};
pub use flag::flag_meaning;
pub use flywheel::{
    CAST_IRON, FlywheelError, FlywheelMaterial, FlywheelPlaces, FlywheelProportions, FlywheelShape,
    FlywheelSize, RimSpeedCheck, STEEL,
};
pub use lookup::find_designation;
pub use motor::Motor;
pub use plausibility::{Doubt, doubts};
pub use rated::{RatedData, RatedDataError};
pub use selection::{Candidate, Selection, SelectionError, SelectionRequest, SkipReason, Skipped, select};
pub use shaft::{ShaftError, ShaftMotor};
pub use table::{CatalogueTable, parse_table};
pub use units::{rad_per_s, rpm};
pub use warning::{
    MotorWarning, check_breakdown, check_rms, check_rotor_inertia, check_starting, rms_torque,
    starting_torque,
};

#[cfg(test)]
mod tests;
