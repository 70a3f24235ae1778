//! What there is to show in a view, and the places to which the user goes back.

use std::collections::BTreeMap;

use assur_analysis::results::{Column, Owner, Quantity};

use super::kinds::{Chosen, View};
use super::{Source, State};
use assur_picture::{Series, ViewPart};

impl State {
    /// Whether a view has something to show.
    pub(crate) fn has(&self, view: View) -> bool {
        let found = self.found();
        match view {
            View::Forces => found.is_some_and(|found| !found.reactions.is_empty()),
            View::Plans | View::Results => found.is_some(),
            View::Motion => {
                found.is_some_and(|found| !found.motion.is_empty() || !found.analysis.trajectory.is_empty())
            }
            View::Drive => found.is_some_and(|found| found.analysis.dynamics.is_some()),
            View::Checks => found.is_some_and(|found| !found.analysis.checks.is_empty()),
            _ => self.scene.is_some(),
        }
    }

    /// The part of a view that is shown: the chosen one if there is something to show in it.
    pub(crate) fn part(&self, view: View) -> ViewPart {
        let parts = self.available_parts(view);
        let chosen = self.parts.get(&view).filter(|part| parts.contains(part));
        chosen.or(parts.first()).copied().unwrap_or(ViewPart::Overview)
    }

    /// The parts of a view in which there is something to show.
    pub(crate) fn available_parts(&self, view: View) -> Vec<ViewPart> {
        let found = self.found();
        let reaction = found.and_then(|found| found.reactions.get(self.chosen.reaction));
        let regime = found.is_some_and(|found| found.analysis.dynamics.is_some());
        let has = |part: &ViewPart| match (view, part) {
            // The balancing load has one number, no direction.
            (View::Forces, ViewPart::Hodograph) => {
                reaction.is_some_and(|reaction| reaction.series.len() == 3)
            }
            (View::Motion, ViewPart::Course) => {
                regime || found.is_some_and(|found| !found.analysis.trajectory.is_empty())
            }
            (View::Motion, ViewPart::Iteration) => regime,
            (View::Motion, ViewPart::Reduction) => found.is_some_and(|found| {
                let moment = Column::of(Quantity::ReducedMoment, Owner::Input);
                let turns = self.scene.as_ref().is_some_and(|scene| scene.linkage.angular());
                turns && found.analysis.positions.schema().find(moment).is_some()
            }),
            _ => true,
        };
        view.parts().iter().copied().filter(has).collect()
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

    /// The positions in the order of the table's rows.
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

    /// Remembers a place.
    pub(crate) fn leave(&mut self, stop: Stop) {
        if self.trail.len() == MOST {
            self.trail.remove(0);
        }
        self.trail.push(stop);
    }
}

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
