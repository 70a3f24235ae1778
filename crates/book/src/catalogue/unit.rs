//! The unit of a quantity, in SI and as it is shown.

use assur_analysis::results::{Column, Owner, Quantity, Schema};

use super::of;

/// What a number measures.
#[derive(Debug, Clone, Copy)]
pub(super) enum Measure {
    /// A plain number.
    Number,
    Time,
    /// Where its owner is: an angle of a link, a length of a point or slide, the coordinate of the input.
    Place,
    /// A derivative of the place by the coordinate, of this order.
    Transfer(u8),
    /// A derivative of the place by time, of this order.
    Rate(u8),
    /// Inertia reduced to the input.
    Inertia,
    /// Its derivative with respect to the coordinate.
    InertiaDerivative,
    /// What acts on the input along its coordinate.
    OnInput,
    /// The balancing load: a moment or a force.
    Balancing,
    Moment,
    Force,
    /// Work or energy.
    Energy,
    /// A power; without a motion the work by unit of the coordinate.
    Power,
    Length,
    /// A load of the scene.
    Load,
}

/// The unit of a derivative: `m/s2`.
fn derivative(base: &str, by: &str, order: u8) -> String {
    match order {
        0 => base.to_owned(),
        1 => format!("{base}/{by}"),
        order => format!("{base}/{by}{order}"),
    }
}

/// The SI unit of a column: `kg m2/rad`; empty for a plain number.
pub fn unit(schema: &Schema, column: Column) -> String {
    let (coordinate, on_input, inertia) =
        if schema.angular { ("rad", "N m", "kg m2") } else { ("m", "N", "kg") };
    let place = match column.owner {
        Owner::Link(_) => "rad",
        Owner::Input => coordinate,
        _ => "m",
    };
    let unit = match of(column).measure {
        Measure::Number => "",
        Measure::Time => "s",
        Measure::Place => place,
        Measure::Transfer(order) => return derivative(place, coordinate, order),
        Measure::Rate(order) => return derivative(place, "s", order),
        Measure::Inertia => inertia,
        Measure::InertiaDerivative => return derivative(inertia, coordinate, 1),
        Measure::Balancing if schema.balances_by_moment => "N m",
        Measure::Moment => "N m",
        Measure::Balancing | Measure::Force => "N",
        Measure::Energy => "J",
        Measure::Power if schema.find(Column::of(Quantity::Velocity, Owner::Input)).is_some() => "W",
        Measure::OnInput | Measure::Power => on_input,
        Measure::Length => "m",
        Measure::Load => match column.owner {
            Owner::Load(load) => schema.unit_of_load(load),
            _ => "N",
        },
    };
    unit.to_owned()
}

/// A unit in which a quantity is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// Its symbol.
    pub unit: String,
    /// How many of these units the SI unit has.
    pub factor: f64,
}

/// The unit in which angles are shown, and how many of it a radian has.
pub const ANGLE: (&str, f64) = ("deg", 180.0 / std::f64::consts::PI);
/// The unit in which lengths are shown, and how many of it a meter has.
pub const LENGTH: (&str, f64) = ("mm", 1e3);

/// The unit in which a column is shown: places in degrees and millimeters, derivatives of lengths by the coordinate in
/// millimeters, everything else in SI.
pub fn shown(schema: &Schema, column: Column) -> Shown {
    let unit = unit(schema, column);
    let (symbol, factor) = match (of(column).measure, unit.as_str()) {
        (Measure::Place, "rad") => (ANGLE.0.to_owned(), ANGLE.1),
        (Measure::Place | Measure::Length, "m") => (LENGTH.0.to_owned(), LENGTH.1),
        (Measure::Transfer(order), _) if unit.starts_with('m') && schema.angular => {
            (derivative(LENGTH.0, "rad", order), LENGTH.1)
        }
        _ => (unit, 1.0),
    };
    Shown { unit: symbol, factor }
}
