//! Places to which the user goes back.

use std::collections::BTreeMap;

use super::kinds::{Chosen, View, ViewPart};
use super::{Source, State};

/// Places that are remembered.
const MOST: usize = 100;

/// What was shown: scene, view, position, and what was chosen.
#[derive(Debug, Clone)]
pub(crate) struct Stop {
    pub(crate) source: Source,
    pub(crate) view: View,
    position: usize,
    chosen: Chosen,
    picked: Vec<String>,
    parts: BTreeMap<View, ViewPart>,
}

impl Stop {
    /// What is shown now; `None` without a scene.
    pub(crate) fn of(state: &State) -> Option<Self> {
        let source = state.scene.as_ref()?.session.source.clone();
        let State { view, position, chosen, picked, parts, .. } = state;
        let (picked, parts) = (picked.clone(), parts.clone());
        Some(Self { source, view: *view, position: *position, chosen: *chosen, picked, parts })
    }

    /// Shows it again in the same scene.
    pub(crate) fn restore(self, state: &mut State) {
        let Self { view, position, chosen, picked, parts, .. } = self;
        (state.view, state.chosen, state.picked, state.parts) = (view, chosen, picked, parts);
        state.go_to(position.min(state.positions() - 1));
    }
}

impl State {
    /// Remembers a place.
    pub(crate) fn leave(&mut self, stop: Stop) {
        if self.trail.len() == MOST {
            self.trail.remove(0);
        }
        self.trail.push(stop);
    }
}
