//! Radau IIA collocation: nodes, integration matrix, interpolation (Hairer & Wanner II, IV.5).

use std::array::from_fn;

use crate::elementary;

/// The method with `S` nodes in (0, 1], the last of which is 1, of order 2 S - 1; `N` is S + 1. A polynomial of degree S on
/// [0, 1] is given by its values at 0 and at the nodes. The method is L-stable.
#[derive(Debug)]
pub struct Radau<const S: usize, const N: usize> {
    /// 0 and the nodes in (0, 1], ascending.
    pub c: [f64; N],
    /// ∫ from 0 to node i of the Lagrange polynomial of node j. The last row holds the weights.
    pub a: [[f64; S]; S],
    /// Where a residual is checked: the middle of the widest gap.
    pub middle: f64,
    /// Lagrange polynomials of the nodes at `middle`.
    at_middle: [f64; S],
    /// Their integrals from 0 to `middle`.
    to_middle: [f64; S],
    /// Barycentric weights of 0 and the nodes.
    weights: [f64; N],
}

/// Legendre polynomials P0 to P(N-1) at `x`.
fn legendre<const N: usize>(x: f64) -> [f64; N] {
    let mut p = [1.0; N];
    p[1] = x;
    for n in 1..N - 1 {
        let n_ = n as f64;
        p[n + 1] = ((2.0 * n_ + 1.0) * x * p[n] - n_ * p[n - 1]) / (n_ + 1.0);
    }
    p
}

/// Zeros of P(S) - P(S-1) on (-1, 1], ascending.
fn zeros<const S: usize, const N: usize>() -> [f64; S] {
    let s = S as f64;
    let mut x: [f64; S] =
        from_fn(|k| elementary::cos(2.0 * std::f64::consts::PI * (S - 1 - k) as f64 / (2.0 * s - 1.0)));
    for x in &mut x[..S - 1] {
        for _ in 0..20 {
            let p = legendre::<N>(*x);
            // (1 - x²) Pn' = n (P(n-1) - x Pn)
            let slope = |n: usize| n as f64 * (p[n - 1] - *x * p[n]) / (1.0 - *x * *x);
            *x -= (p[S] - p[S - 1]) / (slope(S) - slope(S - 1));
        }
    }
    x[S - 1] = 1.0;
    x
}

impl<const S: usize, const N: usize> Radau<S, N> {
    /// The numbers of the method.
    pub fn new() -> Self {
        const { assert!(N == S + 1 && S > 1, "0 is no node of the method") }
        let x = zeros::<S, N>();
        let c: [f64; N] = from_fn(|k| if k == 0 { 0.0 } else { 0.5 * (1.0 + x[k - 1]) });
        let at: [[f64; N]; S] = x.map(legendre);
        // l_j = sum of (2 n + 1)/2 w_j P_n(x_j) P_n over n < S: with the weights w of Radau sums are integrals to degree 2 S - 2.
        let combine = |of: [f64; S]| {
            from_fn(|j| {
                let weight = 0.5 * (1.0 + x[j]) / (S as f64 * at[j][S - 1]).powi(2);
                weight * (0..S).map(|n| (2 * n + 1) as f64 * at[j][n] * of[n]).sum::<f64>()
            })
        };
        let integral = |x: f64| {
            let p = legendre::<N>(x);
            let of = |n| if n == 0 { x + 1.0 } else { (p[n + 1] - p[n - 1]) / (2 * n + 1) as f64 };
            combine(from_fn(|n| 0.5 * of(n)))
        };
        let middle = 0.5 * (c[S / 2] + c[S / 2 + 1]);
        let p = legendre::<N>(2.0 * middle - 1.0);
        Self {
            a: x.map(integral),
            middle,
            at_middle: combine(from_fn(|n| p[n])),
            to_middle: integral(2.0 * middle - 1.0),
            weights: super::weights(&c),
            c,
        }
    }

    /// The polynomial with these values at 0 and the nodes, at the part `theta` of the panel.
    pub fn interpolate(&self, values: &[f64; N], theta: f64) -> f64 {
        let shares = super::shares::<N>(theta, self.c.into_iter().zip(self.weights));
        shares.iter().zip(values).map(|(share, value)| share * value).sum()
    }

    /// Integral from 0 to each node, from the values at the nodes; the value at 0 is not used.
    #[inline]
    pub fn integrals(&self, values: &[f64; N]) -> [f64; N] {
        from_fn(|i| if i == 0 { 0.0 } else { dot(&self.a[i - 1], values) })
    }

    /// Integral over the panel, from the values at the nodes.
    pub fn integral(&self, values: &[f64; N]) -> f64 {
        dot(&self.a[S - 1], values)
    }

    /// Integral from 0 to the middle, from the values at the nodes.
    pub fn integral_to_middle(&self, values: &[f64; N]) -> f64 {
        dot(&self.to_middle, values)
    }

    /// The polynomial of degree S - 1 through the values at the nodes, in the middle.
    pub fn at_middle(&self, values: &[f64; N]) -> f64 {
        dot(&self.at_middle, values)
    }
}

impl<const S: usize, const N: usize> Default for Radau<S, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Sum over the nodes.
#[inline]
fn dot<const S: usize, const N: usize>(weights: &[f64; S], values: &[f64; N]) -> f64 {
    weights.iter().zip(&values[1..]).map(|(weight, value)| weight * value).sum()
}

#[cfg(test)]
mod tests;
