//! From the longitudinal reactions to the reactions in the pairs (L eq. 12).

use assur_force::Reactions;
use assur_group::plane::{cross, dot, minus, perp, plus, scaled};
use assur_group::{Body, Wrench};

use crate::layout::{End, Layout};
use crate::layout::{Setting, Unknowns};

/// Force of the pin A on the coupler, N.
pub(crate) fn at_a(found: &Unknowns) -> [f64; 2] {
    plus(found.fb, found.r1)
}

/// Force of the pin B on the coupler, N.
pub(crate) fn at_b(at: &Setting, found: &Unknowns) -> [f64; 2] {
    plus(at.known, found.r3)
}

/// Fb, R1, R3 with the signs of L: Fb against the turning of A towards x, R1 from O to A, R3 towards -x on the coupler, where y goes
/// along the guide (across the rocker) so that B is below O, and x to the right of it.
pub(crate) fn in_axes(at: &Setting, found: &Unknowns) -> [f64; 3] {
    let (crank, _) = at.crank();
    let x = if dot(minus(at.b, at.o), perp(at.line)) < 0.0 { at.line } else { scaled(-1.0, at.line) };
    [-dot(found.fb, perp(crank)), dot(found.r1, crank), -dot(found.r3, x)]
}

/// Stores every reaction and the balancing moment.
pub(crate) fn store(
    layout: &Layout,
    at: &Setting,
    found: &Unknowns,
    bodies: &[Body<f64>],
    loads: &[Wrench<f64>],
    out: &mut Reactions,
) {
    let (at_a, at_b) = (at_a(found), at_b(at, found));
    layout.a.store(at_a, &mut out.pairs);
    layout.b.store(at_b, &mut out.pairs);
    // Loads of the crank change only what follows.
    layout.o.store(minus(at_a, loads[layout.crank].force()), &mut out.pairs);
    out.balancing = cross(minus(at.a, at.o), at_a) - at.moment_o;
    out.further.clear();
    out.further.extend(in_axes(at, found));
    let third = &loads[layout.third];
    match &layout.end {
        End::Pin(pin) => pin.store(minus(at_b, third.force()), &mut out.pairs),
        End::Guide(guide) => {
            let body = &bodies[layout.third];
            let own = body.point(guide.own);
            let across = dot(minus(found.r3, third.force()), at.line);
            let moment = cross(minus(at.b, own), at_b) - third.about(body.arm(guide.own));
            guide.store(bodies, scaled(across, at.line), moment, &mut out.pairs);
        }
    }
}
