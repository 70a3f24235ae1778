//! What must be calculated for a scene.
//!
//! [`Plan::of`] examines the content of a mechanism and the requested results, and decides which stages are run, which
//! groups must be solved, and up to which order. The calculation follows the plan. Nothing is calculated here.

mod needs;

use assur_group::Order;
use assur_mechanism::{LinkId, Mechanism, Output, PairId, Place, PointId, SlideId};
use assur_structure::Structure;
use assur_words::Text;

/// The content of results, in the order of the scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Wanted {
    /// Moving links.
    pub links: Vec<LinkId>,
    /// Points, each with the link in which it is evaluated: the one that is known first.
    pub points: Vec<(PointId, Place)>,
    /// Slides.
    pub slides: Vec<SlideId>,
    /// Pins and slides whose reactions are wanted.
    pub reactions: Vec<PairId>,
}

/// What is calculated for a scene, and how.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "each stage is run or not, on its own")]
pub struct Plan {
    /// The content of the results.
    pub wanted: Wanted,
    /// Whether these are all results.
    pub all: bool,
    /// By group: whether any requested result depends on it.
    pub groups_needed: Vec<bool>,
    /// By group: whether its reactions can differ from zero, by the loads on its links and on the groups after it.
    pub groups_carrying: Vec<bool>,
    /// Whether the force analyzer solves group by group.
    pub by_groups: bool,
    /// J is the same at every coordinate, by structure: dJ/dq is zero and not computed.
    pub inertia_constant: bool,
    /// Highest order of transfer functions that is calculated.
    pub order: Order,
    /// The reason for that order, in words.
    pub order_for: Vec<Text>,
    /// Velocities and accelerations are wanted.
    pub velocities: bool,
    /// Inertia, its derivative and loads are reduced to the input link.
    pub reduction: bool,
    /// Inertia loads enter the force analysis.
    pub inertia_loads: bool,
    /// Reactions and balancing load are calculated.
    pub forces: bool,
    /// The equation of motion is solved: the motion is not prescribed.
    pub dynamics: bool,
    /// What the plan took from the numbers of the mechanism.
    basis: Basis,
}

/// What of the numbers of a mechanism a plan depends on; the rest are its links, pairs, loads, motion and output.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Basis {
    gravity: bool,
    /// By link: whether it has a mass, and a moment of inertia.
    heavy: Vec<[bool; 2]>,
    /// J is the same at every coordinate.
    inertia_constant: bool,
}

impl Basis {
    fn of(mechanism: &Mechanism) -> Self {
        Self {
            gravity: mechanism.gravity.is_some_and(|gravity| gravity != [0.0, 0.0]),
            heavy: mechanism.links.iter().map(|link| [link.mass > 0.0, !link.inertia.is_none()]).collect(),
            inertia_constant: mechanism.has_constant_reduced_inertia(),
        }
    }
}

impl Wanted {
    /// Whether neither link nor point nor slide is wanted.
    pub fn has_no_motion(&self) -> bool {
        self.links.is_empty() && self.points.is_empty() && self.slides.is_empty()
    }
}

impl Plan {
    /// The plan for some results of a mechanism, or for all; `by_groups`: whether the force analyzer solves group by group,
    /// so that groups without a load can be left out.
    pub fn of(
        mechanism: &Mechanism,
        structure: &Structure,
        output: Option<&Output>,
        by_groups: bool,
    ) -> Self {
        let moves = mechanism.motion.is_some();
        let heavy = mechanism.heavy_links().next().is_some();
        let wanted = needs::wanted(mechanism, structure, output);
        // With `[output]`, forces are requested only where reactions are.
        let asked = output.is_none() || !wanted.reactions.is_empty();
        let dynamics = mechanism.has_equation_of_motion();
        let forces = asked && (moves || mechanism.has_loads());
        let mut plan = Self {
            all: output.is_none(),
            groups_needed: Vec::new(),
            groups_carrying: needs::groups_carrying(mechanism, structure),
            by_groups,
            inertia_constant: mechanism.has_constant_reduced_inertia(),
            order: Order::Second,
            order_for: Vec::new(),
            velocities: moves && !wanted.has_no_motion(),
            reduction: dynamics || asked && (heavy || mechanism.has_loads()),
            inertia_loads: forces && moves && heavy,
            forces,
            dynamics,
            wanted,
            basis: Basis::of(mechanism),
        };
        plan.groups_needed = needs::groups(mechanism, structure, &plan);
        (plan.order, plan.order_for) = needs::order(mechanism, structure, &plan);
        plan
    }

    /// Turns the plan of a mechanism into that of another one, which differs in numbers only.
    pub fn fit(&mut self, mechanism: &Mechanism, structure: &Structure) {
        if self.basis != Basis::of(mechanism) {
            let output = mechanism.output.as_ref().filter(|_| !self.all);
            *self = Self::of(mechanism, structure, output, self.by_groups);
            return;
        }
        for (point, place) in &mut self.wanted.points {
            place.at = mechanism.place_in(*point, place.link).unwrap_or_default();
        }
    }

    /// Whether any group is left out.
    pub fn is_partial(&self) -> bool {
        self.groups_needed.contains(&false)
    }
}

#[cfg(test)]
mod tests;
