//! Extracts named results from a solved position, of the input or of a sample of a motion.

use std::collections::HashSet;
use std::sync::Arc;

use assur_force::{
    AnalyzerPlugin, ForceError, Joint, JointReaction, Loads, Reactions, State, applicable, joints,
};
use assur_group::{Order, Wrench};
use assur_kinematics::{Linkage, Position, PositionError};
use assur_mechanism::{Mechanism, PairId};

use crate::Calculation;
use crate::angles::Angles;
use crate::plan::Wanted;
use crate::results::{Named, PairReaction, PointMotion, Rates, ScalarMotion};

/// A force below this part of the greatest of the position has no meaningful line of action.
const LEAST_FORCE: f64 = 1e-9;

/// A position with the data needed to extract results; it is solved anew for each coordinate.
#[derive(Debug)]
pub(crate) struct Reader<'a> {
    linkage: &'a Linkage,
    order: Order,
    wanted: &'a Wanted,
    names: Names,
    angles: Angles,
    forces: Option<Forces<'a>>,
    /// The position that was solved last.
    pub(crate) position: Position,
}

/// Reactions (where the method gives them) and the balancing load.
pub(crate) type Found = (Option<Named<PairReaction>>, f64);

/// Transfer functions of links, points and slides.
pub(crate) struct Transfers {
    pub(crate) links: Named<ScalarMotion>,
    pub(crate) points: Named<PointMotion>,
    pub(crate) slides: Named<ScalarMotion>,
}

impl<'a> Reader<'a> {
    /// With force analysis where the calculation has one.
    pub(crate) fn new(calculation: &'a Calculation) -> Self {
        let (linkage, plan) = (&calculation.linkage, &calculation.plan);
        let forces = match (&calculation.loads, calculation.analyzer) {
            (Some(loads), Some(analyzer)) => Some(Forces {
                loads,
                analyzer,
                joints: joints(&linkage.mechanism, &linkage.structure),
                wrenches: vec![Wrench::ZERO; linkage.structure.links],
                reactions: Reactions::new(linkage).without_idle(&plan.groups_carrying),
            }),
            _ => None,
        };
        Self {
            linkage,
            order: plan.order,
            wanted: &plan.wanted,
            names: Names::of(&linkage.mechanism),
            angles: Angles::new(linkage),
            forces,
            position: linkage.position(),
        }
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

    /// Whether there is a force analysis.
    pub(crate) fn has_forces(&self) -> bool {
        self.forces.is_some()
    }

    /// Angles of the links, which continue those of the previously read position.
    pub(crate) fn links(&mut self) -> Named<ScalarMotion> {
        let angles = self.angles.follow(self.linkage, &self.position, &self.wanted.links);
        let each = self.wanted.links.iter().map(|&id| {
            let found = self.linkage.link_motion(id, &self.position);
            (Arc::clone(&self.names.links[id]), ScalarMotion { pf0: angles[id], ..found })
        });
        each.collect()
    }

    /// Transfer functions of links, points and slides.
    pub(crate) fn transfers(&mut self) -> Transfers {
        let links = self.links();
        let points = self.wanted.points.iter().map(|&(id, place)| {
            (Arc::clone(&self.names.points[id]), self.linkage.place_motion(place, &self.position))
        });
        let slides =
            self.wanted.slides.iter().map(|&id| {
                (Arc::clone(&self.names.slides[id]), self.linkage.slide_motion(id, &self.position))
            });
        Transfers { links, points: points.collect(), slides: slides.collect() }
    }

    /// The balancing load in a state; `None` without force analysis.
    pub(crate) fn balancing(&mut self, state: &State) -> Option<Result<f64, ForceError>> {
        Some(self.forces.as_mut()?.solve(self.linkage, state, &self.position))
    }

    /// The balancing load at a change point, where the reactions are not determined but the powers of the loads are: by
    /// a method that finds it without reactions. `None` where there is no such method.
    pub(crate) fn balancing_alone(&mut self, state: &State) -> Option<f64> {
        let method = applicable(self.linkage).into_iter().find(|plugin| !plugin.gives_reactions)?;
        let mut wrenches = self.forces.as_ref()?.loads.total(state, &self.position.bodies);
        let mut found = Reactions::new(self.linkage);
        method.instance.solve(self.linkage, &self.position, &mut wrenches, &mut found).ok()?;
        Some(found.balancing)
    }

    /// Reactions and balancing load in a state; `None` without force analysis.
    pub(crate) fn forces(&mut self, state: &State) -> Option<Result<Found, ForceError>> {
        let forces = self.forces.as_mut()?;
        Some(forces.solve(self.linkage, state, &self.position).map(|balancing| {
            let named = forces
                .analyzer
                .gives_reactions
                .then(|| forces.named(self.linkage, &self.position, self.wanted, &self.names));
            (named, balancing)
        }))
    }
}

impl Transfers {
    /// Velocities and accelerations: v = PF1 w, a = PF2 w² + PF1 e.
    pub(crate) fn rates(&self, state: &State) -> [Rates; 2] {
        let (speed, acceleration) = (state.speed, state.acceleration);
        [self.rate(|pf1, _| pf1 * speed), self.rate(|pf1, pf2| pf2 * speed * speed + pf1 * acceleration)]
    }

    fn rate(&self, rate: impl Fn(f64, f64) -> f64) -> Rates {
        let scalar = |motions: &Named<ScalarMotion>| {
            motions.0.iter().map(|(name, m)| (Arc::clone(name), rate(m.pf1, m.pf2))).collect()
        };
        let points = self
            .points
            .0
            .iter()
            .map(|(name, m)| (Arc::clone(name), [rate(m.pf1[0], m.pf2[0]), rate(m.pf1[1], m.pf2[1])]));
        Rates { links: scalar(&self.links), points: points.collect(), slides: scalar(&self.slides) }
    }
}

/// Scratch memory of the force analysis.
#[derive(Debug)]
struct Forces<'a> {
    loads: &'a Loads,
    analyzer: &'static AnalyzerPlugin,
    joints: Vec<Joint>,
    wrenches: Vec<Wrench<f64>>,
    reactions: Reactions,
}

impl Forces<'_> {
    /// The balancing load; the reactions are kept.
    fn solve(&mut self, linkage: &Linkage, state: &State, position: &Position) -> Result<f64, ForceError> {
        self.loads.evaluate(state, &position.bodies, &mut self.wrenches);
        self.analyzer.instance.solve(linkage, position, &mut self.wrenches, &mut self.reactions)?;
        Ok(self.reactions.balancing)
    }

    fn named(
        &self,
        linkage: &Linkage,
        position: &Position,
        wanted: &Wanted,
        names: &Names,
    ) -> Named<PairReaction> {
        let found = self.joints.iter().map(|joint| joint.reaction(&self.reactions.pairs));
        let joints: Vec<_> = found.collect();
        let each = joints.iter().flat_map(|joint| &joint.forces);
        let greatest = each.map(|(_, force)| force[0].hypot(force[1])).fold(0.0, f64::max);
        let reactions: HashSet<PairId> = wanted.reactions.iter().copied().collect();
        let asked_for = joints.iter().filter(|joint| reactions.contains(&joint.joint));
        asked_for
            .map(|joint| {
                let forces =
                    joint.forces.iter().map(|(link, force)| (Arc::clone(&names.links[*link]), *force));
                let reaction = PairReaction {
                    forces: forces.collect(),
                    moment: joint.moment,
                    offset: offset(linkage, joint, position, LEAST_FORCE * greatest),
                };
                (names.pair(joint.joint), reaction)
            })
            .collect()
    }
}

/// Where along the guide the force alone is equivalent: moment = offset times the force along the normal.
fn offset(linkage: &Linkage, joint: &JointReaction, position: &Position, least: f64) -> Option<f64> {
    let (PairId::Slide(id), Some(moment), Some((_, force))) =
        (joint.joint, joint.moment, joint.forces.first())
    else {
        return None;
    };
    let slide = &linkage.mechanism.slides[id];
    let (s, c) = slide.angle.sin_cos();
    let along = position.bodies[slide.on].turned([c, s]);
    let normal = along[0] * force[1] - along[1] * force[0];
    (normal.abs() > least).then(|| moment / normal)
}

/// Names of links, points and slides by index, created once and shared by all results.
#[derive(Debug)]
struct Names {
    links: Vec<Arc<str>>,
    points: Vec<Arc<str>>,
    slides: Vec<Arc<str>>,
}

impl Names {
    fn of(mechanism: &Mechanism) -> Self {
        Self {
            links: mechanism.links.iter().map(|link| link.name.as_str().into()).collect(),
            points: mechanism.points.iter().map(|point| point.name.as_str().into()).collect(),
            slides: mechanism.slides.iter().map(|slide| slide.name.as_str().into()).collect(),
        }
    }

    fn pair(&self, pair: PairId) -> Arc<str> {
        match pair {
            PairId::Pin(point) => Arc::clone(&self.points[point]),
            PairId::Slide(slide) => Arc::clone(&self.slides[slide]),
        }
    }
}
