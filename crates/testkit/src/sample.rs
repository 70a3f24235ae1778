//! Random groups by construction: poses first, then the pairs that fit them.

use assur_group::{Body, GroupFrame, Pair, PairGeometry, PairSort, Pattern};
use assur_number::Real;

use crate::Dice;

/// How a body moves with q: value, first and second derivative at q = 0 of x, y (m) and the angle (rad).
#[derive(Debug, Clone, Copy, Default)]
pub struct Path {
    /// x, m.
    pub x: [f64; 3],
    /// y, m.
    pub y: [f64; 3],
    /// Angle, rad.
    pub angle: [f64; 3],
}

fn taylor<T: Real>(of: [f64; 3], q: T) -> [T; 3] {
    let [a, b, c] = of.map(T::from_f64);
    [a + q * (b + (q * c).half()), b + q * c, c]
}

impl Path {
    fn random(dice: &mut Dice) -> Self {
        let mut three = || [dice.unit(), dice.unit(), dice.unit()];
        let (x, y, mut angle) = (three(), three(), three());
        angle[0] *= std::f64::consts::PI;
        Self { x, y, angle }
    }

    /// Pose and derivatives at q.
    pub fn at<T: Real>(&self, q: T) -> Body<T> {
        let ([x, x1, x2], [y, y1, y2]) = (taylor(self.x, q), taylor(self.y, q));
        let [angle, w1, w2] = taylor(self.angle, q);
        let (s, c) = angle.sin_cos();
        Body { x, y, c, s, x1, y1, w1, x2, y2, w2 }
    }

    /// A point of the ground's frame in the frame of the body at q = 0.
    fn local(&self, point: [f64; 2]) -> [f64; 2] {
        let (s, c) = self.angle[0].sin_cos();
        let [x, y] = [point[0] - self.x[0], point[1] - self.y[0]];
        [c * x + s * y, c * y - s * x]
    }
}

/// Two bodies and the pair that shall join them.
#[derive(Debug, Clone, Copy)]
pub struct Join {
    /// First body; the sliding one.
    pub a: usize,
    /// Second body; the one with the guide.
    pub b: usize,
    /// The pin; or a point of the guide, in the ground's frame, m.
    pub at: [f64; 2],
    /// Direction of the guide, rad; `None` for a pin.
    pub slide: Option<f64>,
}

/// A group, and the motion of all bodies around it.
#[derive(Debug, Clone)]
pub struct Sample {
    /// The group.
    pub frame: GroupFrame,
    /// Bodies: those outside the group move like this; those of the group are here at q = 0.
    pub paths: Vec<Path>,
}

impl Sample {
    /// Random poses, the body 0 being the ground.
    pub fn poses(dice: &mut Dice, bodies: usize) -> Vec<Path> {
        (0..bodies).map(|i| if i == 0 { Path::default() } else { Path::random(dice) }).collect()
    }

    /// Reads the pairs off the poses.
    pub fn assemble(dice: &mut Dice, paths: Vec<Path>, links: Vec<usize>, joins: &[Join]) -> Self {
        let mut frame = GroupFrame { links, inner: vec![], outer: vec![], scale: dice.between(0.5, 1.5) };
        for (id, join) in joins.iter().enumerate() {
            // The scene may name the bodies of a pair in either order.
            let (a, b) = if dice.one_in(2) { (join.a, join.b) } else { (join.b, join.a) };
            let geometry = match join.slide {
                None => PairGeometry::Pin { at_a: paths[a].local(join.at), at_b: paths[b].local(join.at) },
                Some(direction) => {
                    let (s, c) = direction.sin_cos();
                    let shift = dice.unit();
                    let elsewhere = [join.at[0] + shift * c, join.at[1] + shift * s];
                    PairGeometry::Slide {
                        point: paths[a].local(join.at),
                        through: paths[b].local(elsewhere),
                        angle: direction - paths[b].angle[0],
                        tilt: paths[a].angle[0] - direction,
                    }
                }
            };
            let inside = |body| frame.links.contains(&body);
            let pairs = if inside(a) && inside(b) { &mut frame.inner } else { &mut frame.outer };
            pairs.push(Pair { id, a, b, geometry });
        }
        if dice.one_in(2) {
            frame.outer.reverse();
        }
        Self { frame, paths }
    }

    /// All bodies at q; those of the group a little beside their place at q = 0, for a kind that iterates.
    pub fn bodies<T: Real>(&self, q: T) -> Vec<Body<T>> {
        let beside = |(i, path): (usize, &Path)| {
            if self.frame.column(i).is_none() {
                return path.at(q);
            }
            let mut near = *path;
            near.x[0] += 0.01;
            near.angle[0] -= 0.01;
            near.at(T::ZERO)
        };
        self.paths.iter().enumerate().map(beside).collect()
    }

    /// Bodies outside the group that its pairs join.
    pub fn outer(&self) -> Vec<usize> {
        let mut outer: Vec<_> = self
            .frame
            .outer
            .iter()
            .flat_map(|p| [p.a, p.b])
            .filter(|&i| self.frame.column(i).is_none())
            .collect();
        outer.sort_unstable();
        outer.dedup();
        outer
    }
}

/// A random dyad of a pattern; at a singular position if wanted. `None` for dice that fall badly: two pins
/// almost in one place, or a regular one too near a singular position.
pub fn dyad(dice: &mut Dice, pattern: &Pattern, singular: bool) -> Option<Sample> {
    let is_slide = |sort: &PairSort| *sort == PairSort::Slide;
    let ([(_, first), (_, second)], [(_, inner)]) = (pattern.outer, pattern.inner) else { return None };
    let [first, inner, second] = [first, inner, second].map(is_slide);
    let paths = Sample::poses(dice, 5);
    let outer = if dice.one_in(4) {
        [1, 0]
    } else if dice.one_in(6) {
        [1, 1]
    } else {
        [1, 2]
    };
    let mut at = [dice.vector(), dice.vector(), dice.vector()];
    let mut along = [dice.unit() * 3.0, dice.unit() * 3.0, dice.unit() * 3.0];
    let chord = (at[2][1] - at[0][1]).atan2(at[2][0] - at[0][0]);
    let across = std::f64::consts::FRAC_PI_2;
    if singular {
        match (first, inner, second) {
            (false, false, false) => {
                let part = dice.between(-1.0, 2.0);
                at[1] = [0, 1].map(|k| at[0][k] + part * (at[2][k] - at[0][k]));
            }
            (false, false, true) => along[2] = (at[1][1] - at[0][1]).atan2(at[1][0] - at[0][0]) + across,
            (false, true, false) => along[1] = chord + across,
            (true, false, true) => along[2] = along[0],
            _ => along[2] = along[1],
        }
    }
    let apart = |i: usize, k: usize| (at[i][0] - at[k][0]).hypot(at[i][1] - at[k][1]) > 0.2;
    let pins_apart = apart(0, 1) && apart(1, 2) && apart(0, 2);
    let slide = |is: bool, i: usize| is.then_some(along[i]);
    let joins = [
        Join { a: 3, b: outer[0], at: at[0], slide: slide(first, 0) },
        Join { a: 3, b: 4, at: at[1], slide: slide(inner, 1) },
        Join { a: 4, b: outer[1], at: at[2], slide: slide(second, 2) },
    ];
    let links = if dice.one_in(2) { vec![3, 4] } else { vec![4, 3] };
    pins_apart.then(|| Sample::assemble(dice, paths, links, &joins))
}
