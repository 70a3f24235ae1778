//! The least maximum of the moduli of forces that depend linearly on a few unknowns.
//!
//! The problem is convex: find u and the least t with `|F_i + B_i u| <= t`. It is solved by the logarithmic barrier of
//! second-order cones (Boyd, Vandenberghe, Convex Optimization, section 11.6): Newton's method makes
//! `weight t - sum log(t² - |F_i + B_i u|²)` least, for a weight that grows until its share of the result is rounding.

use nalgebra::{DMatrix, DVector};

/// Relative distance from the least maximum at which the search ends.
const GAP: f64 = 1e-10;

/// Factor between weights.
const GROWTH: f64 = 8.0;

/// Greatest number of Newton steps for one weight; about ten are needed.
const MOST_STEPS: usize = 60;

/// Square of Newton's decrement at which the least point of a weight is found.
const CENTERED: f64 = 1e-9;

/// The unknowns with the least maximum, from any start.
pub(crate) fn least_maximum(rows: &[Row], start: DVector<f64>) -> DVector<f64> {
    let mut point = Point { greatest: 0.0, unknowns: start };
    let most = point.squares(rows).fold(0.0, f64::max).sqrt();
    if most <= GAP {
        return point.unknowns;
    }
    point.greatest = 1.1 * most;
    // Each cone contributes 2 to the distance from the least maximum, over the weight.
    let cones = 2.0 * rows.len() as f64;
    let mut weight = cones / point.greatest;
    while cones / weight > GAP * point.greatest {
        point = point.centered(rows, weight);
        weight *= GROWTH;
    }
    point.unknowns
}

/// A point strictly inside all cones.
#[derive(Clone)]
struct Point {
    /// t: above all moduli.
    greatest: f64,
    unknowns: DVector<f64>,
}

impl Point {
    fn squares<'a>(&'a self, rows: &'a [Row]) -> impl Iterator<Item = f64> + 'a {
        rows.iter().map(|row| row.at(&self.unknowns)).map(|[x, y]| x * x + y * y)
    }

    /// The function to make least; infinite outside the cones.
    fn value(&self, rows: &[Row], weight: f64) -> f64 {
        let inside = self.squares(rows).map(|square| {
            let slack = self.greatest * self.greatest - square;
            if slack > 0.0 && self.greatest > 0.0 { -slack.ln() } else { f64::INFINITY }
        });
        weight * self.greatest + inside.sum::<f64>()
    }

    /// The least point for a weight, by Newton's method with steps that stay inside.
    fn centered(mut self, rows: &[Row], weight: f64) -> Self {
        let mut value = self.value(rows, weight);
        for _ in 0..MOST_STEPS {
            let (gradient, hessian) = self.derivatives(rows, weight);
            let step = solve(hessian, &-&gradient);
            let decrement = -gradient.dot(&step);
            if decrement.is_nan() || decrement <= CENTERED {
                break;
            }
            let moved = |part: f64| Self {
                greatest: self.greatest + part * step[0],
                unknowns: &self.unknowns + step.rows(1, self.unknowns.len()) * part,
            };
            let enough = |part: f64, found: f64| found <= value - 0.25 * part * decrement;
            let parts = std::iter::successors(Some(1.0), |part| Some(0.5 * part)).take(50);
            let next = parts.map(|part| (part, moved(part))).find_map(|(part, point)| {
                let found = point.value(rows, weight);
                enough(part, found).then_some((point, found))
            });
            // No smaller value is found: only rounding is left.
            let Some(next) = next else { break };
            (self, value) = next;
        }
        self
    }

    /// Gradient and second derivatives by t and the unknowns.
    fn derivatives(&self, rows: &[Row], weight: f64) -> (DVector<f64>, DMatrix<f64>) {
        let size = 1 + self.unknowns.len();
        let (mut gradient, mut hessian) = (DVector::zeros(size), DMatrix::zeros(size, size));
        gradient[0] = weight;
        for row in rows {
            let [x, y] = row.at(&self.unknowns);
            let slack = self.greatest * self.greatest - x * x - y * y;
            // Half the gradient of the slack.
            let mut half = DVector::zeros(size);
            half[0] = self.greatest;
            for (i, column) in row.columns.iter().enumerate() {
                half[i + 1] = -(column[0] * x + column[1] * y);
            }
            gradient.axpy(-2.0 / slack, &half, 1.0);
            hessian.ger(4.0 / (slack * slack), &half, &half, 1.0);
            hessian[(0, 0)] -= 2.0 / slack;
            for (i, a) in row.columns.iter().enumerate() {
                for (j, b) in row.columns.iter().enumerate() {
                    hessian[(i + 1, j + 1)] += 2.0 / slack * (a[0] * b[0] + a[1] * b[1]);
                }
            }
        }
        (gradient, hessian)
    }
}

/// Part of the greatest singular value below which counterweights on several links replace each other; the smallest of
/// them are then taken.
const DEPENDENT: f64 = 1e-10;

/// A force as a linear function of the unknowns: `force + columns u`, columns two by two as x and y.
pub(crate) struct Row {
    pub(crate) force: [f64; 2],
    /// What each unknown adds, along x and along y.
    pub(crate) columns: Vec<[f64; 2]>,
}

impl Row {
    pub(crate) fn at(&self, unknowns: &DVector<f64>) -> [f64; 2] {
        let each = self.columns.iter().zip(unknowns.iter());
        each.fold(self.force, |sum, (column, u)| [sum[0] + column[0] * u, sum[1] + column[1] * u])
    }
}

/// The least solution of a linear system, in the sense of least squares where it has none.
pub(crate) fn solve(matrix: DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let unknowns = matrix.ncols();
    let decomposed = matrix.svd(true, true);
    let least = DEPENDENT * decomposed.singular_values.max();
    decomposed.solve(right, least).unwrap_or_else(|_| DVector::zeros(unknowns))
}
