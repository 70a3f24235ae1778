//! Reading a scene file.

use std::fs;
use std::path::Path;

use assur_analysis::{Calculation, Options, unwatched};
use assur_mechanism::Mechanism;
use assur_scene::SceneErrors;
use assur_structure::{Structure, StructureError};

use super::args::{MethodArgs, SceneArgs};
use super::fault::Fault;
use super::style::Style;

/// Reads a scene file.
pub(crate) fn read(path: &Path, style: Style) -> Result<Mechanism, Fault> {
    let text = text_of(path)?;
    let name = path.display().to_string();
    let mechanism = assur_scene::read(&name, &text).map_err(|errors| faults(&errors, style))?;
    match Structure::of(&mechanism).err().and_then(|error| located(&name, &text, &error)) {
        Some(errors) => Err(faults(&errors, style)),
        None => Ok(mechanism),
    }
}

/// A fault of the structure at its line of the scene, where it concerns a link.
pub(crate) fn located(name: &str, text: &str, error: &StructureError) -> Option<SceneErrors> {
    assur_scene::fault_at_link(name, text, error.link()?, &error.to_string())
}

/// The faults of a scene, as they are printed.
pub(crate) fn faults(errors: &SceneErrors, style: Style) -> Fault {
    let text = errors.to_string();
    Fault::Scene(if style.ascii { keep_columns(&text) } else { text })
}

/// Reads and compiles a scene file.
pub(crate) fn study(args: &SceneArgs, style: Style) -> Result<Calculation, Fault> {
    let options = options(&args.methods)?;
    compiled(args, &options, read(&args.scene, style)?)
}

/// The same, as if the scene asked for everything.
pub(crate) fn whole_study(args: &SceneArgs, style: Style) -> Result<Calculation, Fault> {
    let options = options(&args.methods)?;
    let mechanism = read(&args.scene, style)?;
    compiled(args, &options, Mechanism { output: None, ..mechanism })
}

fn compiled(args: &SceneArgs, options: &Options, mechanism: Mechanism) -> Result<Calculation, Fault> {
    Calculation::of(mechanism, options, &mut unwatched)
        .map_err(|error| in_file(&args.scene, &error.to_string()))
}

/// The methods asked for, which must exist even where the scene has no use for them.
pub(crate) fn options(methods: &MethodArgs) -> Result<Options, Fault> {
    if let Some(name) = &methods.analyzer {
        assur_force::find(name).map_err(Fault::other)?;
    }
    if let Some(name) = methods.integrator.as_deref().filter(|name| *name != "auto") {
        assur_integrator::find(name).map_err(Fault::other)?;
    }
    Ok(Options { analyzer: methods.analyzer.clone(), integrator: methods.integrator.clone() })
}

/// A fault of the scene as a whole.
pub(crate) fn in_file(path: &Path, message: &str) -> Fault {
    Fault::Read { path: path.to_owned(), problem: message.to_owned() }
}

/// The text of a scene file.
pub(crate) fn text_of(path: &Path) -> Result<String, Fault> {
    let fault = |problem: String| Fault::Read { path: path.to_owned(), problem };
    if path.is_dir() {
        return Err(fault("is a folder, not a scene file".to_owned()));
    }
    let bytes = fs::read(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => {
            let offer = path.to_str().and_then(super::usage::nearest_command);
            let offer =
                offer.map_or_else(String::new, |name| format!("; did you mean the command `assur {name}`?"));
            fault(format!("there is no such file (`assur new FILE` writes a scene to begin with){offer}"))
        }
        _ => fault(format!("can't be read: {error}")),
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..at].split(|byte| *byte == b'\n').count();
        fault(format!("is not UTF-8 text (byte {at}, line {line}); save it as UTF-8"))
    })
}

/// ASCII with a question mark for each other character, so that marks stay below what they mark.
fn keep_columns(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect()
}
