//! From the longitudinal reactions to the reactions in the pairs (L eq. 12).

use assur_force::Reactions;
use assur_group::plane::{cross, dot, minus, plus, scaled};
use assur_group::{Body, Wrench};

use crate::layout::{End, Layout};
use crate::setting::{Setting, Unknowns};

/// Force of the pin A on the coupler, N.
pub(crate) fn at_a(found: &Unknowns) -> [f64; 2] {
    plus(found.fb, found.r1)
}

/// Force of the pin B on the coupler, N.
pub(crate) fn at_b(at: &Setting, found: &Unknowns) -> [f64; 2] {
    plus(at.known, found.r3)
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
