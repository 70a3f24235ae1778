//! Scenes and methods of a command, and how it ends.

use std::path::Path;
use std::sync::Arc;

use assur_analysis::{Calculation, Options};
use assur_kinematics::Linkage;
use assur_mechanism::Warning;
use assur_words::{Text, joined, text};

use super::fault::{Fault, Status};
use super::options::{CheckedArgs, MethodArgs};
use super::style::Style;
use crate::progress::ProgressLine;
use crate::session::{Session, Source};
use crate::verdict::Verdict;

/// Reads a scene file. What is probably not meant in it is reported, as far as reading finds it; where that is an error, it is not read.
pub(crate) fn open(path: &Path, style: Style) -> Result<Session, Fault> {
    let session = read(path)?;
    warn(&session, &session.mechanism.warnings, style)?;
    Ok(session)
}

/// Reads a scene file, and reports nothing.
pub(crate) fn read(path: &Path) -> Result<Session, Fault> {
    Session::open(Source::File(path.to_owned())).map_err(Fault::Scene)
}

/// The calculation of a scene. What the motion shows to be probably not meant is reported; where that is an error, there is no calculation.
pub(crate) fn calculation(session: &Session, options: &Options, style: Style) -> Result<Calculation, Fault> {
    let found = calculated(session, options, style)?;
    warn_of_motion(session, &found, style)?;
    Ok(found)
}

/// The calculation of a scene, beside one that reported what is probably not meant in it.
pub(crate) fn calculated(session: &Session, options: &Options, style: Style) -> Result<Calculation, Fault> {
    let line = ProgressLine::new(style.language);
    session.calculation(options, &mut line.watch()).map_err(|error| Fault::Scene(session.fault(&error)))
}

/// Tells what the motion of a scene shows to be probably not meant, or refuses it where that is an error.
pub(crate) fn warn_of_motion(session: &Session, found: &Calculation, style: Style) -> Result<(), Fault> {
    warn(session, &found.mistakes(), style)
}

/// Tells what is probably not meant in a scene, or refuses it where that is an error.
fn warn(session: &Session, warnings: &[Warning], style: Style) -> Result<(), Fault> {
    mistakes(session, warnings, style)?.into_iter().for_each(|one| style.tell(one));
    Ok(())
}

/// What is probably not meant in a scene, with its places there. Where that is an error, the scene is refused.
pub(crate) fn mistakes(session: &Session, warnings: &[Warning], style: Style) -> Result<Vec<Text>, Fault> {
    let all: Vec<_> = warnings.iter().map(|one| session.placed(one)).collect();
    refuse_strictly(&all, style)?;
    Ok(all)
}

/// Tells what is probably not meant, or refuses it where that is an error.
pub(super) fn tell_all(told: Vec<Text>, style: Style) -> Result<(), Fault> {
    refuse_strictly(&told, style)?;
    for one in told {
        style.tell(one);
    }
    Ok(())
}

/// Refuses what is probably not meant where that is an error.
fn refuse_strictly(told: &[Text], style: Style) -> Result<(), Fault> {
    if style.strict && !told.is_empty() {
        return Err(Fault::Scene(text!("cli-strict", notes = joined("\n", told.iter().cloned()))));
    }
    Ok(())
}

/// The mechanism of a scene, for a command that needs neither loads nor motion.
pub(crate) fn linkage(session: &Session) -> Result<Arc<Linkage>, Fault> {
    session.linkage().map_err(|error| Fault::Scene(session.fault(&error.into())))
}

/// Calculates the results of a scene, for a command that gives others: what they lack, those lack too.
pub(crate) fn verdict(session: &Session, calculation: &Calculation, style: Style) -> Result<Verdict, Fault> {
    let analysis =
        calculation.analyze(&mut ProgressLine::new(style.language).watch()).map_err(Fault::told)?;
    Ok(Verdict::of(&analysis, calculation, Some(session)))
}

/// The requested methods, which must exist even if the scene does not use them; for all results, or what the scene requests.
pub(crate) fn options(methods: &MethodArgs, whole: bool) -> Result<Options, Fault> {
    if let Some(method) = &methods.analyzer {
        assur_force::find(method).map_err(Fault::told)?;
    }
    if let Some(method) = methods.integrator.as_deref().filter(|method| *method != "auto") {
        assur_integrator::find(method).map_err(Fault::told)?;
    }
    Ok(Options { whole, ..methods.clone().into() })
}

impl CheckedArgs {
    /// The requested methods, as [`options`], and how undetermined reactions are given.
    pub(crate) fn options(&self, whole: bool) -> Result<Options, Fault> {
        let least_norm = self.indeterminate.is_some();
        Ok(Options { least_norm, ..options(&self.scene.methods, whole)? })
    }
}

/// How a command that calculates a scene ends, and what is reported on standard error.
impl Verdict {
    /// The exit status of a command that gives results: 1 where some of them are missing.
    pub(crate) fn status(&self) -> Status {
        if self.is_complete() { Status::Done } else { Status::Failed }
    }

    /// The exit status of a command that vouches for the results: 1 also where a check fails.
    pub(crate) fn proved(&self) -> Status {
        if self.is_proved() { Status::Done } else { Status::Failed }
    }

    /// Tells everything on standard error, what is missing first.
    pub(crate) fn tell(&self, style: Style) {
        self.messages().for_each(|message| style.tell(message));
    }
}
