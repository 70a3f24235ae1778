//! `assur stability`.

use std::ops::ControlFlow;

use assur_study::stability::stability;
use assur_words::{Describe, text};

use super::args::StabilityArgs;
use super::fault::{Fault, Status};
use super::options::Format;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::progress::ProgressLine;
use crate::verdict::Verdict;

pub(crate) fn run(args: &StabilityArgs, style: Style) -> Result<Status, Fault> {
    let path = &args.scene;
    let output = Output::of(args.output.as_deref(), path)?;
    let session = scene::open(path, style)?;
    let linkage = scene::linkage(&session)?;
    let verdict = Verdict::of_positions(&linkage, &session);
    verdict.tell(style);
    let line = ProgressLine::new(style.language);
    let found = stability(session.mechanism.clone(), &mut |done, total| {
        line.count(&text!("progress-step"), done, total);
        ControlFlow::Continue(())
    });
    drop(line);
    let ControlFlow::Continue(found) = found else { return Err(Fault::Other(text!("cli-study-stopped"))) };
    let found = found.map_err(|error| Fault::Scene(session.in_file(error.describe())))?;
    let text = match args.format {
        Format::Json => found.to_json().map_err(Fault::other)?,
        Format::Csv => found.to_csv().map_err(Fault::told)?,
        Format::Text => style.text(&found.text(style.language)).into_owned(),
    };
    if let Some(failure) = &found.failure {
        style.tell(text!("cli-error", problem = failure));
    }
    let status = verdict.status().or(if found.is_ok() { Status::Done } else { Status::Failed });
    output.write(text, status).map(|()| status)
}
