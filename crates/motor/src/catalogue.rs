//! The contract of a motor catalogue, and the registry of the catalogues that are linked into the program.

use assur_plugin::Registered;

use crate::{CatalogueError, CatalogueTable, LookupError, Motor, find_designation, same_designation};

/// Registry entry of a catalogue; give it to `inventory::submit!`.
#[derive(Debug, Clone, Copy)]
pub struct CataloguePlugin {
    /// Stable identifier, as scenes write it.
    pub name: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// One line: what motors these are.
    pub summary: &'static str,
    /// Where the numbers are printed.
    pub source: &'static str,
    /// The rows.
    pub table: &'static CatalogueTable,
}

inventory::collect!(CataloguePlugin);

impl CataloguePlugin {
    /// All rows, in the order of the source; read once, then cached.
    ///
    /// # Errors
    ///
    /// Those of [`parse_table`](crate::parse_table).
    pub fn rows(&self) -> Result<&[Motor], CatalogueError> {
        self.table.rows(self.name)
    }

    /// The motor of that designation, see [`find_designation`].
    ///
    /// # Errors
    ///
    /// [`LookupError`] if the catalogue cannot be used, or the designation names no motor or several.
    pub fn find(&self, designation: &str) -> Result<&Motor, LookupError> {
        find_designation(self.rows()?, designation, &format!("catalogue {}", self.name))
    }
}

impl Registered for CataloguePlugin {
    const WHAT: &'static str = "motor catalogue";

    fn registration(&self) -> (&'static str, &'static str) {
        (self.name, self.crate_name)
    }
}

/// All registered catalogues, sorted by name: the order of linking does not matter.
///
/// # Errors
///
/// [`CatalogueError::Registry`] if two have one name or there is none.
pub fn catalogues() -> Result<Vec<&'static CataloguePlugin>, CatalogueError> {
    Ok(assur_plugin::all()?)
}

/// The registered catalogue of that name, without regard to case, spaces and script.
///
/// # Errors
///
/// Those of [`catalogues`], and [`CatalogueError::UnknownName`].
pub fn find_catalogue(name: &str) -> Result<&'static CataloguePlugin, CatalogueError> {
    named(&catalogues()?, name)
}

/// The motor of that designation, in one catalogue or, without a name, in all.
///
/// # Errors
///
/// Those of [`find_catalogue`] and [`find_designation`]; a designation that occurs in several catalogues is ambiguous.
pub fn find_motor(catalogue: Option<&str>, designation: &str) -> Result<&'static Motor, LookupError> {
    if let Some(name) = catalogue {
        return find_catalogue(name)?.find(designation);
    }
    let mut all = Vec::new();
    for plugin in catalogues()? {
        all.extend(plugin.rows()?);
    }
    find_designation(all.iter().copied(), designation, "any catalogue")
}

/// The catalogue of that name among these.
pub(crate) fn named<'a>(
    all: &[&'a CataloguePlugin],
    name: &str,
) -> Result<&'a CataloguePlugin, CatalogueError> {
    all.iter().find(|c| same_designation(c.name, name)).copied().ok_or_else(|| {
        let asked = name.to_uppercase();
        let mut known: Vec<String> = all.iter().map(|c| c.name.to_owned()).collect();
        known.sort_by_key(|k| strsim::osa_distance(&k.to_uppercase(), &asked));
        CatalogueError::UnknownName { name: name.to_owned(), known }
    })
}
