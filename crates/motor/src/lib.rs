//! Asynchronous motors as data and as functions of speed: the contract of a catalogue and its registry,
//! the mechanical characteristic, selection, and flywheel sizes.
//!
//! Knows no catalogue, no scene file and no terminal. SI units: W, rad/s, N·m, kg·m², m, kg.
//! The formulas are those of the working section and of Kloss (theory of the asynchronous machine), each documented at
//! the function that uses it.
//!
//! ```
//! use assur_motor::{Characteristic, CharacteristicKind, RatedMotor, rad_per_s};
//!
//! let rated = RatedMotor {
//!     power: 1100.0,
//!     synchronous_speed: rad_per_s(1500.0),
//!     rated_speed: rad_per_s(1410.0),
//!     max_torque_ratio: Some(2.2),
//!     inertia: Some(0.0045),
//! };
//! let kloss = Characteristic::new(CharacteristicKind::Kloss, &rated)?;
//! assert!((kloss.torque(rated.rated_speed) - 7.4498).abs() < 1e-4); // 1100 W / 147.65 rad/s
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A catalogue is a plugin: a CSV file and one `inventory::submit!`.
//!
//! ```
//! use assur_motor::{CataloguePlugin, CatalogueTable, find_motor};
//! use assur_words::text;
//!
//! static TABLE: CatalogueTable = CatalogueTable::new(
//!     // usually include_str!("../data/mine.csv")
//!     "designation,poles,rated_power_kw,synchronous_speed_rpm,rated_speed_rpm,source\nM 1,4,1.1,1500,1410,p. 7\n",
//! );
//! inventory::submit! {
//!     CataloguePlugin {
//!         name: "MINE",
//!         crate_name: env!("CARGO_PKG_NAME"),
//!         summary: text!("mine-summary"), // what motors these are: in lang/*.ftl of the crate
//!         source: text!("mine-source"), // where they are printed
//!         table: &TABLE,
//!     }
//! }
//! # fn main() {
//! assert_eq!(find_motor(Some("mine"), "m1").map(|m| m.poles), Ok(4));
//! # }
//! ```

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod catalogue;
mod characteristic;
mod error;
mod flywheel;
mod lookup;
mod motor;
mod selection;
mod table;
mod warning;

assur_words::resources!();

pub use assur_mechanism::{CharacteristicKind, RatedMotor};
pub use catalogue::{CataloguePlugin, MotorFilter, catalogues, find_catalogue, find_motor, list_motors};
pub use characteristic::Characteristic;
pub use error::MotorError;
pub use flywheel::{FlywheelSize, flywheel_sizes};
pub use flywheel::{USUAL_SOURCE, USUAL_UNEVENNESS, UsualUnevenness};
pub use lookup::find_designation;
pub use lookup::{latin_designation, normalize_designation, same_designation};
pub use motor::{Motor, flag_meaning, rad_per_s, rpm};
pub use selection::{Candidate, PassedOver, Selection, SelectionRequest, nearest, select};
pub use table::{CatalogueTable, parse_table};
pub use warning::{
    MotorWarning, check_breakdown, check_rms, check_rotor_inertia, check_starting, rms_torque,
    starting_torque,
};

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "mirror images, zeros and values handed through agree to the last bit")]
mod tests;
