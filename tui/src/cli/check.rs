//! `assur check`.

use assur_report::{text, topic};

use super::fault::{Fault, Status};
use super::options::CheckedArgs;
use super::style::Style;
use super::{output, scene};
use crate::progress::ProgressLine;
use crate::verdict::Verdict;

pub(crate) fn run(args: &CheckedArgs, style: Style) -> Result<Status, Fault> {
    // The whole mechanism is checked, whatever results the scene requests.
    let options = args.options(true)?;
    let session = scene::open(&args.scene.scene, style)?;
    let study = scene::calculation(&session, &options, style)?;
    let line = ProgressLine::new(style.language);
    let mut analysis = study.analyze(&mut line.watch()).map_err(Fault::told)?;
    let checks = study.checks(args.checks.into(), &mut line.watch()).map_err(Fault::told)?;
    drop(line);
    analysis.add_checks(checks);
    output::print(&text::told(style.words(), |page| topic::checks(&analysis.checks, page)))?;
    let verdict = Verdict::of(&analysis, &study, Some(&session));
    verdict.tell(style);
    Ok(verdict.proved())
}
