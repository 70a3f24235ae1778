//! Positions in which dry friction leaves several solutions.

use assur_force::{Doubt, FrictionSolution, joints};
use assur_kinematics::Linkage;
use assur_structure::name_of;
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
    /// Whether it is the one that all other results are those of.
    pub taken: bool,
    /// Forces and moments by pair, as in the results of a position.
    pub reactions: IndexMap<String, IndexMap<String, Load>>,
}

/// A force or a moment.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Load {
    /// A force, N.
    Force([f64; 2]),
    /// A moment, N m.
    Moment(f64),
}

impl Several {
    /// What is reported of a position.
    pub(crate) fn of(linkage: &Linkage, index: usize, doubt: &Doubt) -> Self {
        let solutions = doubt.solutions.iter().map(|solution| SolutionReport::of(linkage, solution));
        Self { index, solutions: solutions.collect(), proved: doubt.proved, continuum: doubt.continuum }
    }
}

impl SolutionReport {
    fn of(linkage: &Linkage, solution: &FrictionSolution) -> Self {
        let mechanism = &linkage.mechanism;
        let reactions = joints(mechanism, &linkage.structure).into_iter().map(|joint| {
            let found = joint.reaction(&solution.pairs);
            let forces = found.forces.iter();
            let mut all: IndexMap<String, Load> = forces
                .map(|(link, force)| (mechanism.links[*link].name.to_string(), Load::Force(*force)))
                .collect();
            if let Some(moment) = found.moment {
                all.insert("moment".to_owned(), Load::Moment(moment));
            }
            (name_of(mechanism, joint.id).to_string(), all)
        });
        Self { balancing: solution.balancing, taken: solution.taken, reactions: reactions.collect() }
    }
}
