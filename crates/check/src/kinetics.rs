//! The reduced inertia, written out over the links once more.

use assur_group::Body;
use assur_mechanism::Mechanism;

/// J = sum(m vS'² + I w'²) and J' = 2 sum(m vS' aS' + I w' e'); theory of the project, section 3.
pub(crate) fn reduced(mechanism: &Mechanism, bodies: &[Body<f64>]) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (link, body) in mechanism.links.iter().zip(bodies).skip(1) {
        let arm = body.arm(link.center);
        let (v, a) = (body.first(arm), body.second(arm));
        sum[0] += link.mass * (v[0] * v[0] + v[1] * v[1]) + link.inertia * body.w1 * body.w1;
        sum[1] += 2.0 * (link.mass * (v[0] * a[0] + v[1] * a[1]) + link.inertia * body.w1 * body.w2);
    }
    sum
}
