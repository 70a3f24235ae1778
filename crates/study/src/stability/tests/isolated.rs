//! A dyad on its own, at a chosen distance from each of its singular positions.
//!
//! Its two outer pairs are put on two free bodies, whose poses are found in 32 digits such that the group is at the wanted
//! distance, and rounded. Rounding shifts the distance by some 1e-16; the method and its reference then have the same f64
//! data, so that the reference is exact for what the method was given.

use assur_group::plane::{direction, dot, minus, perp, plus, scaled, times, vector};
use assur_group::{Body, GroupFrame, Pair, PairGeometry, PinJoint, Reading, SeenPair, SlideJoint};
use assur_number::{Dd, Real};
use assur_structure::Group;

/// A way to fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// Type 1, links in one line, one after the other.
    Stretched,
    /// Type 1, links in one line, one over the other.
    Folded,
    /// Type 2, rod across the guide, to its left or right.
    Interpolation(bool),
    /// Type 3, the pins as close as the offset of the guide lets them.
    PinsMeet,
    /// Types 4 and 5.
    Parallel,
}

impl Side {
    /// In words.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Stretched => "stretched",
            Self::Folded => "folded",
            Self::Interpolation(true) => "rod perpendicular to the guide, left",
            Self::Interpolation(false) => "rod perpendicular to the guide, right",
            Self::PinsMeet => "pins meeting",
            Self::Parallel => "guides turning parallel",
        }
    }
}

/// A dyad on the moving bodies 4 and 1, its links being 2 and 3.
#[derive(Debug, Clone)]
pub(crate) struct Isolated {
    pub(crate) frame: GroupFrame,
    dyad: Reading,
    /// A length that all coordinates of the walk stay near, m.
    pub(crate) size: f64,
}

impl Isolated {
    /// `None` for a group that is no dyad of the five types.
    pub(crate) fn of(group: &Group) -> Option<Self> {
        let dyad = group.plugin.pattern?.find(&group.frame)?;
        let ([first, second], [inner]) = (&dyad.outer[..], &dyad.inner[..]) else { return None };
        let moved = |pair: &Pair, id, a, b| Pair { id, a, b, ..*pair };
        let (first, inner, second) =
            (moved(&first.pair, 0, 2, 4), moved(&inner.pair, 1, 2, 3), moved(&second.pair, 2, 3, 1));
        let scale = group.frame.scale;
        let frame = GroupFrame {
            links: vec![2, 3],
            inner: vec![inner],
            outer: vec![first, second],
            driven: vec![],
            scale,
        };
        let dyad = group.plugin.pattern?.find(&frame)?;
        let reach = |at: [f64; 2]| at[0].hypot(at[1]);
        let size = [first, inner, second].iter().fold(scale, |size, pair| match pair.geometry {
            PairGeometry::Pin { at_a, at_b } => size.max(reach(at_a)).max(reach(at_b)),
            PairGeometry::Slide { point, through, .. } => size.max(reach(point)).max(reach(through)),
        });
        Some(Self { frame, dyad, size })
    }

    /// The ways in which this group can fail.
    pub(crate) fn sides(&self) -> Vec<Side> {
        match [&self.dyad.outer[0], &self.dyad.inner[0], &self.dyad.outer[1]].map(|seen| seen.pair.is_slide())
        {
            [false, false, false] => vec![Side::Stretched, Side::Folded],
            [false, false, true] => vec![Side::Interpolation(true), Side::Interpolation(false)],
            [false, true, false] => vec![Side::PinsMeet],
            _ => vec![Side::Parallel],
        }
    }

    /// Lengths of the two links between their pins, m.
    fn lengths(&self) -> Option<[Dd; 2]> {
        let (first, inner, second) =
            (pin_of(&self.dyad.outer[0])?, pin_of(&self.dyad.inner[0])?, pin_of(&self.dyad.outer[1])?);
        let length = |a: [f64; 2], b: [f64; 2]| {
            let rod = minus(vector::<Dd>(a), vector(b));
            dot(rod, rod).sqrt()
        };
        Some([length(inner.own, first.own), length(inner.at, second.own)])
    }

    /// How errors grow near this side: as health to the power of minus this, for PF0 and for everything else.
    ///
    /// Where the determinant is the square root of what the data say (1 - distance/length), a rounding of the data is
    /// divided by it twice; where it is linear in them, once.
    pub(crate) fn powers(&self, side: Side) -> [i32; 2] {
        match side {
            Side::Parallel => [1, 1],
            Side::PinsMeet if self.offset().is_some_and(|e| e.to_f64() == 0.0) => [1, 1],
            Side::Folded if self.lengths().is_some_and(|[a, b]| a == b) => [1, 1],
            _ => [1, 2],
        }
    }

    /// How much longer the coordinates are than the shortest link: their rounding counts in its units.
    pub(crate) fn disparity(&self) -> f64 {
        let shortest = match (self.lengths(), self.rod()) {
            (Some([a, b]), _) => a.to_f64().min(b.to_f64()),
            (None, Some(rod)) => rod.to_f64(),
            _ => self.size,
        };
        (self.size / shortest).max(1.0)
    }

    /// Type 2: length of the rod.
    fn rod(&self) -> Option<Dd> {
        let (first, inner) = (pin_of(&self.dyad.outer[0])?, pin_of(&self.dyad.inner[0])?);
        let rod = minus(vector::<Dd>(inner.own), vector(first.own));
        self.dyad.outer[1].pair.is_slide().then(|| dot(rod, rod).sqrt())
    }

    /// Type 3: offset of the pins across the guide.
    fn offset(&self) -> Option<Dd> {
        let (a, b) = (pin_of(&self.dyad.outer[0])?, pin_of(&self.dyad.outer[1])?);
        let slide = slide_of(&self.dyad.inner[0])?;
        let reach = times(direction::<Dd>(slide.tilt_angle), minus(vector(slide.own), vector(a.own)));
        let along = direction::<Dd>(slide.along_angle);
        let line = minus(vector(slide.through), vector(b.own));
        Some(dot(perp(along), line) - reach[1])
    }

    /// Frame (of type 5 changed) and bodies at a distance from a side.
    pub(crate) fn posed(&self, side: Side, distance: f64) -> Option<(GroupFrame, [Body<f64>; 5])> {
        let mut frame = self.frame.clone();
        let size = self.size;
        let mut bodies = [Body::<f64>::ground(); 5];
        moving(&mut bodies[4], 0.4, size, [0.31, -0.17, 0.23, 0.13, 0.29, -0.19]);
        moving(&mut bodies[1], 1.1, size, [-0.21, 0.27, -0.15, 0.22, -0.11, 0.16]);
        (bodies[4].x, bodies[4].y) = (0.3 * size, -0.2 * size);
        let near = Dd::from_f64(distance);
        match side {
            Side::Stretched | Side::Folded => {
                let [a, b] = self.lengths()?;
                let apart = if side == Side::Stretched {
                    (a + b) * (Dd::ONE - near)
                } else {
                    (a - b).abs() + (a + b) * near
                };
                self.apart(&mut bodies, apart)?;
            }
            Side::PinsMeet => {
                let e = self.offset()?.abs();
                self.apart(&mut bodies, e + Dd::from_f64(size.max(e.to_f64())) * near)?;
            }
            Side::Interpolation(left) => {
                let height = self.rod()? * (Dd::ONE - near);
                self.across(&mut bodies, if left { height } else { -height })?;
            }
            Side::Parallel => self.parallel(&mut frame, &mut bodies, near)?,
        }
        Some((frame, bodies))
    }

    /// Moves body 1 such that the outer pins are this far apart.
    fn apart(&self, bodies: &mut [Body<f64>; 5], distance: Dd) -> Option<()> {
        let (first, second) = (pin_of(&self.dyad.outer[0])?, pin_of(&self.dyad.outer[1])?);
        let a = bodies[4].map(Dd::from_f64).point(vector(first.at));
        let b = plus(a, scaled(distance, direction(0.7)));
        put(&mut bodies[1], &second, b);
        Some(())
    }

    /// Moves body 1 such that the inner pin runs at this height over the outer pin.
    fn across(&self, bodies: &mut [Body<f64>; 5], wanted: Dd) -> Option<()> {
        let (first, inner) = (pin_of(&self.dyad.outer[0])?, pin_of(&self.dyad.inner[0])?);
        let slide = slide_of(&self.dyad.outer[1])?;
        let a = bodies[4].map(Dd::from_f64).point(vector(first.at));
        let along = direction::<Dd>(slide.along_angle);
        let offset = times(direction::<Dd>(slide.tilt_angle), minus(vector(inner.at), vector(slide.own)))[1];
        let height = dot(perp(along), vector(slide.through)) + offset;
        let t = bodies[1].map(Dd::from_f64).turned(along);
        let shift = scaled(Dd::from_f64(0.3 * self.size), t);
        let origin = plus(plus(a, scaled(wanted - height, perp(t))), shift);
        (bodies[1].x, bodies[1].y) = (origin[0].to_f64(), origin[1].to_f64());
        Some(())
    }

    /// Turns guides to this angle: body 1 for type 4, the inner guide itself for type 5.
    fn parallel(&self, frame: &mut GroupFrame, bodies: &mut [Body<f64>; 5], near: Dd) -> Option<()> {
        let outer = slide_of(&self.dyad.outer[1])?;
        if let Some(first) = slide_of(&self.dyad.outer[0]) {
            let turn =
                Dd::from_f64(0.4) + Dd::from_f64(first.along_angle) - Dd::from_f64(outer.along_angle) + near;
            let (s, c) = turn.sin_cos();
            (bodies[1].c, bodies[1].s) = (c.to_f64(), s.to_f64());
            (bodies[1].x, bodies[1].y) = (-0.4 * self.size, 0.5 * self.size);
            return Some(());
        }
        if let PairGeometry::Slide { angle, .. } = &mut frame.inner[0].geometry {
            *angle = (near - Dd::from_f64(outer.tilt_angle)).to_f64();
        }
        (bodies[1].x, bodies[1].y) = (-0.4 * self.size, 0.5 * self.size);
        Some(())
    }
}

/// Gives a body a direction and a motion.
fn moving(body: &mut Body<f64>, angle: f64, size: f64, [x1, y1, w1, x2, y2, w2]: [f64; 6]) {
    (body.s, body.c) = angle.sin_cos();
    (body.x1, body.y1, body.w1) = (x1 * size, y1 * size, w1);
    (body.x2, body.y2, body.w2) = (x2 * size, y2 * size, w2);
}

/// Puts a body such that its pin lies there.
fn put(body: &mut Body<f64>, pin: &PinJoint<f64>, place: [Dd; 2]) {
    let origin = minus(place, body.map(Dd::from_f64).arm(vector(pin.at)));
    (body.x, body.y) = (origin[0].to_f64(), origin[1].to_f64());
}

fn pin_of(seen: &SeenPair) -> Option<PinJoint<f64>> {
    PinJoint::new(seen).ok()
}

fn slide_of(seen: &SeenPair) -> Option<SlideJoint<f64>> {
    SlideJoint::new(seen).ok()
}
