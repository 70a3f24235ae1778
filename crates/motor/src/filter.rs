//! Choosing rows for a list.

use crate::catalogue::named;
use crate::designation::normalize_latin;
use crate::{CatalogueError, CataloguePlugin, Motor, normalize_designation};

/// Which motors to list; a field that is `None` admits all.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotorFilter {
    /// Name of the catalogue.
    pub catalogue: Option<String>,
    /// Least rated power, W, included.
    pub min_power: Option<f64>,
    /// Greatest rated power, W, included.
    pub max_power: Option<f64>,
    /// Number of poles.
    pub poles: Option<u32>,
    /// A part of the designation, without regard to case, spaces and script.
    pub designation: Option<String>,
}

impl MotorFilter {
    /// Whether the row fits everything but the catalogue.
    pub fn accepts(&self, motor: &Motor) -> bool {
        self.min_power.is_none_or(|least| motor.rated_power >= least)
            && self.max_power.is_none_or(|most| motor.rated_power <= most)
            && self.poles.is_none_or(|poles| motor.poles == poles)
            && self.designation.as_deref().is_none_or(|part| contains(&motor.designation, part))
    }
}

/// The rows of these catalogues that the filter admits, in the order of the catalogues and of their rows.
///
/// # Errors
///
/// [`CatalogueError`] if the filter names a catalogue that is not among these, or one cannot be used.
pub fn list_motors(
    catalogues: &[&'static CataloguePlugin],
    filter: &MotorFilter,
) -> Result<Vec<&'static Motor>, CatalogueError> {
    let wanted = match &filter.catalogue {
        Some(name) => &[named(catalogues, name)?][..],
        None => catalogues,
    };
    let mut motors = Vec::new();
    for catalogue in wanted {
        motors.extend(catalogue.rows()?.iter().filter(|m| filter.accepts(m)));
    }
    Ok(motors)
}

fn contains(designation: &str, part: &str) -> bool {
    normalize_designation(designation).contains(&normalize_designation(part))
        || normalize_latin(designation).contains(&normalize_latin(part))
}
