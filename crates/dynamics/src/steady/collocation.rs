//! Radau IIA collocation of order 15: nodes, integration matrix, interpolation (Hairer & Wanner II, IV.5).
//!
//! A polynomial of degree 8 on [0, 1] is given by its value at 0 and at the eight nodes, the last of which is 1. The method is
//! L-stable: a steep motor characteristic on a small inertia is no obstacle.

use std::sync::LazyLock;

/// Number of nodes.
pub(crate) const S: usize = 8;

/// One number for each node.
pub(crate) type Nodal = [f64; S];

/// Everything that a panel needs.
#[derive(Debug)]
pub(crate) struct Rule {
    /// Nodes in (0, 1], ascending.
    pub(crate) c: Nodal,
    /// ∫ from 0 to node i of the Lagrange polynomial of node j. The last row holds the weights.
    pub(crate) a: [Nodal; S],
    /// Where the residual is checked: the middle of the widest gap.
    pub(crate) middle: f64,
    /// Lagrange polynomials of the nodes at `middle`.
    pub(crate) at_middle: Nodal,
    /// Their integrals from 0 to `middle`.
    pub(crate) to_middle: Nodal,
    /// Barycentric weights of 0 and the nodes.
    weights: [f64; S + 1],
}

/// The rule, made once.
pub(crate) static RULE: LazyLock<Rule> = LazyLock::new(Rule::new);

/// Legendre polynomials P0 to P(S) at `x`.
fn legendre(x: f64) -> [f64; S + 1] {
    let mut p = [1.0; S + 1];
    p[1] = x;
    for n in 1..S {
        let n_ = n as f64;
        p[n + 1] = ((2.0 * n_ + 1.0) * x * p[n] - n_ * p[n - 1]) / (n_ + 1.0);
    }
    p
}

/// ∫ from -1 to `x` of P0 to P(S-1).
fn legendre_integrals(x: f64) -> Nodal {
    let p = legendre(x);
    std::array::from_fn(|n| if n == 0 { x + 1.0 } else { (p[n + 1] - p[n - 1]) / (2.0 * n as f64 + 1.0) })
}

/// Zeros of P(S) - P(S-1) on (-1, 1], ascending.
fn zeros() -> Nodal {
    let mut x: Nodal = std::array::from_fn(|k| {
        (2.0 * std::f64::consts::PI * (S - 1 - k) as f64 / (2.0 * S as f64 - 1.0)).cos()
    });
    for x in &mut x[..S - 1] {
        for _ in 0..20 {
            let p = legendre(*x);
            let s = S as f64;
            // (1 - x²) Pn' = n (P(n-1) - x Pn)
            let slope = |n: usize, n_: f64| n_ * (p[n - 1] - *x * p[n]) / (1.0 - *x * *x);
            *x -= (p[S] - p[S - 1]) / (slope(S, s) - slope(S - 1, s - 1.0));
        }
    }
    x[S - 1] = 1.0;
    x
}

impl Rule {
    fn new() -> Self {
        let x = zeros();
        let c = x.map(|x| 0.5 * (1.0 + x));
        // l_j(y) = sum over n of P_n(y) v[n][j], V the inverse of the matrix P_n(x_j).
        let matrix: [Nodal; S] = std::array::from_fn(|j| std::array::from_fn(|n| legendre(x[j])[n]));
        let lu = Lu::new(matrix);
        let combine = |basis: &Nodal| lu.solve_transposed(basis);
        let integral = |x: f64| combine(&legendre_integrals(x).map(|value| 0.5 * value));
        let middle = 0.5 * (c[S / 2 - 1] + c[S / 2]);
        let y = 2.0 * middle - 1.0;
        let p = legendre(y);
        Self {
            a: std::array::from_fn(|i| integral(x[i])),
            middle,
            at_middle: combine(&std::array::from_fn(|n| p[n])),
            to_middle: integral(y),
            weights: barycentric(&c),
            c,
        }
    }

    /// The polynomial with the value `start` at 0 and `values` at the nodes, at `theta`.
    pub(crate) fn interpolate(&self, start: f64, values: &Nodal, theta: f64) -> f64 {
        let (mut above, mut below) = (0.0, 0.0);
        for k in 0..=S {
            let (node, value) = if k == 0 { (0.0, start) } else { (self.c[k - 1], values[k - 1]) };
            let gap = theta - node;
            if gap == 0.0 {
                return value;
            }
            let weight = self.weights[k] / gap;
            above += weight * value;
            below += weight;
        }
        above / below
    }
}

fn barycentric(c: &Nodal) -> [f64; S + 1] {
    let node = |k: usize| if k == 0 { 0.0 } else { c[k - 1] };
    std::array::from_fn(|k| {
        let product: f64 = (0..=S).filter(|m| *m != k).map(|m| node(k) - node(m)).product();
        1.0 / product
    })
}

/// LU factors with partial pivoting.
#[derive(Debug)]
pub(crate) struct Lu {
    factors: [Nodal; S],
    order: [usize; S],
}

impl Lu {
    /// Factors a matrix. A singular one gives infinities, which the caller sees in the solution.
    pub(crate) fn new(mut a: [Nodal; S]) -> Self {
        let mut order: [usize; S] = std::array::from_fn(|i| i);
        for k in 0..S {
            let best = (k..S).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs())).unwrap_or(k);
            a.swap(k, best);
            order.swap(k, best);
            let pivot = a[k];
            let inverse = 1.0 / pivot[k];
            for row in &mut a[k + 1..] {
                let factor = row[k] * inverse;
                row[k] = factor;
                for j in k + 1..S {
                    row[j] -= factor * pivot[j];
                }
            }
        }
        Self { factors: a, order }
    }

    /// Solves A x = b.
    pub(crate) fn solve(&self, b: &Nodal) -> Nodal {
        let mut x: Nodal = std::array::from_fn(|i| b[self.order[i]]);
        for i in 1..S {
            for j in 0..i {
                x[i] -= self.factors[i][j] * x[j];
            }
        }
        for i in (0..S).rev() {
            for j in i + 1..S {
                x[i] -= self.factors[i][j] * x[j];
            }
            x[i] /= self.factors[i][i];
        }
        x
    }

    /// Solves A^T x = b.
    fn solve_transposed(&self, b: &Nodal) -> Nodal {
        let mut y = *b;
        for i in 0..S {
            for j in 0..i {
                y[i] -= self.factors[j][i] * y[j];
            }
            y[i] /= self.factors[i][i];
        }
        for i in (0..S).rev() {
            for j in i + 1..S {
                y[i] -= self.factors[j][i] * y[j];
            }
        }
        let mut x = [0.0; S];
        for i in 0..S {
            x[self.order[i]] = y[i];
        }
        x
    }
}

/// Product of a matrix and a vector.
#[inline]
pub(crate) fn product(a: &[Nodal; S], x: &Nodal) -> Nodal {
    std::array::from_fn(|i| dot(&a[i], x))
}

/// Product of two vectors.
#[inline]
pub(crate) fn dot(a: &Nodal, b: &Nodal) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests;
