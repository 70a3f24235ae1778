//! Places of any group without a closed form: Newton's method on the constraints of its pairs, with its certificate.
//!
//! A mode keeps the sign of its determinant until it meets another one, whose sign is the opposite. So a pose near the
//! wanted one and this sign determine a mode, also close to the place where two of them meet.

use assur_number::{Real, elimination::Factored};

use crate::driven::{angle_between, violation};
use crate::general::{derive_by, right_side, sized, unfit};
use crate::plane::{direction, length, minus, times, vector};
use crate::solver::{Solver, entries, guide};
use crate::{
    AssurGroup, Body, BuildError, GroupError, GroupFrame, GroupKind, Number, Order, Pair, PairGeometry,
};

/// Kernel of any kind without closed forms: places by Newton's method, derivatives and reactions by the general solution.
///
/// A plugin needs only its registry entry, with `builders: Builders::of::<Iterated>()` and `iterates: true`. Groups of more
/// than 8 links are solved with sparse matrices, which are allocated.
#[derive(Debug, Clone)]
pub struct Iterated(GroupFrame);

impl<T: Real> AssurGroup<T> for Iterated {
    fn frame(&self) -> &GroupFrame {
        &self.0
    }

    /// The sign of the determinant.
    fn ways(&self) -> usize {
        2
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        self.solve(bodies, way, Order::Place)
    }

    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        let frame = &self.0;
        sized!(frame, solve_signed(frame, bodies, way == 0, order), Err(unfit(frame)))
    }
}

impl GroupKind for Iterated {
    type Kernel<T: Number> = Self;

    fn build<T: Number>(frame: &GroupFrame) -> Result<Self, BuildError> {
        Ok(Self(frame.clone()))
    }
}

/// Greatest number of steps of Newton's method.
const MOST_STEPS: usize = 60;

/// Greatest turn of a link in one step, rad.
const MOST_TURN: f64 = 0.7;

/// How often a step is halved that makes the violations greater.
const HALVINGS: usize = 6;

/// Violations below this are not made smaller by shorter steps, in parts of the scale: rounding decides.
const SMALL: f64 = 1e-6;

/// Places any group by Newton's method on its constraints, starting from the poses of its bodies on entry.
///
/// Returns the health. The assembly found is one near the starting poses; a step that makes the violations greater is
/// shortened.
///
/// # Errors
///
/// [`GroupError::NoAssembly`] with the remaining gap if it does not converge; [`GroupError::Singular`] if J is
/// singular during the iteration; [`GroupError::Unfit`] for a wrong count of pairs.
pub fn place_by_newton<T: Real>(frame: &GroupFrame, bodies: &mut [Body<T>]) -> Result<T, GroupError> {
    sized!(frame, newton_health(frame, bodies), Err(unfit(frame)))
}

fn newton_health<T: Real, S: Solver<T>>(frame: &GroupFrame, bodies: &mut [Body<T>]) -> Result<T, GroupError> {
    newton_sized::<T, S>(frame, bodies).map(|lu| T::from_f64(lu.factored().health))
}

/// Places a group in the mode near the poses on entry whose determinant has the sign asked for, and differentiates its motion.
fn solve_signed<T: Real, S: Solver<T>>(
    frame: &GroupFrame,
    bodies: &mut [Body<T>],
    is_positive: bool,
    order: Order,
) -> Result<T, GroupError> {
    let mut found: S = newton_sized(frame, bodies)?;
    let Factored { health, is_positive: is_found_positive } = found.factored();
    if is_found_positive != is_positive && health >= (256.0 * T::EPSILON).sqrt() {
        to_partner(frame, bodies, &found);
        found = newton_sized(frame, bodies)?;
        if found.factored().is_positive != is_positive {
            return Err(GroupError::NoAssembly { gap_m: 0.0 });
        }
    }
    if order > Order::Place {
        derive_by(&found, frame, bodies, order)?;
    }
    Ok(T::from_f64(found.factored().health))
}

/// Moves the links of a placed group to about where the mode is that would meet this one: along the motion v that the
/// constraints hinder least, by t with w J v + t/2 w H(v, v) = 0, where w is the self-stress that is least hindered.
fn to_partner<T: Real, S: Solver<T>>(frame: &GroupFrame, bodies: &mut [Body<T>], lu: &S) {
    let transposed = S::factor(frame, bodies, true);
    let v = weakest(frame, lu);
    let w = weakest(frame, &transposed);
    let mut moved = bodies.to_vec();
    let scale = T::from_f64(frame.scale);
    for body in &mut moved {
        let Body { x, y, c, s, .. } = *body;
        *body = Body { x, y, c, s, ..Body::ground() };
    }
    for (part, &link) in v.as_ref().chunks_exact(3).zip(&frame.links) {
        let body = &mut moved[link];
        (body.x1, body.y1, body.w1) = (part[0] * scale, part[1] * scale, part[2]);
    }
    let mut linear = T::ZERO;
    entries(frame, bodies, |row, column, entry| {
        linear += w.as_ref()[row] * entry * v.as_ref()[column];
    });
    let mut bend = S::zeros(frame);
    // The right-hand side of the second order is minus the quadratic terms.
    right_side(frame, &moved, true, bend.as_mut());
    let curved = bend.as_ref().iter().zip(w.as_ref()).fold(T::ZERO, |sum, (bend, w)| sum + *bend * *w);
    let t = linear.twice() / curved;
    let most = v.as_ref().chunks_exact(3).map(|part| part[2].abs().to_f64()).fold(0.0, f64::max);
    let length = t.abs().to_f64() * most;
    let t = if length > 1.0 { t * T::from_f64(1.0 / length) } else { t };
    if t.to_f64().is_finite() {
        // A step subtracts.
        take(frame, bodies, v.as_ref(), -t);
    }
}

/// The unit vector that a matrix makes smallest, by inverse iteration.
fn weakest<T: Real, S: Solver<T>>(frame: &GroupFrame, lu: &S) -> S::Vector {
    let mut x = S::zeros(frame);
    let count = 3 * frame.links.len();
    for (i, part) in x.as_mut().iter_mut().take(count).enumerate() {
        *part = T::from_f64(1.0 + 0.37 * (i % 3) as f64 - 0.21 * (i % 5) as f64);
    }
    for _ in 0..3 {
        x = lu.solve(&x);
        let square = x.as_ref().iter().fold(T::ZERO, |sum, part| sum + *part * *part);
        let inverse = T::ONE / square.sqrt();
        x.as_mut().iter_mut().for_each(|part| *part = *part * inverse);
    }
    x
}

/// Constraint residuals Phi of all pairs, in units of the scale, with the sign such that J du = -Phi; their greatest size.
fn residual<T: Real>(frame: &GroupFrame, bodies: &[Body<T>], phi: &mut [T]) -> f64 {
    let inverse_scale = T::ONE / T::from_f64(frame.scale);
    let mut most = 0.0_f64;
    let mut note = |row: usize, part: T| {
        phi[row] = part;
        let size = part.abs().greatest();
        most = if size <= most { most } else { size };
    };
    for (k, pair) in frame.pairs().enumerate() {
        let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
        let both = match pair.geometry {
            PairGeometry::Pin { at_a, at_b } => {
                let gap = minus(a.point(vector(at_a)), b.point(vector(at_b)));
                [gap[0] * inverse_scale, gap[1] * inverse_scale]
            }
            PairGeometry::Slide { point, through, angle, tilt } => {
                let [c, s] = guide(bodies, pair.b, angle);
                let gap = minus(a.point(vector(point)), b.point(vector(through)));
                let turn = angle_between(a, times([c, s], direction(tilt)));
                [(c * gap[1] - s * gap[0]) * inverse_scale, turn]
            }
        };
        both.into_iter().enumerate().for_each(|(row, part)| note(2 * k + row, part));
    }
    let pairs = frame.pairs().count();
    for (k, driven) in frame.driven.iter().enumerate() {
        let unit = if driven.pair.is_slide() { inverse_scale } else { T::ONE };
        note(2 * pairs + k, violation(driven, bodies) * unit);
    }
    most
}

fn newton_sized<T: Real, S: Solver<T>>(frame: &GroupFrame, bodies: &mut [Body<T>]) -> Result<S, GroupError> {
    let mut phi = S::zeros(frame);
    let mut size = residual(frame, bodies, phi.as_mut());
    let mut least = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let lu = S::factor(frame, bodies, false);
        lu.determined()?;
        // Converged when no further step reduces the residual: the rest is rounding.
        if size <= 64.0 * T::EPSILON && size >= least || size == 0.0 {
            return Ok(lu);
        }
        let before = size;
        least = least.min(size);
        let step = lu.solve(&phi);
        let turn = step.as_ref().chunks_exact(3).map(|part| part[2].abs().greatest()).fold(0.0, f64::max);
        let mut part = if turn > MOST_TURN { MOST_TURN / turn } else { 1.0 };
        take(frame, bodies, step.as_ref(), T::from_f64(part));
        size = residual(frame, bodies, phi.as_mut());
        for _ in 0..HALVINGS {
            if size < before || size.is_nan() || before < SMALL {
                break;
            }
            part *= 0.5;
            take(frame, bodies, step.as_ref(), T::from_f64(-part));
            size = residual(frame, bodies, phi.as_mut());
        }
    }
    // What is left of the violations is where the iteration gave up, and says nothing of a length.
    Err(GroupError::NoAssembly { gap_m: 0.0 })
}

/// Subtracts a part of a step from the poses of all links.
fn take<T: Real>(frame: &GroupFrame, bodies: &mut [Body<T>], step: &[T], part: T) {
    let scale = part * T::from_f64(frame.scale);
    for (own, &link) in step.chunks_exact(3).zip(&frame.links) {
        let body = &mut bodies[link];
        body.x -= own[0] * scale;
        body.y -= own[1] * scale;
        let (s, c) = (-(own[2] * part)).sin_cos();
        // The direction remains a unit vector.
        let [x, y] = body.turned([c, s]);
        let length = (x * x + y * y).sqrt();
        (body.c, body.s) = (x / length, y / length);
    }
}

/// Rounding of a constraint, in units of the last place.
const ROUNDINGS: f64 = 16.0;

/// The distance within which a placed group is certainly the only assembly, in rad and parts of the scale, by the theorem of
/// Newton and Kantorovich: with the size b of the inverse of J, a Lipschitz constant g of J and the length e of the next
/// step, b g e <= 1/2 proves a root at most 2 e away and none other within 1 / (b g). `None` where that is not proved.
pub fn certify_generally<T: Real>(frame: &GroupFrame, bodies: &[Body<T>]) -> Option<f64> {
    fn certified<T: Real, S: Solver<T>>(frame: &GroupFrame, bodies: &[Body<T>]) -> Option<f64> {
        let lu = S::factor(frame, bodies, false);
        let count = 3 * frame.links.len();
        let mut sums = vec![0.0_f64; count];
        for column in 0..count {
            let mut unit = S::zeros(frame);
            unit.as_mut()[column] = T::ONE;
            let found = lu.solve(&unit);
            sums.iter_mut().zip(found.as_ref()).for_each(|(sum, part)| *sum += part.abs().greatest());
        }
        let inverse = sums.into_iter().fold(0.0, f64::max);
        let mut phi = S::zeros(frame);
        let violation = residual(frame, bodies, phi.as_mut()) + ROUNDINGS * T::EPSILON;
        let bent = inverse * frame.pairs().map(|pair| bend(pair, frame.scale, bodies)).fold(0.0, f64::max);
        let is_proved = bent * inverse * violation <= 0.5;
        is_proved.then(|| 1.0 / bent)
    }
    sized!(frame, certified(frame, bodies), None)
}

/// Lipschitz constant of the two rows of a pair in J, in the greatest norm.
fn bend<T: Real>(pair: &Pair, scale: f64, bodies: &[Body<T>]) -> f64 {
    let far = |a: [f64; 2]| length(a) / scale;
    match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => far(at_a) + far(at_b),
        PairGeometry::Slide { point, .. } => {
            let way = minus(bodies[pair.a].point(vector(point)), bodies[pair.b].origin());
            let across = far(way.map(|part| part.abs().greatest()));
            // The normal turns with b: four entries of a unit vector, two arms, and the way between the origins.
            2.0 * 2.0_f64.sqrt() + 2.0 + 3.0 * far(point) + across
        }
    }
}
