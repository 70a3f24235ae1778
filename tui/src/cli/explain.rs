//! `assur explain`.

use assur_analysis::{Options, method_of_motion, methods, plan};
use assur_note::working;
use assur_words::{Describe, number, text};
use assur_working::WorkingError;

use super::args::ExplainArgs;
use super::fault::{Fault, Status};
use super::style::Style;
use super::{output, scene};
use crate::progress::ProgressLine;
use crate::session::Session;
use crate::verdict::Verdict;

pub(crate) fn run(args: &ExplainArgs, style: Style) -> Result<Status, Fault> {
    let options = scene::options(&args.scene.methods, args.position.is_some() || args.energy)?;
    let session = scene::open(&args.scene.scene, style)?;
    if let Some(position) = args.position {
        return working(&session, &options, position, style);
    }
    if args.energy {
        return energy(&session, &options, style);
    }
    let Session { mechanism, structure, .. } = &session;
    let (methods, plan) = (methods(mechanism, structure, &options), plan(mechanism, structure, &options));
    let equation = if mechanism.has_equation_of_motion() {
        let linkage = scene::linkage(&session)?;
        method_of_motion(&linkage, &options).map_err(|error| Fault::Scene(session.fault(&error)))?
    } else {
        None
    };
    let words = style.words();
    let text = assur_report::text::told(words, |page| {
        assur_report::topic::explain(mechanism, structure, &plan, &methods, equation.as_ref(), page);
    });
    output::print(&text)?;
    Ok(Status::Done)
}

fn energy(session: &Session, options: &Options, style: Style) -> Result<Status, Fault> {
    let study = scene::calculation(session, options, style)?;
    let analysis = study.analyze(&mut ProgressLine::new(style.language).watch()).map_err(Fault::told)?;
    let verdict = Verdict::of_motion(&study, session);
    verdict.tell(style);
    let sections = working::energy(&analysis, &study.linkage.mechanism);
    if sections.is_empty() {
        return Err(Fault::Scene(session.in_file(text!("cli-no-energy-form"))));
    }
    let told = assur_worksheet::text(&sections, assur_worksheet::WIDTH, style.language);
    output::print(&style.text(&told))?;
    Ok(verdict.status())
}

/// Every equation of one position, or of one sample of a transient motion, with its numbers.
fn working(session: &Session, options: &Options, index: usize, style: Style) -> Result<Status, Fault> {
    let study = scene::calculation(session, options, style)?;
    let verdict = Verdict::of_motion(&study, session);
    verdict.tell(style);
    if let (None, count @ 1..) = study.sample(index) {
        let [sample, last] = [index, count - 1].map(number);
        let problem = text!("cli-no-sample", sample, last);
        return Err(Fault::Scene(session.in_file(problem)));
    }
    match working::of_position(&study, index) {
        Ok(working) => {
            let note = text!("cli-working-in-note", position = number(index)).render(style.language);
            output::print(&style.text(&(working.text(style.language) + "\n" + &note + "\n")))?;
            Ok(verdict.status())
        }
        Err(error @ (WorkingError::Position(_) | WorkingError::Load { .. })) => {
            style.tell(session.fault_at(error.key(&session.mechanism), error.describe()));
            Ok(Status::Failed)
        }
        Err(error) => Err(Fault::Scene(session.in_file(error.describe()))),
    }
}
