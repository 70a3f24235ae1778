//! What is read of the text while it is built: what of it moves, its faults, the lengths with which it would close.

use std::sync::Arc;

use assur_draft::{Part, delete, key_at, readable};
use assur_kinematics::decompose;
use assur_mechanism::{Key, Mechanism, Step};
use assur_scene::edit::ParsedText;
use assur_sketch::{closings, sketch};
use assur_structure::StructureError;
use assur_words::Describe;

use super::fields;
use crate::screen::state::{Faulty, Read, Scene, State, View};

/// How often what is loose or surplus is left out before nothing is drawn.
const ATTEMPTS: usize = 20;

/// Looks at the text, if it is another one than before.
pub(super) fn refresh(state: &mut State) {
    let is_new = state.build.read.as_ref().is_none_or(|read| read.text != *state.draft.text());
    if state.view != View::Build || !is_new {
        return;
    }
    let name = state.draft.source.short_name();
    state.build.read = Some(read(&name, state.draft.text()));
    state.build.line = None;
    let things = state.build.things();
    state.build.chosen.take_if(|chosen| !things.contains(chosen));
    fields::renew(state);
}

pub(super) fn read(name: &str, text: &Arc<str>) -> Read {
    let found = readable(name, text);
    let mechanism = |text: &str| assur_scene::read(name, text).unwrap_or_default();
    let faulty = |fault: &assur_scene::SceneError| Faulty {
        text: fault.message.clone(),
        key: key_at(text, fault.span.start).filter(|_| !fault.span.is_empty()),
    };
    let mut faults: Vec<Faulty> = found.faults.iter().map(faulty).collect();
    let sketch = sketch(&mechanism(&found.text));
    let moving = moving(name, found.text, &mut faults).map(Arc::from);
    let readable = moving.map(|moving: Arc<str>| if *moving == **text { Arc::clone(text) } else { moving });
    Read { text: Arc::clone(text), readable, sketch, faults, closings: None }
}

/// The part of a text that makes a mechanism: without the links that are loose; `None` if nothing does.
pub(super) fn moving(name: &str, mut text: String, faults: &mut Vec<Faulty>) -> Option<String> {
    for attempt in 0..ATTEMPTS {
        let mechanism = assur_scene::read(name, &text).ok()?;
        let Err(error) = decompose(&mechanism) else { return Some(text) };
        if attempt == 0 {
            let key = assur_kinematics::CompileError::from(error.clone()).key();
            faults.push(Faulty { text: error.describe(), key });
        }
        let StructureError::Loose { links, .. } = error else { return None };
        let parts: Vec<Part> = links.into_iter().map(Part::Link).collect();
        text = delete(&text, &parts).ok().filter(|_| !parts.is_empty())?;
    }
    None
}

/// Before a frame: of a dyad that can't be assembled the lengths with which it could, unless one is being typed. Of a larger group they
/// are looked for when they are asked for, since that may take seconds.
pub(super) fn look_for_closings(state: &mut State) {
    let is_typing = state.build.form().is_some_and(|form| form.entry.is_some());
    let of_dyad = |scene: &Scene| {
        let broken = scene.broken.values().next().map(|broken| broken.group);
        let group = broken.and_then(|group| scene.linkage.structure.groups.get(group));
        group.is_some_and(|group| group.frame.links.len() <= 2)
    };
    if state.view == View::Build && !is_typing && state.scene.as_ref().is_some_and(of_dyad) {
        find_closings(state);
    }
}

/// Looks for numbers with which the mechanism could be assembled, where it can't.
pub(super) fn find_closings(state: &mut State) {
    let (Some(scene), Some(read)) = (&state.scene, &mut state.build.read) else { return };
    let is_shown = state.draft.shown == read.text && scene.session.text == *read.text;
    let Some(broken) = scene.broken.values().next().filter(|_| is_shown && read.closings.is_none()) else {
        return;
    };
    let mechanism = &scene.linkage.mechanism;
    let group = scene.linkage.structure.groups.get(broken.group);
    let links = group.map_or(&[][..], |group| &group.frame.links);
    let keys = ParsedText::of(&read.text).values().into_iter().map(|value| value.key);
    let keys: Vec<Key> = keys.filter(|key| is_of(key, mechanism, links)).collect();
    read.closings = Some(closings(&read.text, &keys));
}

/// Whether a key is that of a place on one of these links.
pub(super) fn is_of(key: &Key, mechanism: &Mechanism, links: &[usize]) -> bool {
    let mut steps = key.steps().iter();
    steps.next() == Some(&Step::from("link"))
        && steps
            .next()
            .is_some_and(|step| links.iter().any(|link| *step == Step::from(&mechanism.links[*link].name)))
        && steps.next() == Some(&Step::from("points"))
}
