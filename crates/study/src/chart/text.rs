//! The chart as text: the figure of each stage, and the table under it.

use assur_report::text::columns;

use super::figure::{FRONT, drawn};
use super::{ChartData, Row, Stage, units};

/// Columns of a chart by default.
pub const WIDTH: u16 = 92;
/// Lines of a figure.
const HEIGHT: u16 = 24;

/// All stages for a reader, in about `width` columns; only a row of a table may be wider.
pub fn text(data: &ChartData, ascii: bool, width: u16) -> String {
    let dash = if ascii { "-" } else { "—" };
    let mut text = format!("Speed against accuracy {dash} {}\n", data.title);
    if !data.complete {
        text += "Stopped before the end: what had been measured is shown.\n";
    }
    for stage in Stage::ALL {
        if data.of(stage).next().is_some() {
            text.push('\n');
            text += &stage_text(data, stage, ascii, width, |_| true);
        }
    }
    text
}

/// One stage in about `width` columns; its table has the selected rows.
pub fn stage_text(
    data: &ChartData,
    stage: Stage,
    ascii: bool,
    width: u16,
    wanted: fn(&Row) -> bool,
) -> String {
    let mut text = format!("{}\n", stage.heading());
    if let Some(how) = data.reference.get(&stage) {
        let error = data.reference_error.get(&stage).copied().unwrap_or(f64::NAN);
        let about = format!("Reference: {how}; own error about {error:.0e}.");
        text += &(textwrap::fill(&about, usize::from(width)) + "\n");
    }
    let figure = drawn(data, stage, [width, HEIGHT], ascii);
    if !figure.is_empty() {
        text.extend(["\n", figure.as_str(), "  dotted, and * below: ", FRONT, "\n"]);
    }
    let head = ["", "method", "setting", &format!("time/{}", stage.unit()), "evaluations", "error", ""];
    let rows: Vec<_> = data.of(stage).filter(|row| wanted(row)).map(|row| cells(row, ascii)).collect();
    text + "\n" + &columns(&head, &rows, ascii)
}

fn cells(row: &Row, ascii: bool) -> Vec<String> {
    let dash = || "-".to_owned();
    vec![
        if row.front { "*" } else { " " }.to_owned(),
        row.method.clone(),
        row.setting.to_string(),
        row.seconds.map_or_else(dash, |seconds| units::time(seconds, ascii)),
        row.evaluations.map_or_else(dash, |count| count.to_string()),
        row.error.map_or_else(dash, |error| units::error(error, row.at_most, ascii)),
        row.reason.clone().unwrap_or_default(),
    ]
}
