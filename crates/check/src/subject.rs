//! What is checked: a linkage, and where there are loads the states and methods.

use std::sync::Arc;

use assur_force::{AnalyzerPlugin, LoadState, Loads, Reactions, applicable, choose};
use assur_group::Order;
use assur_kinematics::{Interpolation, Linkage, Position};

use crate::Chosen;

/// What is checked.
pub struct Subject<'a> {
    /// The linkage.
    pub linkage: &'a Linkage,
    /// Its loads; `None`: only the transfer functions are checked.
    pub loads: Option<&'a Loads>,
    /// The positions of the scene in which the transfer functions are checked.
    pub positions: Chosen,
    /// The states in which forces are checked, by the numbers to report: those of positions of the scene, or of samples
    /// of a trajectory.
    pub states: Chosen,
    /// The state of such a number; `None` where forces are not determined.
    pub state: &'a (dyn Fn(usize) -> Option<LoadState> + Sync),
    /// The load on the input in a state, by the motion that was found; `None` where the motion is prescribed, so that the
    /// balancing load has nothing to agree with.
    pub drive: Option<&'a (dyn Fn(&LoadState) -> InputLoad + Sync)>,
    /// The methods. All checks use the first one that gives reactions; the others are compared with it.
    pub methods: Vec<AnalyzerPlugin>,
}

/// The load of drive, flywheel and rotor on the input in a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InputLoad {
    /// Moment, N m (force, N), positive along the coordinate.
    pub value: f64,
    /// How far it may be off: by rounding, and since the motion is known with a limited accuracy only, N m (N).
    pub error: f64,
    /// How far the motion may be off, rad (m) and s.
    pub accuracy: [f64; 2],
}

/// A solved position.
#[derive(Debug, Clone)]
pub(crate) struct Solved {
    /// The number to report.
    pub(crate) index: usize,
    pub(crate) position: Position,
    /// The smallest determinant of a group, at least the rounding unit.
    pub(crate) health: f64,
    /// Sum of 1/determinant over the groups, at least 1, times the [reach](Subject::reach): each group adds the rounding of
    /// its places, magnified by this factor.
    pub(crate) condition: f64,
}

/// The registered methods that support the linkage: the one called `first` (`None`: the preferred one), then all others
/// by name.
pub fn methods(linkage: &Linkage, first: Option<&str>) -> Vec<AnalyzerPlugin> {
    let first = choose(first, !linkage.mechanism.frictions.is_empty(), !linkage.structure.passive.is_empty())
        .map_or("", |plugin| plugin.name);
    let mut all: Vec<_> = applicable(linkage).into_iter().cloned().collect();
    all.sort_by_key(|method| method.name != first);
    all
}

impl Subject<'_> {
    /// The position at a coordinate; `None` where there is none.
    pub(crate) fn solve(&self, index: usize, coordinate: f64) -> Option<Solved> {
        let mut position = self.linkage.position();
        self.linkage.solve(coordinate, Order::Second, &mut position).ok()?;
        let determinants = || position.health.iter().map(|health| health.abs().max(f64::EPSILON));
        let health = determinants().fold(1.0, f64::min);
        let condition = self.reach() * determinants().map(|health| 1.0 / health).sum::<f64>().max(1.0);
        Some(Solved { index, position, health, condition })
    }

    /// How far the joints are from the origins of their links, in sizes of the mechanism, at least 1: everything follows from
    /// differences of places, which are rounded by that distance.
    pub(crate) fn reach(&self) -> f64 {
        let structure = &self.linkage.structure;
        let places = structure.pairs.iter().flat_map(|named| named.pair.places());
        places.map(|(_, at)| at[0].hypot(at[1]) / structure.scale).fold(1.0, f64::max)
    }

    /// How far the joints of the mechanism are from the origins, over the least distance of two joints of the link that do not
    /// coincide, from whose places its direction follows; at least 1.
    pub(crate) fn spread(&self, link: usize) -> f64 {
        let structure = &self.linkage.structure;
        let ends = structure.pairs.iter().flat_map(|named| named.pair.places());
        let places: Vec<_> = ends.filter(|(body, _)| *body == link).map(|(_, at)| at).collect();
        let distances = places.iter().flat_map(|a| places.iter().map(|b| (a[0] - b[0]).hypot(a[1] - b[1])));
        let least = distances.filter(|distance| *distance > 0.0).fold(f64::INFINITY, f64::min);
        (self.reach() * structure.scale / least).max(1.0)
    }

    /// Unit of a transfer function of this order: a typical length (or 1 rad) per unit of the coordinate.
    pub(crate) fn unit(&self, order: usize, is_length: bool) -> f64 {
        let top = if is_length { self.linkage.structure.scale } else { 1.0 };
        (0..order).fold(top, |unit, _| unit / self.linkage.coordinate_unit())
    }

    /// Whether the motion is interpolated across a change point at a position, or close to it.
    pub(crate) fn is_interpolated(&self, solved: &Solved) -> bool {
        let distance = 2.0 * Interpolation::GREATEST_HALF_WIDTH * self.linkage.coordinate_unit();
        self.linkage.is_near_change_point(solved.position.coordinate, distance)
    }

    /// Factor of rounding: 1, except where a position is interpolated across a change point. There the determinant is
    /// only as large as the distance; PF0 loses digits with its inverse, PF1 with its square, PF2 with its cube.
    pub(crate) fn lost_by_interpolation(&self, solved: &Solved, order: usize) -> f64 {
        let orders = if self.is_interpolated(solved) { order + 1 } else { 0 };
        (0..orders).fold(1.0, |factor, _| factor / Interpolation::GREATEST_HALF_WIDTH)
    }

    /// The result of a method under the loads of a state, with all coefficients of friction times `part`; `None` where it fails.
    pub(crate) fn answer(
        &self,
        method: &AnalyzerPlugin,
        loads: &Loads,
        state: &LoadState,
        position: &Position,
        part: f64,
    ) -> Option<Reactions> {
        let mut wrenches = loads.total(state, &position.bodies);
        let mut reactions = Reactions::new(self.linkage).with_friction(loads, self.linkage);
        if let Some(friction) = &mut reactions.friction {
            loads.senses(state, &position.bodies, &mut friction.senses);
            friction.drive = state.drive;
            if part < 1.0 {
                for bearing in &mut Arc::make_mut(&mut friction.frictions).bearings {
                    bearing.coefficient *= part;
                }
            }
        }
        assur_force::solve_by(method.instance, self.linkage, position, &mut wrenches, &mut reactions).ok()?;
        Some(reactions)
    }
}
