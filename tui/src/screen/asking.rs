//! The analysis of the open scene: asked for, taken, and which views it fills.

use assur_analysis::results::Check;

use super::found::Found;
use super::running::{Cancel, Running};
use super::state::{Pane, State, View, Wish};
use super::text::fill;
use super::theme::Role;
use super::work::{Job, Request};

impl State {
    /// Asks for the analysis of the open scene; `other`: by [`State::analyzer`]'s successor, for the difference.
    pub(crate) fn analyze(&mut self, other: bool) {
        let Some(study) = &self.study else { return };
        let linkage = study.linkage.clone();
        // An analysis of the same kind that still runs has become needless; a new main one makes both so.
        self.stop_running(|running| running.other || !other);
        self.asked += 1;
        let cancel = Cancel::default();
        let running = Running { number: self.asked, other, count: String::new(), cancel: cancel.clone() };
        self.running.push(running);
        let request = Request {
            number: self.asked,
            linkage,
            analyzer: self.analyzer.clone(),
            integrator: self.integrator.clone(),
            other,
            cancel,
        };
        self.wishes.push(Wish::Work(Job::Analyze(request)));
    }

    fn stop_running(&mut self, wanted: impl Fn(&Running) -> bool) {
        self.running.iter().filter(|running| wanted(running)).for_each(|running| running.cancel.stop());
        self.running.retain(|running| !wanted(running));
    }

    /// Stops the analyses that run. What was found before stays.
    pub(crate) fn stop(&mut self) {
        if self.running.is_empty() {
            return;
        }
        self.stop_running(|_| true);
        let stopped = fill(self.texts.stopped, &[&self.keys.first("reload")]);
        if let Some(study) = &mut self.study {
            match &study.found {
                Some(found) => self.analyzer = Some(found.analyzer.clone()).filter(|name| !name.is_empty()),
                None => study.fault = Some(stopped.clone()),
            }
        }
        self.say(Role::Plain, stopped);
    }

    /// Takes a count of an analysis; tells whether the frame may differ.
    pub(crate) fn take_count(&mut self, number: usize, count: String) -> bool {
        match self.running.iter_mut().find(|running| running.number == number) {
            Some(running) => running.count = count,
            None => return false,
        }
        true
    }

    /// Takes an analysis, unless nobody waits for it any more; tells whether the frame may differ.
    pub(crate) fn take_found(&mut self, number: usize, found: Result<Box<Found>, String>) -> bool {
        let texts = self.texts;
        let Some(index) = self.running.iter().position(|running| running.number == number) else {
            return false;
        };
        let other = self.running[index].other;
        // After the main one its checks go on.
        if other || found.is_err() {
            self.running.remove(index);
        }
        let Some(study) = &mut self.study else { return false };
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

    /// Takes the checks of the analysis that was given before them.
    pub(crate) fn take_checks(&mut self, number: usize, checks: Vec<Check>) -> bool {
        let Some(index) = self.running.iter().position(|running| running.number == number) else {
            return false;
        };
        self.running.remove(index);
        if let Some(found) = self.study.as_mut().and_then(|study| study.found.as_mut()) {
            found.checks = checks;
        }
        true
    }

    /// Whether a view has something to show.
    pub(crate) fn has(&self, view: View) -> bool {
        let found = self.study.as_ref().and_then(|study| study.found.as_ref());
        match view {
            View::Menu => true,
            View::Mechanism
            | View::Curves
            | View::Accuracy
            | View::Structure
            | View::Table
            | View::Values => self.study.is_some(),
            View::Forces => found.is_some_and(|found| found.has_forces()),
            View::Plans => found.is_some(),
            View::Motion => {
                found.is_some_and(|found| !found.motion.is_empty() || !found.analysis.trajectory.is_empty())
            }
            View::Drive => found.is_some_and(|found| found.analysis.dynamics.is_some()),
            View::Checks => found.is_some_and(|found| !found.checks.is_empty()),
        }
    }

    /// Goes to a view; one that has nothing to show says what to add to the scene.
    pub(crate) fn show(&mut self, view: View) {
        self.view = view;
        if view != View::Forces && self.pane == Pane::Causes {
            self.pane = Pane::Table;
        }
    }
}
