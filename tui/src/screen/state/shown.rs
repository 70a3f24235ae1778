//! What there is to show in a view, and the places to which the user goes back.

use std::collections::BTreeMap;

use super::kinds::{Chosen, View};
use super::{Source, State};
use assur_picture::{Series, ViewPart};

impl State {
    pub(crate) fn has(&self, view: View) -> bool {
        let Some(scene) = &self.scene else { return false };
        match (view, view.picture()) {
            (View::Results, _) => scene.found.is_some(),
            (View::Checks, _) => scene.found.as_ref().is_some_and(|found| !found.analysis.checks.is_empty()),
            (_, picture) => picture.is_none_or(|picture| picture.is_in(scene)),
        }
    }

    pub(crate) fn available_parts(&self, view: View) -> Vec<ViewPart> {
        let picture = view.picture().zip(self.scene.as_ref());
        picture.map_or_else(Vec::new, |(picture, scene)| picture.parts_of(scene, &self.pictured()))
    }

    pub(crate) fn has_part(&self, part: ViewPart) -> bool {
        self.available_parts(self.view).contains(&part)
    }

    /// The part of a view that is shown: the chosen one if there is something to show in it.
    pub(crate) fn part(&self, view: View) -> ViewPart {
        let (picture, wanted) = (view.picture().zip(self.scene.as_ref()), self.parts.get(&view).copied());
        picture.map_or(ViewPart::Overview, |(picture, scene)| picture.part(scene, &self.pictured(), wanted))
    }

    /// The quantity that the view is about: what the keys to the greatest and least value mean.
    pub(crate) fn main_series(&self) -> Option<&Series> {
        let scene = self.scene.as_ref()?;
        let of_found = |index: usize| scene.found.as_ref()?.series.get(index);
        let transfer = || scene.series.get(scene.transfers.get(self.chosen.transfer)?.orders[0]);
        match self.view {
            View::Table => scene.column(self.chosen.column),
            View::Forces => {
                let reaction = self.found()?.reactions.get(self.chosen.reaction)?;
                of_found(*reaction.series.last()?)
            }
            View::Motion => {
                let motion = &self.found()?.motion;
                of_found(*motion.get(self.chosen.motion % motion.len().max(1))?)
            }
            View::Curves => self.picked.last().and_then(|short| scene.named(short)).or_else(transfer),
            _ => transfer(),
        }
    }

    pub(crate) fn order(&self) -> Vec<usize> {
        let Some(scene) = &self.scene else { return Vec::new() };
        let mut order: Vec<usize> = (0..scene.positions()).collect();
        if let Some((column, up)) = self.sorted
            && let Some(series) = scene.column(column)
        {
            order.sort_by(|a, b| series.at(*a).total_cmp(&series.at(*b)));
            if !up {
                order.reverse();
            }
        }
        order
    }

    pub(crate) fn leave(&mut self, stop: Stop) {
        if self.trail.len() == MOST {
            self.trail.remove(0);
        }
        self.trail.push(stop);
    }
}

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
