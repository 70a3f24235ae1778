//! The interpolants of all change points of a mechanism.

use assur_group::{Body, Order};
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::interpolant::{Interpolant, Interpolation, Site};
use crate::wide::{Assembly, Wide};
use crate::{poses::Guesses, ways::Ways};

#[derive(Debug, Clone, Default)]
pub(crate) struct Interpolants {
    /// By group.
    all: Vec<Interpolant>,
    /// The change points reduced to one period, in increasing order.
    centers: Vec<f64>,
    /// Length after which the motion repeats, for a pinned input.
    period: Option<f64>,
    /// Distance from a change point beyond which nothing is interpolated.
    reach: f64,
}

impl Interpolants {
    /// One for each group around each of its change points, where the neighborhood can be solved.
    pub(crate) fn of(
        structure: &Structure,
        unit: f64,
        wide: &mut Wide<'_>,
        assembled: (&Ways, Option<&Guesses>),
    ) -> Self {
        let ways = assembled.0;
        if ways.change_points().next().is_none() || !wide.is_available() {
            return Self::default();
        }
        wide.restart(Order::Second);
        let turns = ways.period.map(|period| period / std::f64::consts::TAU);
        let mut all: Vec<_> = ways
            .change_points()
            .filter_map(|point| {
                let (center, group) = (point.coordinate, point.group);
                let links = &structure.groups[group].frame.links;
                let solve = |q: Dd| {
                    let way = assembled.way(group, q.to_f64());
                    wide.solve(q, (group, way), &assembled).ok()
                };
                Interpolant::sample(Site { center, group, links, turns }, unit, solve)
            })
            .collect();
        all.sort_by_key(|interpolant| interpolant.group);
        let period = ways.period;
        let mut centers: Vec<f64> =
            ways.change_points().map(|point| reduced(point.coordinate, period)).collect();
        centers.sort_by(f64::total_cmp);
        // Twice the greatest half-width: more than rounding of whole turns makes of the distance.
        Self { all, centers, period, reach: 2.0 * Interpolation::GREATEST_HALF_WIDTH * unit }
    }

    /// Whether the motion of a group is interpolated at a coordinate.
    #[inline]
    pub(crate) fn cover(&self, coordinate: f64) -> bool {
        self.is_near(coordinate) && self.all.iter().any(|interpolant| interpolant.covers(coordinate))
    }

    /// Whether a change point is so near that an interpolation may cover the coordinate; in a time that grows with the
    /// logarithm of their number.
    fn is_near(&self, coordinate: f64) -> bool {
        let (Some(first), Some(last)) = (self.centers.first(), self.centers.last()) else { return false };
        let at = reduced(coordinate, self.period);
        let next = self.centers.partition_point(|center| *center < at);
        let length = self.period.unwrap_or(f64::INFINITY);
        let above = self.centers.get(next).map_or(first + length - at, |center| center - at);
        let below = next.checked_sub(1).map_or(at - (last - length), |before| at - self.centers[before]);
        above.min(below) <= self.reach
    }

    /// The widest interpolation that covers a coordinate.
    pub(crate) fn widest(&self, coordinate: f64) -> Option<Interpolation> {
        let found = self.all.iter().filter_map(|interpolant| interpolant.at(coordinate));
        found.max_by(|a, b| a.half_width.total_cmp(&b.half_width))
    }

    /// Sets the links of a group whose motion is interpolated at a coordinate, and returns its determinant.
    pub(crate) fn apply(&self, group: usize, coordinate: f64, bodies: &mut [Body<f64>]) -> Option<f64> {
        let mut own = self.all.iter().filter(|one| one.group == group);
        own.find(|one| one.covers(coordinate)).map(|found| found.apply(coordinate, bodies))
    }

    /// Whether the motion of a group with this determinant is interpolated at a coordinate.
    pub(crate) fn cover_unhealthy(&self, coordinate: f64, health: &[f64], limit: f64) -> bool {
        self.all.iter().any(|found| health[found.group].abs() < limit && found.covers(coordinate))
    }
}

/// The assembly after it was followed over the whole range.
impl Assembly for (&Ways, Option<&Guesses>) {
    fn way(&self, group: usize, coordinate: f64) -> u8 {
        self.0.at(coordinate)[group]
    }

    fn guess(&self, coordinate: f64, bodies: &mut [Body<f64>]) {
        if let Some(guesses) = self.1 {
            guesses.put(coordinate, bodies);
        }
    }
}

/// A coordinate reduced to the first period.
fn reduced(coordinate: f64, period: Option<f64>) -> f64 {
    period.map_or(coordinate, |period| coordinate.rem_euclid(period))
}
