//! How a reaction stands to the dry friction of its pair, as the textbooks draw it: that of a pin touches the circle of friction,
//! that of a slide leans against the sliding by the angle of friction.

use assur_mechanism::{Friction, Surfaces};

/// Friction that is greater by this part than one normal force gives is that of two.
const ROUNDING: f64 = 1e-9;

/// The circle of friction of a pin and the force of the pin on a link (N, N), with the moment of the friction on that link, N m: the
/// radius of the circle, coefficient times radius of the journal, m; and the distance of the force from the center, m, positive where
/// its moment about the center is counter-clockwise. `None` without friction or force.
pub fn friction_circle(friction: &Friction, force: [f64; 2], moment: f64) -> Option<(f64, f64)> {
    let Surfaces::Journal { radius, .. } = friction.surfaces else { return None };
    let (radius, size) = (friction.coefficient * radius, force[0].hypot(force[1]));
    (radius > 0.0 && size > 0.0).then(|| (radius, moment / size))
}

/// The cone of friction of a slide and its force (N, N), whose guide has the direction `along`, a unit vector, with the force of
/// friction, N: the angle of friction, rad; the part of the force across the guide, N, positive to the left of `along`; and whether both
/// ends of the contact are pressed, in opposite senses: then the friction is greater than that of their sum. `None` without friction
/// or force.
pub fn friction_cone(
    friction: &Friction,
    force: [f64; 2],
    along: [f64; 2],
    share: f64,
) -> Option<(f64, f64, bool)> {
    let (angle, size) = (friction.coefficient.atan(), force[0].hypot(force[1]));
    let normal = force[1] * along[0] - force[0] * along[1];
    let on_both_ends = share.abs() > (1.0 + ROUNDING) * angle.tan() * normal.abs();
    (angle > 0.0 && size > 0.0).then_some((angle, normal, on_both_ends))
}
