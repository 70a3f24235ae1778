//! How a reaction stands to the dry friction of its pair, as the textbooks draw it: that of a pin touches the circle of friction,
//! that of a slide leans against the sliding by the angle of friction.

use assur_mechanism::{Friction, Surfaces};

/// Friction that is greater by this part than one normal force gives is that of two.
const ROUNDING: f64 = 1e-9;

/// A reaction beside the friction of its pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrictionDiagram {
    /// Of a pin.
    Circle {
        /// Radius of the circle of friction: coefficient times radius of the journal, m.
        radius: f64,
        /// Moment of the friction by the force, m: the distance of the force from the center, positive where its moment about the
        /// center is counter-clockwise.
        lever: f64,
    },
    /// Of a slide.
    Cone {
        /// Angle of friction, rad.
        angle: f64,
        /// Unit vector along the guide.
        along: [f64; 2],
        /// The part of the force across the guide, N, positive to the left of `along`.
        normal: f64,
        /// Whether both ends of the contact are pressed, in opposite senses: then the friction is greater than that of their sum.
        on_both_ends: bool,
    },
}

impl FrictionDiagram {
    /// Of the force of a pin on a link (N, N), with the moment of the friction on that link, N m. `None` without friction or force.
    pub fn of_pin(friction: &Friction, force: [f64; 2], moment: f64) -> Option<Self> {
        let Surfaces::Journal { radius, .. } = friction.surfaces else { return None };
        let (radius, size) = (friction.coefficient * radius, force[0].hypot(force[1]));
        (radius > 0.0 && size > 0.0).then(|| Self::Circle { radius, lever: moment / size })
    }

    /// Of the force of a slide (N, N) whose guide has the direction `along`, a unit vector, with the force of friction, N. `None`
    /// without friction or force.
    pub fn of_slide(friction: &Friction, force: [f64; 2], along: [f64; 2], share: f64) -> Option<Self> {
        let (angle, size) = (friction.coefficient.atan(), force[0].hypot(force[1]));
        let normal = force[1] * along[0] - force[0] * along[1];
        let on_both_ends = share.abs() > (1.0 + ROUNDING) * angle.tan() * normal.abs();
        (angle > 0.0 && size > 0.0).then_some(Self::Cone { angle, along, normal, on_both_ends })
    }
}
