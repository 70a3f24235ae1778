//! Reads scene files: TOML with units becomes a [`Mechanism`], or a list of all faults with their lines.
//!
//! The entry point is [`read`], a pure function from text to mechanism. Nothing here opens a file or prints. After a
//! fault the reader continues, so that one run shows all that is wrong; see [`SceneErrors`].

mod context;
pub mod document;
mod doubts;
mod drive;
pub mod edit;
mod error;
mod friction;
mod inertia;
mod input;
mod joints;
mod limits;
mod linkage;
mod links;
mod loads;
mod motion;
mod numbers;
pub mod reference;
mod render;
mod scan;
#[cfg(test)]
mod tests;
mod text;
mod units;
mod value;
mod walk;
mod wishes;

use assur_mechanism::Mechanism;
use assur_words::{Text, text};
use toml::de::DeValue;

use context::Context;
use error::{Fault, Faults};
use linkage::SceneLinks;
use walk::{Known, Section};

pub use error::{SceneError, SceneErrors};
pub use units::{Dimension, LEAST, Unit, UnitError, UnitFault, quantity};
pub use wishes::Note;

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
/// assert_eq!(errors.errors[0].message.to_string(), "`mass` wants a mass (kg, g, t, lb), got `mm`, a length");
/// assert!(assur_scene::read("arm.toml", &scene.replace("mm", "kg")).is_ok());
/// ```
pub fn read(file_name: &str, text: &str) -> Result<Mechanism, SceneErrors> {
    read_with_note(file_name, text).map(|(mechanism, _)| mechanism)
}

/// Reads a scene, and what it says about its explanatory note. `file_name` appears only in errors.
///
/// # Errors
///
/// Those of [`read`].
pub fn read_with_note(file_name: &str, text: &str) -> Result<(Mechanism, Note), SceneErrors> {
    let known = Known::Table(reference::table(""), None);
    document::read_known(file_name, text, text!("scene-a-scene"), known, scene)
}

/// A fault that is found after reading, at the key that it concerns: `["link", "crank"]`, `["force", "0", "value"]`; an
/// element of a list is given by its number, from 0. Where the scene leaves a key out, the fault is at the table that would
/// have it; `None` if there is none either. `file_name` appears only in the error.
pub fn fault_at(file_name: &str, text: &str, path: &[&str], message: Text) -> Option<SceneErrors> {
    let document = document::recovered(text);
    let (first, rest) = path.split_first()?;
    let (key, mut value) = document.get_ref().get_key_value(*first)?;
    let mut span = key.span();
    for step in rest {
        let next = match value.get_ref() {
            DeValue::Table(table) => table.get_key_value(*step).map(|(key, value)| (key.span(), value)),
            DeValue::Array(array) => {
                step.parse().ok().and_then(|index: usize| array.get(index)).map(|value| (value.span(), value))
            }
            _ => None,
        };
        let Some(next) = next else { break };
        (span, value) = next;
    }
    let faults = Faults::default();
    faults.push(Fault::new(span, message));
    Some(faults.into_errors(file_name, text))
}

/// Builds the mechanism from parsed TOML. If faults were noted, the mechanism must not be used.
fn scene(root: &Section<'_>) -> (Mechanism, Note) {
    if limits::exceeded(root) {
        return (Mechanism::default(), wishes::read(root, None));
    }
    let title = root.get("title").and_then(|entry| {
        let title = entry.line()?;
        limits::check_name(&entry, &entry.span, &title);
        Some(title)
    });
    let title = title.unwrap_or_default();
    let (mut linkage, firsts) = links::read(root);
    links::read_slides(root, &mut linkage, &firsts);
    // A point with a fault is at the origin until then.
    if root.faults.is_empty() {
        links::refuse_points(root, &linkage);
    }
    let input = input::read(root, &linkage);
    let context = Context {
        linkage: &linkage,
        input: input.as_ref(),
        loads: limits::loads(root),
        moves: root.get("motion").is_some(),
    };
    let motion = motion::read(root, &context);
    let note = wishes::read(root, input.as_ref().map(|input| input.positions));
    let mechanism = Mechanism {
        title,
        assembly: wishes::assembly(root, &linkage),
        gravity: loads::gravity(root),
        loads: loads::read(root, &context),
        frictions: friction::read(root, &linkage, motion.as_ref()),
        balance: wishes::balance(root, &linkage),
        drive: drive::read(root, motion.as_ref(), &context),
        motion,
        output: wishes::output(root, &linkage),
        ..Mechanism::default()
    };
    let input = input.unwrap_or_default();
    let SceneLinks { links, points, slides, .. } = linkage;
    let mut mechanism = Mechanism { links, points, slides, input, notes: root.mistakes(), ..mechanism };
    if root.faults.is_empty() {
        inertia::refuse_not_positive(root, &mechanism);
        let gives_inertia = |link: &str| links::gives_inertia(root, link);
        mechanism.notes.extend(doubts::of(&mechanism, links::have_units(root), gives_inertia));
    }
    (mechanism, note)
}
