//! Motion of one link as seen from another.

use assur_group::Body;
use assur_group::plane::{minus, mirrored, perp, plus, scaled, times};

/// Pose and derivatives of `body` in the frame of `observer`.
pub(crate) fn seen_from(body: &Body<f64>, observer: &Body<f64>) -> Body<f64> {
    let back = |vector: [f64; 2]| times(vector, mirrored([observer.c, observer.s]));
    let (w, e) = (observer.w1, observer.w2);
    let arm = minus([body.x, body.y], [observer.x, observer.y]);
    // Velocity relative to the observer, along the axes of the ground; then Coriolis' theorem.
    let first = minus(minus([body.x1, body.y1], [observer.x1, observer.y1]), scaled(w, perp(arm)));
    let second = minus([body.x2, body.y2], [observer.x2, observer.y2]);
    let carried = plus(scaled(e, perp(arm)), plus(scaled(-w * w, arm), scaled(2.0 * w, perp(first))));
    let ([x, y], [c, s]) = (back(arm), back([body.c, body.s]));
    let ([x1, y1], [x2, y2]) = (back(first), back(minus(second, carried)));
    Body { x, y, c, s, x1, y1, w1: body.w1 - w, x2, y2, w2: body.w2 - e }
}
