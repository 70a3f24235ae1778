//! What can be wrong with a catalogue, and with a requested designation.

use assur_plugin::RegistryError;
use assur_words::{Describe, Text, name, number, text};

/// Why a catalogue cannot be used.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum CatalogueError {
    /// The text is not a table of motors.
    Table {
        /// Name of the catalogue.
        catalogue: String,
        /// What the CSV reader says, with the line.
        reason: String,
    },
    /// The table has no rows (name of the catalogue).
    Empty(String),
    /// A row holds an impossible value.
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
    Registry(RegistryError),
    /// There is no catalogue of that name.
    UnknownName {
        /// The requested name.
        name: String,
        /// All registered names, the nearest first.
        known: Vec<String>,
    },
}

/// What is impossible in one row.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum RowFault {
    /// A value outside the possible range.
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
    Poles(u32),
    /// The synchronous speed does not belong to the number of poles.
    SynchronousSpeed {
        /// The value, 1/min.
        rpm: f64,
        /// Number of poles.
        poles: u32,
    },
    /// Another row has the same designation.
    Duplicate,
}

/// What someone who asked for an unknown motor may have meant.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LookupHint {
    /// Up to three designations that are most alike, the nearest first.
    Nearest(Vec<String>),
    /// A power in place of a designation.
    OfPower {
        /// The power, W.
        power: f64,
        /// How many motors are rated at it.
        count: usize,
        /// The first of them.
        candidates: Vec<String>,
    },
    /// Nothing is alike.
    List,
}

/// Why a designation does not name one motor.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LookupError {
    /// No such motor.
    NotFound {
        /// The requested designation.
        designation: String,
        /// Where: a catalogue in words.
        catalogue: Text,
        /// What may have been meant.
        hint: LookupHint,
    },
    /// Several motors.
    Ambiguous {
        /// The requested designation.
        designation: String,
        /// Where: a catalogue in words.
        catalogue: Text,
        /// How many rows fit.
        count: usize,
        /// The first of them.
        candidates: Vec<String>,
    },
    /// A catalogue cannot be used.
    Catalogue(CatalogueError),
}

assur_words::errors!(RowFault);
assur_words::errors!(LookupError; Catalogue(CatalogueError));
assur_words::errors!(CatalogueError; Registry(RegistryError));

fn names(list: &[String]) -> Text {
    assur_words::list(list.iter().map(|one| name(one.clone())))
}

/// What follows a list that shows not all.
fn more(count: usize, shown: &[String]) -> Text {
    name(if count > shown.len() { ", ..." } else { "" })
}

impl Describe for LookupHint {
    fn describe(&self) -> Text {
        match self {
            Self::Nearest(nearest) => text!("motor-hint-nearest", nearest = names(nearest)),
            Self::OfPower { power, count, candidates } => text!(
                "motor-hint-power",
                // As the command line reads it, in every language; to a milliwatt, without the rounding of the units.
                power = name(((power * 1e3).round() / 1e6).to_string()),
                count = *count,
                candidates = names(candidates),
                more = more(*count, candidates)
            ),
            Self::List => text!("motor-hint-list"),
        }
    }
}

impl Describe for CatalogueError {
    fn describe(&self) -> Text {
        let own = |letters: &String| name(letters.clone());
        match self {
            Self::Table { catalogue, reason } => {
                text!("motor-table-unreadable", catalogue = own(catalogue), reason = own(reason))
            }
            Self::Empty(catalogue) => text!("motor-no-rows", catalogue = own(catalogue)),
            Self::Row { catalogue, line, designation, fault } => text!(
                "motor-bad-row",
                catalogue = own(catalogue),
                line = number(line),
                designation = own(designation),
                fault = fault.describe()
            ),
            Self::Registry(error) => error.describe(),
            Self::UnknownName { name, known } => {
                text!("motor-no-catalogue", name = own(name), known = names(known))
            }
        }
    }
}

impl Describe for RowFault {
    fn describe(&self) -> Text {
        match self {
            Self::OutOfRange { column, value, above, most } => text!(
                "motor-out-of-range",
                column = name(*column),
                value = number(value),
                above = number(above),
                most = number(most)
            ),
            Self::Poles(poles) => text!("motor-bad-poles", poles = number(poles)),
            Self::SynchronousSpeed { rpm, poles } => {
                text!("motor-bad-synchronous", rpm = number(rpm), poles = number(poles))
            }
            Self::Duplicate => text!("motor-row-twice"),
        }
    }
}

impl Describe for LookupError {
    fn describe(&self) -> Text {
        match self {
            Self::NotFound { designation, catalogue, hint } => text!(
                "motor-not-found",
                designation = name(designation.clone()),
                catalogue,
                hint = hint.describe()
            ),
            Self::Ambiguous { designation, catalogue, count, candidates } => text!(
                "motor-ambiguous",
                designation = name(designation.clone()),
                count = *count,
                catalogue,
                candidates = names(candidates),
                more = more(*count, candidates)
            ),
            Self::Catalogue(error) => error.describe(),
        }
    }
}
