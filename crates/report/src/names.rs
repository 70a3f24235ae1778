//! What the columns of tables are called in JSON and in CSV.

use std::borrow::Cow;

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema};

/// A step into an object or an array of JSON.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Step<'a> {
    Key(Cow<'a, str>),
    Item(usize),
}

/// The keys of a column in JSON, and its name in CSV without the unit. `*` stands for the name of the owner, `+` for the link
/// on which a force acts, `%` for the axis of a projection. An empty name: CSV does not have it; `None`: neither has it.
fn patterns(column: Column) -> Option<(&'static str, &'static str)> {
    use Owner::{Input, Link, PairOn, Slide};
    use Quantity as Q;
    Some(match (column.quantity, column.owner) {
        (Q::Time, _) => ("time", "time"),
        (Q::Transfer(_), Input) => ("coordinate", "coordinate"),
        (Q::Velocity, Input) => ("speed", "speed"),
        (Q::Acceleration, Input) => ("acceleration", "acceleration"),
        (Q::DrivingWork, _) => ("work_driving", "work_driving"),
        (Q::ResistingWork, _) => ("work_resisting", "work_resisting"),
        (Q::KineticEnergy, _) => ("kinetic_energy", "kinetic_energy"),
        (Q::Transfer(0), Link(_)) => ("links.*.pf0", "*_angle"),
        (Q::Transfer(1), Link(_)) => ("links.*.pf1", "*_angle_pf1"),
        (Q::Transfer(2), Link(_)) => ("links.*.pf2", "*_angle_pf2"),
        (Q::Transfer(0), Slide(_)) => ("slides.*.pf0", "*_displacement"),
        (Q::Transfer(1), Slide(_)) => ("slides.*.pf1", "*_displacement_pf1"),
        (Q::Transfer(2), Slide(_)) => ("slides.*.pf2", "*_displacement_pf2"),
        (Q::Transfer(0), _) => ("points.*.pf0", "*_%"),
        (Q::Transfer(1), _) => ("points.*.pf1", "*_%_pf1"),
        (Q::Transfer(2), _) => ("points.*.pf2", "*_%_pf2"),
        (Q::Velocity, Link(_)) => ("velocities.links.*", "*_w"),
        (Q::Velocity, Slide(_)) => ("velocities.slides.*", "*_v"),
        (Q::Velocity, _) => ("velocities.points.*", "*_v%"),
        (Q::Acceleration, Link(_)) => ("accelerations.links.*", "*_e"),
        (Q::Acceleration, Slide(_)) => ("accelerations.slides.*", "*_a"),
        (Q::Acceleration, _) => ("accelerations.points.*", "*_a%"),
        (Q::ReducedInertia, Link(_)) => ("reduced.inertia_of_links.*", "*_reduced_inertia"),
        (Q::ReducedInertia, _) => ("reduced.inertia", "reduced_inertia"),
        (Q::ReducedInertiaDerivative, _) => ("reduced.inertia_derivative", "reduced_inertia_derivative"),
        (Q::ReducedMoment, _) => ("reduced.moment", "reduced_moment"),
        (Q::Load, _) => ("loads.*", "load_*"),
        (Q::InertiaForce, _) => ("inertia_loads.*.force", "*_inertia_f%"),
        (Q::InertiaMoment, _) => ("inertia_loads.*.moment", "*_inertia_moment"),
        (Q::ShakingForce, _) => ("shaking.force", "shaking_f%"),
        (Q::ShakingMoment, _) => ("shaking.moment", "shaking_moment"),
        (Q::Force, PairOn(..)) => ("reactions.*.+", "*_+_f%"),
        (Q::Moment, _) => ("reactions.*.moment", "*_moment"),
        (Q::Balancing, _) => ("balancing", "balancing"),
        (Q::Holding, _) => ("holding.moment", ""),
        (Q::HoldingBound, _) => ("holding.bound", ""),
        (Q::Residual(_), _) => ("residuals.*", "residual_*"),
        (Q::Condition, _) => ("condition.*", "condition_*"),
        _ => return None,
    })
}

/// The keys of a row in JSON, in their order.
pub(crate) const KEYS: &str = "time coordinate speed acceleration work_driving work_resisting kinetic_energy links \
                               points slides velocities accelerations reduced loads inertia_loads shaking reactions \
                               balancing reactions_by_cause balancing_by_cause holding residuals condition";

/// The name of the owner of a column; of a residual its own.
fn owner(schema: &Schema, column: Column) -> Cow<'_, str> {
    match column.quantity {
        Quantity::Residual(of) => of.name(column.owner),
        _ => schema.name(column.owner),
    }
}

/// The name of the link on which a force acts.
fn link(schema: &Schema, column: Column) -> &str {
    if let Owner::PairOn(_, link) = column.owner { schema.link(link) } else { "" }
}

/// Where a column stands in the object of a row; `None` where JSON does not have it. The share of a cause stands under the
/// cause.
pub(crate) fn path(schema: &Schema, column: Column) -> Option<Vec<Step<'_>>> {
    let key = |key| match key {
        "*" => owner(schema, column),
        "+" => link(schema, column).into(),
        key => key.into(),
    };
    let mut keys: Vec<Cow<'_, str>> = patterns(column)?.0.split('.').map(key).collect();
    if let Some(cause) = column.cause {
        keys[0] += "_by_cause";
        keys.insert(1, schema.causes[cause].as_str().into());
    }
    let item = match column.part {
        Part::Whole | Part::Modulus => None,
        Part::X => Some(Step::Item(0)),
        Part::Y => Some(Step::Item(1)),
    };
    Some(keys.into_iter().map(Step::Key).chain(item).collect())
}

/// The name of a column in CSV, with its unit; `None` where CSV does not have it.
pub(crate) fn csv(schema: &Schema, column: Column) -> Option<String> {
    let pattern = patterns(column)?.1;
    if pattern.is_empty() || column.cause.is_some() {
        return None;
    }
    let mut name = String::new();
    for c in pattern.chars() {
        match c {
            '*' => name += &owner(schema, column),
            '+' => name += link(schema, column),
            '%' => name += ["", "x", "y", ""][column.part as usize],
            c => name.push(c),
        }
    }
    if matches!(column.quantity, Quantity::Residual(_)) {
        name = name.replace(' ', "_");
    }
    // `m_per_rad2`, `kgm2`.
    let unit = schema.unit(column).replace('/', "_per_").replace(' ', "");
    Some(if unit.is_empty() { name } else { name + "_" + &unit })
}
