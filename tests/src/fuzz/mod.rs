//! Inputs that nobody meant, and what must hold for each of them.
//!
//! [`input`] makes the text of a scene from a number: a random mechanism, or a shipped or kept scene that is mutated by
//! numbers, lines, sections or bytes. [`run`] calculates a scene in this process as the command `analyze` does, and says what
//! became of it, or what must not be: a panic, a number that is not finite, a key that stands twice, a fault without a place, a
//! check that fails though the same formulas in 32 digits find the numbers right. [`variant`] makes a scene that a person might
//! write.

mod exact;
mod input;
mod json;
mod run;
mod variant;

pub use input::{Source, input};
pub use run::{Finding, Outcome, run};
pub use variant::variant;

/// The scenes that mutations begin with: the shipped and the kept ones.
///
/// # Errors
///
/// [`std::io::Error`] where the kept ones can't be read.
pub fn known() -> std::io::Result<Vec<String>> {
    let shipped = assur_fixtures::SCENES.iter().map(|(_, text)| (*text).to_owned());
    Ok(shipped.chain(corpus()?.into_iter().map(|(_, text)| text)).collect())
}

/// The scenes that are kept because they were once answered wrongly: name and text.
///
/// # Errors
///
/// [`std::io::Error`] where the folder can't be read.
pub fn corpus() -> std::io::Result<Vec<(String, String)>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/corpus");
    let mut scenes = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        scenes.push((name, std::fs::read_to_string(path)?));
    }
    scenes.sort();
    Ok(scenes)
}
