//! Reading a scene file.

use std::path::Path;

use assur_analysis::{AnalysisError, Calculation, Options};
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;
use assur_scene::SceneErrors;
use assur_structure::Structure;
use assur_words::{Describe, Text, name};

use super::fault::Fault;
use super::options::{MethodArgs, SceneArgs};
use super::style::Style;
use crate::files::{self, FileError};
use crate::progress::ProgressLine;
use crate::screen::state::State;
use crate::verdict::Verdict;

/// Reads a scene file.
pub(crate) fn read(path: &Path) -> Result<Mechanism, Fault> {
    let text = files::read(path)?;
    let file = path.display().to_string();
    let mechanism = assur_scene::read(&file, &text).map_err(|errors| faults(&errors))?;
    let structure =
        || Structure::of(&mechanism).err().and_then(|error| files::located(&file, &text, &error.into()));
    match files::integrator_fault(&file, &text, &mechanism).or_else(structure) {
        Some(errors) => Err(faults(&errors)),
        None => Ok(mechanism),
    }
}

/// The errors of a scene.
pub(crate) fn faults(errors: &SceneErrors) -> Fault {
    Fault::Scene(name(errors.to_string()))
}

/// Reads and compiles a scene file.
pub(crate) fn study(args: &SceneArgs, style: Style) -> Result<Calculation, Fault> {
    let options = options(&args.methods)?;
    compiled(args, &options, read(&args.scene)?, style)
}

/// Reads and compiles a scene file, as if the scene requested all results.
pub(crate) fn whole_study(args: &SceneArgs, style: Style) -> Result<Calculation, Fault> {
    let options = options(&args.methods)?;
    let mechanism = read(&args.scene)?;
    compiled(args, &options, Mechanism { output: None, ..mechanism }, style)
}

fn compiled(
    args: &SceneArgs,
    options: &Options,
    mechanism: Mechanism,
    style: Style,
) -> Result<Calculation, Fault> {
    Calculation::of(mechanism, options, &mut ProgressLine::new(style.language).watch())
        .map_err(|error| fault(&args.scene, &error))
}

/// An error of a calculation, at the key of the scene that it concerns if there is one.
pub(crate) fn fault(path: &Path, error: &AnalysisError) -> Fault {
    let located = || {
        let mechanism = assur_scene::read(&path.display().to_string(), &files::read(path).ok()?).ok()?;
        at_key(path, &error.key(&mechanism)?, &error.to_string())
    };
    located().unwrap_or_else(|| in_file(path, error.describe()))
}

/// A fault that is found while calculating, at a key of the scene; `None` if the scene has no such key.
pub(crate) fn at_key(path: &Path, key: &[String], message: &str) -> Option<Fault> {
    let text = files::read(path).ok()?;
    let steps: Vec<&str> = key.iter().map(String::as_str).collect();
    let errors = assur_scene::fault_at(&path.display().to_string(), &text, &steps, message)?;
    Some(faults(&errors))
}

/// Calculates the results of a scene, for a command that gives others: what they lack, those lack too.
pub(crate) fn verdict(calculation: &Calculation, path: &Path, style: Style) -> Result<Verdict, Fault> {
    let analysis =
        calculation.analyze(&mut ProgressLine::new(style.language).watch()).map_err(Fault::told)?;
    Ok(Verdict::of(&analysis, calculation, &path))
}

/// What the results lack that the views and the note are made of.
pub(crate) fn verdict_of(state: &State, args: &SceneArgs, style: Style) -> Result<Verdict, Fault> {
    if let Some(found) = state.found() {
        return Ok(Verdict::of(&found.analysis, found.plans.calculation(), &args.scene.as_path()));
    }
    // The same calculation, which says why there is none, and where.
    verdict(&study(args, style)?, &args.scene, style)
}

/// Reads a scene file and compiles its mechanism, for a command that needs neither loads nor motion.
pub(crate) fn linkage(path: &Path) -> Result<Linkage, Fault> {
    Linkage::compile(read(path)?).map_err(|error| fault(path, &error.into()))
}

/// The requested methods, which must exist even if the scene does not use them.
pub(crate) fn options(methods: &MethodArgs) -> Result<Options, Fault> {
    if let Some(method) = &methods.analyzer {
        assur_force::find(method).map_err(Fault::told)?;
    }
    if let Some(method) = methods.integrator.as_deref().filter(|method| *method != "auto") {
        assur_integrator::find(method).map_err(Fault::told)?;
    }
    Ok(Options { analyzer: methods.analyzer.clone(), integrator: methods.integrator.clone() })
}

/// An error of the scene as a whole.
pub(crate) fn in_file(path: &Path, message: Text) -> Fault {
    FileError::read(path, message).into()
}
