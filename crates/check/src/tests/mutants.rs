//! Mistakes to plant in the formulas of a group.

use assur_group::{AssurGroup, Body, GroupError, GroupFrame, Order, Wrench};

/// A small mistake of a factor: well above rounding, well below what a plot would show.
pub(super) const SLIP: f64 = 1.0 + 1e-6;

/// A mistake in one formula of one group.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slip {
    pub(super) name: &'static str,
    place: fn(&mut Body<f64>),
    first: fn(&mut Body<f64>),
    second: fn(&mut Body<f64>),
    reaction: fn(&mut Wrench<f64>),
    /// Whether the reactions on the outer bodies are not handed on.
    keeps: bool,
}

pub(super) const NONE: Slip =
    Slip { name: "none", place: |_| (), first: |_| (), second: |_| (), reaction: |_| (), keeps: false };

pub(super) const SLIPS: [Slip; 18] = [
    Slip {
        name: "place: link turned by 1e-6",
        place: |b| (b.c, b.s) = (b.c - 1e-6 * b.s, b.s + 1e-6 * b.c),
        ..NONE
    },
    Slip { name: "place: x longer by 1e-6", place: |b| b.x *= SLIP, ..NONE },
    Slip { name: "place: sign of y", place: |b| b.y = -b.y, ..NONE },
    Slip { name: "place: sign of the sine", place: |b| b.s = -b.s, ..NONE },
    Slip { name: "PF1: sign of w1", first: |b| b.w1 = -b.w1, ..NONE },
    Slip { name: "PF1: w1 longer by 1e-6", first: |b| b.w1 *= SLIP, ..NONE },
    Slip { name: "PF1: sign of x1", first: |b| b.x1 = -b.x1, ..NONE },
    Slip { name: "PF1: y1 longer by 1e-6", first: |b| b.y1 *= SLIP, ..NONE },
    Slip { name: "PF2: sign of w2", second: |b| b.w2 = -b.w2, ..NONE },
    Slip { name: "PF2: w2 longer by 1e-6", second: |b| b.w2 *= SLIP, ..NONE },
    Slip { name: "PF2: sign of y2", second: |b| b.y2 = -b.y2, ..NONE },
    Slip { name: "PF2: x2 longer by 1e-6", second: |b| b.x2 *= SLIP, ..NONE },
    Slip { name: "PF2: w2 forgotten", second: |b| b.w2 = 0.0, ..NONE },
    Slip { name: "reaction: sign of fx", reaction: |r| r.fx = -r.fx, ..NONE },
    Slip { name: "reaction: fy longer by 1e-6", reaction: |r| r.fy *= SLIP, ..NONE },
    Slip { name: "reaction: sign of the moment", reaction: |r| r.m = -r.m, ..NONE },
    Slip { name: "reaction: both components exchanged", reaction: |r| (r.fx, r.fy) = (r.fy, r.fx), ..NONE },
    Slip { name: "reaction: not handed on", keeps: true, ..NONE },
];

/// A sound kernel with a mistake in one link, or in one pair.
#[derive(Debug)]
pub(super) struct Mutant {
    pub(super) sound: Box<dyn AssurGroup<f64>>,
    pub(super) slip: Slip,
    /// Which link (of 0, 1) and pair (of 0, 1, 2) of the group.
    pub(super) victim: usize,
}

impl Mutant {
    fn link(&self) -> usize {
        let links = &self.sound.frame().links;
        links[self.victim % links.len()]
    }
}

impl AssurGroup<f64> for Mutant {
    fn frame(&self) -> &GroupFrame {
        self.sound.frame()
    }

    fn ways(&self) -> usize {
        self.sound.ways()
    }

    fn place(&self, bodies: &mut [Body<f64>], way: usize) -> Result<f64, GroupError> {
        let health = self.sound.place(bodies, way)?;
        (self.slip.place)(&mut bodies[self.link()]);
        Ok(health)
    }

    fn derive(&self, bodies: &mut [Body<f64>], order: Order) -> Result<(), GroupError> {
        self.sound.derive(bodies, order)?;
        (self.slip.first)(&mut bodies[self.link()]);
        (self.slip.second)(&mut bodies[self.link()]);
        Ok(())
    }

    fn solve(&self, bodies: &mut [Body<f64>], way: usize, order: Order) -> Result<f64, GroupError> {
        let health = self.place(bodies, way)?;
        self.derive(bodies, order)?;
        Ok(health)
    }

    fn reactions_under(
        &self,
        bodies: &[Body<f64>],
        loads: &mut [Wrench<f64>],
        reactions: &mut [Wrench<f64>],
        sets: usize,
    ) -> Result<(), GroupError> {
        let before = loads.to_vec();
        self.sound.reactions_under(bodies, loads, reactions, sets)?;
        if self.slip.keeps {
            loads.copy_from_slice(&before);
        }
        let pairs: Vec<_> = self.frame().pairs().map(|pair| pair.id).collect();
        (self.slip.reaction)(&mut reactions[pairs[self.victim % pairs.len()]]);
        Ok(())
    }
}
