//! The mechanism over its own cycle: least health of each group, and the angles that forces pass through.

use assur_group::Order;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::Range;
use serde::Serialize;

/// Coordinates that are tried over the cycle before the search is refined.
const SAMPLES: usize = 720;

/// How near a group comes to a singular position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupHealth {
    /// `group 1 (RRR rod, rocker)`.
    #[serde(rename = "where")]
    pub place: String,
    /// Least dimensionless determinant over the cycle.
    pub health: f64,
    /// Where, rad or m.
    pub coordinate: f64,
    /// Number of the scene's position that is nearest.
    pub position: usize,
    /// What the angle is.
    pub angle_of: &'static str,
    /// Worst value of that angle over the cycle, rad.
    pub angle: f64,
    /// Whether two ways of assembly meet there: a change point, which the motion goes through.
    pub change_point: bool,
}

impl GroupHealth {
    /// What the least health means, as a sentence.
    pub(crate) fn words(&self) -> String {
        if self.change_point {
            return format!(
                "{} goes through a change point: its motion is continued smoothly, its reactions are not determined there.",
                self.place
            );
        }
        let digits = (-(f64::EPSILON / self.health.max(1e-8).powi(2)).log10()).clamp(0.0, 16.0);
        format!(
            "{} comes closest to a singular position (health {:.3e}): about {digits:.0} digits are left there of \
             velocities and reactions.",
            self.place, self.health
        )
    }
}

/// Coordinates over what the scene asks for, both ends included.
pub(crate) fn coordinates(linkage: &Linkage) -> Vec<f64> {
    let input = &linkage.mechanism.input;
    let length = match input.range {
        Range::Cycle(cycle) => input.sign() * cycle,
        Range::To(to) => to - input.from,
    };
    (0..=SAMPLES).map(|i| input.from + length * (i as f64) / (SAMPLES as f64)).collect()
}

/// The coordinate of the cycle at which the least health of all groups is greatest; `None` where nothing assembles.
pub(crate) fn healthiest(linkage: &Linkage) -> Option<f64> {
    let mut position = linkage.position();
    let mut least = |q: f64| {
        linkage.solve(q, Order::Place, &mut position).ok()?;
        let health = position.health.iter().fold(1.0_f64, |least, health| least.min(health.abs()));
        (!linkage.is_interpolated(q)).then_some((q, health))
    };
    let all = coordinates(linkage).into_iter().filter_map(&mut least);
    all.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(q, _)| q)
}

/// The least health of each group.
///
/// # Errors
///
/// What is told of the first position that does not assemble.
pub(crate) fn healths(linkage: &Linkage) -> Result<Vec<GroupHealth>, String> {
    let grid = coordinates(linkage);
    let mut position = linkage.position();
    let mut least: Vec<(f64, usize)> = vec![(f64::INFINITY, 0); linkage.groups().len()];
    for (i, &q) in grid.iter().enumerate() {
        linkage.solve(q, Order::Place, &mut position).map_err(|error| error.to_string())?;
        for (least, health) in least.iter_mut().zip(&position.health) {
            if health.abs() < least.0 {
                *least = (health.abs(), i);
            }
        }
    }
    (0..least.len()).map(|group| refined(linkage, group, least[group].1, &grid, &mut position)).collect()
}

/// Golden-section search between the neighbors of the best sample.
fn refined(
    linkage: &Linkage,
    group: usize,
    at: usize,
    grid: &[f64],
    position: &mut Position,
) -> Result<GroupHealth, String> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let health = |q: f64, position: &mut Position| match linkage.solve(q, Order::Place, position) {
        Ok(()) => position.health[group].abs(),
        Err(_) => f64::INFINITY,
    };
    let (mut low, mut high) = (grid[at.saturating_sub(1)], grid[(at + 1).min(grid.len() - 1)]);
    for _ in 0..80 {
        let (a, b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        if health(a, position) < health(b, position) { high = b } else { low = a }
    }
    let candidates = [grid[at], 0.5 * (low + high), low, high];
    let mut best = grid[at];
    for q in candidates {
        if health(q, position) < health(best, position) {
            best = q;
        }
    }
    linkage.solve(best, Order::Place, position).map_err(|error| error.to_string())?;
    let input = &linkage.mechanism.input;
    let nearest = (0..input.positions)
        .min_by(|&a, &b| (input.coordinate(a) - best).abs().total_cmp(&(input.coordinate(b) - best).abs()));
    let found = &linkage.structure.groups[group];
    let health = position.health[group].abs();
    let force_angle = &found.plugin.force_angle;
    Ok(GroupHealth {
        place: linkage.structure.group_name(&linkage.mechanism, group),
        health,
        coordinate: best,
        position: nearest.unwrap_or(0),
        angle_of: force_angle.words,
        angle: (force_angle.of)(&found.frame, &position.bodies, health),
        change_point: linkage.is_interpolated(best),
    })
}
