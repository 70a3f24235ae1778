//! What is mended on request: the fields of faults, the lengths with which the mechanism would close.

use assur_draft::Part;
use assur_mechanism::Key;
use assur_words::{name, number, text};

use super::{draft, form, reading};
use crate::screen::state::{Role, State, Task};

/// Goes to the field of the next fault.
pub(super) fn fault(state: &mut State) {
    let faults = state.build.read.as_ref().map_or(&[][..], |read| &read.faults);
    let Some(fault) = faults.get(state.build.fault % faults.len().max(1)).cloned() else {
        let lost = state.scene.as_ref().and_then(|scene| scene.broken.keys().next().copied());
        let key = || name(state.keys.first("close-gap"));
        let told =
            lost.map(|position| text!("build-only-unassembled", position = number(position), key = key()));
        let role = if told.is_some() { Role::Bad } else { Role::Good };
        return state.say(role, told.unwrap_or_else(|| text!("build-no-faults")));
    };
    let [at, count] = [state.build.fault % faults.len() + 1, faults.len()].map(number);
    state.build.fault += 1;
    if let Some(key) = &fault.key {
        let things = state.build.things();
        match things
            .into_iter()
            .find(|part| matches!(part, Part::Link(link) if *key == Key::of("link").at(link.as_str())))
        {
            // A fault of a link as a whole has no field: the link is chosen.
            Some(part) => (state.build.chosen, state.build.task) = (Some(part), Task::Choose),
            None => form::at(state, key),
        }
    }
    state.say(Role::Bad, text!("build-fault", at, count, fault = fault.text));
}

/// Takes the nearest change of one number with which the mechanism can be assembled.
pub(super) fn close(state: &mut State) {
    let found = |state: &State| state.build.read.as_ref().and_then(|read| read.closings.clone());
    if found(state).is_none() {
        reading::find_closings(state);
        if found(state).is_some_and(|found| !found.is_empty()) {
            return;
        }
    }
    let closing = found(state).and_then(|found| found.into_iter().next());
    match closing {
        Some(closing) => {
            let text = assur_draft::set(state.draft.text(), &closing.key, &closing.toml);
            draft::take(state, text);
        }
        None => state.say(Role::Plain, text!("build-nothing-to-close")),
    }
}
