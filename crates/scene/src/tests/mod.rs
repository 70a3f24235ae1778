//! Tests of the whole reader.

mod display;
mod faults;
mod limits;
mod robust;
mod values;

/// A scene with one of each, that the tests change.
pub(crate) const BASE: &str = include_str!("base.toml");

/// The base scene with a motion that a drive can give.
fn steady() -> String {
    BASE.replace("speed = \"900 rpm\"", "kind = \"steady\"\nmean_speed = \"900 rpm\"\nunevenness = 0.05")
}

pub(crate) fn fixtures() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures");
    let mut all = Vec::new();
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
