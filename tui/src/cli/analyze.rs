//! `assur analyze`.

use assur_analysis::results::Failure;
use assur_report::{csv, json};

use super::args::{AnalyzeArgs, Format};
use super::fault::{Fault, Status};
use super::style::Style;
use super::{output, plans, scene};
use crate::files;
use crate::progress::ProgressLine;

/// Failures that are told in full.
const MOST: usize = 3;

pub(crate) fn run(args: &AnalyzeArgs, style: Style) -> Result<Status, Fault> {
    if args.format == Format::Csv && args.output.is_none() {
        return Err(Fault::other("--format csv writes several files; name a folder with `-o FOLDER`"));
    }
    let study = scene::study(&args.scene, style)?;
    args.plans.refuse(args.format, &study)?;
    let line = ProgressLine::new();
    let mut analysis = study.analyze(&mut line.watch()).map_err(Fault::other)?;
    analysis.checks = study.checks(&mut line.watch()).map_err(Fault::other)?;
    drop(line);
    let added = args.plans.add(&study, &args.scene, style, &mut analysis)?;
    if let Err(problem) = json::finite(&analysis) {
        style.tell(&format!("error: {problem}"));
        return Ok(Status::Failed);
    }
    let target = args.output.as_deref();
    match (args.format, target) {
        (Format::Json, _) => {
            let text = json::to_json(&analysis, style.ascii_data).map_err(Fault::other)?;
            output::print_or_write(&text, target)?;
        }
        (Format::Csv, Some(folder)) => {
            let files = csv::to_csv(&analysis, style.ascii_data).map_err(Fault::other)?;
            files::write_folder(folder, &files)?;
        }
        (Format::Text | Format::Csv, _) => {
            let report = assur_report::text::report(&analysis, &study.linkage.mechanism, style.ascii);
            let mut text = report.map_err(Fault::other)?;
            text += &plans::text(&analysis, style);
            output::print_or_write(&text, target)?;
        }
    }
    for note in &analysis.notes {
        style.tell(&format!("note: {note}"));
    }
    tell_failures(&analysis.failures, style);
    tell_no_motion(analysis.no_motion.as_deref(), style);
    let found = analysis.failures.is_empty() && analysis.no_motion.is_none();
    Ok(if found { added } else { Status::Failed })
}

/// The motion that was asked for and is not found goes to standard error.
pub(crate) fn tell_no_motion(no_motion: Option<&str>, style: Style) {
    if let Some(message) = no_motion {
        style.tell(&format!("error: {message}"));
    }
}

/// Positions without a solution go to standard error, the first ones in full.
pub(crate) fn tell_failures(failures: &[Failure], style: Style) {
    for Failure { message, .. } in failures.iter().take(MOST) {
        style.tell(&format!("error: {message}"));
    }
    if failures.len() > MOST {
        let rest: Vec<_> = failures[MOST..].iter().map(|failure| failure.index.to_string()).collect();
        style.tell(&format!("error: no solution in {} more positions: {}", rest.len(), rest.join(", ")));
    }
}
