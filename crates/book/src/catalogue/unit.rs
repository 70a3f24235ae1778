//! The units of quantities: in SI, as they are shown, and in the names of columns.

use assur_analysis::results::{Column, Owner, Quantity, Schema};
use assur_mechanism::CoordinateKind;
use assur_words::{Text, exact};

use super::of;
use crate::number::short;

/// A unit: its SI unit, which names of columns have, and the unit in which people read its numbers.
///
/// Symbols are written in ASCII, `kg m2/rad`; texts have them with the signs of print.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// The symbol of the SI unit; empty for a plain number.
    si: &'static str,
    /// The symbol of the unit that is shown.
    pub name: &'static str,
    /// How many of these units the SI unit has.
    pub factor: f64,
}

impl Unit {
    /// A plain number.
    pub const NONE: Self = Self::si("");
    /// A mass.
    pub const KILOGRAM: Self = Self::si("kg");
    /// A time.
    pub const SECOND: Self = Self::si("s");
    /// A moment.
    pub const MOMENT: Self = Self::si("N m");
    /// A force.
    pub const FORCE: Self = Self::si("N");
    /// Work and energy.
    pub const JOULE: Self = Self::si("J");
    /// A power.
    pub const POWER: Self = Self::si("W");
    /// A moment of inertia.
    pub const INERTIA: Self = Self::si("kg m2");
    /// A length.
    pub const LENGTH: Self = Self::si("m").shown("mm", 1e3);
    /// An angle.
    pub const ANGLE: Self = Self::si("rad").shown("deg", 180.0 / std::f64::consts::PI);
    /// A curvature.
    pub const CURVATURE: Self = Self::si("1/m");
    /// Angular velocity and kind acceleration.
    pub const TURNING: [Self; 2] = [Self::si("rad/s"), Self::si("rad/s2")];
    /// Velocity and acceleration.
    pub const MOVING: [Self; 2] = [Self::si("m/s"), Self::si("m/s2")];

    /// An SI unit that is shown as it is.
    pub const fn si(symbol: &'static str) -> Self {
        Self { si: symbol, name: symbol, factor: 1.0 }
    }

    /// The same, shown in another unit, of which the SI unit has `factor`.
    #[must_use]
    pub const fn shown(self, name: &'static str, factor: f64) -> Self {
        Self { name, factor, ..self }
    }

    /// An angle or a length: a place of what turns or slides.
    pub const fn place(is_angle: bool) -> Self {
        if is_angle { Self::ANGLE } else { Self::LENGTH }
    }

    /// First and second derivative by time of an angle or a length.
    pub const fn rates(is_angle: bool) -> [Self; 2] {
        if is_angle { Self::TURNING } else { Self::MOVING }
    }

    /// What the coordinate of a mechanism is.
    pub const fn coordinate(kind: CoordinateKind) -> Self {
        match kind {
            CoordinateKind::Angle => Self::ANGLE,
            CoordinateKind::Length => Self::LENGTH,
            CoordinateKind::Time => Self::SECOND,
        }
    }

    /// First and second derivative by time of the coordinate of a mechanism.
    pub const fn rates_of(kind: CoordinateKind) -> [Self; 2] {
        match kind {
            CoordinateKind::Angle => Self::TURNING,
            CoordinateKind::Length => Self::MOVING,
            CoordinateKind::Time => [Self::NONE, Self::si("1/s")],
        }
    }

    /// What acts along the coordinate of a mechanism.
    pub const fn load_of(kind: CoordinateKind) -> Self {
        match kind {
            CoordinateKind::Angle => Self::MOMENT,
            CoordinateKind::Length => Self::FORCE,
            CoordinateKind::Time => Self::POWER,
        }
    }

    /// A derivative of an angle or a length with respect to the coordinate of the input, which is of this kind.
    pub const fn transfer(is_angle: bool, kind: CoordinateKind, order: u8) -> Self {
        use CoordinateKind::{Angle, Length, Time};
        match (is_angle, kind, order) {
            (_, _, 0) => Self::place(is_angle),
            (true, Time, 1) => Self::TURNING[0],
            (true, Time, _) => Self::TURNING[1],
            (false, Time, 1) => Self::MOVING[0],
            (false, Time, _) => Self::MOVING[1],
            (true, Angle, 1) => Self::si("rad/rad"),
            (true, Angle, _) => Self::si("rad/rad2"),
            (true, Length, 1) => Self::si("rad/m"),
            (true, Length, _) => Self::si("rad/m2"),
            (false, Angle, 1) => Self::si("m/rad").shown("mm/rad", 1e3),
            (false, Angle, _) => Self::si("m/rad2").shown("mm/rad2", 1e3),
            (false, Length, 1) => Self::si("m/m"),
            (false, Length, _) => Self::si("m/m2"),
        }
    }

    /// What acts along an angle or along a length.
    pub const fn load(is_moment: bool) -> Self {
        if is_moment { Self::MOMENT } else { Self::FORCE }
    }

    /// Inertia reduced to the input and its derivative with respect to the coordinate.
    pub const fn inertias(kind: CoordinateKind) -> [Self; 2] {
        if matches!(kind, CoordinateKind::Angle) {
            [Self::INERTIA, Self::si("kg m2/rad")]
        } else {
            [Self::KILOGRAM, Self::si("kg/m")]
        }
    }

    /// The name of a column of numbers in SI, which ends with the unit: `D_x_pf2_m_per_rad2`, `flywheel_kgm2`.
    pub fn column(self, name: String) -> String {
        if self.si.is_empty() { name } else { name + "_" + &self.si.replace('/', "_per_").replace(' ', "") }
    }

    /// A number in SI with this unit, with six significant digits.
    pub fn show(self, value: f64) -> Text {
        match self.name {
            "" => self.number(value),
            symbol => assur_words::joined(" ", [self.number(value), assur_words::unit(symbol)]),
        }
    }

    /// Several numbers in SI, then the unit once.
    pub fn show_all(self, values: &[f64]) -> Text {
        let all: Vec<_> = values.iter().map(|value| self.number(*value)).collect();
        assur_words::joined(" ", [assur_words::joined("; ", all), assur_words::unit(self.name)])
    }

    /// The number alone.
    pub fn number(self, value: f64) -> Text {
        let value = value * self.factor;
        exact(value, short(value))
    }
}

/// What a number measures.
#[derive(Debug, Clone, Copy)]
pub(super) enum Measure {
    /// A number of this unit.
    In(Unit),
    /// A derivative of this order by the coordinate of where its owner is: an angle of a link, a length of a point or slide, the
    /// coordinate of the input.
    Transfer(u8),
    /// A derivative by time: velocity or acceleration.
    Rate(usize),
    /// Inertia reduced to the input, or its derivative.
    Inertia(usize),
    /// Over time a derivative by the coordinate of one drive.
    Partial,
    /// What acts on the input along its coordinate.
    OnInput,
    /// The balancing load: a moment or a force.
    Balancing,
    /// A power; without a motion the work by unit of the coordinate.
    Power,
    /// A load of the scene.
    Load,
}

/// The unit of a column.
pub fn unit(schema: &Schema, column: Column) -> Unit {
    let kind = schema.kind;
    let of_drive = |drive: usize| schema.drives.get(drive).is_some_and(|(_, is_angle)| *is_angle);
    let is_angle = match column.owner {
        Owner::Link(_) => true,
        Owner::Input => kind.is_angle(),
        Owner::Drive(drive) => of_drive(drive),
        _ => false,
    };
    // Over time what is reduced to a drive is by its coordinate.
    let kind = match (column.owner, column.quantity) {
        (Owner::Drive(drive), _) | (_, Quantity::Partial { drive, .. }) if of_drive(drive) => {
            CoordinateKind::Angle
        }
        (Owner::Drive(_), _) | (_, Quantity::Partial { .. }) => CoordinateKind::Length,
        _ => kind,
    };
    match of(column).measure {
        Measure::In(unit) => unit,
        Measure::Transfer(0) if column.owner == Owner::Input => Unit::coordinate(kind),
        Measure::Transfer(order) => Unit::transfer(is_angle, kind, order),
        Measure::Partial => {
            let order = if let Quantity::Partial { order, .. } = column.quantity { order } else { 1 };
            Unit::transfer(is_angle, kind, order)
        }
        Measure::Rate(order) if column.owner == Owner::Input => Unit::rates_of(kind)[order],
        Measure::Rate(order) => Unit::rates(is_angle)[order],
        Measure::Inertia(order) => Unit::inertias(kind)[order],
        Measure::Balancing if matches!(column.owner, Owner::Drive(_)) => Unit::load(is_angle),
        Measure::Balancing => Unit::load(schema.balances_by_moment),
        Measure::Power if schema.find(Column::of(Quantity::Velocity, Owner::Input)).is_some() => Unit::POWER,
        Measure::OnInput | Measure::Power => Unit::load_of(kind),
        Measure::Load => match column.owner {
            Owner::Load(load) => Unit::si(schema.loads[load].1),
            _ => Unit::FORCE,
        },
    }
}
