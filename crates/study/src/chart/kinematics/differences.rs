//! Numerical differentiation of positions: PF1 and PF2 from PF0 alone, by central differences.

use assur_group::{Body, Order};
use assur_kinematics::{Linkage, Position};
use assur_words::{Describe, Text};

/// Weights of f(q + k h) for k = 1, 2: for the first derivative with odd symmetry, for the second with even symmetry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stencil {
    pub(crate) name: &'static str,
    /// f' h = sum of w (f(q + k h) - f(q - k h)).
    first: &'static [f64],
    /// f'' h² = sum of w (f(q + k h) - 2 f(q) + f(q - k h)).
    second: &'static [f64],
}

impl Stencil {
    /// Three points, order 2; five points, order 4.
    pub(crate) const ALL: [Self; 2] = [
        Self { name: "differences-2", first: &[0.5], second: &[1.0] },
        Self { name: "differences-4", first: &[2.0 / 3.0, -1.0 / 12.0], second: &[4.0 / 3.0, -1.0 / 12.0] },
    ];
}

#[derive(Debug)]
pub(crate) struct Differentiator<'a> {
    linkage: &'a Linkage,
    stencil: Stencil,
    /// Step, rad or m.
    step: f64,
    /// The middle, then pairs after and before.
    at: Vec<Position>,
}

impl<'a> Differentiator<'a> {
    /// `step`: rad, or parts of the scale for a sliding input.
    pub(crate) fn new(linkage: &'a Linkage, stencil: Stencil, step: f64) -> Self {
        let points = 1 + 2 * stencil.first.len();
        Self {
            linkage,
            stencil,
            step: step * linkage.coordinate_unit(),
            at: vec![linkage.position(); points],
        }
    }

    pub(crate) fn points(&self) -> usize {
        self.at.len()
    }

    /// Places at all points of the stencil, and the derivatives with the middle position.
    pub(crate) fn solve(&mut self, q: f64) -> Result<&Position, Text> {
        for (i, position) in self.at.iter_mut().enumerate() {
            let side = if i % 2 == 1 { 1.0 } else { -1.0 };
            let offset = if i == 0 { 0.0 } else { side * i.div_ceil(2) as f64 * self.step };
            let solved = self.linkage.solve(q + offset, Order::Place, position);
            solved.map_err(|error| error.describe())?;
        }
        let (middle, around) = self.at.split_at_mut(1);
        for (link, body) in middle[0].bodies.iter_mut().enumerate().skip(1) {
            differentiate(&self.stencil, self.step, link, body, around);
        }
        Ok(&self.at[0])
    }
}

fn differentiate(stencil: &Stencil, step: f64, link: usize, body: &mut Body<f64>, around: &[Position]) {
    let place = |body: &Body<f64>| [body.x, body.y, body.c, body.s];
    let here = place(body);
    let (mut first, mut second) = ([0.0; 4], [0.0; 4]);
    for (k, pair) in around.chunks_exact(2).enumerate() {
        let (after, before) = (place(&pair[0].bodies[link]), place(&pair[1].bodies[link]));
        for i in 0..4 {
            first[i] += stencil.first[k] * (after[i] - before[i]) / step;
            second[i] += stencil.second[k] * ((after[i] - here[i]) - (here[i] - before[i])) / (step * step);
        }
    }
    let [_, _, c, s] = here;
    (body.x1, body.y1, body.w1) = (first[0], first[1], c * first[3] - s * first[2]);
    (body.x2, body.y2, body.w2) = (second[0], second[1], c * second[3] - s * second[2]);
}
