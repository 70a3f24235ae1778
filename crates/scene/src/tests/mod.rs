//! Tests of the whole reader.

mod display;
mod faults;
mod labels;
mod limits;
mod over_time;
mod places;
mod robust;
mod values;

/// A scene with one of each, that the tests change.
pub(crate) const BASE: &str = include_str!("base.toml");

/// Scenes with several inputs, and with a law of one over time.
pub(crate) const FIVE_BAR: &str = include_str!("five-bar.toml");
pub(crate) const ARM: &str = include_str!("arm.toml");
pub(crate) const BOOM: &str = include_str!("boom.toml");

/// A scene with points in polar form and by two lengths.
pub(crate) const PLACES: &str = include_str!("places.toml");

/// The base scene with a motion that a drive can give.
fn steady() -> String {
    BASE.replace("speed = \"900 rpm\"", "kind = \"steady\"\nmean_speed = \"900 rpm\"\nunevenness = 0.05")
}

/// The shipped scenes, those over time, and one with points by all keys.
pub(crate) fn fixtures() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures");
    let others = [("five-bar", FIVE_BAR), ("arm", ARM), ("boom-law", BOOM), ("places", PLACES)];
    let mut all: Vec<_> = others.map(|(name, text)| (name.to_owned(), text.to_owned())).into();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            all.push((name, std::fs::read_to_string(&path).unwrap()));
        }
    }
    all.sort();
    all
}

fn fixture(name: &str) -> assur_mechanism::Mechanism {
    let (_, text) = fixtures().into_iter().find(|fixture| fixture.0 == name).unwrap();
    crate::read(name, &text).unwrap_or_else(|errors| panic!("{errors}"))
}
