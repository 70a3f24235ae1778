//! The tour: a shaper is built in ten steps; each says what to press, and ends where what it asks for is there.

use assur_kinematics::decompose;
use assur_mechanism::Key;
use assur_words::{Text, name, number, text};

use super::begin;
use crate::screen::state::{Role, State, Task, View};

/// A step: the identity of what it says, and whether it is done.
type Step = (&'static str, fn(&State) -> bool);

const STEPS: [Step; 10] = [
    ("tour-crank", |state| stands(state, "link.crank.points.A")),
    ("tour-stone", |state| stands(state, "link.rocker.points.C") && stands(state, "link.stone2.points.A")),
    ("tour-ram", |state| stands(state, "link.ram.points") && stands(state, "link.stone4.points.D")),
    ("tour-play", |state| state.draft.has_steps()[1]),
    ("tour-masses", |state| stands(state, "link.ram.mass")),
    ("tour-motion", |state| stands(state, "motion.speed")),
    ("tour-force", |state| stands(state, "force[0].value")),
    ("tour-reactions", |state| state.view == View::Forces && state.chosen.reaction > 0),
    ("tour-checks", |state| state.view == View::Checks),
    ("tour-save", |state| state.draft.saved.is_some()),
];

/// Whether a key stands in the text, and no form is open in which it may still change.
fn stands(state: &State, key: &str) -> bool {
    let found = |key: Key| assur_draft::stands(state.draft.text(), &key);
    matches!(state.build.task, Task::Choose) && Key::parse(key).is_ok_and(found)
}

/// The kind of a group of the shaper, in solving order, as it is searched for in the list: the texts name none.
fn kind(group: usize) -> &'static str {
    let shaper = assur_scene::read("shaper.toml", assur_fixtures::scene("shaper"));
    let structure = shaper.ok().and_then(|mechanism| decompose(&mechanism).ok());
    structure
        .and_then(|structure| structure.groups.get(group).map(|group| group.plugin.name))
        .unwrap_or_default()
}

/// Begins the tour.
pub(crate) fn begin(state: &mut State) {
    begin::new(state);
    state.tour = Some((0, told(0)));
}

/// Goes on where the present step is done.
pub(super) fn go_on(state: &mut State) {
    while let Some(step) = state.tour.as_ref().map(|(step, _)| *step) {
        if STEPS.get(step).is_some_and(|(_, is_done)| !is_done(state)) {
            return;
        }
        state.tour = Some((step + 1, told(step + 1))).filter(|_| step + 1 < STEPS.len());
        if state.tour.is_none() {
            state.say(Role::Good, text!("tour-end"));
        }
    }
}

/// What a step says.
fn told(step: usize) -> Text {
    let text = STEPS.get(step).map_or_else(Text::default, |(id, _)| match *id {
        // The steps that add groups.
        "tour-stone" => text!("tour-stone", kind = name(kind(0))),
        "tour-ram" => text!("tour-ram", kind = name(kind(1))),
        id => text!(id),
    });
    text!("tour-step", at = number(step + 1), count = number(STEPS.len()), text)
}
