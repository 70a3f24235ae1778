//! The results of a scene as CSV: one file for the positions, one for reactions, one for the motion over time.

use assur_analysis::results::{Analysis, Base, Column, Owner, Part, Quantity, Schema, Table};

use super::{CsvError, header, number};
use crate::json::analysis::finite;
use crate::template::{Template, Templates};

/// The names of all files that [`to_csv`] may give.
pub const FILES: [&str; 3] = ["positions.csv", "reactions.csv", "trajectory.csv"];

/// One CSV file: its name and its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CsvFile {
    /// `positions.csv`
    pub name: &'static str,
    /// The rows.
    pub text: String,
}

/// The files that apply: `positions.csv`, `reactions.csv`, `trajectory.csv`.
///
/// # Errors
///
/// [`CsvError`] for a number that is not finite.
pub fn to_csv(analysis: &Analysis, ascii: bool) -> Result<Vec<CsvFile>, CsvError> {
    let analysis = finite(analysis)?;
    let (positions, trajectory) = (&analysis.positions, &analysis.trajectory);
    let mut files = vec![CsvFile { name: FILES[0], text: text(positions, &places(positions), true, ascii)? }];
    if positions.schema().find(Column::BALANCING).is_some_and(|balancing| positions.has(balancing)) {
        files.push(CsvFile { name: FILES[1], text: text(positions, &reactions(positions), true, ascii)? });
    }
    if !trajectory.is_empty() {
        files.push(CsvFile { name: FILES[2], text: text(trajectory, &samples(trajectory), false, ascii)? });
    }
    Ok(files)
}

/// Whether a column is about forces.
fn is_reaction(column: Column) -> bool {
    matches!(column.quantity, Quantity::Force | Quantity::Moment | Quantity::Balancing)
}

/// Columns that CSV has, with numbers in any row, in the order of the schema.
fn shown(table: &Table, wanted: impl Fn(Column) -> bool) -> Vec<(usize, String)> {
    let schema = table.schema();
    let each = schema.select(|column| wanted(*column)).into_iter().filter(|column| table.has(*column));
    each.filter_map(|column| Some((column, name(schema, schema.columns()[column])?))).collect()
}

fn places(table: &Table) -> Vec<(usize, String)> {
    shown(table, |column| !is_reaction(column))
}

fn reactions(table: &Table) -> Vec<(usize, String)> {
    // The balancing load stands before the reactions.
    let mut all =
        shown(table, |column| column == Column::COORDINATE || column.quantity == Quantity::Balancing);
    all.extend(shown(table, |column| is_reaction(column) && column.quantity != Quantity::Balancing));
    all
}

fn samples(table: &Table) -> Vec<(usize, String)> {
    let mut all = places(table);
    // The balancing load of a motion is what the drive does.
    let drive = shown(table, |column| column.quantity == Quantity::Balancing).into_iter();
    all.extend(drive.map(|(column, name)| (column, name.replace("balancing", "drive"))));
    all.extend(shown(table, |column| is_reaction(column) && column.quantity != Quantity::Balancing));
    all
}

/// The header and the rows; `numbered`: the number of the position in front.
fn text(table: &Table, columns: &[(usize, String)], numbered: bool, ascii: bool) -> Result<String, CsvError> {
    let index = numbered.then_some("index");
    let names = index.into_iter().chain(columns.iter().map(|(_, name)| name.as_str()));
    let mut out = header(&names.collect::<Vec<_>>(), ascii)?;
    let mut templates = Templates::new(table, columns.iter().map(|(column, _)| *column));
    for row in 0..table.len() {
        if numbered {
            out.extend_from_slice(table.numbers()[row].to_string().as_bytes());
        }
        templates.of(table, row, |has| template(columns, numbered, has)).write(table, row, &mut out, number);
    }
    // Only UTF-8 was written.
    Ok(String::from_utf8_lossy(&out).into_owned())
}

/// Commas between the numbers; a column without a number leaves its cell empty.
fn template(columns: &[(usize, String)], numbered: bool, has: &dyn Fn(usize) -> bool) -> Template {
    let (mut text, mut pieces) = (String::new(), Vec::new());
    for (place, (column, _)) in columns.iter().enumerate() {
        if numbered || place > 0 {
            text.push(',');
        }
        if has(*column) {
            pieces.push((std::mem::take(&mut text), *column));
        }
    }
    Template { pieces, end: text + "\n" }
}

/// The name of a column, with its unit; `None` where CSV does not have it.
pub(crate) fn name(schema: &Schema, column: Column) -> Option<String> {
    use Quantity as Q;
    if column.cause.is_some() {
        return None;
    }
    let unit = unit(schema, column);
    let owner = schema.name(column.owner);
    let part = match column.part {
        Part::Whole => "",
        Part::X => "x",
        Part::Y => "y",
    };
    let name = match (column.quantity, column.owner) {
        (Q::Time, _) => "time".to_owned(),
        (Q::Transfer(_), Owner::Input) => "coordinate".to_owned(),
        (Q::Velocity, Owner::Input) => "speed".to_owned(),
        (Q::Acceleration, Owner::Input) => "acceleration".to_owned(),
        (Q::Transfer(order), _) => {
            let what = match column.owner {
                Owner::Link(_) => "angle",
                Owner::Slide(_) => "displacement",
                _ => part,
            };
            if order == 0 { format!("{owner}_{what}") } else { format!("{owner}_{what}_pf{order}") }
        }
        (Q::Velocity, Owner::Link(_)) => format!("{owner}_w"),
        (Q::Acceleration, Owner::Link(_)) => format!("{owner}_e"),
        (Q::Velocity, _) => format!("{owner}_v{part}"),
        (Q::Acceleration, _) => format!("{owner}_a{part}"),
        (Q::ReducedInertia, _) => "reduced_inertia".to_owned(),
        (Q::ReducedInertiaDerivative, _) => "reduced_inertia_derivative".to_owned(),
        (Q::ReducedMoment, _) => "reduced_moment".to_owned(),
        (Q::Force, Owner::PairOn(_, link)) => format!("{owner}_{}_f{part}", schema.link(link)),
        (Q::Moment, _) => format!("{owner}_moment"),
        (Q::Balancing, _) => "balancing".to_owned(),
        (Q::Condition, _) => format!("condition_{owner}"),
        _ => return None,
    };
    Some(if unit.is_empty() { name } else { format!("{name}_{unit}") })
}

/// The unit as part of a name: `m_per_rad2`, `kgm2`; empty for a plain number.
fn unit(schema: &Schema, column: Column) -> String {
    let unit = schema.unit(column);
    let base = match unit.base {
        Base::One => "",
        Base::Second => "s",
        Base::Radian => "rad",
        Base::Meter => "m",
        Base::Kilogram => "kg",
        Base::KilogramMeter2 => "kgm2",
        Base::Newton => "N",
        Base::NewtonMeter => "Nm",
    };
    let q = if schema.angular() { "rad" } else { "m" };
    let per = |of: &str, times: u8| match times {
        0 => String::new(),
        1 => format!("_per_{of}"),
        times => format!("_per_{of}{times}"),
    };
    format!("{base}{}{}", per(q, unit.per_coordinate), per("s", unit.per_time))
}
