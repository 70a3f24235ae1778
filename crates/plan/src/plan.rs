//! The plan itself.

use assur_group::Order;
use assur_mechanism::{LinkId, Mechanism, Motion, PairId, Place, PointId, SlideId};
use assur_structure::Structure;

use crate::{needs, stages};

/// The methods that a user has chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Methods {
    /// Force analyzer.
    pub analyzer: String,
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
    /// Up to which order transfer functions are calculated.
    pub order: Order,
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

impl Plan {
    /// The plan for a mechanism.
    pub fn of(mechanism: &Mechanism, structure: &Structure, methods: &Methods) -> Self {
        let moves = mechanism.motion.is_some();
        let dynamics = matches!(mechanism.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }));
        let heavy = mechanism.links.iter().skip(1).any(|link| link.mass > 0.0 || link.inertia > 0.0);
        let wanted = needs::wanted(mechanism, structure);
        let tells_motion = !(wanted.links.is_empty() && wanted.points.is_empty() && wanted.slides.is_empty());
        // With `[output]`, forces are wanted only where reactions are.
        let asked = mechanism.output.is_none() || !wanted.reactions.is_empty();
        let forces = asked && (moves || mechanism.has_loads());
        let reduction = dynamics || asked && (heavy || mechanism.has_loads());
        let mut plan = Self {
            stages: Vec::new(),
            groups_needed: if forces || reduction || dynamics {
                // A reaction depends on the loads of every group behind it, and they on every group before.
                vec![true; structure.groups.len()]
            } else {
                needs::groups(mechanism, structure, &wanted)
            },
            order: if tells_motion || dynamics || heavy && (reduction || moves) {
                Order::Second
            } else {
                Order::First
            },
            velocities: moves && tells_motion,
            reduction,
            inertia_loads: forces && moves && heavy,
            forces,
            dynamics,
            wanted,
        };
        plan.stages = stages::stages(mechanism, structure, methods, &plan);
        plan
    }

    /// Whether any group is left out.
    pub fn is_partial(&self) -> bool {
        self.groups_needed.contains(&false)
    }
}
