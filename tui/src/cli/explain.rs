//! `assur explain`.

use assur_analysis::plan::Plan;
use assur_analysis::{method_of_motion, methods};
use assur_structure::Structure;
use assur_words::{Describe, number, text};
use assur_working::WorkingError;

use super::args::ExplainArgs;
use super::fault::{Fault, Status};
use super::style::Style;
use super::{output, scene};
use crate::verdict::Verdict;
use crate::working;

pub(crate) fn run(args: &ExplainArgs, style: Style) -> Result<Status, Fault> {
    let options = scene::options(&args.scene.methods)?;
    if let Some(position) = args.position {
        return working(args, position, style);
    }
    let mechanism = scene::read(&args.scene.scene)?;
    let path = &args.scene.scene;
    let fault = |error: &dyn Describe| scene::in_file(path, error.describe());
    let structure = Structure::of(&mechanism).map_err(|error| fault(&error))?;
    let methods = methods(&mechanism, &options);
    let plan = Plan::of(&mechanism, &structure, methods.by_groups);
    let equation = method_of_motion(&mechanism, structure.clone(), &options)
        .map_err(|error| scene::fault(path, &error))?;
    let words = style.words();
    let text = assur_report::text::explain(&mechanism, &structure, &plan, &methods, equation.as_ref(), words);
    output::print(&text)?;
    Ok(Status::Done)
}

/// Every equation of one position, or of one sample of a transient motion, with its numbers.
fn working(args: &ExplainArgs, index: usize, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let fault = |error: &dyn Describe| scene::in_file(path, error.describe());
    let study = scene::whole_study(&args.scene, style)?;
    let verdict = Verdict::of_motion(&study, &path.as_path());
    verdict.tell(style);
    let worked = match study.sample(index) {
        (Some(state), _) => working::of_sample(&study, index, state),
        (None, 0) => working::of_position(&study, index),
        (None, count) => {
            let [sample, last] = [index, count - 1].map(number);
            return Err(scene::in_file(path, text!("cli-no-sample", sample = sample, last = last)));
        }
    };
    match worked {
        Ok(working) => {
            output::print(&style.text(&working.text(style.language)))?;
            Ok(verdict.status())
        }
        Err(error @ WorkingError::Position(_)) => {
            style.tell(fault(&error).describe());
            Ok(Status::Failed)
        }
        Err(error @ WorkingError::Load { .. }) => {
            let key = error.key(&study.linkage.mechanism);
            let located = key.and_then(|key| scene::at_key(path, &key, error.describe()));
            style.tell(located.unwrap_or_else(|| fault(&error)).describe());
            Ok(Status::Failed)
        }
        Err(error) => Err(fault(&error)),
    }
}
