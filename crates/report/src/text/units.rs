//! Units of the report, which depend on the kind of the input coordinate.

/// A unit and the factor from SI.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unit {
    /// Name in headers.
    pub(super) name: &'static str,
    /// Factor from SI.
    pub(super) factor: f64,
}

const fn unit(name: &'static str, factor: f64) -> Unit {
    Unit { name, factor }
}

/// Degrees in a radian.
const DEG: f64 = 180.0 / std::f64::consts::PI;

/// Units by order of derivative.
#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    /// Of the coordinate.
    pub(super) coordinate: Unit,
    /// Of its speed and acceleration.
    pub(super) rates: [Unit; 2],
    /// Of angles: PF0, PF1, PF2.
    pub(super) angle: [Unit; 3],
    /// Of lengths: PF0, PF1, PF2.
    pub(super) length: [Unit; 3],
    /// Of reduced inertia and its derivative, and of the reduced load.
    pub(super) reduced: [Unit; 3],
}

/// kg.
pub(super) const KILOGRAM: Unit = unit("kg", 1.0);
/// s.
pub(super) const SECOND: Unit = unit("s", 1.0);
/// N m.
pub(super) const MOMENT: Unit = unit("N·m", 1.0);
/// J.
pub(super) const JOULE: Unit = unit("J", 1.0);
/// N.
pub(super) const FORCE: Unit = unit("N", 1.0);
/// mm.
pub(super) const LENGTH: Unit = unit("mm", 1e3);
/// W.
pub(super) const POWER: &str = "W";
/// deg.
pub(super) const ANGLE: Unit = unit("deg", DEG);
/// Speed and acceleration of links.
pub(super) const TURNING: [Unit; 2] = [unit("rad/s", 1.0), unit("rad/s²", 1.0)];
/// Speed and acceleration of points and slides.
pub(super) const MOVING: [Unit; 2] = [unit("m/s", 1.0), unit("m/s²", 1.0)];

impl Units {
    pub(super) fn of(angular: bool) -> Self {
        if angular {
            Self {
                coordinate: ANGLE,
                rates: TURNING,
                angle: [ANGLE, unit("1", 1.0), unit("1/rad", 1.0)],
                length: [LENGTH, unit("mm/rad", 1e3), unit("mm/rad²", 1e3)],
                reduced: [unit("kg·m²", 1.0), unit("kg·m²/rad", 1.0), MOMENT],
            }
        } else {
            Self {
                coordinate: LENGTH,
                rates: MOVING,
                angle: [ANGLE, unit("rad/m", 1.0), unit("rad/m²", 1.0)],
                length: [LENGTH, unit("1", 1.0), unit("1/m", 1.0)],
                reduced: [unit("kg", 1.0), unit("kg/m", 1.0), FORCE],
            }
        }
    }
}
