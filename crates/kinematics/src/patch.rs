//! The smooth motion across a change point, where the equations of the group say nothing.
//!
//! At a change point J is singular though the motion goes through it smoothly: PF1 and PF2 are of the form 0/0, and
//! close to it the closed forms lose digits with the inverse of the distance, its square and its cube. The motion is
//! therefore interpolated there by a polynomial through nodes on both sides.

use assur_group::Body;

/// Nodes on each side.
const NODES: usize = 6;

/// Distance between nodes, rad (or parts of the scale for a sliding input): close enough that a polynomial of degree 11
/// is exact to some 1e-12, far enough that PF2 at the innermost node keeps about 10 digits.
const STEP: f64 = 0.0125;

/// All bodies around one change point.
#[derive(Debug, Clone)]
pub(crate) struct Patch {
    center: f64,
    period: Option<f64>,
    step: f64,
    /// Bodies at center - NODES step ... - step, + step ... + NODES step.
    nodes: Vec<Vec<Body<f64>>>,
}

/// Place of node `i` in steps from the center.
fn offset(i: usize) -> f64 {
    let i = i as f64 - NODES as f64;
    if i < 0.0 { i } else { i + 1.0 }
}

impl Patch {
    /// Samples the motion around a change point; `None` where a node can't be solved.
    pub(crate) fn sample(
        center: f64,
        period: Option<f64>,
        unit: f64,
        mut solve: impl FnMut(f64) -> Option<Vec<Body<f64>>>,
    ) -> Option<Self> {
        let step = STEP * unit;
        let nodes = (0..2 * NODES).map(|i| solve(center + offset(i) * step)).collect::<Option<Vec<_>>>()?;
        Some(Self { center, period, step, nodes })
    }

    fn distance(&self, coordinate: f64) -> f64 {
        let d = coordinate - self.center;
        match self.period {
            Some(period) => d - period * (d / period).round(),
            None => d,
        }
    }

    /// Whether the coordinate lies between the innermost nodes.
    pub(crate) fn covers(&self, coordinate: f64) -> bool {
        self.distance(coordinate).abs() < self.step
    }

    /// Writes all bodies but ground and input (body whose w1 is set already is overwritten by the same values).
    pub(crate) fn apply(&self, coordinate: f64, bodies: &mut [Body<f64>], health: &mut [f64]) {
        let x = self.distance(coordinate) / self.step;
        let weights = lagrange(x);
        for (i, body) in bodies.iter_mut().enumerate().skip(1) {
            *body = blend(&weights, |k| &self.nodes[k][i]);
        }
        // What is left of the determinant grows linearly from the change point.
        for value in health {
            *value = x.abs() * self.step;
        }
    }
}

/// Weights of Lagrange's polynomial through the nodes at `x` steps from the center.
fn lagrange(x: f64) -> [f64; 2 * NODES] {
    let mut weights = [1.0; 2 * NODES];
    for (i, weight) in weights.iter_mut().enumerate() {
        for k in 0..2 * NODES {
            if k != i {
                *weight *= (x - offset(k)) / (offset(i) - offset(k));
            }
        }
    }
    weights
}

fn blend<'a>(weights: &[f64; 2 * NODES], node: impl Fn(usize) -> &'a Body<f64>) -> Body<f64> {
    let mut sum = [0.0; 10];
    for (k, weight) in weights.iter().enumerate() {
        let b = node(k);
        let values = [b.x, b.y, b.c, b.s, b.x1, b.y1, b.w1, b.x2, b.y2, b.w2];
        for (total, value) in sum.iter_mut().zip(values) {
            *total += weight * value;
        }
    }
    let [x, y, c, s, x1, y1, w1, x2, y2, w2] = sum;
    let length = c.hypot(s);
    Body { x, y, c: c / length, s: s / length, x1, y1, w1, x2, y2, w2 }
}
