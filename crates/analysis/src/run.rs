//! Position after position.

use std::convert::Infallible;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::results::{Analysis, Failure, InputReport, Named, PositionResult, Reduced};
use assur_group::Order;
use assur_kinematics::{Linkage, Position, PositionError};
use assur_mechanism::Balance;

use crate::Progress;
use crate::Study;
use crate::angles::Angles;
use crate::forces::Forces;
use crate::names::Names;
use crate::{motions, structure};

impl Study {
    /// The positions that can't be assembled; nothing else is calculated.
    pub fn failures(&self) -> Vec<Failure> {
        let mut position = self.linkage.position();
        let indices = 0..self.linkage.mechanism.input.positions;
        let failed = indices.filter_map(|index| {
            let error = self.linkage.solve_index(index, Order::Place, &mut position).err()?;
            Some(Failure { index, coordinate: error.coordinate, message: error.to_string() })
        });
        failed.collect()
    }

    /// [`analyze`](Self::analyze), with [`checks`](Self::checks) of the numbers.
    pub fn analyze_and_check(&self) -> Analysis {
        Analysis { checks: self.checks(), ..self.analyze() }
    }

    /// Calculates everything that the scene asks for, without checks. A position without a solution is told among the failures, with what
    /// could still be calculated there.
    pub fn analyze(&self) -> Analysis {
        match self.analyze_watched(&mut |_| ControlFlow::<Infallible>::Continue(())) {
            ControlFlow::Continue(analysis) => analysis,
            ControlFlow::Break(never) => match never {},
        }
    }

    /// The same; `watch` is told how far it is, and may stop it.
    pub fn analyze_watched<B>(
        &self,
        watch: &mut impl FnMut(Progress) -> ControlFlow<B>,
    ) -> ControlFlow<B, Analysis> {
        let mechanism = &self.linkage.mechanism;
        let mut run = Run::new(self);
        let total = mechanism.input.positions;
        for index in 0..total {
            watch(Progress::Positions { done: index, total })?;
            run.position(index);
        }
        let (trajectory, lost) = self.trajectory(watch)?;
        ControlFlow::Continue(Analysis {
            format: Analysis::FORMAT,
            title: mechanism.title.clone(),
            input: InputReport {
                link: mechanism.links[mechanism.input.link].name.clone(),
                angular: self.linkage.angular(),
                balancing_is_moment: match mechanism.balance {
                    Some(balance) => matches!(balance, Balance::Moment(_)),
                    None => self.linkage.angular(),
                },
            },
            structure: structure::report(&self.linkage, !self.plan.is_partial()),
            cycle: self.cycle(&run.positions),
            positions: run.positions,
            failures: run.failures,
            trajectory,
            dynamics: self.dynamics(),
            integration: self.integration(),
            no_motion: self.no_motion.clone(),
            notes: self.notes(&run.lost, &lost),
            checks: Vec::new(),
        })
    }
}

/// One run over the positions.
struct Run<'a> {
    study: &'a Study,
    names: Names,
    groups: Vec<Arc<str>>,
    angles: Angles,
    forces: Option<Forces<'a>>,
    position: Position,
    positions: Vec<PositionResult>,
    failures: Vec<Failure>,
    /// Positions at a change point, where forces are not determined.
    lost: Vec<usize>,
}

impl<'a> Run<'a> {
    fn new(study: &'a Study) -> Self {
        let linkage = &study.linkage;
        let forces = match (&study.loads, study.analyzer) {
            (Some(loads), Some(analyzer)) => {
                Some(Forces::new(linkage, loads, analyzer, &study.plan.groups_carrying))
            }
            _ => None,
        };
        Self {
            study,
            names: Names::of(&linkage.mechanism),
            groups: (0..linkage.structure.groups.len()).map(|index| index.to_string().into()).collect(),
            angles: Angles::new(linkage),
            forces,
            position: linkage.position(),
            positions: Vec::with_capacity(linkage.mechanism.input.positions),
            failures: Vec::new(),
            lost: Vec::new(),
        }
    }

    fn position(&mut self, index: usize) {
        let linkage = &self.study.linkage;
        if let Err(error) = linkage.solve_index(index, self.study.plan.order, &mut self.position) {
            self.fail(index, error.coordinate, &error);
            return;
        }
        let mut result = self.motion(linkage, index);
        let state = self.study.state(self.position.coordinate);
        if let (true, Some(loads)) = (self.study.plan.reduction, &self.study.loads) {
            let found = loads.reduced(&state, &self.position.bodies);
            result.reduced = Some(Reduced {
                inertia: found.inertia,
                inertia_derivative: found.inertia_derivative,
                moment: found.moment,
            });
        }
        let lost = linkage.is_at_change_point(&self.position);
        if let (Some(forces), true) = (&mut self.forces, self.study.positions_have_forces()) {
            if lost {
                self.lost.push(index);
                self.positions.push(result);
                return;
            }
            match forces.solve(&state, &self.position, &self.study.plan.wanted, &self.names) {
                Ok((reactions, balancing)) => {
                    result.reactions = reactions;
                    result.balancing = Some(balancing);
                }
                Err(error) => {
                    let message = format!("position {index}: {error}");
                    self.failures.push(Failure { index, coordinate: result.coordinate, message });
                }
            }
        }
        self.positions.push(result);
    }

    fn fail(&mut self, index: usize, coordinate: f64, error: &PositionError) {
        self.failures.push(Failure { index, coordinate, message: error.to_string() });
    }

    /// Places, transfer functions, rates and condition.
    fn motion(&mut self, linkage: &Linkage, index: usize) -> PositionResult {
        let (plan, position) = (&self.study.plan, &self.position);
        let angles = self.angles.follow(linkage, position, &plan.wanted.links);
        let links = motions::links(linkage, &plan.wanted, &self.names, position, angles);
        let points = motions::points(linkage, &plan.wanted, &self.names, position);
        let slides = motions::slides(linkage, &plan.wanted, &self.names, position);
        let moves = self.study.course.moves(&linkage.mechanism);
        let state = self.study.state(position.coordinate);
        let rates = |second| {
            let all = (&links, &points, &slides);
            (moves && plan.velocities).then(|| motions::rates(all, state.speed, state.acceleration, second))
        };
        PositionResult {
            index,
            coordinate: position.coordinate,
            speed: moves.then_some(state.speed),
            acceleration: moves.then_some(state.acceleration),
            velocities: rates(false),
            accelerations: rates(true),
            reduced: None,
            reactions: None,
            balancing: None,
            by_cause: None,
            condition: self.condition(),
            links,
            points,
            slides,
        }
    }

    /// 1 / |health| of the groups that are solved; a group in a singular position has none that is a number.
    fn condition(&self) -> Named<f64> {
        let healths = self.groups.iter().zip(&self.position.health).zip(&self.study.plan.groups_needed);
        healths
            .filter(|((_, health), needed)| **needed && health.abs() > f64::MIN_POSITIVE)
            .map(|((name, health), _)| (Arc::clone(name), 1.0 / health.abs()))
            .collect()
    }
}
