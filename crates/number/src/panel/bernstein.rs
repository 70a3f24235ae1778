//! Polynomials by Bernstein's coefficients, which bound them.

/// A polynomial of degree N - 1 on [0, 1] by Bernstein's coefficients: it lies between the least and the greatest of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bernstein<const N: usize>(pub [f64; N]);

impl<const N: usize> Bernstein<N> {
    /// The polynomial c0 + f0 (c1 + f1 (c2 + ...)), whose factors are linear; each is given by its values at 0 and 1.
    pub fn nested(coefficients: &[f64; N], factor: impl Fn(usize) -> [f64; 2]) -> Self {
        let mut found = [coefficients[N - 1]; N];
        for degree in 1..N {
            let outer = N - 1 - degree;
            let [first, last] = factor(outer);
            let before = found;
            let part = |i: usize, of: usize| i as f64 / degree as f64 * before[of];
            for (i, coefficient) in found.iter_mut().enumerate().take(degree + 1) {
                let product = first * part(degree - i, i) + last * part(i, i.saturating_sub(1));
                *coefficient = coefficients[outer] + product;
            }
        }
        Self(found)
    }

    /// The polynomial through values at distinct nodes (Newton's form).
    pub fn through(nodes: &[f64; N], values: &[f64; N]) -> Self {
        let mut differences = *values;
        for order in 1..N {
            for i in (order..N).rev() {
                let width = nodes[i] - nodes[i - order];
                differences[i] = (differences[i] - differences[i - 1]) / width;
            }
        }
        Self::nested(&differences, |i| [-nodes[i], 1.0 - nodes[i]])
    }

    /// Its bounds.
    pub fn bounds(&self) -> [f64; 2] {
        bounds(self.0)
    }

    /// Bounds of its derivative where the interval is `length` long.
    pub fn slopes(&self, length: f64) -> [f64; 2] {
        let step = length / (N - 1) as f64;
        bounds(self.0.windows(2).map(|two| (two[1] - two[0]) / step))
    }

    /// Its derivative where the interval is `length` long.
    #[must_use]
    pub fn derivative(&self, length: f64) -> Self {
        let (degree, Self(all)) = ((N - 1) as f64, self);
        let step = |i: usize| degree * (all[i + 1] - all[i]) / length;
        Self(std::array::from_fn(|i| {
            let (before, part) = (i as f64 / degree, 1.0 - i as f64 / degree);
            // By one degree more than it has.
            let earlier = if i > 0 { before * step(i - 1) } else { 0.0 };
            earlier + if i + 1 < N { part * step(i) } else { 0.0 }
        }))
    }

    /// The same polynomial on a part of [0, 1], over [0, 1].
    #[must_use]
    pub fn within(&self, [from, to]: [f64; 2]) -> Self {
        Self(std::array::from_fn(|i| {
            let mut all = self.0;
            for level in 1..N {
                let at = if level <= i { to } else { from };
                for k in 0..N - level {
                    all[k] += at * (all[k + 1] - all[k]);
                }
            }
            all[0]
        }))
    }

    /// Its value at 1.
    pub fn end(&self) -> f64 {
        self.0[N - 1]
    }

    /// Its halves, each over [0, 1] (de Casteljau).
    pub fn halves(mut self) -> [Self; 2] {
        let mut first = self;
        for (level, coefficient) in first.0.iter_mut().enumerate().skip(1) {
            for i in 0..N - level {
                self.0[i] = f64::midpoint(self.0[i], self.0[i + 1]);
            }
            *coefficient = self.0[0];
        }
        [first, self]
    }
}

fn bounds(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    values
        .into_iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

#[cfg(test)]
mod tests;
