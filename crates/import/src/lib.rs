//! Scenes from drawings of other programs.
//!
//! An [`ImporterPlugin`] knows its format by the ending of a file or by how the content begins, and reads bytes into a
//! [`Drawing`]: joints, links, slides, inputs and forces at their places in the plane, in SI. [`import`] finds the plugin, and
//! makes of its drawing what a scene can say, and the text of that scene; what was replaced or left out stands in comments
//! at its beginning, so that nothing is dropped in silence.

mod drawing;
mod mechanism;
mod names;
mod scene;
#[cfg(test)]
mod tests;

use assur_plugin::RegistryError;
use assur_words::{Describe, Language, Text, joined, list, name, text};

pub use drawing::{Drawing, Driven, Force, Input, Joint, Link, Remark, Slide, are_apart};

assur_words::resources!();

/// What is imported.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// Name of the file; of a link nothing.
    pub file: &'a str,
    /// Content of the file, or the link itself.
    pub bytes: &'a [u8],
    /// What one unit of the drawing's coordinates is, m, where it is not as the format says.
    pub unit: Option<f64>,
}

/// How a format is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// The file's name ends so, in any case.
    Ending(&'static str),
    /// The content begins so, behind blanks.
    Prefix(&'static str),
}

/// Registry entry of an importer; give it to `inventory::submit!`.
#[derive(Debug, Clone)]
pub struct ImporterPlugin {
    /// Stable identifier, as the command line has it.
    pub name: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// One line: of which program drawings are read.
    pub summary: Text,
    /// Where the format is described.
    pub source: Text,
    /// How the format is known; one of them is enough.
    pub signs: &'static [Sign],
    /// Reads a drawing. The error says what is wrong and where.
    pub read: fn(&Source<'_>) -> Result<Drawing, Text>,
}

assur_plugin::registry!(ImporterPlugin, text!("import-sort"), name);

impl ImporterPlugin {
    fn knows(&self, source: &Source<'_>) -> bool {
        let content =
            source.bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(source.bytes).trim_ascii_start();
        self.signs.iter().any(|sign| match sign {
            Sign::Ending(ending) => source.file.to_lowercase().ends_with(ending),
            Sign::Prefix(prefix) => content.starts_with(prefix.as_bytes()),
        })
    }

    /// Its name, and how its format is known.
    fn told(&self) -> Text {
        let signs = self.signs.iter().map(|sign| match sign {
            Sign::Ending(ending) => text!("import-ending", ending = name(*ending)),
            Sign::Prefix(prefix) => text!("import-prefix", prefix = name(*prefix)),
        });
        text!("import-format", name = name(self.name), signs = list(signs))
    }
}

/// All registered importers, sorted by name.
pub fn importers() -> Result<Vec<&'static ImporterPlugin>, RegistryError> {
    assur_plugin::all()
}

/// A scene from a drawing.
#[derive(Debug, Clone)]
pub struct Imported {
    /// The text of the scene.
    pub scene: String,
    /// What of the drawing could not be said.
    pub lost: Vec<Text>,
}

/// The scene of a drawing, its comments in a language; of a format by its name, or that which knows the source.
///
/// # Errors
///
/// The format is not known, the source is not of it, or nothing of the drawing moves.
pub fn import(source: &Source<'_>, format: Option<&str>, language: &Language) -> Result<Imported, Text> {
    let plugin = match format {
        Some(format) => assur_plugin::find::<ImporterPlugin>(format).map_err(|error| error.describe())?,
        None => known(source)?,
    };
    let mut drawing = (plugin.read)(source)?;
    drawing.check()?;
    mechanism::reduce(&mut drawing)?;
    let lost =
        drawing.remarks.iter().filter(|remark| remark.is_lost).map(|remark| remark.text.clone()).collect();
    Ok(Imported { scene: scene::write(&drawing, plugin.name, language), lost })
}

fn known(source: &Source<'_>) -> Result<&'static ImporterPlugin, Text> {
    let all = importers().map_err(|error| error.describe())?;
    all.iter().find(|plugin| plugin.knows(source)).copied().ok_or_else(|| {
        text!("import-unknown", formats = joined("; ", all.iter().map(|plugin| plugin.told())))
    })
}
