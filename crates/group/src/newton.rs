//! Places of any group without a closed form: Newton's method on the constraints of its pairs.

use assur_number::Real;

use crate::general::{guide, jacobian, sized, unfit};
use crate::linear::Lu;
use crate::plane::{direction, minus, times, vector};
use crate::{
    AssurGroup, Body, BuildError, GroupError, GroupFrame, GroupKind, LEAST_HEALTH, Number, PairGeometry,
};

/// Kernel of any kind without closed forms: places by Newton's method, derivatives and reactions by the general solution.
///
/// A plugin needs only its registry entry, with `builders: Builders::of::<Iterated>()`, one way and `iterates: true`.
/// The group may have at most 8 links.
#[derive(Debug, Clone)]
pub struct Iterated(GroupFrame);

impl<T: Real> AssurGroup<T> for Iterated {
    fn frame(&self) -> &GroupFrame {
        &self.0
    }

    fn place(&self, bodies: &mut [Body<T>], _way: usize) -> Result<T, GroupError> {
        place_by_newton(&self.0, bodies)
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

/// Places any group by Newton's method on its constraints, starting from the poses of its bodies on entry.
///
/// Returns the health. The assembly found is the one near the starting poses.
///
/// # Errors
///
/// [`GroupError::NoAssembly`] with the remaining gap if it does not converge; [`GroupError::Singular`] if J is
/// singular during the iteration; [`GroupError::Unfit`] for more than 8 links.
pub fn place_by_newton<T: Real>(frame: &GroupFrame, bodies: &mut [Body<T>]) -> Result<T, GroupError> {
    sized!(frame, newton_sized(frame, bodies), Err(unfit(frame)))
}

/// Constraint residuals Phi of all pairs, in units of the scale, with the sign such that J du = -Phi.
fn residual<T: Real, const N: usize>(frame: &GroupFrame, bodies: &[Body<T>]) -> [T; N] {
    let mut phi = [T::ZERO; N];
    let inverse_scale = T::ONE / T::from_f64(frame.scale);
    for (k, pair) in frame.pairs().enumerate() {
        let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
        (phi[2 * k], phi[2 * k + 1]) = match pair.geometry {
            PairGeometry::Pin { at_a, at_b } => {
                let gap = minus(a.point(vector(at_a)), b.point(vector(at_b)));
                (gap[0] * inverse_scale, gap[1] * inverse_scale)
            }
            PairGeometry::Slide { point, through, angle, tilt } => {
                let [c, s] = guide(bodies, pair.b, angle);
                let gap = minus(a.point(vector(point)), b.point(vector(through)));
                let wanted = times([c, s], direction(tilt));
                ((c * gap[1] - s * gap[0]) * inverse_scale, wanted[0] * a.s - wanted[1] * a.c)
            }
        };
    }
    phi
}

fn newton_sized<T: Real, const N: usize>(
    frame: &GroupFrame,
    bodies: &mut [Body<T>],
) -> Result<T, GroupError> {
    let mut before = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let phi = residual::<T, N>(frame, bodies);
        let size = phi.iter().map(|r| r.abs().greatest()).fold(0.0, f64::max);
        let lu = Lu::new(jacobian::<T, N>(frame, bodies));
        if lu.health.is_nan() || lu.health < LEAST_HEALTH {
            return Err(GroupError::Singular { health: lu.health });
        }
        // Converged when a further step does not reduce the residual: the rest is rounding.
        if size <= 64.0 * T::EPSILON && size >= before.min(4.0 * T::EPSILON) || size == 0.0 {
            return Ok(T::from_f64(lu.health));
        }
        before = size;
        let step = lu.solve(&phi);
        for (i, &link) in frame.links.iter().enumerate() {
            let scale = T::from_f64(frame.scale);
            nudge(&mut bodies[link], [step[3 * i] * scale, step[3 * i + 1] * scale, step[3 * i + 2]]);
        }
    }
    Err(GroupError::NoAssembly { gap_m: before * frame.scale })
}

/// Subtracts a Newton step from the pose of a body; its direction remains a unit vector.
fn nudge<T: Real>(body: &mut Body<T>, step: [T; 3]) {
    body.x -= step[0];
    body.y -= step[1];
    let (s, c) = (-step[2]).sin_cos();
    let [x, y] = body.turned([c, s]);
    let length = (x * x + y * y).sqrt();
    (body.c, body.s) = (x / length, y / length);
}
