//! Chebyshev polynomials on [-1, 1]: fit, value, integral; for methods that advance in panels of the coordinate or of
//! the speed.

use std::{array::from_fn, f64::consts::PI, sync::LazyLock};

use crate::elementary;

/// Number of nodes of a fit.
pub const NODES: usize = 13;

/// Coefficients of an integral: one more than of a fit.
pub const TERMS: usize = NODES + 1;

/// The coefficients of `Σ c_k T_k(x)`.
pub type Series = [f64; TERMS];

/// Nodes and the table that turns values into coefficients.
#[derive(Debug, Clone)]
pub struct Basis {
    /// Nodes, ascending.
    pub nodes: [f64; NODES],
    table: [[f64; NODES]; NODES],
}

/// The basis whose nodes include both ends, computed once: its cosines cost as much as a short motion.
pub static WITH_ENDS: LazyLock<Basis> = LazyLock::new(Basis::with_ends);

/// The basis whose nodes are all inside, computed once.
pub static INSIDE: LazyLock<Basis> = LazyLock::new(Basis::inside);

impl Basis {
    /// Nodes with both ends (extrema of the last polynomial): panels share their ends.
    fn with_ends() -> Self {
        let half = |k: usize| if k == 0 || k == NODES - 1 { 0.5 } else { 1.0 };
        Self::of(NODES - 1, 0.0, |k, j| half(k) * half(j))
    }

    /// Nodes inside (zeros of the polynomial after the last): for integrands that are 0/0 at an end.
    fn inside() -> Self {
        Self::of(NODES, 0.5, |k, _| if k == 0 { 0.5 } else { 1.0 })
    }

    /// The basis of nodes at equal angles, in steps of 1/`parts` of pi and the first so many of them away from the end; `half` halves the
    /// terms that sums count twice, by polynomial and node.
    fn of(parts: usize, first: f64, half: impl Fn(usize, usize) -> f64) -> Self {
        let n = parts as f64;
        let angle = |j: usize| PI * (1.0 - (j as f64 + first) / n);
        let entry = |k: usize, j: usize| 2.0 / n * half(k, j) * elementary::cos(k as f64 * angle(j));
        let table = from_fn(|k| from_fn(|j| entry(k, j)));
        Self { nodes: from_fn(|j| elementary::cos(angle(j))), table }
    }

    /// Coefficients of the polynomial through these values at the nodes.
    #[inline]
    pub fn fit(&self, values: &[f64; NODES]) -> Series {
        let mut series = [0.0; TERMS];
        for (coefficient, row) in series.iter_mut().zip(&self.table) {
            *coefficient = row.iter().zip(values).map(|(a, b)| a * b).sum();
        }
        series
    }
}

/// Value at `x`, by Clenshaw's recurrence, with the even and the odd terms in two chains. In each chain every operation
/// waits for the one before; two chains of half the length run in parallel. `T_2k(x) = T_k(u)` and `T_2k+1(x) = x
/// V_k(u)` with `u = 2 x² - 1` and the polynomials of the third kind, `V_0 = 1`, `V_1 = 2 u - 1`.
#[inline]
pub fn value(series: &Series, x: f64) -> f64 {
    let twice = 2.0 * (2.0 * x * x - 1.0);
    let (mut even, mut even_before) = (0.0, 0.0);
    let (mut odd, mut odd_before) = (0.0, 0.0);
    for pair in series.chunks_exact(2).rev() {
        (even, even_before) = (pair[0] + twice * even - even_before, even);
        (odd, odd_before) = (pair[1] + twice * odd - odd_before, odd);
    }
    // The last step of the recurrence has u where the others have 2 u.
    even - 0.5 * twice * even_before + x * (odd - odd_before)
}

/// Integral from -1, times `scale`.
#[inline]
pub fn integral(series: &Series, scale: f64) -> Series {
    let at = |k: usize| if k < TERMS { series[k] } else { 0.0 };
    let mut sum = [0.0; TERMS];
    sum[1] = scale * (at(0) - 0.5 * at(2));
    for (k, term) in sum.iter_mut().enumerate().skip(2) {
        *term = scale * (at(k - 1) - at(k + 1)) / (2.0 * k as f64);
    }
    let at_start: f64 = (1..TERMS).map(|k| if k % 2 == 0 { sum[k] } else { -sum[k] }).sum();
    sum[0] = -at_start;
    sum
}

/// The series h with p(x) - p(r) = (x - r) h(x): division without cancellation near the root, from
/// `x T_k = (T_{k+1} + T_{k-1})/2`.
pub fn divided(p: &Series, r: f64) -> Series {
    let mut h = [0.0; TERMS];
    for k in (2..TERMS).rev() {
        let above = if k + 1 < TERMS { h[k + 1] } else { 0.0 };
        h[k - 1] = 2.0 * (p[k] + r * h[k]) - above;
    }
    h[0] = p[1] + r * h[1] - 0.5 * h[2];
    h
}

/// The contribution of the last coefficients: an upper estimate of the truncation error.
#[inline]
pub fn tail(series: &Series) -> f64 {
    series[NODES - 1].abs() + series[NODES - 2].abs()
}

/// `Σ |c_k|` over k > 0: the value differs from the first coefficient by no more.
#[inline]
pub fn swing(series: &Series) -> f64 {
    series[1..].iter().map(|c| c.abs()).sum()
}

/// First x in [-1, 1] at which a series falls to zero. The walk goes on by steps over which the slope here and a bound of the
/// curvature keep the series positive: it passes no dip, however narrow, and becomes Newton's method near a root.
pub fn first_zero(series: &Series) -> Option<f64> {
    let slope = derivative(series);
    // |T_k''| is at most k² (k² - 1)/3.
    let most = |(k, c): (usize, &f64)| (k * k * (k * k).saturating_sub(1)) as f64 / 3.0 * c.abs();
    let curvature: f64 = series.iter().enumerate().map(most).sum();
    let mut x = -1.0;
    while x <= 1.0 {
        let (height, slope) = (value(series, x), value(&slope, x));
        let step = 2.0 * height / ((slope * slope + 2.0 * curvature * height).sqrt() - slope);
        if height <= 0.0 || x + step <= x {
            return Some(x);
        }
        x += step;
    }
    None
}

fn derivative(series: &Series) -> Series {
    let mut slope = [0.0; TERMS];
    for k in (1..TERMS).rev() {
        slope[k - 1] = 2.0 * k as f64 * series[k] + if k + 1 < TERMS { slope[k + 1] } else { 0.0 };
    }
    slope[0] *= 0.5;
    slope
}

/// The argument between `low` and `high` at which a growing function (given with its derivative) has a value: Newton's
/// method from `start`, kept within the bounds by bisection, until a correction is at most `enough`. Near the root a
/// correction d leaves an error of about d².
pub fn inverse(
    wanted: f64,
    [mut low, mut high]: [f64; 2],
    start: f64,
    enough: f64,
    function: impl Fn(f64) -> (f64, f64),
) -> f64 {
    /// More than bisection alone needs.
    const MOST_STEPS: usize = 100;
    let mut x = start;
    for _ in 0..MOST_STEPS {
        let (found, slope) = function(x);
        if found < wanted {
            low = x;
        } else {
            high = x;
        }
        let newton = x - (found - wanted) / slope;
        let is_inside = newton >= low && newton <= high;
        let step = (newton - x).abs();
        x = if is_inside { newton } else { f64::midpoint(low, high) };
        if is_inside && step <= enough || high - low <= 2.0 * f64::EPSILON * high.abs() {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests;
