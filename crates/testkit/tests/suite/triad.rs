//! Class III: a ternary link and three binary ones, six pins. Placed by Newton's method; the rest is the default.

use assur_group::PairSort::Pin;
use assur_group::{
    AssurGroup, Body, BuildError, Builders, ForceAngle, GroupError, GroupFrame, GroupKind, GroupPlugin,
    Number, Order, Pattern, Ways, inventory, place_by_newton,
};
use assur_number::Real;

use assur_testkit::{Dice, Join, Sample};

#[derive(Debug)]
struct Triad(GroupFrame);

impl<T: Real> AssurGroup<T> for Triad {
    fn frame(&self) -> &GroupFrame {
        &self.0
    }

    fn place(&self, bodies: &mut [Body<T>], _: usize) -> Result<T, GroupError> {
        place_by_newton(&self.0, bodies)
    }

    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        assur_group::derive_generally(&self.0, bodies, order)?;
        let mut parts = bodies.iter().map(|b| b.x1 + b.y1 + b.w1 + b.x2 + b.y2 + b.w2);
        parts.try_for_each(GroupError::if_nan)
    }
}

struct TriadKind;

impl GroupKind for TriadKind {
    type Kernel<T: Number> = Triad;

    fn build<T: Number>(frame: &GroupFrame) -> Result<Triad, BuildError> {
        Ok(Triad(frame.clone()))
    }
}

inventory::submit! {
    GroupPlugin {
        name: "triad",
        kind: "class III",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "a ternary link and three binary ones, six pins",
        pattern: Pattern {
            links: 4,
            inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin)],
            outer: &[(1, Pin), (2, Pin), (3, Pin)],
        },
        ways: Ways { most: 1, varies: false, words: "the one near the start" },
        iterates: true,
        singular: "the lines of the three binary links through one point",
        force_angle: ForceAngle::DEFAULT,
        source: "a test",
        builders: Builders::of::<TriadKind>(),
    }
}

/// Bodies 0 to 2 outside, 3 the ternary link, 4 to 6 the binary ones.
pub(crate) fn sample(dice: &mut Dice, singular: bool) -> Sample {
    let paths = Sample::poses(dice, 7);
    let turn = dice.unit();
    let mut joins = vec![];
    for (i, outer) in [0, 1, 2].into_iter().enumerate() {
        // Corners of a triangle, and legs that are far from meeting in one point; if singular, all through (0, 0).
        let (s, c) = (turn + 2.1 * i as f64).sin_cos();
        let lean = if singular { 0.0 } else { dice.between(0.5, 1.0) };
        let corner = [0.5 * c, 0.5 * s];
        let foot = [c - lean * s, s + lean * c];
        joins.push(Join { a: 3, b: 4 + i, at: corner, slide: None });
        joins.push(Join { a: 4 + i, b: outer, at: foot, slide: None });
    }
    Sample::assemble(dice, paths, vec![3, 4, 5, 6], &joins)
}
