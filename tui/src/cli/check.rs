//! `assur check`.

use assur_report::text;

use super::fault::{Fault, Status};
use super::options::CheckedArgs;
use super::style::Style;
use super::{output, scene};
use crate::progress::ProgressLine;
use crate::verdict::Verdict;

pub(crate) fn run(args: &CheckedArgs, style: Style) -> Result<Status, Fault> {
    // The whole mechanism is checked, whatever results the scene requests.
    let study = scene::whole_study(&args.scene, style)?;
    let line = ProgressLine::new(style.language);
    let mut analysis = study.analyze(&mut line.watch()).map_err(Fault::told)?;
    let checks = study.checks(args.checks.into(), &mut line.watch()).map_err(Fault::told)?;
    drop(line);
    analysis.add_checks(checks);
    output::print(&text::checks(&analysis.checks, style.words()))?;
    let verdict = Verdict::of(&analysis, &study, &args.scene.scene.as_path());
    verdict.tell(style);
    Ok(verdict.proved())
}
