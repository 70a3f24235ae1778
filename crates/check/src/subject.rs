//! What is checked: a linkage, and where there are loads their methods and states.

use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{AnalyzerPlugin, Loads, Reactions, State, applicable, choose};
use assur_group::{Order, Wrench};
use assur_kinematics::{Interpolation, Linkage, Position};

use crate::worst::Check;
use crate::{closure, forces, test_pf};

/// What is checked.
#[derive(Debug)]
pub struct Subject<'a> {
    /// The linkage.
    pub linkage: &'a Linkage,
    /// Its loads; `None`: only the transfer functions are checked.
    pub loads: Option<&'a Loads>,
    /// The state in each position of the scene. Positions without one are not checked for forces.
    pub states: Vec<State>,
    /// The methods. The first one that gives reactions is checked in full, all others against it.
    pub methods: Vec<AnalyzerPlugin>,
}

/// A solved position of the scene.
#[derive(Debug, Clone)]
pub(crate) struct Solved {
    pub(crate) index: usize,
    pub(crate) position: Position,
    /// The smallest determinant of a group, at least the rounding unit.
    pub(crate) health: f64,
    /// Sum of 1/determinant over the groups, at least 1: each adds its rounding, magnified by that.
    pub(crate) condition: f64,
}

/// Answer of one method in one position.
pub(crate) type Answer = Option<Reactions>;

/// The registered methods that can treat the linkage: the one called `first` (`None`: the preferred one), then all others
/// by name.
pub fn methods(linkage: &Linkage, first: Option<&str>) -> Vec<AnalyzerPlugin> {
    let first = choose(first).map_or("", |plugin| plugin.name);
    let mut all: Vec<_> = applicable(linkage).into_iter().copied().collect();
    all.sort_by_key(|method| method.name != first);
    all
}

/// Every check of a linkage under its prescribed motion, by all registered methods.
///
/// Loads that need a motion which the scene has not leave out the checks of forces.
pub fn checks(linkage: &Linkage) -> Vec<Check> {
    let loads = Loads::compile(linkage).ok();
    let input = &linkage.mechanism.input;
    let coordinates = (0..input.positions).map(|index| input.coordinate(index));
    let states = coordinates.map(|q| State::prescribed(&linkage.mechanism, q)).collect();
    Subject { linkage, loads: loads.as_ref(), states, methods: methods(linkage, None) }.checks()
}

impl Subject<'_> {
    /// Every check that applies, over all positions of the scene that can be solved.
    pub fn checks(&self) -> Vec<Check> {
        match self.checks_watched(&mut |_, _| ControlFlow::<Infallible>::Continue(())) {
            ControlFlow::Continue(all) => all,
            ControlFlow::Break(never) => match never {},
        }
    }

    /// The same; `tell` is called before each piece of work with how many are done and how many there are, and may stop it.
    pub fn checks_watched<B>(
        &self,
        tell: &mut impl FnMut(usize, usize) -> ControlFlow<B>,
    ) -> ControlFlow<B, Vec<Check>> {
        let solved = self.solved();
        let rounds = if self.loads.is_some() { 3 } else { 2 };
        let (mut done, total) = (0, rounds * solved.len());
        let mut step = || {
            done += 1;
            tell(done - 1, total)
        };
        let mut all = closure::checks(self, &solved, &mut step)?;
        all.extend(test_pf::checks(self, &solved, &mut step)?);
        if let Some(loads) = self.loads {
            all.extend(forces::checks(self, loads, &solved, &mut step)?);
        }
        ControlFlow::Continue(all)
    }

    fn solved(&self) -> Vec<Solved> {
        let mut position = self.linkage.position();
        let mut all = Vec::new();
        for index in 0..self.linkage.mechanism.input.positions {
            if self.linkage.solve_index(index, Order::Second, &mut position).is_ok() {
                let determinants = || position.health.iter().map(|health| health.abs().max(f64::EPSILON));
                let health = determinants().fold(1.0, f64::min);
                let condition = determinants().map(|health| 1.0 / health).sum::<f64>().max(1.0);
                all.push(Solved { index, position: position.clone(), health, condition });
            }
        }
        all
    }

    /// Unit of a transfer function of this order: a typical length (or 1 rad) per unit of the coordinate.
    pub(crate) fn unit(&self, order: usize, is_length: bool) -> f64 {
        let top = if is_length { self.linkage.structure.scale } else { 1.0 };
        let mut unit = top;
        (0..order).for_each(|_| unit /= self.linkage.coordinate_unit());
        unit
    }

    /// Whether a position lies on the bridge across a change point, or close to it.
    pub(crate) fn is_bridged(&self, solved: &Solved) -> bool {
        let distance = 2.0 * Interpolation::GREATEST_HALF_WIDTH * self.linkage.coordinate_unit();
        self.linkage.is_near_change_point(solved.position.coordinate, distance)
    }

    /// What multiplies rounding where a position is interpolated across a change point: there the determinant is only as
    /// large as the distance, PF0 loses digits with its inverse, PF1 with its square, PF2 with its cube.
    pub(crate) fn bridged(&self, solved: &Solved, order: usize) -> f64 {
        let mut factor = 1.0;
        if self.is_bridged(solved) {
            (0..=order).for_each(|_| factor /= Interpolation::GREATEST_HALF_WIDTH);
        }
        factor
    }

    /// The answer of each method in each position; none where it fails.
    pub(crate) fn answers(&self, loads: &Loads, one: &Solved) -> Vec<Answer> {
        let Some(state) = self.states.get(one.index) else { return vec![None; self.methods.len()] };
        let mut wrenches = vec![Wrench::ZERO; self.linkage.structure.links];
        let each = self.methods.iter().map(|method| {
            let mut reactions = Reactions::new(self.linkage);
            loads.apply(state, &one.position.bodies, &mut wrenches);
            loads.inertia(state, &one.position.bodies, &mut wrenches);
            let solved = method.instance.solve(self.linkage, &one.position, &mut wrenches, &mut reactions);
            solved.ok().map(|()| reactions)
        });
        each.collect()
    }
}
