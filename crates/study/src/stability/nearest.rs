//! The mechanism over its own cycle: the least health of each group, and the transmission angle there.

use assur_group::Order;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::Range;
use assur_number::search;
use assur_words::{Describe, Text, number, text};
use serde::Serialize;

/// Number of coordinates that are tried over the cycle before the search is refined.
pub(crate) const SAMPLES: usize = 720;

/// Steps of the search between two of them: down to rounding.
const SECTIONS: usize = 80;

/// Number of groups, those of least health, whose minimum is refined between the samples: each costs as many solutions
/// of the whole mechanism.
const MOST_REFINED: usize = 60;

/// How near a group comes to a singular position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupHealth {
    /// `group 1 (RRR rod, rocker)`.
    #[serde(rename = "where")]
    pub place: Text,
    /// Least dimensionless determinant over the cycle.
    pub health: f64,
    /// Where, rad or m.
    pub coordinate: f64,
    /// Number of the scene's position that is nearest.
    pub position: usize,
    /// What the angle is.
    pub angle_of: Text,
    /// Worst value of that angle over the cycle, rad.
    pub angle: f64,
    /// Whether two assembly modes meet there: a change point, through which the motion passes.
    pub change_point: bool,
}

impl GroupHealth {
    /// What the least health means, as a sentence.
    pub(crate) fn words(&self) -> Text {
        if self.change_point {
            return text!("stability-through-change-point", group = &self.place);
        }
        let digits = (-(f64::EPSILON / self.health.max(1e-8).powi(2)).log10()).clamp(0.0, 16.0);
        text!(
            "stability-closest",
            group = &self.place,
            health = number(format_args!("{:.3e}", self.health)),
            digits = number(format_args!("{digits:.0}"))
        )
    }
}

/// Coordinates over the range of the scene, both ends included, between which minima are sought.
pub(crate) struct Grid {
    pub(crate) coordinates: Vec<f64>,
    is_cycle: bool,
}

impl Grid {
    /// [`SAMPLES`] parts of the range of the scene, every so many together.
    pub(crate) fn of(linkage: &Linkage, stride: usize) -> Self {
        let input = &linkage.mechanism.input;
        let (length, is_cycle) = match input.range {
            Range::Cycle(cycle) => (input.sign() * cycle, true),
            Range::To(to) => (to - input.from, false),
        };
        let at = |i: usize| input.from + length * (i as f64) / (SAMPLES as f64);
        Self { coordinates: (0..=SAMPLES).step_by(stride).map(at).collect(), is_cycle }
    }

    /// The coordinates before and after that of index `i`, with the value of a function there. A cycle goes on beyond its ends; a
    /// range does not, and the function is infinite there.
    pub(crate) fn around(&self, i: usize, value: impl Fn(usize) -> f64) -> [(f64, f64); 2] {
        let (q, last) = (&self.coordinates, self.coordinates.len() - 1);
        let beyond = |end: f64, inner: usize, way: f64| {
            if self.is_cycle { (end + way, value(inner)) } else { (end, f64::INFINITY) }
        };
        let before = if i == 0 { beyond(q[0], last - 1, q[0] - q[1]) } else { (q[i - 1], value(i - 1)) };
        let after = if i == last { beyond(q[last], 1, q[1] - q[0]) } else { (q[i + 1], value(i + 1)) };
        [before, after]
    }
}

/// Where the health of each group is least.
///
/// # Errors
///
/// Why the first position that can't be assembled has no assembly.
pub(crate) fn nearest(linkage: &Linkage) -> Result<Vec<GroupHealth>, Text> {
    let grid = Grid::of(linkage, 1);
    let mut position = linkage.position();
    let mut least: Vec<(f64, usize)> = vec![(f64::INFINITY, 0); linkage.groups().len()];
    for (i, &q) in grid.coordinates.iter().enumerate() {
        linkage.solve(q, Order::Place, &mut position).map_err(|error| error.describe())?;
        for (least, health) in least.iter_mut().zip(&position.health) {
            if health.abs() < least.0 {
                *least = (health.abs(), i);
            }
        }
    }
    let mut worst: Vec<usize> = (0..least.len()).collect();
    worst.sort_by(|&a, &b| least[a].0.total_cmp(&least[b].0));
    let mut places: Vec<f64> = least.iter().map(|(_, at)| grid.coordinates[*at]).collect();
    for &group in worst.iter().take(MOST_REFINED) {
        let (health, at) = least[group];
        let [(low, _), (high, _)] = grid.around(at, |_| 0.0);
        let found = search::least(low, high, SECTIONS, |q| {
            linkage
                .solve(q, Order::Place, &mut position)
                .map_or(f64::INFINITY, |()| position.health[group].abs())
        });
        if found.1 < health {
            // One before the first coordinate is at the end of the cycle.
            let (q, length) = (found.0, grid.coordinates[SAMPLES] - grid.coordinates[0]);
            places[group] = if (q - grid.coordinates[0]) * length < 0.0 { q + length } else { q };
        }
    }
    (0..places.len()).map(|group| at(linkage, group, places[group], &mut position)).collect()
}

fn at(linkage: &Linkage, group: usize, q: f64, position: &mut Position) -> Result<GroupHealth, Text> {
    linkage.solve(q, Order::Place, position).map_err(|error| error.describe())?;
    let input = &linkage.mechanism.input;
    let away = |index: &usize| (input.coordinate(*index) - q).abs();
    let position_near = (0..input.positions).min_by(|a, b| away(a).total_cmp(&away(b)));
    let found = &linkage.structure.groups[group];
    let health = position.health[group].abs();
    let force_angle = &found.plugin.force_angle;
    Ok(GroupHealth {
        place: linkage.structure.group_name(&linkage.mechanism, group),
        health,
        coordinate: q,
        position: position_near.unwrap_or(0),
        angle_of: force_angle.words.clone(),
        angle: (force_angle.of)(&found.frame, &position.bodies, health),
        change_point: linkage.is_interpolated(q),
    })
}
