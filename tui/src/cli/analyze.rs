//! `assur analyze`.

use std::path::Path;

use assur_analysis::Calculation;
use assur_analysis::results::{Check, Failure};
use assur_report::{csv, json};

use super::args::AnalyzeArgs;
use super::fault::{Fault, Status};
use super::options::Format;
use super::output::Output;
use super::style::Style;
use super::{plans, scene};
use crate::progress::ProgressLine;

/// Most failures that are printed in full; of the others only the numbers.
const MOST: usize = 3;

pub(crate) fn run(args: &AnalyzeArgs, style: Style) -> Result<Status, Fault> {
    if args.format == Format::Csv && args.output.is_none() {
        return Err(Fault::other("--format csv writes several files; name a folder with `-o FOLDER`"));
    }
    let scene = &args.checked.scene;
    let output = Output::of(args.output.as_deref(), &scene.scene)?;
    let study = scene::study(scene, style)?;
    args.plans.refuse(args.format, &study)?;
    let line = ProgressLine::new();
    let mut analysis = study.analyze(&mut line.watch()).map_err(Fault::other)?;
    analysis.checks = study.checks(args.checked.checks.into(), &mut line.watch()).map_err(Fault::other)?;
    drop(line);
    let added = args.plans.add(&study, scene, style, &mut analysis)?;
    if let Err(problem) = json::analysis::finite(&analysis) {
        style.tell(&format!("error: {problem}"));
        return Ok(Status::Failed);
    }
    let found = analysis.failures.is_empty() && analysis.no_motion.is_none();
    let status = if found { added } else { Status::Failed };
    let written = match args.format {
        Format::Json => {
            output.write(json::analysis::to_json(&analysis, style.ascii_data).map_err(Fault::other)?, status)
        }
        Format::Csv => {
            output.write_folder(&csv::to_csv(&analysis, style.ascii_data).map_err(Fault::other)?, status)
        }
        Format::Text => {
            let report = assur_report::text::report(&analysis, &study.linkage.mechanism, style.ascii);
            output.write(report.map_err(Fault::other)? + &plans::text(&analysis, style), status)
        }
    };
    for note in &analysis.notes {
        style.tell(&format!("note: {note}"));
    }
    tell_failures(&analysis.failures, style);
    tell_no_motion(&study, &scene.scene, style);
    tell_checks(&analysis.checks, style);
    written.map(|()| status)
}

/// Checks that fail, or that could check nothing, are reported on standard error.
pub(crate) fn tell_checks(checks: &[Check], style: Style) {
    for check in checks.iter().filter(|check| check.failed()) {
        style.tell(&format!("FAILED: {}: {}", check.name, check.reason));
    }
    for check in checks.iter().filter(|check| !check.failed() && !check.judged) {
        style.tell(&format!("not judged: {}: {}", check.name, check.why_left_out));
    }
}

/// A requested motion that is not found is reported on standard error.
pub(crate) fn tell_no_motion(study: &Calculation, path: &Path, style: Style) {
    if let Some(error) = &study.no_motion {
        style.tell(&scene::fault(path, error, style).to_string());
    }
}

/// Positions without a solution are reported on standard error, the first ones in full.
pub(crate) fn tell_failures(failures: &[Failure], style: Style) {
    for Failure { message, .. } in failures.iter().take(MOST) {
        style.tell(&format!("error: {message}"));
    }
    if failures.len() > MOST {
        let rest: Vec<_> = failures[MOST..].iter().map(|failure| failure.index.to_string()).collect();
        style.tell(&format!("error: no solution in {} more positions: {}", rest.len(), rest.join(", ")));
    }
}
