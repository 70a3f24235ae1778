//! Groups with driven pairs: the two links of a driven pair are one rigid link whose shape follows the coordinate.
//!
//! At a coordinate the group is one of fewer links, of the kind that its pattern has then; that kind places it, lists its modes and
//! tells its determinant. Its derivatives and reactions come from the general solution, in which each driven pair has a third
//! constraint.

use assur_number::{Real, elementary};

use crate::plane::{direction, dot, minus, times, vector};
use crate::{
    AssurGroup, Body, BuildError, Builders, Driven, GroupError, GroupFrame, Mode, Number, Pair, PairGeometry,
    place_by_newton,
};

/// A coordinate (rad, or parts of the scale) at which no two points of a drawing coincide by its round numbers.
const SOME_ANGLE: f64 = 0.739_085_133_215_160_6;

/// Determinant above which places can be made more accurate by Newton's method in any number type.
const WELL_PLACED: f64 = 1e-3;

impl Driven {
    /// Pose of the held body in the frame of the other one.
    fn pose<T: Real>(&self, held: usize, bodies: &[Body<T>]) -> Body<T> {
        let pose = self.relative(bodies);
        if held == self.pair.a {
            return pose;
        }
        let mut inverse = Body::ground();
        inverse.put([pose.c, -pose.s], pose.origin(), [T::ZERO; 2]);
        inverse
    }

    /// Pose of `a` in the frame of `b` at the present coordinate.
    fn relative<T: Real>(&self, bodies: &[Body<T>]) -> Body<T> {
        let coordinate = &bodies[self.coordinate];
        let mut pose = Body::ground();
        match self.pair.geometry {
            PairGeometry::Pin { at_a, at_b } => {
                pose.put([coordinate.c, coordinate.s], vector(at_a), vector(at_b));
            }
            PairGeometry::Slide { point, through, angle, tilt } => {
                let (along, through) = (direction::<T>(angle), vector::<T>(through));
                let place = [0, 1].map(|k| through[k] + coordinate.x * along[k]);
                pose.put(times(along, direction(tilt)), vector(point), place);
            }
        }
        pose
    }
}

/// The geometry of a pair of which one body, `from`, is held in another one, `into`, with this pose in the frame of it.
fn moved(pair: &Pair, from: usize, into: usize, pose: &Body<f64>) -> Pair {
    let turn = elementary::atan2(pose.s, pose.c);
    let Pair { id, a, b, geometry } = *pair;
    let (on_a, on_b) = (a == from, b == from);
    let at = |is_moved: bool, at: [f64; 2]| if is_moved { pose.point(at) } else { at };
    let geometry = match geometry {
        PairGeometry::Pin { at_a, at_b } => PairGeometry::Pin { at_a: at(on_a, at_a), at_b: at(on_b, at_b) },
        PairGeometry::Slide { point, through, angle, tilt } => PairGeometry::Slide {
            point: at(on_a, point),
            through: at(on_b, through),
            angle: if on_b { angle + turn } else { angle },
            tilt: if on_a { tilt - turn } else { tilt },
        },
    };
    let body = |body: usize| if body == from { into } else { body };
    Pair { id, a: body(a), b: body(b), geometry }
}

impl GroupFrame {
    /// The driven pairs in an order in which they place links: each with the link that it holds, and the body in which it holds it, which
    /// is not held by a later one.
    pub fn held(&self) -> Vec<(Driven, [usize; 2])> {
        let mut left = self.driven.clone();
        let mut found: Vec<(Driven, [usize; 2])> = Vec::with_capacity(left.len());
        while !left.is_empty() {
            let is_fixed = |body: usize| {
                self.column(body).is_none() || found.iter().any(|(_, ends)| ends.contains(&body))
            };
            let hung = left.iter().position(|one| is_fixed(one.pair.a) || is_fixed(one.pair.b));
            // Links that hold each other alone: the one that is not driven against another carries the others.
            let is_driven = |body: usize| left.iter().any(|one| one.pair.a == body);
            let first = || left.iter().position(|one| !is_driven(one.pair.b));
            let next = hung.or_else(first).unwrap_or(0);
            let Pair { a, b, .. } = left[next].pair;
            let ends = if is_fixed(a) && !is_fixed(b) { [b, a] } else { [a, b] };
            found.push((left.remove(next), ends));
        }
        found
    }

    /// The same group with the two links of each driven pair as one, at the coordinates and places of these bodies.
    #[must_use]
    pub fn merged(&self, bodies: &[Body<f64>]) -> Self {
        let mut merged = Self { driven: Vec::new(), ..self.clone() };
        for (one, [held, carrier]) in self.held().into_iter().rev() {
            let pose = one.pose(held, bodies);
            merged.links.retain(|link| *link != held);
            let pairs = merged.inner.iter_mut().chain(&mut merged.outer);
            pairs.for_each(|pair| *pair = moved(pair, held, carrier, &pose));
        }
        merged
    }

    /// The same group with the two links of each driven pair as one, at some coordinate: for its pattern alone.
    #[must_use]
    pub fn merged_pattern(&self) -> Self {
        let most = self.driven.iter().map(|driven| driven.coordinate).max();
        let [c, s] = direction(SOME_ANGLE);
        let body = Body { c, s, x: SOME_ANGLE * self.scale, ..Body::ground() };
        self.merged(&vec![body; most.map_or(0, |most| most + 1)])
    }
}

/// The kernel of a group with driven pairs.
#[derive(Debug)]
pub(crate) struct Merged<T: Real> {
    frame: GroupFrame,
    /// Its driven pairs in the order in which they place links.
    held: Vec<(Driven, [usize; 2])>,
    builders: Builders,
    /// The kernel at some coordinate: for what does not depend on it.
    any: Box<dyn AssurGroup<T>>,
}

impl<T: Number> Merged<T> {
    pub(crate) fn new(builders: &Builders, frame: &GroupFrame) -> Result<Self, BuildError> {
        let any = T::build(builders, &frame.merged_pattern())?;
        Ok(Self { frame: frame.clone(), held: frame.held(), builders: *builders, any })
    }

    /// The kernel with the shapes of the merged links at the present coordinate.
    fn at(&self, bodies: &[Body<T>]) -> Result<Box<dyn AssurGroup<T>>, GroupError> {
        let numbers: Vec<_> = bodies.iter().map(|body| body.map(Real::to_f64)).collect();
        let frame = self.frame.merged(&numbers);
        T::build(&self.builders, &frame).map_err(|_| GroupError::Singular { health: 0.0 })
    }

    /// Sets the links that are merged into others.
    fn spread(&self, bodies: &mut [Body<T>]) {
        for (driven, [held, carrier]) in &self.held {
            let (pose, on) = (driven.pose(*held, bodies), bodies[*carrier]);
            let place = on.point(pose.origin());
            bodies[*held].put(on.turned([pose.c, pose.s]), [T::ZERO; 2], place);
        }
    }

    /// The places of a kernel of 16 digits in all digits of the number type.
    fn refine(&self, bodies: &mut [Body<T>], health: T) {
        if T::EPSILON >= f64::EPSILON || health.abs().least() < WELL_PLACED {
            return;
        }
        let before: Vec<_> = self.frame.links.iter().map(|link| bodies[*link]).collect();
        if place_by_newton(&self.frame, bodies).is_err() {
            self.frame.links.iter().zip(before).for_each(|(link, body)| bodies[*link] = body);
        }
    }
}

impl<T: Number> AssurGroup<T> for Merged<T> {
    fn frame(&self) -> &GroupFrame {
        &self.frame
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        let health = self.at(bodies)?.place(bodies, way)?;
        self.spread(bodies);
        self.refine(bodies, health);
        Ok(health)
    }

    fn ways(&self) -> usize {
        self.any.ways()
    }

    fn lists_modes(&self) -> bool {
        self.any.lists_modes()
    }

    fn modes(&self, bodies: &[Body<T>]) -> Result<Option<Vec<Mode<T>>>, GroupError> {
        let kernel = self.at(bodies)?;
        let Some(modes) = kernel.modes(bodies)? else { return Ok(None) };
        let mut all = bodies.to_vec();
        let each = modes.into_iter().map(|mode| {
            kernel.frame().links.iter().zip(&mode.bodies).for_each(|(link, body)| all[*link] = *body);
            self.spread(&mut all);
            let bodies = self.frame.links.iter().map(|link| all[*link]).collect();
            Mode { bodies, ..mode }
        });
        Ok(Some(each.collect()))
    }

    fn health(&self, bodies: &[Body<T>]) -> f64 {
        self.at(bodies).map_or(0.0, |kernel| kernel.health(bodies))
    }

    fn resolution(&self, bodies: &[Body<T>]) -> f64 {
        self.at(bodies).map_or(1.0, |kernel| kernel.resolution(bodies))
    }
}

/// What is left of the constraint by which a driven pair follows its coordinate: the sine of an angle, or a length in m.
pub(crate) fn violation<T: Real>(driven: &Driven, bodies: &[Body<T>]) -> T {
    let Driven { pair: Pair { a, b, geometry, .. }, coordinate } = *driven;
    let (a, b, coordinate) = (&bodies[a], &bodies[b], &bodies[coordinate]);
    match geometry {
        PairGeometry::Pin { .. } => angle_between(a, b.turned([coordinate.c, coordinate.s])),
        PairGeometry::Slide { point, through, angle, .. } => {
            let gap = minus(a.point(vector(point)), b.point(vector(through)));
            dot(gap, b.turned(direction(angle))) - coordinate.x
        }
    }
}

/// The angle from a direction to the x axis of a body: its sine where that is small; turned round by more than a right angle it is not
/// satisfied.
pub(crate) fn angle_between<T: Real>(body: &Body<T>, wanted: [T; 2]) -> T {
    let (sine, cosine) = (wanted[0] * body.s - wanted[1] * body.c, wanted[0] * body.c + wanted[1] * body.s);
    let whole = T::from_f64(if sine.to_f64() < 0.0 { -2.0 } else { 2.0 });
    if cosine.at_least(0.0) { sine } else { whole - sine }
}
