//! The names of columns: of a parameter its key, and of every number its unit at the end.

use assur_mechanism::Key;
use assur_scene::Dimension;
use assur_scene::edit::ParsedText;
use assur_words::Text;
use strum::VariantArray;

/// The first column: the number of the point.
pub(crate) const ROW: &str = "row";

/// The column behind the parameters.
pub(crate) const STATUS: &str = "status";

/// The unit as the end of a column's name, `kgm2`, `m_per_s`; empty for a plain number.
pub(crate) fn suffix(dimension: Dimension) -> String {
    dimension.si().replace('/', "_per_").replace(['*', '^'], "")
}

/// Key and unit without the end of a column's name that is the unit; `None` of a plain number, and where no scene has such a unit.
fn parted(column: &str) -> Option<(&str, Dimension)> {
    let mut all: Vec<_> = Dimension::VARIANTS.iter().map(|kind| (*kind, suffix(*kind))).collect();
    all.retain(|(_, suffix)| !suffix.is_empty());
    // `m_per_s` before `s`.
    all.sort_by_key(|(_, suffix)| std::cmp::Reverse(suffix.len()));
    let part = |(kind, suffix): &(Dimension, String)| {
        Some((column.strip_suffix(suffix)?.strip_suffix('_').filter(|rest| !rest.ends_with("_per"))?, *kind))
    };
    all.iter().find_map(part)
}

/// What a column measures, by its unit.
pub(crate) fn measured(column: &str) -> Option<Dimension> {
    parted(column).map(|(_, kind)| kind)
}

/// The key of the parameter that a column holds, and what it measures where its name has the unit: `link.crank.mass`,
/// `link.crank.mass_kg`.
///
/// # Errors
///
/// A message about the key, with the keys that the scene has instead.
pub fn parameter(document: &ParsedText<'_>, column: &str) -> Result<(Key, Option<Dimension>), Text> {
    let find = |key: &str| {
        let key = Key::parse(key)?;
        document.find(&key).map(|_| key)
    };
    find(column).map(|key| (key, None)).or_else(|problem| {
        let found = parted(column).and_then(|(key, kind)| Some((find(key).ok()?, Some(kind))));
        found.ok_or(problem)
    })
}
