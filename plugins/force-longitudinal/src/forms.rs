//! The two forms of the solution. The stable one: R3 from moments about A, which never goes to infinity.
//!
//! The published one: the pole P in plain coordinates (L eqs. 1-12, for any load on the coupler and any line 3).
//!
//! Axes as in L: origin O, x along line 3 (across the guide), y along the guide, away from the slider; f1 is the angle of OA from
//! -y towards x. K and B are taken from the position, not from the printed (8), (9), which apply to the press alone.

use assur_force::ForceError;
use assur_group::LEAST_HEALTH;
use assur_group::plane::{cross, dot, length, minus, opposite, perp, plus, scaled};
use assur_kinematics::Linkage;
use assur_number::{ROUNDING, elementary};
use assur_words::{Text, text};

use crate::layout::{End, Layout, Setting, Unknowns};
use crate::{Longitudinal, singular};

/// Why the equations have no solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Failure {
    /// The crank is parallel to line 3 up to this angle, rad.
    Parallel(f64),
    /// P falls on A: the coupler lies along line 3 and the group is singular; the sine between them.
    Singular(f64),
}

/// Solves the equations.
///
/// # Errors
///
/// [`Failure`] where P or the ratios are not determined.
pub(crate) fn published(at: &Setting) -> Result<Unknowns, Failure> {
    let (x, y) = (at.line, perp(at.line));
    let (along, r1) = at.crank();
    let (sin, cos) = (dot(along, x), -dot(along, y));
    if cos.abs() <= ROUNDING {
        return Err(Failure::Parallel(elementary::asin(cos.abs())));
    }
    let action = at.action();
    let from_o = |point| minus(point, at.o);
    let (xk, yk) = (dot(from_o(action.at), x), dot(from_o(action.at), y));
    // P: on line 3, at the height of B, and on the line of the crank.
    let yp = dot(from_o(at.b), y);
    let xp = -yp * (sin / cos);
    let ap = -yp / cos - r1;
    let rod = minus(at.b, at.a);
    let health = cross(rod, x).abs() / length(rod);
    if health.is_nan() || health < LEAST_HEALTH || ap == 0.0 {
        return Err(Failure::Singular(health));
    }
    let (fx, fy) = (dot(at.force, x), dot(at.force, y)); // L eq. (2)
    let (x2, y2) = (xp - xk, yk - yp); // L eqs. (8), (9): distances of K and P
    let mc = fy * x2 + fx * y2 - action.couple; // L eq. (7), clockwise; the couple is what L does not have
    let mb = mc * r1 / ap; // L eq. (6), clockwise
    let fb = mb / r1; // L eq. (5)
    let r1 = (fy - fb * sin) / cos; // L eq. (10), from (1), (3): Fy - Fb sin f1 - R1 cos f1 = 0
    let r3 = fx - fb * cos + r1 * sin; // L eq. (11), from (1), (4): Fx - Fb cos f1 + R1 sin f1 - R3 = 0
    let vector = |u: f64, v: f64| plus(scaled(u, x), scaled(v, y));
    // RA = |Fb + R1| and RB = R3 of L eq. (12) follow where the reactions in the pairs are stored.
    Ok(Unknowns { fb: vector(-fb * cos, -fb * sin), r1: vector(r1 * sin, -r1 * cos), r3: vector(-r3, 0.0) })
}

impl Failure {
    pub(crate) fn explain(self, linkage: &Linkage, layout: &Layout, coordinate: f64) -> ForceError {
        match self {
            Self::Parallel(angle) => {
                let lines = lines(linkage, layout);
                ForceError::Parallel { coordinate, lines, angle, instead: Longitudinal::Stable.name() }
            }
            Self::Singular(health) => singular(linkage, coordinate, health),
        }
    }
}

/// The two lines that meet in the pole.
fn lines(linkage: &Linkage, layout: &Layout) -> Text {
    let [crank, third] = [layout.crank, layout.third].map(|link| &linkage.mechanism.links[link].name);
    match layout.end {
        End::Guide(_) => text!("force-longitudinal-lines-guide", crank, third),
        End::Pin(_) => text!("force-longitudinal-lines-rocker", crank, third),
    }
}

/// Solves for the unknowns.
///
/// This is the published system with P in homogeneous coordinates: only the ratio of the moments about A enters, so the
/// weight of P, which is zero for a pole at infinity, cancels.
///
/// # Errors
///
/// The sine of the angle between coupler and line 3 where it is zero: the group itself is singular.
pub(crate) fn stable(at: &Setting) -> Result<Unknowns, f64> {
    let rod = minus(at.b, at.a);
    let arm = cross(rod, at.line);
    let health = arm.abs() / length(rod);
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
