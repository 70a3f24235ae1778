//! The reduced inertia, computed independently as a sum over the links.

use assur_group::Body;
use assur_mechanism::{Link, Mechanism};
use assur_number::{Dd, Real};

/// Rounding errors of the solution of one group, or of the system of all, and of a sum of the terms of one load, in
/// units of the last place of the largest term, per unit of the condition number: some twenty operations in each of two bodies, and
/// the root and the division of the group that placed them.
pub(crate) const ROUNDINGS: f64 = 64.0;

/// Rounding of a sum over loads and of its terms, as part of their sizes `total`; `added`: the sizes of all its partial sums, one
/// after the other. Each addition may be off by half a unit of what was added up before, in the sum of the program and in that
/// of the check, and equal loads round in the same direction.
pub(crate) fn rounding_of_sum(added: f64, total: f64) -> f64 {
    ROUNDINGS.max(added / total) * f64::EPSILON
}

/// J = sum(m vS'² + I w'²) and J' = sum(2 (m vS' aS' + I w' e') + I' w'²); theory of the project, section 3.
pub(crate) fn reduced<T: Real>(mechanism: &Mechanism, coordinate: T, bodies: &[Body<T>]) -> [T; 2] {
    let mut sum = [T::ZERO; 2];
    for (link, body) in mechanism.links.iter().zip(bodies).skip(1) {
        let mass = T::from_f64(link.mass);
        let [inertia, slope] = own_inertia(link, coordinate);
        let arm = body.arm(link.center.map(T::from_f64));
        let (v, a) = (body.first(arm), body.second(arm));
        sum[0] += mass * (v[0] * v[0] + v[1] * v[1]) + inertia * body.w1 * body.w1;
        sum[1] += (mass * (v[0] * a[0] + v[1] * a[1]) + inertia * body.w1 * body.w2).twice()
            + slope * body.w1 * body.w1;
    }
    sum
}

/// The moment of inertia of a link and its derivative with respect to the coordinate, in about 32 digits.
pub(crate) fn own_inertia<T: Real>(link: &Link, coordinate: T) -> [T; 2] {
    let Some(law) = link.inertia.varying() else {
        return [link.inertia.constant(), 0.0].map(T::from_f64);
    };
    let hi = coordinate.to_f64();
    let lo = (coordinate - T::from_f64(hi)).to_f64();
    let found = law.formula.precise(Dd::from_f64(hi) + Dd::from_f64(lo));
    found.map(|number| {
        let number = number * Dd::from_f64(law.factor);
        T::from_f64(number.hi) + T::from_f64(number.lo)
    })
}

/// The sizes of the terms of the moment of inertia of a link and of its derivative, in which these have a rounding unit: that of the
/// argument of a sine shows where the derivative is zero.
pub(crate) fn inertia_terms(link: &Link, coordinate: f64) -> [f64; 2] {
    let Some(law) = link.inertia.varying() else { return [link.inertia.constant(), 0.0] };
    let rounding = law.formula.rounding_with_slope(coordinate);
    rounding.map(|bound| law.factor.abs() * bound / f64::EPSILON)
}

/// Sizes of the terms of J and of J' before they cancel, in which these have a rounding unit.
pub(crate) fn sizes(mechanism: &Mechanism, coordinate: f64, bodies: &[Body<f64>]) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (link, body) in mechanism.links.iter().zip(bodies).skip(1) {
        let arm = body.arm(link.center);
        let [v, a] = [body.first(arm), body.second(arm)].map(|v| v[0].hypot(v[1]));
        let [inertia, slope] = inertia_terms(link, coordinate);
        let square = body.w1 * body.w1;
        // A direction found from points close together isn't quite of length one, by which the arm is too long or too short.
        let stretch = (body.c * body.c + body.s * body.s - 1.0).abs() / (ROUNDINGS * f64::EPSILON);
        let arm = arm[0].hypot(arm[1]) * (1.0 + stretch);
        // The motion of the origin and the rotation about it cancel at a center that nearly rests.
        let v_terms = body.x1.hypot(body.y1) + body.w1.abs() * arm;
        let a_terms = body.x2.hypot(body.y2) + (body.w2.abs() + square) * arm;
        sum[0] += link.mass * v * v_terms + inertia * square;
        sum[1] += link.mass * (v * a_terms + a * v_terms)
            + 2.0 * inertia * (body.w1 * body.w2).abs()
            + slope * square;
    }
    sum
}

#[cfg(test)]
mod tests;
