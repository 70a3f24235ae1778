//! What a scene needs, and by which method.
//!
//! [`Plan::of`] reads the content of a mechanism and what it asks for, and says which stages are run and why, which are
//! left out and why, which groups must be solved and to which order. The calculation obeys the plan; `explain` prints it.
//! Nothing is calculated here.

mod carry;
mod explain;
mod kinematics;
mod missing;
mod model;
mod needs;
mod order;
mod stages;
mod words;

use assur_group::Order;
use assur_mechanism::{LinkId, Mechanism, Motion, PairId, Place, PointId, SlideId};
use assur_structure::Structure;

pub use explain::explain;
pub use missing::not_modelled;
pub use model::{Remark, modelled};

/// The methods that a user has chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Methods {
    /// Force analyzer.
    pub analyzer: String,
    /// Whether this analyzer goes group by group, so that groups without a load can be left alone.
    pub by_groups: bool,
    /// Integrator of a motion that is not prescribed.
    pub integrator: String,
}

/// What results tell, in the order of the scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Wanted {
    /// Moving links.
    pub links: Vec<LinkId>,
    /// Points, each with the link that it is read from: the one that is known first.
    pub points: Vec<(PointId, Place)>,
    /// Slides.
    pub slides: Vec<SlideId>,
    /// Pins and slides whose reactions are told.
    pub reactions: Vec<PairId>,
}

/// One stage of the calculation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stage {
    /// What it finds.
    pub name: &'static str,
    /// Whether it is run.
    pub needed: bool,
    /// Why it is run, or why not and what would make it run.
    pub reason: String,
    /// How it is done; empty for a stage that is not run.
    pub method: String,
}

/// What is calculated for a scene, and how.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "each stage is run or not, on its own")]
pub struct Plan {
    /// All stages in the order in which data goes through them.
    pub stages: Vec<Stage>,
    /// What results tell.
    pub wanted: Wanted,
    /// By group: whether anything that is asked for depends on it.
    pub groups_needed: Vec<bool>,
    /// By group: whether its reactions can differ from zero, by what the scene puts on its links and on the groups behind it.
    pub groups_carrying: Vec<bool>,
    /// Whether the force analyzer goes group by group.
    pub by_groups: bool,
    /// J is the same at every coordinate, by structure: dJ/dq is zero and not computed.
    pub inertia_constant: bool,
    /// Up to which order transfer functions are calculated.
    pub order: Order,
    /// What needs that order, in words.
    pub order_for: Vec<&'static str>,
    /// Velocities and accelerations are told.
    pub velocities: bool,
    /// Inertia, its derivative and loads are reduced to the input link.
    pub reduction: bool,
    /// Inertia loads enter the force analysis.
    pub inertia_loads: bool,
    /// Reactions and balancing load are calculated.
    pub forces: bool,
    /// The equation of motion is solved: the motion is not prescribed.
    pub dynamics: bool,
}

impl Wanted {
    /// Whether neither link nor point nor slide is told.
    pub fn tells_no_motion(&self) -> bool {
        self.links.is_empty() && self.points.is_empty() && self.slides.is_empty()
    }
}

impl Plan {
    /// The plan for a mechanism.
    pub fn of(mechanism: &Mechanism, structure: &Structure, methods: &Methods) -> Self {
        let moves = mechanism.motion.is_some();
        let heavy = (1..mechanism.links.len()).any(|link| carry::is_heavy(mechanism, link));
        let wanted = needs::wanted(mechanism, structure);
        // With `[output]`, forces are wanted only where reactions are.
        let asked = mechanism.output.is_none() || !wanted.reactions.is_empty();
        let dynamics = matches!(mechanism.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }));
        let forces = asked && (moves || mechanism.has_loads());
        let mut plan = Self {
            stages: Vec::new(),
            groups_needed: Vec::new(),
            groups_carrying: carry::groups(mechanism, structure),
            by_groups: methods.by_groups,
            inertia_constant: mechanism.has_constant_reduced_inertia(),
            order: Order::Second,
            order_for: Vec::new(),
            velocities: moves && !wanted.tells_no_motion(),
            reduction: dynamics || asked && (heavy || mechanism.has_loads()),
            inertia_loads: forces && moves && heavy,
            forces,
            dynamics,
            wanted,
        };
        plan.groups_needed = needs::groups(mechanism, structure, &plan);
        (plan.order, plan.order_for) = order::order(mechanism, structure, &plan);
        plan.stages = stages::stages(mechanism, structure, methods, &plan);
        plan
    }

    /// Whether any group is left out.
    pub fn is_partial(&self) -> bool {
        self.groups_needed.contains(&false)
    }

    /// By group: whether the force analysis solves it. A group that carries no load has reactions that are exactly zero, and a
    /// method that goes group by group leaves it alone.
    pub fn groups_with_forces(&self) -> Vec<bool> {
        let each = self.groups_carrying.iter();
        each.map(|carrying| self.forces && (*carrying || !self.by_groups)).collect()
    }
}

#[cfg(test)]
mod tests;
