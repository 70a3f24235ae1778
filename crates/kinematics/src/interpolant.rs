//! The smooth motion across a change point, where the equations of the group are singular.
//!
//! At a change point J is singular although the motion is smooth: PF1 and PF2 have the form 0/0. Close to it, the
//! errors of the closed forms grow with the first, second and third power of the inverse distance. The motion is
//! therefore interpolated by a polynomial through nodes on both sides. The nodes are solved in 32 digits and so are
//! accurate to 16 digits although they are close to the change point. Each group whose modes meet has its own
//! interpolant; all other groups are solved by their own equations.

use std::f64::consts::{PI, TAU};

use assur_group::Body;
use assur_number::{Dd, Real, elementary, panel::shares};

use crate::wide::Solved;

/// All nodes are outside the interpolated interval, at most this many half-widths away. With rounded lengths the
/// change point is not exact, and the error from this grows towards it.
const SPREAD: f64 = 6.0;

/// Numbers of nodes on each side, in the order in which they are tried.
const NODES: [usize; 4] = [6, 10, 16, 24];

/// Greatest number of nodes, both sides together.
const MOST_NODES: usize = 48;

/// How often the width is halved if the motion changes too fast for the number of nodes.
const HALVINGS: usize = 9;

/// Distances from the change point, in half-widths, at which an interpolation is tested.
const TRIALS: [f64; 4] = [-0.98, -0.83, 0.79, 0.95];

/// Deviation at the test points that counts as rounding, relative to the largest number of its order.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Error of the closed forms of PF0, PF1, PF2 at the end of the interval, in units of eps divided by determinant to the
/// power 1, 2, 3: the interpolation need not be more accurate.
const LOST: f64 = 4.0 * f64::EPSILON;

/// 2 pi minus its nearest f64.
const TAU_REST: f64 = 2.449_293_598_294_706_4e-16;

/// The motion of the links of a group around a change point of its own.
#[derive(Debug, Clone)]
pub(crate) struct Interpolant {
    pub(crate) group: usize,
    links: Vec<usize>,
    /// The change point, in the turn closest to zero, and the remainder that its f64 leaves out.
    center: [f64; 2],
    /// Turns after which the motion repeats, for a pinned input.
    turns: Option<f64>,
    half_width: f64,
    nodes: Vec<Node>,
    /// |determinant| of the group at the end of the interval; it falls to zero linearly towards the change point.
    health_at_end: f64,
}

/// The interval around a change point in which the motion of a group is interpolated instead of solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interpolation {
    /// Index of the group.
    pub group: usize,
    /// The change point, rad or m, in the same turn as the given coordinate.
    pub center: f64,
    /// Half-width: how far the interval extends to each side, rad or m.
    pub half_width: f64,
    /// Number of nodes on each side of the change point.
    pub nodes: usize,
    /// Greatest magnification of the nodes' rounding, in the middle of the interval: the sum of the absolute weights
    /// there.
    pub gain: f64,
}

impl Interpolation {
    /// Greatest half-width, in units of the coordinate
    /// ([`Linkage::coordinate_unit`](crate::Linkage::coordinate_unit)): at greater distances PF2 by the closed forms
    /// keeps about 10 digits.
    pub const GREATEST_HALF_WIDTH: f64 = 0.0125;
}

/// The motion at one node.
#[derive(Debug, Clone)]
struct Node {
    /// Distance from the change point in half-widths.
    x: f64,
    /// Weight of the barycentric formula.
    weight: f64,
    /// One for each link of the group.
    bodies: Vec<Body<f64>>,
}

/// A change point and the group whose modes meet there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Site<'a> {
    /// The change point, rad or m.
    pub(crate) center: f64,
    pub(crate) group: usize,
    pub(crate) links: &'a [usize],
    /// Turns after which the motion repeats, for a pinned input.
    pub(crate) turns: Option<f64>,
}

impl Interpolant {
    /// Samples the motion around a change point of a group; `None` where it can't be solved beside it.
    ///
    /// `unit` is the unit of the coordinate, `solve` solves the group at a coordinate.
    pub(crate) fn sample(
        site: Site<'_>,
        unit: f64,
        mut solve: impl FnMut(Dd) -> Option<Solved>,
    ) -> Option<Self> {
        let mut half_width = Interpolation::GREATEST_HALF_WIDTH * unit;
        let mut best: Option<(f64, Self)> = None;
        for _ in 0..=HALVINGS {
            for count in NODES {
                let found = Self::through(count, site, half_width, &mut solve);
                let Some((found, miss)) = found.and_then(|found| found.miss(site.center, &mut solve)) else {
                    break;
                };
                if miss[0] <= ROUNDING {
                    return Some(found);
                }
                if best.as_ref().is_none_or(|(least, _)| miss[1] < *least) {
                    best = Some((miss[1], found));
                }
            }
            if best.as_ref().is_some_and(|(least, _)| *least <= 1.0) {
                break;
            }
            half_width *= 0.5;
        }
        best.map(|(_, found)| found)
    }

    /// Builds the interpolation with `count` nodes on each side, at the zeros of Chebyshev's polynomial in the
    /// squared distance.
    fn through(
        count: usize,
        Site { center, group, links, turns }: Site<'_>,
        half_width: f64,
        solve: &mut impl FnMut(Dd) -> Option<Solved>,
    ) -> Option<Self> {
        let node = |i: usize| {
            let (sine, cosine) = elementary::sin_cos(PI * ((i % count) as f64 + 0.5) / count as f64);
            let square = 0.5 * ((SPREAD * SPREAD + 1.0) + (SPREAD * SPREAD - 1.0) * cosine);
            let x = if i < count { square.sqrt() } else { -square.sqrt() };
            let (bodies, _) = solve(place(center, x * half_width))?;
            let sign = if (i % count).is_multiple_of(2) { 1.0 } else { -1.0 };
            Some(Node {
                x,
                weight: sign * sine / x,
                bodies: bodies.iter().map(|body| body.map(Real::to_f64)).collect(),
            })
        };
        let nodes = (0..2 * count).map(node).collect::<Option<Vec<_>>>()?;
        let (_, health) = solve(place(center, half_width))?;
        let passed = turns.map_or(0.0, |turns| turns * (center / (turns * TAU)).round());
        let center = [(-passed).mul_add(TAU, center), -passed * TAU_REST];
        let (links, health_at_end) = (links.to_vec(), health.to_f64().abs());
        Some(Self { group, links, center, turns, half_width, nodes, health_at_end })
    }

    /// Returns the interpolant with its largest deviation at the test points, relative to the largest number of its
    /// order, and relative to the error of the closed forms at the end of the interval.
    fn miss(self, center: f64, solve: &mut impl FnMut(Dd) -> Option<Solved>) -> Option<(Self, [f64; 2])> {
        let (mut sizes, mut misses) = ([1.0_f64; 3], [0.0_f64; 3]);
        for x in TRIALS {
            let (exact, _) = solve(place(center, x * self.half_width))?;
            let weights = self.weights(x);
            for (i, exact) in exact.iter().enumerate() {
                let found = self.blend(&weights, i).numbers();
                for (k, (exact, found)) in exact.numbers().into_iter().zip(found).enumerate() {
                    let order = [0, 0, 0, 0, 1, 1, 1, 2, 2, 2][k];
                    sizes[order] = sizes[order].max(exact.to_f64().abs());
                    misses[order] = misses[order].max((Dd::from_f64(found) - exact).to_f64().abs());
                }
            }
        }
        let least = self.health_at_end.min(1.0);
        let relative = [0, 1, 2].map(|order| misses[order] / sizes[order]);
        let lost = [1, 2, 3].map(|power| LOST / least.powi(power));
        let all = relative.iter().zip(lost).map(|(miss, lost)| miss / lost);
        let worst = [relative.iter().copied().fold(0.0, f64::max), all.fold(0.0, f64::max)];
        Some((self, worst))
    }

    /// Displacement from the change point to a coordinate, corrected for the rounding of 2 pi, which adds up over
    /// many turns.
    fn distance(&self, coordinate: f64) -> f64 {
        let [center, rest] = self.center;
        let Some(turns) = self.turns else { return coordinate - center };
        let passed = turns * ((coordinate - center) / (turns * TAU)).round();
        ((-passed).mul_add(TAU, coordinate) - center) - (passed * TAU_REST + rest)
    }

    /// Whether a coordinate is in the interpolated interval.
    pub(crate) fn covers(&self, coordinate: f64) -> bool {
        self.distance(coordinate).abs() < self.half_width
    }

    /// The interpolation that covers a coordinate, in the same turn.
    pub(crate) fn at(&self, coordinate: f64) -> Option<Interpolation> {
        let away = self.distance(coordinate);
        let gain = || self.weights(0.0).iter().map(|weight| weight.abs()).sum();
        (away.abs() < self.half_width).then(|| Interpolation {
            group: self.group,
            center: coordinate - away,
            half_width: self.half_width,
            nodes: self.nodes.len() / 2,
            gain: gain(),
        })
    }

    /// Sets the links of the group; returns its determinant.
    pub(crate) fn apply(&self, coordinate: f64, bodies: &mut [Body<f64>]) -> f64 {
        let x = self.distance(coordinate) / self.half_width;
        let weights = self.weights(x);
        for (i, &link) in self.links.iter().enumerate() {
            bodies[link] = self.blend(&weights, i);
        }
        // The determinant grows linearly with the distance from the meeting.
        x.abs() * self.health_at_end
    }

    /// Weight of each node at a distance of `x` half-widths.
    fn weights(&self, x: f64) -> [f64; MOST_NODES] {
        shares(x, self.nodes.iter().map(|node| (node.x, node.weight)))
    }

    fn blend(&self, weights: &[f64; MOST_NODES], body: usize) -> Body<f64> {
        let mut sum = [0.0; 10];
        for (weight, node) in weights.iter().zip(&self.nodes) {
            for (total, value) in sum.iter_mut().zip(node.bodies[body].numbers()) {
                *total += weight * value;
            }
        }
        let body = Body::of_numbers(sum);
        let length = elementary::hypot(body.c, body.s);
        Body { c: body.c / length, s: body.s / length, ..body }
    }
}

/// Sum of two numbers and its rounding error.
fn place(center: f64, offset: f64) -> Dd {
    Dd::from_f64(center) + Dd::from_f64(offset)
}
