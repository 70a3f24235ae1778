//! Positions in which dry friction leaves several solutions.

use assur_force::{Doubt, FrictionSolution, joints};
use assur_kinematics::Linkage;
use indexmap::IndexMap;
use serde::Serialize;

/// A position with several solutions.
#[derive(Debug, Clone, PartialEq)]
pub struct Several {
    /// Number of the position.
    pub index: usize,
    /// All solutions, ascending by the balancing load.
    pub solutions: Vec<SolutionReport>,
    /// Whether there are certainly no others.
    pub proved: bool,
    /// Whether they are the ends of a continuum.
    pub continuum: bool,
}

/// One of several solutions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SolutionReport {
    /// The balancing load, N m or N.
    pub balancing: f64,
    /// Whether all other results belong to this solution.
    pub taken: bool,
    /// Forces and moments by pair, as in the results of a position.
    pub reactions: IndexMap<String, IndexMap<String, ForceOrMoment>>,
}

/// A force or a moment.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ForceOrMoment {
    /// A force, N.
    Force([f64; 2]),
    /// A moment, N m.
    Moment(f64),
    /// What passive links leave undetermined.
    Open,
}

impl Several {
    /// What is reported of a position; `open`: which reactions are undetermined, by [`Joint::open`](assur_force::Joint::open).
    pub(crate) fn of(linkage: &Linkage, index: usize, doubt: &Doubt, open: &[bool]) -> Self {
        let solutions = doubt.solutions.iter().map(|solution| SolutionReport::of(linkage, solution, open));
        Self { index, solutions: solutions.collect(), proved: doubt.proved, continuum: doubt.continuum }
    }
}

impl SolutionReport {
    fn of(linkage: &Linkage, solution: &FrictionSolution, open: &[bool]) -> Self {
        let mechanism = &linkage.mechanism;
        let reactions = joints(mechanism, &linkage.structure).into_iter().map(|joint| {
            let found = joint.reaction(&solution.pairs);
            let open = joint.open(open);
            let or_open =
                |nth: usize, load| if open.get(nth) == Some(&true) { ForceOrMoment::Open } else { load };
            let forces = found.forces.iter().enumerate();
            let mut all: IndexMap<String, ForceOrMoment> = forces
                .map(|(nth, (link, force))| {
                    (mechanism.links[*link].name.to_string(), or_open(nth, ForceOrMoment::Force(*force)))
                })
                .collect();
            if let Some(moment) = found.moment {
                all.insert("moment".to_owned(), or_open(found.forces.len(), ForceOrMoment::Moment(moment)));
            }
            (mechanism.pair_name(joint.id).to_string(), all)
        });
        Self { balancing: solution.balancing, taken: solution.taken, reactions: reactions.collect() }
    }
}
