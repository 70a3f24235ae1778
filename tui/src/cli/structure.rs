//! `assur structure`.

use std::path::PathBuf;

use assur_analysis::StructureStudy;
use assur_kinematics::decompose;
use assur_report::{json, text as report};
use assur_words::Describe;
use clap::{Args, ValueEnum};

use super::fault::{Fault, Status};
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::session::{Source, mechanism_of};
use crate::verdict::Verdict;

/// Arguments of `structure`.
#[derive(Debug, Clone, Args)]
pub(crate) struct StructureArgs {
    /// Scene file
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

pub(crate) fn run(args: &StructureArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.scene)?;
    let (study, status) = study(args, style)?;
    let text = match args.format {
        Form::Text => report::structure(&study, style.words()).map_err(Fault::told)?,
        Form::Json => json::to_json(&study, style.ascii).map_err(Fault::told)?,
    };
    output.write(text, status).map(|()| status)
}

/// The structure of the scene, and how the command ends: 1 where no input gives a mechanism.
fn study(args: &StructureArgs, style: Style) -> Result<(StructureStudy, Status), Fault> {
    let mechanism = mechanism_of(&Source::File(args.scene.clone())).map_err(Fault::Scene)?;
    let (mut study, linkage, fault) = match scene::open(&args.scene, style) {
        Ok(session) => {
            let linkage = scene::linkage(&session)?;
            let mut study = StructureStudy::of(&linkage);
            if args.modes {
                study.add_modes(&linkage);
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
