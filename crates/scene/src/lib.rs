//! Reads scene files: TOML with units becomes a [`Mechanism`], or a list of all faults with their lines.
//!
//! The entry point is [`read`], a pure function from text to mechanism. Nothing here opens a file or prints. After a
//! fault the reader continues, so that one run shows all that is wrong; see [`SceneErrors`].
//!
//! ```
//! let text = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = '100 mm' }\n[input]\nlink = 'crank'";
//! let mechanism = assur_scene::read("crank.toml", text)?;
//! assert_eq!(mechanism.links.len(), 2); // the ground is one
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod context;
pub mod document;
mod drive;
pub mod edit;
mod error;
mod friction;
mod inertia;
mod input;
mod joints;
mod known;
mod labels;
mod limits;
mod linkage;
mod links;
mod loads;
mod mistakes;
mod motion;
mod note;
mod numbers;
mod over_time;
mod places;
mod reading;
pub mod reference;
mod render;
mod scan;
mod sheet;
#[cfg(test)]
mod tests;
mod text;
mod units;
mod value;
mod walk;
mod wishes;

use assur_mechanism::{Key, Mechanism};
use assur_words::{Text, text};

use context::Context;
use edit::ParsedText;
use error::{Fault, Faults};
use known::Known;
use linkage::SceneLinks;
use over_time::Timing;
use walk::Section;

pub use error::{SceneError, SceneErrors};
pub use note::{Chapter, Note};
pub use reading::{Reading, SceneNumber};
pub use sheet::{SHEET_FIELDS, Sheet, SheetField, SheetFormat, SheetPositions};
pub use text::{by_likeness, nearest};
pub use units::{Dimension, LEAST, Unit, UnitError, UnitFault, quantity};

assur_words::resources!();

/// A commented, complete scene as a start for a new one.
pub const STARTER: &str = include_str!("starter.toml");

/// Reads a scene. `file_name` appears only in errors.
///
/// # Errors
///
/// [`SceneErrors`] with every fault: those of the TOML syntax or, if it is correct, those of keys, kinds of values,
/// units, names and the scene as a whole.
///
/// # Examples
///
/// ```
/// let scene = "[ground]\npoints = { O = 0 }\n[link.arm]\npoints = { O = 0 }\nmass = '4 mm'\n[input]\nlink = 'arm'";
/// let errors = assur_scene::read("arm.toml", scene).unwrap_err();
/// assert_eq!((errors.errors[0].line, errors.errors[0].column), (5, 8));
/// assert_eq!(errors.errors[0].message.to_string(), "`mass` wants a mass (kg, g, t, lb, slug), got `mm`, a length");
/// assert!(assur_scene::read("arm.toml", &scene.replace("mm", "kg")).is_ok());
/// ```
pub fn read(file_name: &str, text: &str) -> Result<Mechanism, SceneErrors> {
    read_with_note(file_name, text).map(|(mechanism, _)| mechanism)
}

/// Reads a scene, and what it says about its explanatory note. `file_name` appears only in errors.
pub fn read_with_note(file_name: &str, text: &str) -> Result<(Mechanism, Note), SceneErrors> {
    read_as(file_name, text, Faults::default()).map(|reading| (reading.mechanism, reading.note))
}

/// Reads a scene with all that it tells: its mechanism, its note, its numbers. `file_name` appears only in errors.
pub fn reading(file_name: &str, text: &str) -> Result<Reading, SceneErrors> {
    read_as(file_name, text, Faults::telling())
}

fn read_as(file_name: &str, text: &str, faults: Faults) -> Result<Reading, SceneErrors> {
    let known = Known::Table(reference::table(""), None);
    document::read_known((file_name, text), text!("scene-a-scene"), known, faults, |root| {
        let (mechanism, note) = scene(root);
        let told = root.faults.told.as_ref().filter(|_| root.faults.is_empty());
        let numbers =
            told.map(|told| told.take().numbers(root.table(), mechanism.clone())).unwrap_or_default();
        Reading { mechanism, note, numbers }
    })
}

/// A fault that is found after reading, at the key that it concerns. Where the scene leaves a key out, the fault is at the table that
/// would have it; `None` if there is none either. `file_name` appears only in the error.
pub fn fault_at(file_name: &str, text: &str, key: &Key, message: Text) -> Option<SceneErrors> {
    let faults = Faults::default();
    faults.push(Fault::new(ParsedText::of(text).place(key)?, message));
    Some(faults.into_errors(file_name, text))
}

/// Builds the mechanism from parsed TOML. If faults were noted, the mechanism must not be used.
fn scene(root: &Section<'_>) -> (Mechanism, Note) {
    if limits::exceeded(root) {
        return (Mechanism::default(), note::read(root, None));
    }
    let title = root.title();
    let (mut linkage, firsts) = links::read(root);
    labels::of_points(root, &mut linkage);
    links::read_slides(root, &mut linkage, &firsts);
    // A point with a fault is at the origin until then.
    if root.faults.is_empty() {
        links::refuse_points(root, &linkage);
    }
    let timing = Timing::of(root);
    let input = input::read(root, &linkage, timing);
    let context = Context {
        linkage: &linkage,
        input: input.as_ref(),
        timing,
        loads: limits::loads(root),
        moves: root.get("motion").is_some(),
    };
    let motion = motion::read(root, &context);
    inertia::refuse_over_coordinate(root, &context);
    let note = note::read(root, input.as_ref().map(|input| input.positions));
    let mechanism = Mechanism {
        title,
        assembly: wishes::assembly(root, &linkage),
        gravity: loads::gravity(root),
        loads: loads::read(root, &context),
        frictions: friction::read(root, &context, motion.as_ref()),
        balance: wishes::balance(root, &context),
        drive: drive::read(root, motion.as_ref(), &context),
        motion,
        output: wishes::output(root, &linkage),
        ..Mechanism::default()
    };
    let input = input.unwrap_or_default();
    let SceneLinks { links, points, slides, has_units, .. } = linkage;
    let mut mechanism = Mechanism { links, points, slides, input, warnings: root.mistakes(), ..mechanism };
    if root.faults.is_empty() {
        inertia::refuse_impossible(root, &mechanism);
        let gives_inertia = |link: &str| {
            let key = Key::of("link").at(link).at("inertia");
            edit::within(root.table(), key.steps()).is_ok()
        };
        mechanism.warnings.extend(mistakes::of(&mechanism, has_units, gives_inertia));
    }
    (mechanism, note)
}
