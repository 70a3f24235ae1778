//! The kinds of quantities in a scene.

use assur_words::{Describe, Text, name, text};

/// Exponents of m, kg, s and rad. The angle has its own exponent, which distinguishes an angle from a plain number
/// and an angular speed from 1/s.
pub(crate) type Powers = [i32; 4];

/// A kind of quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::VariantArray, strum::EnumString)]
#[strum(serialize_all = "kebab-case")]
pub enum Dimension {
    /// A plain number.
    Number,
    /// m.
    Length,
    /// rad.
    Angle,
    /// kg.
    Mass,
    /// s.
    Time,
    /// N.
    Force,
    /// N m.
    Moment,
    /// m/s.
    Speed,
    /// rad/s.
    AngularSpeed,
    /// m/s².
    Acceleration,
    /// rad/s².
    AngularAcceleration,
    /// kg m².
    Inertia,
    /// N/m.
    Stiffness,
    /// N s/m.
    Damping,
    /// W.
    Power,
}

use Dimension as D;

/// Dimension, its powers, the identity of its name, its usual units (SI first), an example, the greatest size in SI.
type UnitRow = (Dimension, Powers, &'static str, &'static str, &'static str, f64);

/// Absolute values of a quantity below this, other than 0, are refused: no measurement is so fine, and products of
/// several of them underflow.
pub const LEAST: f64 = 1e-30;

// The greatest values are far beyond any machine, but small enough for results to keep digits: an angle of 1e9 rad
// has 7 digits left after its turns, a length of 1e6 m leaves 1e-10 m of rounding, and energies of the greatest
// masses and speeds stay finite. docs/ranges.md gives them to the user.
const ROWS: [UnitRow; 15] = [
    (D::Number, [0, 0, 0, 0], "scene-dimension-plain-number", "", "0.5", 1e15),
    (D::Length, [1, 0, 0, 0], "scene-dimension-length", "m, mm, cm, dm, km, um, in, ft", "120 mm", 1e6),
    (D::Angle, [0, 0, 0, 1], "scene-dimension-angle", "rad, mrad, deg, rev", "30 deg", 1e9),
    (D::Mass, [0, 1, 0, 0], "scene-dimension-mass", "kg, g, t, lb, slug", "4 kg", 1e12),
    (D::Time, [0, 0, 1, 0], "scene-dimension-time", "s, ms, min, h", "0.5 s", 1e9),
    (D::Force, [1, 1, -2, 0], "scene-dimension-force", "N, kN, MN, mN, kgf, lbf", "1.5 kN", 1e15),
    (D::Moment, [2, 1, -2, 0], "scene-dimension-moment", "N*m, kN*m, N*mm, lbf*in", "25 N*m", 1e15),
    (D::Speed, [1, 0, -1, 0], "scene-dimension-speed", "m/s, mm/s, km/h", "0.3 m/s", 1e6),
    (D::AngularSpeed, [0, 0, -1, 1], "scene-dimension-rotation", "rad/s, rpm, deg/s, rev/s", "60 rpm", 1e9),
    (D::Acceleration, [1, 0, -2, 0], "scene-dimension-acceleration", "m/s^2, mm/s^2", "9.81 m/s^2", 1e9),
    (
        D::AngularAcceleration,
        [0, 0, -2, 1],
        "scene-dimension-angular-acceleration",
        "rad/s^2, deg/s^2",
        "40 rad/s^2",
        1e12,
    ),
    (
        D::Inertia,
        [2, 1, 0, 0],
        "scene-dimension-inertia",
        "kg*m^2, g*mm^2, kg*mm^2, lb*in^2",
        "0.02 kg*m^2",
        1e15,
    ),
    (D::Stiffness, [0, 1, -2, 0], "scene-dimension-stiffness", "N/m, N/mm, kN/m, lbf/in", "4530 N/m", 1e15),
    (D::Damping, [0, 1, -1, 0], "scene-dimension-damping", "N*s/m, kN*s/m", "12 N*s/m", 1e15),
    (D::Power, [2, 1, -3, 0], "scene-dimension-power", "W, kW, MW, hp", "1.5 kW", 1e15),
];

impl Dimension {
    fn row(self) -> &'static UnitRow {
        // The first row is a fallback without a panic; a test finds each dimension in the table.
        ROWS.iter().find(|row| row.0 == self).unwrap_or(&ROWS[0])
    }

    /// Its usual units, the SI unit first: "kg, g, t, lb, slug"; empty for a plain number.
    pub fn units(self) -> &'static str {
        self.row().3
    }

    /// The SI unit of bare numbers; empty for a plain number.
    pub fn si(self) -> &'static str {
        self.units().split(", ").next().unwrap_or_default()
    }

    /// An example of a quantity of this kind: "4 kg".
    pub fn example(self) -> &'static str {
        self.row().4
    }

    /// The greatest absolute value of a quantity of this kind in a scene, SI.
    pub(crate) fn most(self) -> f64 {
        self.row().5
    }

    /// Name and units: "a mass (kg, g, t, lb, slug)".
    pub(crate) fn with_units(self) -> Text {
        if self == Self::Number {
            return self.describe();
        }
        text!("scene-with-units", quantity = self.describe(), units = name(self.units()))
    }

    /// The kind of quantity with these powers, if a scene has one.
    pub(crate) fn of(powers: Powers) -> Option<Self> {
        ROWS.iter().find(|row| row.1 == powers).map(|row| row.0)
    }

    /// Whether a unit of these powers measures this kind; for rotation also 1/s and 1/s², as in the SI.
    pub(crate) fn accepts(self, powers: Powers) -> bool {
        let turning = matches!(self, Self::AngularSpeed | Self::AngularAcceleration);
        let own = self.row().1;
        own == powers || (turning && powers == [own[0], own[1], own[2], 0])
    }
}

impl Describe for Dimension {
    /// Its name with an article: "a mass".
    fn describe(&self) -> Text {
        text!(self.row().2)
    }
}
