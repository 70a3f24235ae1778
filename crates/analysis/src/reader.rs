//! Solves positions, of the input or of samples of a motion, with their forces.

use assur_force::{AnalyzerPlugin, ForceError, Loads, Reactions, State, applicable};
use assur_group::{Order, Wrench};
use assur_kinematics::{Linkage, PointMotion, Position, PositionError, ScalarMotion};

use crate::Calculation;
use crate::joints::Joints;
use crate::plan::Wanted;

/// A position with its forces; it is solved anew for each coordinate.
#[derive(Debug)]
pub(crate) struct Reader<'a> {
    linkage: &'a Linkage,
    order: Order,
    forces: Option<Forces<'a>>,
    /// The position that was solved last.
    pub(crate) position: Position,
}

impl<'a> Reader<'a> {
    /// With force analysis where the calculation has one.
    pub(crate) fn new(calculation: &'a Calculation) -> Self {
        let (linkage, plan) = (&calculation.linkage, &calculation.plan);
        let forces = match (&calculation.loads, calculation.analyzer) {
            (Some(loads), Some(analyzer)) => Some(Forces {
                loads,
                analyzer,
                wrenches: vec![Wrench::ZERO; linkage.structure.links],
                reactions: Reactions::new(linkage).without_idle(&plan.groups_carrying),
                joints: Joints::of(linkage, &plan.wanted.reactions),
            }),
            _ => None,
        };
        Self { linkage, order: plan.order, forces, position: linkage.position() }
    }

    /// Solves the position at a coordinate, rad or m.
    pub(crate) fn solve(&mut self, coordinate: f64) -> Result<(), PositionError> {
        self.linkage.solve(coordinate, self.order, &mut self.position)
    }

    /// Solves the position at a coordinate up to PF2, even where the plan needs less.
    pub(crate) fn solve_second(&mut self, coordinate: f64) -> Result<(), PositionError> {
        self.linkage.solve(coordinate, Order::Second, &mut self.position)
    }

    /// Solves a position of the scene.
    pub(crate) fn solve_index(&mut self, index: usize) -> Result<(), PositionError> {
        self.linkage.solve_index(index, self.order, &mut self.position)
    }

    /// The balancing load in a state; `None` without force analysis.
    pub(crate) fn balancing(&mut self, state: &State) -> Option<Result<f64, ForceError>> {
        Some(self.forces.as_mut()?.solve(self.linkage, state, &self.position))
    }

    /// The position with its forces in a state, if they are `wanted`: at a change point the balancing load alone.
    pub(crate) fn forces(&mut self, state: &State, wanted: bool) -> (&Position, Determined<'_>) {
        let position = &self.position;
        let Some(forces) = self.forces.as_mut().filter(|_| wanted) else {
            return (position, Determined::Nothing);
        };
        if self.linkage.is_at_change_point(position) {
            return (position, Determined::Balancing(forces.balancing_alone(self.linkage, state, position)));
        }
        match forces.solve(self.linkage, state, position) {
            Err(error) => (position, Determined::Failed(error)),
            Ok(balancing) => {
                let Forces { joints, reactions, .. } = forces;
                joints.sum(reactions);
                (position, Determined::All { balancing, joints, reactions })
            }
        }
    }
}

/// What a force analysis determines in a position.
pub(crate) enum Determined<'a> {
    /// Nothing is requested.
    Nothing,
    /// At a change point, where the reactions are not determined but the powers of the loads are: the balancing load, by
    /// a method that finds it without reactions. `None` where there is no such method.
    Balancing(Option<f64>),
    /// Everything that the method gives.
    All {
        /// The balancing load, N m or N.
        balancing: f64,
        /// The forces of pins and slides.
        joints: &'a Joints,
        /// The reactions of the pairs.
        reactions: &'a Reactions,
    },
    /// Nothing, though it is requested.
    Failed(ForceError),
}

/// Scratch memory of the force analysis.
#[derive(Debug)]
struct Forces<'a> {
    loads: &'a Loads,
    analyzer: &'static AnalyzerPlugin,
    wrenches: Vec<Wrench<f64>>,
    reactions: Reactions,
    joints: Joints,
}

impl Forces<'_> {
    /// The balancing load; the reactions are kept.
    fn solve(&mut self, linkage: &Linkage, state: &State, position: &Position) -> Result<f64, ForceError> {
        self.loads.evaluate(state, &position.bodies, &mut self.wrenches);
        self.analyzer.instance.solve(linkage, position, &mut self.wrenches, &mut self.reactions)?;
        Ok(self.reactions.balancing)
    }

    fn balancing_alone(&self, linkage: &Linkage, state: &State, position: &Position) -> Option<f64> {
        let method = applicable(linkage).into_iter().find(|plugin| !plugin.gives_reactions)?;
        let mut wrenches = self.loads.total(state, &position.bodies);
        let mut found = Reactions::new(linkage);
        method.instance.solve(linkage, position, &mut wrenches, &mut found).ok()?;
        Some(found.balancing)
    }
}

/// Transfer functions of the links, points and slides that results show, in one position; angles in (-pi, pi].
#[derive(Debug, Default)]
pub(crate) struct Motions {
    pub(crate) links: Vec<ScalarMotion>,
    pub(crate) points: Vec<PointMotion>,
    pub(crate) slides: Vec<ScalarMotion>,
}

impl Motions {
    pub(crate) fn read(&mut self, linkage: &Linkage, wanted: &Wanted, position: &Position) {
        self.links.clear();
        self.links.extend(wanted.links.iter().map(|link| linkage.link_motion(*link, position)));
        self.points.clear();
        self.points.extend(wanted.points.iter().map(|(_, place)| linkage.place_motion(*place, position)));
        self.slides.clear();
        self.slides.extend(wanted.slides.iter().map(|slide| linkage.slide_motion(*slide, position)));
    }
}
