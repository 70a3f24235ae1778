//! `assur structure`, `assur geometry`, `assur shaking`, `assur stability`: what is studied of a mechanism.

use std::ops::ControlFlow;
use std::path::PathBuf;

use assur_analysis::StructureStudy;
use assur_kinematics::decompose;
use assur_mechanism::GROUND;
use assur_report::{csv, json, text as report, topic};
use assur_study::stability;
use assur_words::{self as words, Describe, text};
use clap::{Args, ValueEnum};

use super::fault::{Fault, Status};
use super::options::{Format, SceneArgs};
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::progress::ProgressLine;
use crate::session::{Source, mechanism_of};
use crate::verdict::Verdict;

#[derive(Debug, Clone, Args)]
pub(crate) struct StructureArgs {
    /// Scene file; `-` is standard input
    scene: PathBuf,
    /// Formula and class with each link as the input that is pinned to the ground or slides on it
    #[arg(long)]
    all_inputs: bool,
    /// All modes of every group over the cycle: where they are born, meet and end, circuits and branches
    #[arg(long)]
    modes: bool,
    /// Form of the results
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Form of the structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Form {
    /// Tables to read
    Text,
    /// One JSON object, SI units, all digits
    Json,
}

/// A scene that is studied, and the form and the file of the results.
#[derive(Debug, Clone, Args)]
pub(crate) struct StudyArgs {
    /// Scene file; `-` is standard input
    scene: PathBuf,
    /// Form of the results; csv: their table alone
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Debug, Clone, Args)]
pub(crate) struct GeometryArgs {
    /// Link from which centers and centrodes are seen [default: the ground]
    #[arg(long, value_name = "LINK")]
    against: Option<String>,
    #[command(flatten)]
    study: StudyArgs,
}

#[derive(Debug, Clone, Args)]
pub(crate) struct ShakingArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Form of the results; csv: the table over the positions
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(crate) fn structure(args: &StructureArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.scene)?;
    let (study, status) = structure_of(args, style)?;
    let text = match args.format {
        Form::Text => report::page(&study, style.words(), topic::structure_study).map_err(Fault::told)?,
        Form::Json => json::to_json(&study, style.ascii_data).map_err(Fault::told)?,
    };
    output.write(text, status)
}

/// The structure of the scene, and how the command ends: 1 where no input gives a mechanism.
fn structure_of(args: &StructureArgs, style: Style) -> Result<(StructureStudy, Status), Fault> {
    let mechanism = mechanism_of(&Source::File(args.scene.clone())).map_err(Fault::Scene)?;
    let (mut study, linkage, fault) = match scene::open(&args.scene, style) {
        Ok(session) => {
            let linkage = scene::linkage(&session)?;
            let mut study = StructureStudy::of(&linkage);
            if args.modes {
                study.modes = assur_analysis::modes(&linkage);
            }
            (study, Some(linkage), None)
        }
        Err(fault) => match decompose(&mechanism) {
            Ok(_) => return Err(fault),
            Err(error) => (StructureStudy::without(&mechanism, &error), None, Some(fault)),
        },
    };
    if args.all_inputs || fault.is_some() {
        study.add_inputs(&mechanism, linkage.as_deref());
    }
    let Some(fault) = fault else {
        let verdict = Verdict::of_structure(&study);
        verdict.tell(style);
        return Ok((study, verdict.status()));
    };
    let any = study.inputs.iter().any(|input| input.class.is_some());
    if any && !args.all_inputs {
        return Err(fault);
    }
    style.tell(fault.describe());
    Ok((study, if any { Status::Done } else { Status::Failed }))
}

pub(crate) fn geometry(
    GeometryArgs { against, study: args }: &GeometryArgs,
    style: Style,
) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.scene)?;
    let session = scene::open(&args.scene, style)?;
    let linkage = scene::linkage(&session)?;
    let against = match against {
        None => GROUND,
        Some(name) => linkage.mechanism.link(name).ok_or_else(|| {
            let links = words::list(linkage.mechanism.links.iter().map(|link| (&link.name).into()));
            Fault::Other(text!("cli-no-such-link", link = words::name(name.clone()), links))
        })?,
    };
    let verdict = Verdict::of_positions(&linkage, &session);
    verdict.tell(style);
    let found = match assur_geometry::geometry(&linkage, against) {
        Ok(found) => found,
        Err(error) => {
            style.tell(session.in_file(error.describe()));
            return Ok(Status::Failed);
        }
    };
    let text = match args.format {
        Format::Text => report::page(&found, style.words(), topic::geometry).map_err(Fault::told)?,
        Format::Json => json::to_json(&found, style.ascii_data).map_err(Fault::told)?,
        Format::Csv => csv::geometry(&found, style.ascii_data).map_err(Fault::told)?,
    };
    output.write(text, verdict.status())
}

pub(crate) fn shaking(args: &ShakingArgs, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let output = Output::of(args.output.as_deref(), path)?;
    let options = scene::options(&args.scene.methods, true)?;
    let session = scene::open(path, style)?;
    let calculation = scene::calculation(&session, &options, style)?;
    let verdict = scene::verdict(&session, &calculation, style)?;
    verdict.tell(style);
    if calculation.no_motion.is_some() {
        return Ok(verdict.status());
    }
    let found = match assur_shaking::shaking(&calculation.linkage, &|q| calculation.state(q)) {
        Ok(found) => found,
        Err(error) => {
            let fault = session.fault_at(error.key(&session.mechanism), error.describe());
            if !error.is_no_solution() {
                return Err(Fault::Scene(fault));
            }
            style.tell(fault);
            return Ok(Status::Failed);
        }
    };
    let text = match args.format {
        Format::Text => report::page(&found, style.words(), topic::shaking).map_err(Fault::told)?,
        Format::Json => json::to_json(&found, style.ascii_data).map_err(Fault::told)?,
        Format::Csv => csv::shaking(&found, style.ascii_data).map_err(Fault::told)?,
    };
    output.write(text, verdict.status())
}

pub(crate) fn stability(args: &StudyArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.scene)?;
    let session = scene::open(&args.scene, style)?;
    let linkage = scene::linkage(&session)?;
    let verdict = Verdict::of_positions(&linkage, &session);
    verdict.tell(style);
    let line = ProgressLine::new(style.language);
    let found = stability::stability(session.mechanism.clone(), &mut |done, total| {
        line.count(&text!("progress-step"), done, total);
        ControlFlow::Continue(())
    });
    drop(line);
    let ControlFlow::Continue(found) = found else { return Err(Fault::Other(text!("cli-study-stopped"))) };
    let found = found.map_err(|error| Fault::Scene(session.in_file(error.describe())))?;
    let text = match args.format {
        Format::Json => json::to_json(&found, style.ascii_data).map_err(Fault::told)?,
        Format::Csv => found.to_csv().map_err(Fault::told)?,
        Format::Text => report::told(style.words(), |page| found.tell(page)),
    };
    if let Some(failure) = &found.failure {
        style.tell(text!("cli-error", problem = failure));
    }
    let status = verdict.status().or(if found.is_ok() { Status::Done } else { Status::Failed });
    output.write(text, status)
}
