//! Random groups by construction: first the poses of all bodies, then pairs that fit them.

use assur_group::{Body, GroupFrame, Pair, PairGeometry, Pattern};
use assur_number::Real;

use crate::Rng;
use crate::arrangement::{Join, Pose, constraints, drawn_pairs, regularity};

/// Joints of one link are at least this far apart, m; the region of all joints is 2 m wide.
const APART: f64 = 0.2;

/// Samples with a smaller ratio of singular values of the constraints are drawn anew.
const LEAST_REGULARITY: f64 = 0.02;

/// Greatest number of arrangements that are drawn for one sample.
const TRIES: usize = 40;

/// Number of steps between two arrangements in the search for a change of sign of the determinant.
const STEPS: u32 = 16;

/// How a body moves with the coordinate q: value, first and second derivative at q = 0 of x, y (m) and the angle (rad).
#[derive(Debug, Clone, Copy, Default)]
struct Path {
    x: [f64; 3],
    y: [f64; 3],
    angle: [f64; 3],
}

fn taylor<T: Real>(of: [f64; 3], q: T) -> [T; 3] {
    let [a, b, c] = of.map(T::from_f64);
    [a + q * (b + (q * c).half()), b + q * c, c]
}

impl Path {
    fn random(rng: &mut Rng) -> Self {
        let mut three = || [rng.range(-1.0, 1.0), rng.range(-1.0, 1.0), rng.range(-1.0, 1.0)];
        let (x, y, mut angle) = (three(), three(), three());
        angle[0] *= std::f64::consts::PI;
        Self { x, y, angle }
    }

    /// Pose and derivatives at q.
    fn at<T: Real>(&self, q: T) -> Body<T> {
        let ([x, x1, x2], [y, y1, y2]) = (taylor(self.x, q), taylor(self.y, q));
        let [angle, w1, w2] = taylor(self.angle, q);
        let (s, c) = angle.sin_cos();
        Body { x, y, c, s, x1, y1, w1, x2, y2, w2 }
    }

    fn pose(&self) -> Pose {
        Pose { x: self.x[0], y: self.y[0], angle: self.angle[0] }
    }
}

/// A group, and the motion of all bodies around it.
#[derive(Debug, Clone)]
pub(crate) struct Sample {
    /// The group.
    pub(crate) frame: GroupFrame,
    /// Bodies, the ground first. Bodies outside the group have this motion; those of the group have this pose at q =
    /// 0.
    paths: Vec<Path>,
}

/// Draws the bodies outside the group, one for each outer pair: mostly different ones, sometimes the ground,
/// sometimes all one.
fn outside(rng: &mut Rng, pairs: usize) -> Vec<usize> {
    let all_one = rng.chance(1.0 / 6.0);
    let body = |k: usize| match k {
        0 => 1,
        _ if all_one => 1,
        _ if rng.chance(0.25) => 0,
        _ => k + 1,
    };
    (0..pairs).map(body).collect()
}

impl Sample {
    /// A random group of a pattern, well away from its singular positions; `None` if many draws found none.
    pub(crate) fn regular(rng: &mut Rng, pattern: &Pattern) -> Option<Self> {
        (0..TRIES).find_map(|_| {
            let draft = Draft::new(rng, pattern);
            let joins = draft.joins(rng);
            let is_regular = are_apart(&joins) && regularity(&draft.matrix(&joins)) > LEAST_REGULARITY;
            is_regular.then(|| draft.sample(rng, &joins))
        })
    }

    /// A random group of a pattern at a singular position, to rounding; `None` if many draws found none.
    ///
    /// Between two arrangements of pairs on the same poses the determinant of the constraints changes its sign; the
    /// arrangement at the change is found by bisection. Each arrangement can be assembled, because its pairs are
    /// fitted to the poses.
    pub(crate) fn singular(rng: &mut Rng, pattern: &Pattern) -> Option<Self> {
        (0..TRIES).find_map(|_| {
            let draft = Draft::new(rng, pattern);
            let ends = [draft.joins(rng), draft.joins(rng)];
            let between = |part: f64| -> Vec<Join> {
                ends[0].iter().zip(&ends[1]).map(|(one, two)| one.between(two, part)).collect()
            };
            let is_positive = |part: f64| draft.matrix(&between(part)).determinant() > 0.0;
            let places = (0..=STEPS).map(|i| f64::from(i) / f64::from(STEPS)).collect::<Vec<_>>();
            let found = places.windows(2).find(|two| is_positive(two[0]) != is_positive(two[1]))?;
            let (mut low, mut high) = (found[0], found[1]);
            let start = is_positive(low);
            loop {
                let middle = 0.5 * (low + high);
                if middle <= low || middle >= high {
                    break;
                }
                if is_positive(middle) == start { low = middle } else { high = middle }
            }
            let joins = between(low);
            // An arrangement with no less singular neighbors is singular because of its sorts of pairs, not because
            // of its position.
            let neighbor = regularity(&draft.matrix(&between(low + 0.25 / f64::from(STEPS))));
            (neighbor > 1e-4 && are_apart(&joins)).then(|| draft.sample(rng, &joins))
        })
    }

    /// All bodies in the poses to which the pairs were fitted.
    pub(crate) fn built(&self) -> Vec<Body<f64>> {
        self.paths.iter().map(|path| path.at(0.0)).collect()
    }

    /// All bodies at q; those of the group near their pose at q = 0, as a start for a kind that iterates.
    pub(crate) fn bodies<T: Real>(&self, q: T) -> Vec<Body<T>> {
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
    pub(crate) fn outer(&self) -> Vec<usize> {
        let ends = self.frame.outer.iter().flat_map(|pair| [pair.a, pair.b]);
        let mut outer: Vec<_> = ends.filter(|&body| self.frame.column(body).is_none()).collect();
        outer.sort_unstable();
        outer.dedup();
        outer
    }
}

impl Join {
    fn between(&self, other: &Self, part: f64) -> Self {
        let mix = |a: f64, b: f64| a + part * (b - a);
        let guide = self.guide.zip(other.guide).map(|(a, b)| mix(a, b));
        Self { at: [0, 1].map(|k| mix(self.at[k], other.at[k])), guide, ..*self }
    }
}

/// Whether the joints of each body are sufficiently far apart.
fn are_apart(joins: &[Join]) -> bool {
    let apart = |a: &Join, b: &Join| (a.at[0] - b.at[0]).hypot(a.at[1] - b.at[1]) > APART;
    let common = |a: &Join, b: &Join| a.bodies.iter().any(|body| b.bodies.contains(body));
    joins.iter().enumerate().all(|(i, a)| joins[..i].iter().all(|b| !common(a, b) || apart(a, b)))
}

/// Draws the poses of all bodies, and which of them the pairs of the group join.
struct Draft {
    paths: Vec<Path>,
    links: Vec<usize>,
    pairs: Vec<([usize; 2], bool)>,
}

impl Draft {
    fn new(rng: &mut Rng, pattern: &Pattern) -> Self {
        let first = pattern.outer.len() + 1;
        let links: Vec<usize> = (first..first + pattern.links).collect();
        let outside = outside(rng, pattern.outer.len());
        let pairs = drawn_pairs(rng, pattern, &links, &outside);
        let moving = (1..first + pattern.links).map(|_| Path::random(rng));
        let paths = std::iter::once(Path::default()).chain(moving).collect();
        Self { paths, links, pairs }
    }

    fn joins(&self, rng: &mut Rng) -> Vec<Join> {
        let join = |(bodies, is_slide): &([usize; 2], bool)| {
            let at = [rng.range(-1.0, 1.0), rng.range(-1.0, 1.0)];
            Join { bodies: *bodies, at, guide: is_slide.then(|| rng.angle()) }
        };
        self.pairs.iter().map(join).collect()
    }

    fn matrix(&self, joins: &[Join]) -> nalgebra::DMatrix<f64> {
        constraints(&self.links, joins, |body| [self.paths[body].x[0], self.paths[body].y[0]], 1.0)
    }

    /// Fits the pairs to the poses; links, pairs and the bodies of a pair are put in any order, as in scenes.
    fn sample(self, rng: &mut Rng, joins: &[Join]) -> Sample {
        let mut links = self.links;
        if rng.chance(0.5) {
            links.reverse();
        }
        let mut frame =
            GroupFrame { links, inner: vec![], outer: vec![], driven: vec![], scale: rng.range(0.5, 1.5) };
        for (id, join) in joins.iter().enumerate() {
            let [a, b] = if rng.chance(0.5) { join.bodies } else { [join.bodies[1], join.bodies[0]] };
            let (pose_a, pose_b) = (self.paths[a].pose(), self.paths[b].pose());
            let geometry = match join.guide {
                None => PairGeometry::Pin { at_a: pose_a.local(join.at), at_b: pose_b.local(join.at) },
                Some(direction) => {
                    let (s, c) = direction.sin_cos();
                    let shift = rng.range(-1.0, 1.0);
                    let elsewhere = [join.at[0] + shift * c, join.at[1] + shift * s];
                    PairGeometry::Slide {
                        point: pose_a.local(join.at),
                        through: pose_b.local(elsewhere),
                        angle: direction - pose_b.angle,
                        tilt: pose_a.angle - direction,
                    }
                }
            };
            let is_inner = join.bodies.iter().all(|body| frame.links.contains(body));
            if is_inner { &mut frame.inner } else { &mut frame.outer }.push(Pair { id, a, b, geometry });
        }
        if rng.chance(0.5) {
            frame.outer.reverse();
        }
        Sample { frame, paths: self.paths }
    }
}
