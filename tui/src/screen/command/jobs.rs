//! What the worker is asked for.

use std::sync::Arc;

use assur_analysis::Options;
use assur_words::{Text, name, text};

use crate::screen::state::{
    CalculationRequest, Cancel, Effect, Job, Purpose, Role, Running, Scene, State, Wanted,
};

pub(super) fn read(state: &mut State, wanted: Wanted) {
    state.effects.push(Effect::Work(Job::Read(wanted)));
}

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
