//! Radau IIA collocation of order 15: nodes, integration matrix, interpolation (Hairer & Wanner II, IV.5).
//!
//! A polynomial of degree 8 on [0, 1] is given by its values at 0 and at the eight nodes, the last of which is 1. The method is
//! L-stable: a steep motor characteristic on a small inertia is no obstacle.

use std::sync::LazyLock;

use nalgebra::{SMatrix, SVector};

/// Number of nodes in (0, 1].
pub(crate) const S: usize = 8;

/// One number for each node.
type Nodal = [f64; S];

/// One number for the start of a panel and one for each node.
pub(crate) type Values = [f64; S + 1];

/// Everything that a panel needs.
#[derive(Debug)]
pub(crate) struct Rule {
    /// 0 and the nodes in (0, 1], ascending.
    pub(crate) c: Values,
    /// ∫ from 0 to node i of the Lagrange polynomial of node j. The last row holds the weights.
    pub(crate) a: [Nodal; S],
    /// Where the residual is checked: the middle of the widest gap.
    pub(crate) middle: f64,
    /// Lagrange polynomials of the nodes at `middle`.
    at_middle: Nodal,
    /// Their integrals from 0 to `middle`.
    to_middle: Nodal,
    /// Barycentric weights of 0 and the nodes.
    weights: Values,
}

/// The rule, computed once.
pub(crate) static RULE: LazyLock<Rule> = LazyLock::new(Rule::new);

/// Legendre polynomials P0 to P(S) at `x`.
fn legendre(x: f64) -> Values {
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
        let c: Values = std::array::from_fn(|k| if k == 0 { 0.0 } else { 0.5 * (1.0 + x[k - 1]) });
        // l_j(y) = sum over n of P_n(y) v[n][j], V the inverse of the matrix P_n(x_j).
        let lu = SMatrix::<f64, S, S>::from_fn(|n, j| legendre(x[j])[n]).lu();
        let combine =
            |basis: Nodal| -> Nodal { lu.solve(&SVector::from(basis)).map_or([f64::NAN; S], Into::into) };
        let integral = |x: f64| combine(legendre_integrals(x).map(|value| 0.5 * value));
        let middle = 0.5 * (c[S / 2] + c[S / 2 + 1]);
        let p = legendre(2.0 * middle - 1.0);
        Self {
            a: std::array::from_fn(|i| integral(x[i])),
            middle,
            at_middle: combine(std::array::from_fn(|n| p[n])),
            to_middle: integral(2.0 * middle - 1.0),
            weights: barycentric(&c),
            c,
        }
    }

    /// The polynomial with these values, at the part `theta` of the panel.
    pub(crate) fn interpolate(&self, values: &Values, theta: f64) -> f64 {
        let (mut above, mut below) = (0.0, 0.0);
        for ((node, weight), value) in self.c.iter().zip(&self.weights).zip(values) {
            let gap = theta - node;
            if gap == 0.0 {
                return *value;
            }
            let weight = weight / gap;
            above += weight * value;
            below += weight;
        }
        above / below
    }

    /// Integral from 0 to each node, from the values at the nodes; the value at 0 is not used.
    #[inline]
    pub(crate) fn integrals(&self, values: &Values) -> Values {
        std::array::from_fn(|i| if i == 0 { 0.0 } else { dot(&self.a[i - 1], values) })
    }

    /// Integral over the panel, from the values at the nodes.
    pub(crate) fn integral(&self, values: &Values) -> f64 {
        dot(&self.a[S - 1], values)
    }

    /// Integral from 0 to the middle, from the values at the nodes.
    pub(crate) fn integral_to_middle(&self, values: &Values) -> f64 {
        dot(&self.to_middle, values)
    }

    /// The polynomial of degree 7 through the values at the nodes, in the middle.
    pub(crate) fn at_middle(&self, values: &Values) -> f64 {
        dot(&self.at_middle, values)
    }
}

/// Sum over the nodes.
#[inline]
fn dot(weights: &Nodal, values: &Values) -> f64 {
    weights.iter().zip(&values[1..]).map(|(weight, value)| weight * value).sum()
}

fn barycentric(c: &Values) -> Values {
    std::array::from_fn(|k| {
        let product: f64 = (0..=S).filter(|m| *m != k).map(|m| c[k] - c[m]).product();
        1.0 / product
    })
}

#[cfg(test)]
mod tests;
