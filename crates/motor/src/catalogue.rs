//! The contract of a motor catalogue, and the registry of the catalogues that are linked into the program.

use assur_words::{Text, name, text};

use crate::error::names;
use crate::lookup::normalize_latin;
use crate::selection::keeps;
use crate::{CatalogueTable, Motor, MotorError, find_designation, normalize_designation, same_designation};

/// Registry entry of a catalogue; give it to `inventory::submit!`.
#[derive(Debug, Clone)]
pub struct CataloguePlugin {
    /// Stable identifier, as scenes write it.
    pub name: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// One line: what motors these are.
    pub summary: Text,
    /// Where the numbers are printed.
    pub source: Text,
    /// The rows.
    pub table: &'static CatalogueTable,
}

assur_plugin::registry!(CataloguePlugin, text!("motor-sort"), name);

impl CataloguePlugin {
    /// All rows, in the order of the source; read once, then cached.
    pub fn rows(&self) -> Result<&[Motor], MotorError> {
        self.table.rows(self.name)
    }

    /// The motor of that designation, see [`find_designation`].
    ///
    /// # Errors
    ///
    /// [`MotorError`] if the catalogue cannot be used, or the designation names no motor or several.
    pub fn find(&self, designation: &str) -> Result<&Motor, MotorError> {
        find_designation(self.rows()?, designation, &text!("motor-in-catalogue", name = name(self.name)))
    }
}

/// All registered catalogues, sorted by name: the order of linking does not matter.
///
/// # Errors
///
/// [`MotorError`] if two have one name or there is none.
pub fn catalogues() -> Result<Vec<&'static CataloguePlugin>, MotorError> {
    Ok(assur_plugin::all()?)
}

/// The registered catalogue of that name, without regard to case, spaces and script.
pub fn find_catalogue(name: &str) -> Result<&'static CataloguePlugin, MotorError> {
    named(&catalogues()?, name)
}

/// The motor of that designation, in one catalogue or, without a name, in all.
///
/// # Errors
///
/// Those of [`find_catalogue`] and [`find_designation`]; a designation that occurs in several catalogues is ambiguous.
pub fn find_motor(catalogue: Option<&str>, designation: &str) -> Result<&'static Motor, MotorError> {
    if let Some(name) = catalogue {
        return find_catalogue(name)?.find(designation);
    }
    let mut all = Vec::new();
    for plugin in catalogues()? {
        all.extend(plugin.rows()?);
    }
    find_designation(all.iter().copied(), designation, &text!("motor-in-any-catalogue"))
}

/// The catalogue of that name among these.
pub(crate) fn named<'a>(all: &[&'a CataloguePlugin], name: &str) -> Result<&'a CataloguePlugin, MotorError> {
    all.iter().find(|c| same_designation(c.name, name)).copied().ok_or_else(|| {
        let asked = name.to_uppercase();
        let mut known: Vec<String> = all.iter().map(|c| c.name.to_owned()).collect();
        known.sort_by_key(|k| strsim::osa_distance(&k.to_uppercase(), &asked));
        let name = assur_words::name(name.to_owned());
        MotorError(text!("motor-no-catalogue", name, known = names(&known)))
    })
}

/// Which motors to list; a field that is `None` admits all.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotorFilter {
    /// Name of the catalogue.
    pub catalogue: Option<String>,
    /// Least rated power, W, included.
    pub min_power: Option<f64>,
    /// Greatest rated power, W, included.
    pub max_power: Option<f64>,
    /// Greatest synchronous speed, rad/s, included (S stage 5: the greatest admissible speed of the rotor).
    pub max_speed: Option<f64>,
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
            && self.max_speed.is_none_or(|most| keeps(motor, most))
            && self.poles.is_none_or(|poles| motor.poles == poles)
            && self.designation.as_deref().is_none_or(|part| contains(&motor.designation, part))
    }
}

/// The rows of these catalogues that the filter admits, in the order of the catalogues and of their rows.
pub fn list_motors(
    catalogues: &[&'static CataloguePlugin],
    filter: &MotorFilter,
) -> Result<Vec<&'static Motor>, MotorError> {
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
