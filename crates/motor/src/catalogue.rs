//! The contract of a motor catalogue, and the registry of the catalogues that are linked into the program.

use crate::{CatalogueError, LookupError, Motor, find_designation, same_designation};

/// A list of motors.
pub trait MotorCatalogue: std::fmt::Debug + Sync {
    /// Stable identifier, as scenes write it: `4A`. Compared like designations, without regard to case.
    fn name(&self) -> &str;

    /// One line: what motors these are.
    fn summary(&self) -> &str;

    /// Where the numbers are printed.
    fn source(&self) -> &str;

    /// All rows, in the order of the source; read once, then kept.
    ///
    /// # Errors
    ///
    /// [`CatalogueError`] if the table cannot be read or a row is impossible.
    fn rows(&self) -> Result<&[Motor], CatalogueError>;

    /// The motor of that designation, see [`find_designation`].
    ///
    /// # Errors
    ///
    /// [`LookupError`] if the catalogue cannot be used, or the designation names no motor or several.
    fn find(&self, designation: &str) -> Result<&Motor, LookupError> {
        find_designation(self.rows()?, designation, &format!("catalogue {}", self.name()))
    }
}

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
    /// All rows; usually [`CatalogueTable::rows`](crate::CatalogueTable::rows) of a static table.
    pub rows: fn() -> Result<&'static [Motor], CatalogueError>,
}

inventory::collect!(CataloguePlugin);

impl MotorCatalogue for CataloguePlugin {
    fn name(&self) -> &str {
        self.name
    }

    fn summary(&self) -> &str {
        self.summary
    }

    fn source(&self) -> &str {
        self.source
    }

    fn rows(&self) -> Result<&[Motor], CatalogueError> {
        (self.rows)()
    }
}

/// All registered catalogues, sorted by name: the order of linking does not matter.
///
/// # Errors
///
/// [`CatalogueError::DuplicateName`] if two have one name, [`CatalogueError::NoneRegistered`] if there is none.
pub fn catalogues() -> Result<Vec<&'static CataloguePlugin>, CatalogueError> {
    sorted(inventory::iter::<CataloguePlugin>.into_iter().collect())
}

/// The registered catalogue of that name, without regard to case, spaces and script.
///
/// # Errors
///
/// As [`catalogues`], and [`CatalogueError::UnknownName`].
pub fn find_catalogue(name: &str) -> Result<&'static CataloguePlugin, CatalogueError> {
    named(&catalogues()?, name)
}

/// The motor of that designation, in one catalogue or, without a name, in all.
///
/// # Errors
///
/// As [`find_catalogue`] and [`find_designation`]; a designation that stands in several catalogues is ambiguous.
pub fn find_motor(catalogue: Option<&str>, designation: &str) -> Result<&'static Motor, LookupError> {
    if let Some(name) = catalogue {
        return find_catalogue(name)?.find(designation);
    }
    let mut all = Vec::new();
    for plugin in catalogues()? {
        all.extend((plugin.rows)()?);
    }
    find_designation(all.iter().copied(), designation, "any catalogue")
}

/// Sorts by name and refuses what would make a name ambiguous.
pub(crate) fn sorted(mut all: Vec<&CataloguePlugin>) -> Result<Vec<&CataloguePlugin>, CatalogueError> {
    if all.is_empty() {
        return Err(CatalogueError::NoneRegistered);
    }
    all.sort_by_key(|c| (c.name.to_uppercase(), c.crate_name));
    for (i, first) in all.iter().enumerate() {
        if let Some(second) = all[i + 1..].iter().find(|c| same_designation(c.name, first.name)) {
            return Err(CatalogueError::DuplicateName {
                name: first.name.to_owned(),
                first: first.crate_name.to_owned(),
                second: second.crate_name.to_owned(),
            });
        }
    }
    Ok(all)
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
