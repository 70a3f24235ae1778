//! What can be wrong with a catalogue, and with a requested designation.

use assur_plugin::RegistryError;

/// Why a catalogue cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CatalogueError {
    /// The text is not a table of motors.
    #[error("catalogue `{catalogue}`: the table cannot be read: {reason}")]
    Table {
        /// Name of the catalogue.
        catalogue: String,
        /// What the CSV reader says, with the line.
        reason: String,
    },
    /// The table has no rows (name of the catalogue).
    #[error("catalogue `{0}` has no rows")]
    Empty(String),
    /// A row holds an impossible value.
    #[error("catalogue `{catalogue}`, line {line}, `{designation}`: {fault}")]
    Row {
        /// Name of the catalogue.
        catalogue: String,
        /// Line of the table, counted from 1; the header is line 1.
        line: u64,
        /// Type as printed.
        designation: String,
        /// What is impossible.
        fault: RowFault,
    },
    /// Two registered catalogues have one name, or none is registered.
    #[error(transparent)]
    Registry(#[from] RegistryError),
    /// There is no catalogue of that name.
    #[error("no motor catalogue `{name}`; there are: {}", known.join(", "))]
    UnknownName {
        /// The requested name.
        name: String,
        /// All registered names, the nearest first.
        known: Vec<String>,
    },
}

/// What is impossible in one row.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RowFault {
    /// A value outside the possible range.
    #[error("{column} = {value}, must be above {above} and at most {most}")]
    OutOfRange {
        /// Column of the table.
        column: &'static str,
        /// The value.
        value: f64,
        /// Exclusive lower limit.
        above: f64,
        /// Inclusive upper limit.
        most: f64,
    },
    /// The number of poles is odd or zero (the value).
    #[error("poles = {0}, must be even and positive")]
    Poles(u32),
    /// The synchronous speed does not belong to the number of poles.
    #[error("synchronous_speed_rpm = {rpm} does not belong to {poles} poles at 50 Hz or 60 Hz")]
    SynchronousSpeed {
        /// The value, 1/min.
        rpm: f64,
        /// Number of poles.
        poles: u32,
    },
    /// Another row has the same designation.
    #[error("the designation occurs twice in the table")]
    Duplicate,
}

/// Why a designation does not name one motor.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LookupError {
    /// No such motor.
    #[error("no motor `{designation}` in {catalogue}{}", nearest_hint(nearest))]
    NotFound {
        /// The requested designation.
        designation: String,
        /// Where: a catalogue in words.
        catalogue: String,
        /// Up to three designations that are most alike, the nearest first.
        nearest: Vec<String>,
    },
    /// Several motors.
    #[error("`{designation}` names {count} motors in {catalogue}: {}{}; give the whole designation",
        candidates.join(", "), if *count > candidates.len() { ", ..." } else { "" })]
    Ambiguous {
        /// The requested designation.
        designation: String,
        /// Where: a catalogue in words.
        catalogue: String,
        /// How many rows fit.
        count: usize,
        /// The first of them.
        candidates: Vec<String>,
    },
    /// A catalogue cannot be used.
    #[error(transparent)]
    Catalogue(#[from] CatalogueError),
}

fn nearest_hint(nearest: &[String]) -> String {
    if nearest.is_empty() {
        "; see the list of motors".to_owned()
    } else {
        format!("; the nearest are: {}", nearest.join(", "))
    }
}
