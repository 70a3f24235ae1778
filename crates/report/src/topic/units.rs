//! Units of the report, which depend on the kind of the input coordinate.

use assur_book::Unit;

/// Degrees in a radian.
const DEG: f64 = 180.0 / std::f64::consts::PI;

/// Units by order of derivative.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    /// Of the coordinate.
    pub(crate) coordinate: Unit,
    /// Of its speed and acceleration.
    pub(crate) rates: [Unit; 2],
    /// Of angles: PF0, PF1, PF2.
    pub(crate) angle: [Unit; 3],
    /// Of lengths: PF0, PF1, PF2.
    pub(crate) length: [Unit; 3],
    /// Of reduced inertia and its derivative, and of the reduced load.
    pub(crate) reduced: [Unit; 3],
}

pub(crate) const KILOGRAM: Unit = Unit::of("kg", 1.0);
pub(crate) const SECOND: Unit = Unit::of("s", 1.0);
pub(crate) const MOMENT: Unit = Unit::of("N·m", 1.0);
pub(crate) const JOULE: Unit = Unit::of("J", 1.0);
pub(crate) const INERTIA: Unit = Unit::of("kg·m²", 1.0);
pub(crate) const FORCE: Unit = Unit::of("N", 1.0);
pub(crate) const LENGTH: Unit = Unit::of("mm", 1e3);
pub(crate) const POWER: Unit = Unit::of("W", 1.0);
pub(crate) const ANGLE: Unit = Unit::of("deg", DEG);
pub(crate) const TURN: Unit = Unit::of("rev", 1.0);
/// Speed and acceleration of links.
pub(crate) const TURNING: [Unit; 2] = [Unit::of("rad/s", 1.0), Unit::of("rad/s²", 1.0)];
/// Speed and acceleration of points and slides.
pub(crate) const MOVING: [Unit; 2] = [Unit::of("m/s", 1.0), Unit::of("m/s²", 1.0)];

impl Units {
    pub(crate) fn of(angular: bool) -> Self {
        if angular {
            Self {
                coordinate: ANGLE,
                rates: TURNING,
                angle: [ANGLE, Unit::of("1", 1.0), Unit::of("1/rad", 1.0)],
                length: [LENGTH, Unit::of("mm/rad", 1e3), Unit::of("mm/rad²", 1e3)],
                reduced: [Unit::of("kg·m²", 1.0), Unit::of("kg·m²/rad", 1.0), MOMENT],
            }
        } else {
            Self {
                coordinate: LENGTH,
                rates: MOVING,
                angle: [ANGLE, Unit::of("rad/m", 1.0), Unit::of("rad/m²", 1.0)],
                length: [LENGTH, Unit::of("1", 1.0), Unit::of("1/m", 1.0)],
                reduced: [Unit::of("kg", 1.0), Unit::of("kg/m", 1.0), FORCE],
            }
        }
    }
}
