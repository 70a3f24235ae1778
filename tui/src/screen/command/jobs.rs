//! What the worker is asked for, and what it reports: scenes that were read, and results.

use std::sync::Arc;

use assur_analysis::Options;
use assur_words::{self as words, Text, name, text};

use super::{draft, modes};
use crate::screen::state::{
    CalculationRequest, Cancel, Change, Chosen, Compared, Effect, Job, Outcome, OutputFile, Purpose, Reading,
    Report, Role, Running, Scene, State, Stop, View, Wanted, Zoom,
};

/// Requests a calculation of the open scene by the chosen analyzer and integrator.
pub(crate) fn ask(state: &mut State, purpose: Purpose) {
    ask_by(state, purpose, state.options.clone());
}

pub(super) fn ask_difference(state: &mut State, analyzer: Option<String>) {
    ask_by(state, Purpose::Difference, Options { analyzer, ..state.options.clone() });
}

fn ask_by(state: &mut State, purpose: Purpose, options: Options) {
    let Some(scene) = &state.scene else { return };
    let session = Arc::clone(&scene.session);
    // An earlier calculation for this purpose is no longer needed; new results also invalidate differences to old ones.
    stop_running(state, |old| old == purpose || (purpose == Purpose::Main && old == Purpose::Difference));
    state.asked += 1;
    let (number, cancel) = (state.asked, Cancel::default());
    state.running.push(Running { number, purpose, count: Text::default(), cancel: cancel.clone() });
    let request = CalculationRequest { number, purpose, session, options, cancel };
    state.effects.push(Effect::Work(Job::Calculate(request)));
}

fn stop_running(state: &mut State, wanted: impl Fn(Purpose) -> bool) {
    state.running.retain(|running| {
        if wanted(running.purpose) {
            running.cancel.stop();
        }
        !wanted(running.purpose)
    });
}

/// Stops the analyses in progress. Results found before stay.
pub(super) fn stop(state: &mut State) {
    if state.analyzing().is_none() {
        return;
    }
    stop_running(state, |purpose| purpose != Purpose::Measurement);
    let stopped = text!("say-stopped", key = name(state.keys.first("reload")));
    if let Some(scene) = &mut state.scene {
        match &scene.found {
            Some(found) => {
                state.options.analyzer = Some(found.analyzer.clone()).filter(|name| !name.is_empty());
            }
            None => scene.fault = Some(stopped.clone()),
        }
    }
    state.say(Role::Plain, stopped);
}

/// Replaces the open scene by another one, and requests its analysis; returns the scene before.
pub(super) fn exchange(state: &mut State, scene: Scene) -> Option<Scene> {
    state.position = state.position.min(scene.positions().saturating_sub(1));
    state.phase = 0;
    let before = state.scene.replace(scene);
    stop_running(state, |purpose| purpose == Purpose::Measurement);
    state.measured = None;
    ask(state, Purpose::Main);
    before
}

pub(super) fn stop_measuring(state: &mut State) {
    if let Some(running) = state.measuring() {
        running.cancel.stop();
        state.say(Role::Plain, text!("say-stopping"));
    }
}

/// Takes a report of the worker; returns whether the frame may differ.
pub(crate) fn take(state: &mut State, report: Report) -> bool {
    match report {
        Report::Read(Wanted::Change(change), scene) => return take_change(state, &change, scene),
        Report::Read(Wanted::Preview(name), preview) => drop(state.previews.insert(name, preview)),
        Report::Read(_, Err(text)) => {
            state.going_back = None;
            state.fault = Some((text!("say-read-fault"), text));
        }
        Report::Read(Wanted::Open(_), Ok(scene)) => open(state, *scene),
        Report::Read(Wanted::Compare(..), Ok(scene)) => take_compared(state, scene),
        Report::Noted(path, Ok(note)) => {
            let content = note.into_bytes();
            state.effects.push(Effect::Write(OutputFile { path, content, ..OutputFile::default() }));
        }
        Report::Noted(_, Err(text)) => state.say(Role::Bad, text!("say-no-note", reason = text)),
        Report::Calculated(number, outcome) => {
            // The report may be no longer needed.
            let running = state.running.iter().position(|running| running.number == number);
            let Some(index) = running else { return false };
            take_outcome(state, index, outcome);
        }
    }
    true
}

/// Takes what the calculation of this index reports.
fn take_outcome(state: &mut State, index: usize, outcome: Outcome) {
    let purpose = state.running[index].purpose;
    // Progress, and the main results, whose checks continue.
    let goes_on = matches!((&outcome, purpose), (Outcome::Count(_), _) | (Outcome::Found(_), Purpose::Main));
    match (outcome, &mut state.scene) {
        (Outcome::Count(count), _) => state.running[index].count = count,
        (Outcome::Found(found), Some(scene)) if purpose == Purpose::Difference => scene.other = Some(found),
        (Outcome::Found(found), Some(scene)) => {
            let before = scene.positions();
            scene.results.take(found);
            scene.fault = None;
            if scene.positions() != before {
                // The samples of a transient motion are shown now.
                (state.position, state.phase) = (0, 0);
            }
            scene.judge();
        }
        (Outcome::Checks(checks), Some(scene)) => {
            scene.found.iter_mut().for_each(|found| found.take_checks(checks.clone()));
            scene.judge();
        }
        (Outcome::Measured(measured), _) => (state.measured, state.chosen.line) = (Some(measured), 0),
        (Outcome::Failed(text), scene) => {
            let scene = scene.as_mut().filter(|_| purpose != Purpose::Measurement);
            // Where positions are lost, the last row tells of the first of them.
            let is_told = scene.is_some_and(|scene| {
                scene.fault.get_or_insert_with(|| text.clone());
                !scene.broken.is_empty()
            });
            if !is_told {
                state.say(Role::Bad, text!("no-analysis", reason = text));
            }
        }
        (Outcome::Found(_) | Outcome::Checks(_), None) => {}
    }
    if !goes_on {
        state.running.remove(index);
    }
}

/// Takes a second scene, unless the open one has other positions by now.
fn take_compared(state: &mut State, other: Box<Scene>) {
    let Some(scene) = state.scene.as_ref().filter(|scene| scene.positions() == other.positions()) else {
        return;
    };
    let mut name = other.session.source.short_name();
    if name == scene.session.source.short_name() {
        name = other.session.source.name();
    }
    let [name, own] = [name, scene.session.source.short_name()].map(words::name);
    state.compared = Some(Compared { name, own, results: Box::new(other.results), before: false });
}

/// Shows a scene: a new one from its first position, a reread one at the position shown before.
fn open(state: &mut State, scene: Scene) {
    let again = state.scene.as_ref().is_some_and(|old| old.session.source == scene.session.source);
    let back = state.going_back.take().filter(|stop| stop.source == scene.session.source);
    if !again {
        let left = Stop::of(state).filter(|_| back.is_none());
        if let Some(stop) = left {
            state.leave(stop);
        }
        state.position = scene.first_position();
        state.chosen = Chosen::default();
        state.zoom = Zoom::WHOLE;
        state.view = View::Mechanism;
        (state.motor_limits, state.joined, state.held) = (None, None, None);
        state.picked.clear();
    }
    // Links and points may have other numbers now.
    (state.picker, state.probe) = (None, None);
    if !again || state.positions() != scene.positions() {
        state.compared = None;
    }
    let Chosen { transfer, group, column, .. } = state.chosen;
    state.chosen = Chosen {
        transfer: transfer.min(scene.transfers.len().saturating_sub(1)),
        group: group.min(scene.linkage.structure.groups.len().saturating_sub(1)),
        column: column.min(scene.series.len().saturating_sub(1)),
        ..Chosen::default()
    };
    state.fault = None;
    draft::reloaded(state, &scene, again);
    exchange(state, scene);
    if let Some(stop) = back {
        stop.restore(state);
    }
}

/// Takes a changed scene, or the reason why it can't be read; returns whether the frame may differ.
fn take_change(state: &mut State, change: &Change, scene: Result<Box<Scene>, Text>) -> bool {
    let what = &mut state.draft;
    if change.opening != what.opening {
        return false;
    }
    what.reading = Reading::Done;
    let late = change.text != *what.text();
    match scene {
        Ok(scene) => {
            let is_of_modes = std::mem::take(&mut what.of_modes);
            what.shown.clone_from(&change.text);
            let before = state.scene.as_ref().filter(|_| !late && !is_of_modes);
            let before = before.and_then(|scene| Some((scene.pose(0, 0.0)?.coordinate, modes::all(scene))));
            show_change(state, *scene);
            if let Some((coordinate, before)) = before {
                modes::keep(state, coordinate, &before);
            }
        }
        Err(text) if !late => {
            what.reading = Reading::Refused;
            state.fault = Some((text!("say-change-fault"), text));
        }
        Err(_) => {}
    }
    if late {
        draft::ask(state);
    }
    true
}

/// Shows a changed scene in place of the one before, with its difference to the same other analyzer; the scene as the
/// file has it is compared with it, unless another one is.
fn show_change(state: &mut State, scene: Scene) {
    if let Some(old) = state.scene.as_ref().filter(|old| old.found.is_some()) {
        state.draft.compared = old.other.as_ref().map(|other| other.analyzer.clone());
    }
    let same = state.positions() == scene.positions();
    let old = exchange(state, scene);
    if !same || state.draft.is_shown_as_opened() {
        state.compared.take_if(|compared| compared.before || !same);
    } else if state.compared.is_none() {
        let (name, own) = (text!("say-before"), Text::default());
        state.compared = old.map(|old| Compared { name, own, results: Box::new(old.results), before: true });
    }
    if let Some(other) = state.draft.compared.clone() {
        ask_difference(state, Some(other));
    }
}
