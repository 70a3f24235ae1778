//! The results of a scene as CSV: one file for the positions, one for reactions, one for the motion over time.

use assur_analysis::results::{Analysis, Named, PairReaction, PositionResult, Rates, ScalarMotion};

use super::{Cell, CsvError, write};
use crate::json::finite;

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
    let mut files = vec![CsvFile { name: FILES[0], text: positions(analysis, ascii)? }];
    if analysis.positions.iter().any(|position| position.balancing.is_some()) {
        files.push(CsvFile { name: FILES[1], text: reactions(analysis, ascii)? });
    }
    if !analysis.trajectory.is_empty() {
        files.push(CsvFile { name: FILES[2], text: trajectory(analysis, ascii)? });
    }
    Ok(files)
}

/// Names of the units that depend on the input.
#[derive(Debug, Clone, Copy)]
struct Units {
    /// Of the coordinate.
    coordinate: &'static str,
    /// "per coordinate", empty where it cancels.
    per: [&'static str; 2],
}

impl Units {
    fn of(angular: bool) -> Self {
        if angular {
            Self { coordinate: "rad", per: ["_per_rad", "_per_rad2"] }
        } else {
            Self { coordinate: "m", per: ["_per_m", "_per_m2"] }
        }
    }
}

/// Cells of a row with the names of their columns.
#[derive(Debug, Default)]
struct Row {
    cells: Vec<(String, f64)>,
}

impl Row {
    fn add(&mut self, column: impl Into<String>, value: f64) {
        self.cells.push((column.into(), value));
    }

    fn vector(&mut self, name: &str, part: &str, unit: &str, value: [f64; 2]) {
        self.add(format!("{name}_x{part}_{unit}"), value[0]);
        self.add(format!("{name}_y{part}_{unit}"), value[1]);
    }

    /// Value and derivatives: `crank_angle_rad`, `crank_angle_pf1_rad_per_rad`, ...
    fn derivatives(&mut self, name: &str, unit: &str, units: Units, value: &ScalarMotion) {
        self.add(format!("{name}_{unit}"), value.pf0);
        self.add(format!("{name}_pf1_{unit}{}", units.per[0]), value.pf1);
        self.add(format!("{name}_pf2_{unit}{}", units.per[1]), value.pf2);
    }
}

/// Rows under all columns that any of them has; a row without a column has an empty cell.
fn table(rows: &[Row], ascii: bool) -> Result<String, CsvError> {
    let header = rows.iter().max_by_key(|row| row.cells.len()).map(|row| &row.cells[..]).unwrap_or_default();
    let names: Vec<&str> = header.iter().map(|(name, _)| name.as_str()).collect();
    let cells = rows.iter().map(|row| {
        let mut cells = row.cells.iter().peekable();
        names.iter().map(move |column| {
            cells.next_if(|(name, _)| name == column).map_or(Cell::Empty, |(_, value)| Cell::Number(*value))
        })
    });
    write(&names, cells, ascii)
}

/// The columns that identify the position of a row.
fn start(position: &PositionResult, units: Units) -> Row {
    let mut row = Row::default();
    row.add("index", position.index as f64);
    row.add(format!("coordinate_{}", units.coordinate), position.coordinate);
    row
}

fn positions(analysis: &Analysis, ascii: bool) -> Result<String, CsvError> {
    let units = Units::of(analysis.input.angular);
    let rows: Vec<_> = analysis.positions.iter().map(|position| position_row(position, units)).collect();
    table(&rows, ascii)
}

fn position_row(position: &PositionResult, units: Units) -> Row {
    let mut row = start(position, units);
    if let (Some(speed), Some(acceleration)) = (position.speed, position.acceleration) {
        row.add(format!("speed_{}_per_s", units.coordinate), speed);
        row.add(format!("acceleration_{}_per_s2", units.coordinate), acceleration);
    }
    for (name, motion) in position.links.iter() {
        row.derivatives(&format!("{name}_angle"), "rad", units, motion);
    }
    for (name, motion) in position.points.iter() {
        row.vector(name, "", "m", motion.pf0);
        row.vector(name, "_pf1", &format!("m{}", units.per[0]), motion.pf1);
        row.vector(name, "_pf2", &format!("m{}", units.per[1]), motion.pf2);
    }
    for (name, motion) in position.slides.iter() {
        row.derivatives(&format!("{name}_displacement"), "m", units, motion);
    }
    rates([&position.velocities, &position.accelerations], &mut row);
    if let Some(reduced) = &position.reduced {
        let (inertia, moment) = if units.coordinate == "rad" { ("kgm2", "Nm") } else { ("kg", "N") };
        row.add(format!("reduced_inertia_{inertia}"), reduced.inertia);
        row.add(format!("reduced_inertia_derivative_{inertia}{}", units.per[0]), reduced.inertia_derivative);
        row.add(format!("reduced_moment_{moment}"), reduced.moment);
    }
    for (group, condition) in position.condition.iter() {
        row.add(format!("condition_{group}"), *condition);
    }
    row
}

fn rates([velocities, accelerations]: [&Option<Rates>; 2], row: &mut Row) {
    for (sign, per, rates) in [("v", "per_s", velocities), ("a", "per_s2", accelerations)] {
        let Some(rates) = rates else { continue };
        let angular = if sign == "v" { "w" } else { "e" };
        for (name, value) in rates.links.iter() {
            row.add(format!("{name}_{angular}_rad_{per}"), *value);
        }
        for (name, value) in rates.points.iter() {
            row.add(format!("{name}_{sign}x_m_{per}"), value[0]);
            row.add(format!("{name}_{sign}y_m_{per}"), value[1]);
        }
        for (name, value) in rates.slides.iter() {
            row.add(format!("{name}_{sign}_m_{per}"), *value);
        }
    }
}

fn reactions(analysis: &Analysis, ascii: bool) -> Result<String, CsvError> {
    let units = Units::of(analysis.input.angular);
    let rows: Vec<_> = analysis
        .positions
        .iter()
        .map(|position| {
            let mut row = start(position, units);
            if let Some(balancing) = position.balancing {
                row.add(format!("balancing_{}", balancing_unit(analysis)), balancing);
            }
            forces(position.reactions.as_ref(), &mut row);
            row
        })
        .collect();
    table(&rows, ascii)
}

fn forces(reactions: Option<&Named<PairReaction>>, row: &mut Row) {
    for (pair, reaction) in reactions.into_iter().flat_map(Named::iter) {
        for (link, force) in &reaction.forces {
            row.add(format!("{pair}_{link}_fx_N"), force[0]);
            row.add(format!("{pair}_{link}_fy_N"), force[1]);
        }
        if let Some(moment) = reaction.moment {
            row.add(format!("{pair}_moment_Nm"), moment);
        }
    }
}

fn balancing_unit(analysis: &Analysis) -> &'static str {
    if analysis.input.balancing_is_moment { "Nm" } else { "N" }
}

fn trajectory(analysis: &Analysis, ascii: bool) -> Result<String, CsvError> {
    let units = Units::of(analysis.input.angular);
    let q = units.coordinate;
    let rows: Vec<_> = analysis
        .trajectory
        .iter()
        .map(|sample| {
            let mut row = Row::default();
            row.add("time_s", sample.time);
            row.add(format!("coordinate_{q}"), sample.coordinate);
            row.add(format!("speed_{q}_per_s"), sample.speed);
            row.add(format!("acceleration_{q}_per_s2"), sample.acceleration);
            for (name, motion) in sample.links.iter() {
                row.derivatives(&format!("{name}_angle"), "rad", units, motion);
            }
            for (name, spot) in sample.points.iter() {
                row.vector(name, "", "m", spot.pf0);
            }
            for (name, motion) in sample.slides.iter() {
                row.derivatives(&format!("{name}_displacement"), "m", units, motion);
            }
            rates([&sample.velocities, &sample.accelerations], &mut row);
            if let Some(balancing) = sample.balancing {
                row.add(format!("drive_{}", balancing_unit(analysis)), balancing);
            }
            forces(sample.reactions.as_ref(), &mut row);
            row
        })
        .collect();
    table(&rows, ascii)
}
