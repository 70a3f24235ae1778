//! The analysis of the open scene: asked for, taken, and which views it fills.

use super::found::Found;
use super::state::{Pane, State, View, Wish};
use super::text::fill;
use super::theme::Role;
use super::work::{Job, Request};

impl State {
    /// Asks for the analysis of the open scene; `other`: by [`State::analyzer`]'s successor, for the difference.
    pub(crate) fn analyze(&mut self, other: bool) {
        let Some(study) = &self.study else { return };
        let request = Request {
            generation: self.generation,
            linkage: study.linkage.clone(),
            analyzer: self.analyzer.clone(),
            integrator: self.integrator.clone(),
            other,
        };
        self.wishes.push(Wish::Work(Job::Analyze(request)));
    }

    /// Takes an analysis, unless it belongs to a scene opened before; tells whether the frame may differ.
    pub(crate) fn take_found(
        &mut self,
        generation: usize,
        other: bool,
        found: Result<Box<Found>, String>,
    ) -> bool {
        let texts = self.texts;
        let Some(study) = self.study.as_mut().filter(|_| generation == self.generation) else { return false };
        match found {
            Ok(found) if other => study.other = Some(found),
            Ok(found) => {
                study.found = Some(found);
                study.fault = None;
            }
            Err(text) => {
                study.fault.get_or_insert_with(|| text.clone());
                self.say(Role::Bad, fill(texts.no_analysis, &[&text]));
            }
        }
        true
    }

    /// Whether a view has something to show.
    pub(crate) fn has(&self, view: View) -> bool {
        let found = self.study.as_ref().and_then(|study| study.found.as_ref());
        match view {
            View::Menu => true,
            View::Mechanism | View::Curves | View::Accuracy | View::Structure | View::Table => {
                self.study.is_some()
            }
            View::Forces | View::Plans => found.is_some_and(|found| found.has_forces()),
            View::Motion => {
                found.is_some_and(|found| !found.motion.is_empty() || !found.analysis.trajectory.is_empty())
            }
            View::Drive => found.is_some_and(|found| found.analysis.dynamics.is_some()),
            View::Checks => found.is_some_and(|found| !found.checks.is_empty()),
        }
    }

    /// Goes to a view, or says that this scene has nothing for it.
    pub(crate) fn show(&mut self, view: View) {
        if self.has(view) {
            self.view = view;
            if view != View::Forces && self.pane == Pane::Causes {
                self.pane = Pane::Table;
            }
            return;
        }
        let study = self.study.as_ref();
        let running = study.is_some_and(|study| study.found.is_none() && study.fault.is_none());
        let text = match study.and_then(|study| study.fault.as_ref()) {
            Some(fault) => fill(self.texts.no_analysis, &[fault]),
            None if running => self.texts.still_running.to_owned(),
            None => self.texts.nothing_here.to_owned(),
        };
        self.say(Role::Bad, text);
    }
}
