//! `assur check`.

use assur_analysis::results::Check;
use assur_report::text;

use super::fault::{Fault, Status};
use super::options::CheckedArgs;
use super::style::Style;
use super::{analyze, output, scene};
use crate::progress::ProgressLine;

pub(crate) fn run(args: &CheckedArgs, style: Style) -> Result<Status, Fault> {
    // The whole mechanism is checked, whatever results the scene requests.
    let study = scene::whole_study(&args.scene, style)?;
    let checks = study.checks(args.checks.into(), &mut ProgressLine::new().watch());
    let checks = checks.map_err(Fault::other)?.all;
    output::print(&text::checks(&checks, style.ascii))?;
    analyze::tell_checks(&checks, style);
    let judged = checks.is_empty() || checks.iter().any(|check| check.judged);
    if !judged {
        style.tell("not judged: no check could judge any position, so that nothing is proved");
    }
    let (failures, count) = study.failures();
    analyze::tell_failures(&failures, count, style);
    analyze::tell_no_motion(&study, &args.scene.scene, style);
    let holds =
        failures.is_empty() && study.no_motion.is_none() && judged && !checks.iter().any(Check::failed);
    Ok(if holds { Status::Done } else { Status::Failed })
}
