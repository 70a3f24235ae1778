//! What the columns of tables are called in JSON and in CSV.

use std::borrow::Cow;

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema};

use super::{axis, of, unit};

/// A step into an object or an array of JSON.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PathStep<'a> {
    /// Into an object.
    Key(Cow<'a, str>),
    /// Into an array.
    Item(usize),
}

/// The keys of a row in JSON, in their order.
pub const KEYS: &str = "time coordinate coordinates speed speeds acceleration accelerations_of_inputs work_driving work_resisting work_friction kinetic_energy works \
                        kinetic_energies reduced_loads links \
                        points slides velocities accelerations reduced loads inertia_loads shaking reactions method \
                        friction balancing balancing_without_friction efficiency reactions_by_cause balancing_by_cause holding residuals condition friction_certificate";

/// The name of the owner of a column; of a residual its own.
fn owner(schema: &Schema, column: Column) -> Cow<'_, str> {
    match column.quantity {
        Quantity::Residual(of) => of.name(column.owner).into(),
        _ => schema.name(column.owner),
    }
}

/// The name of the link on which a force acts.
fn link(schema: &Schema, column: Column) -> &str {
    if let Owner::PairOn(_, link) = column.owner { &schema.links[link] } else { "" }
}

/// The name of the drive to which a column belongs, or with respect to whose coordinate it is derived, where results name each.
fn drive(schema: &Schema, column: Column) -> Option<&str> {
    let ((Quantity::Partial { drive: index, .. }, _) | (_, Owner::Drive(index))) =
        (column.quantity, column.owner)
    else {
        return None;
    };
    schema.drives.get(index).filter(|_| schema.names_drives).map(|(name, _)| name.as_str())
}

/// Where a column stands in the object of a row; `None` where JSON does not have it. The share of a cause stands under the
/// cause.
pub fn path(schema: &Schema, column: Column) -> Option<Vec<PathStep<'_>>> {
    let pattern = Some(of(column).json).filter(|keys| !keys.is_empty())?;
    let drive = drive(schema, column);
    let key = |key| match key {
        "*" => Some(owner(schema, column)),
        "+" => Some(link(schema, column).into()),
        "@" => drive.map(Into::into),
        "coordinates" if drive.is_none() => Some("coordinate".into()),
        "speeds" if drive.is_none() => Some("speed".into()),
        "accelerations_of_inputs" if drive.is_none() => Some("acceleration".into()),
        key => Some(key.into()),
    };
    let mut keys: Vec<Cow<'_, str>> = pattern.split('.').filter_map(key).collect();
    if let Some(cause) = column.cause {
        keys[0] += "_by_cause";
        keys.insert(1, schema.causes[cause].as_str().into());
    }
    let item = match column.part {
        Part::Whole | Part::Modulus => None,
        Part::X => Some(PathStep::Item(0)),
        Part::Y => Some(PathStep::Item(1)),
    };
    Some(keys.into_iter().map(PathStep::Key).chain(item).collect())
}

/// The name of a column in CSV and Parquet, with its unit; `None` where these don't have it.
pub fn csv(schema: &Schema, column: Column) -> Option<String> {
    csv_of(schema, column, "")
}

/// The same of a statistic of the column, whose word stands before the unit: `A_x_min_m`.
pub fn csv_of(schema: &Schema, column: Column, statistic: &str) -> Option<String> {
    let pattern = Some(of(column).csv).filter(|pattern| !pattern.is_empty() && column.cause.is_none())?;
    let mut name = String::new();
    for c in pattern.chars() {
        match c {
            '*' => name += &owner(schema, column),
            '+' => name += link(schema, column),
            '%' => name += axis(column.part),
            '@' => match drive(schema, column) {
                Some(drive) => name += drive,
                None => name.truncate(name.len() - 1),
            },
            c => name.push(c),
        }
    }
    if matches!(column.quantity, Quantity::Residual(_)) {
        name = name.replace(' ', "_");
    }
    if !statistic.is_empty() {
        name = name + "_" + statistic;
    }
    Some(unit(schema, column).column(name))
}
