//! What the worker reports: scenes that were read, and results.

use assur_words::{self as words, Text, number, text};

use super::{jobs, modes, whatif};
use crate::screen::state::{
    Change, Chosen, Compared, Effect, Found, Outcome, OutputFile, Purpose, Reading, Report, Role, Scene,
    State, Stop, View, Wanted, Zoom,
};

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
        Report::Read(Wanted::Compare(_), Ok(scene)) => take_compared(state, scene),
        Report::Noted(path, Ok(note)) => {
            let content = note.into_bytes();
            let file = OutputFile { path, content, numbers: None, overwrite: false, scene: false };
            state.effects.push(Effect::Write(file));
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
    match outcome {
        Outcome::Count(count) => state.running[index].count = count,
        Outcome::Found(found) => take_found(state, index, found),
        Outcome::Checks(checks) => {
            state.running.remove(index);
            if let Some(scene) = &mut state.scene {
                scene.found.iter_mut().for_each(|found| found.take_checks(checks.clone()));
                scene.judge();
            }
        }
        Outcome::Measured(measured) => {
            state.running.remove(index);
            match measured {
                Ok(measured) => (state.measured, state.chosen.line) = (Some(measured), 0),
                Err(text) => state.say(Role::Bad, text!("no-analysis", reason = text)),
            }
        }
    }
}

fn take_found(state: &mut State, index: usize, found: Result<Box<Found>, Text>) {
    let purpose = state.running[index].purpose;
    // After the main results their checks continue.
    if purpose == Purpose::Difference || found.is_err() {
        state.running.remove(index);
    }
    let Some(scene) = &mut state.scene else { return };
    match found {
        Ok(found) if purpose == Purpose::Difference => scene.other = Some(found),
        Ok(found) => {
            (scene.results.found, scene.fault) = (Some(found), None);
            scene.judge();
        }
        Err(text) => {
            scene.fault.get_or_insert_with(|| text.clone());
            state.say(Role::Bad, text!("no-analysis", reason = text));
        }
    }
}

/// Takes a second scene; one with other positions can't be compared.
fn take_compared(state: &mut State, other: Box<Scene>) {
    let Some(scene) = &state.scene else { return };
    let mut name = other.session.source.short_name();
    if other.positions() == scene.positions() {
        if name == scene.session.source.short_name() {
            name = other.session.source.name();
        }
        state.compared = Some(Compared {
            name: words::name(name),
            own: words::name(scene.session.source.short_name()),
            results: Box::new(other.results),
            before: false,
        });
    } else {
        let (other, own) = (other.positions(), scene.positions());
        let (scene, other, own) = (words::name(name), number(other), number(own));
        state.say(Role::Bad, text!("say-other-positions", scene = scene, other = other, own = own));
    }
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
    whatif::reloaded(state, &scene, again);
    jobs::exchange(state, scene);
    if let Some(stop) = back {
        stop.restore(state);
    }
}

/// Takes a changed scene, or the reason why it can't be read; returns whether the frame may differ.
fn take_change(state: &mut State, change: &Change, scene: Result<Box<Scene>, Text>) -> bool {
    let what = &mut state.what_if;
    if change.opening != what.opening {
        return false;
    }
    what.reading = Reading::Done;
    let late = change.edits != what.wanted;
    match scene {
        Ok(scene) => {
            let is_of_modes = what.is_of_modes(&change.edits);
            what.shown.clone_from(&change.edits);
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
        whatif::ask(state);
    }
    true
}

/// Shows a changed scene in place of the one before, with its difference to the same other analyzer; the scene as the
/// file has it is compared with it, unless another one is.
fn show_change(state: &mut State, scene: Scene) {
    if let Some(old) = state.scene.as_ref().filter(|old| old.found.is_some()) {
        state.what_if.compared = old.other.as_ref().map(|other| other.analyzer.clone());
    }
    let same = state.positions() == scene.positions();
    let old = jobs::exchange(state, scene);
    if !same || state.what_if.shown.is_empty() {
        state.compared.take_if(|compared| compared.before || !same);
    } else if state.compared.is_none() {
        let compared = |old: Scene| Compared {
            name: text!("say-before"),
            own: Text::default(),
            results: Box::new(old.results),
            before: true,
        };
        state.compared = old.map(compared);
    }
    if let Some(other) = state.what_if.compared.clone() {
        jobs::ask_difference(state, Some(other));
    }
}
