//! The stable form: R3 from moments about A, which never goes to infinity.

use assur_group::LEAST_HEALTH;
use assur_group::plane::{cross, dot, minus, opposite, perp, plus, scaled};

use crate::setting::{Setting, Unknowns};

/// Solves for the unknowns.
///
/// This is the published system with P in homogeneous coordinates: only the ratio of the moments about A enters, so the
/// weight of P, which is zero for a pole at infinity, cancels.
///
/// # Errors
///
/// The sine of the angle between coupler and line 3 where it is zero: the group itself is singular.
pub(crate) fn solve(at: &Setting) -> Result<Unknowns, f64> {
    let rod = minus(at.b, at.a);
    let arm = cross(rod, at.line);
    let health = arm.abs() / rod[0].hypot(rod[1]);
    if health.is_nan() || health < LEAST_HEALTH {
        return Err(health);
    }
    let r3 = scaled(-at.moment_a / arm, at.line);
    // The remaining force at the pin A, in components across and along the crank.
    let at_a = opposite(plus(at.force, r3));
    let (along, _) = at.crank();
    let across = perp(along);
    Ok(Unknowns { fb: scaled(dot(at_a, across), across), r1: scaled(dot(at_a, along), along), r3 })
}
