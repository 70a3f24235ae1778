//! The reduced inertia, computed independently as a sum over the links.

use assur_group::Body;
use assur_mechanism::Mechanism;
use assur_number::Real;

/// J = sum(m vS'² + I w'²) and J' = 2 sum(m vS' aS' + I w' e'); theory of the project, section 3.
pub(crate) fn reduced<T: Real>(mechanism: &Mechanism, bodies: &[Body<T>]) -> [T; 2] {
    let mut sum = [T::ZERO; 2];
    for (link, body) in mechanism.links.iter().zip(bodies).skip(1) {
        let [mass, inertia] = [link.mass, link.inertia].map(T::from_f64);
        let arm = body.arm(link.center.map(T::from_f64));
        let (v, a) = (body.first(arm), body.second(arm));
        sum[0] += mass * (v[0] * v[0] + v[1] * v[1]) + inertia * body.w1 * body.w1;
        sum[1] += (mass * (v[0] * a[0] + v[1] * a[1]) + inertia * body.w1 * body.w2).twice();
    }
    sum
}

/// Size of the terms of J' before they cancel.
pub(crate) fn slope_terms(mechanism: &Mechanism, bodies: &[Body<f64>]) -> f64 {
    let term = |(link, body): (&assur_mechanism::Link, &Body<f64>)| {
        let arm = body.arm(link.center);
        let (v, a) = (body.first(arm), body.second(arm));
        2.0 * link.mass * v[0].hypot(v[1]) * a[0].hypot(a[1]) + 2.0 * link.inertia * (body.w1 * body.w2).abs()
    };
    mechanism.links.iter().zip(bodies).skip(1).map(term).sum()
}

#[cfg(test)]
mod tests;
