//! The chart as text: a scatter of each stage, and the table under it.

use super::canvas;
use super::scatter::{Scatter, letter};
use super::{ChartData, Row, Stage, units};

/// Columns of a chart by default.
pub const WIDTH: usize = 92;
/// Lines of a scatter.
const HEIGHT: usize = 20;

/// All stages for a reader, in about `width` columns; only a row of a table may be wider.
pub fn text(data: &ChartData, ascii: bool, width: usize) -> String {
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
    width: usize,
    wanted: fn(&Row) -> bool,
) -> String {
    let mut text = format!("{}\n", stage.heading());
    if let Some(how) = data.reference.get(&stage) {
        let error = data.reference_error.get(&stage).copied().unwrap_or(f64::NAN);
        let about = format!("Reference: {how}; own error about {error:.0e}.");
        text += &wrapped(&about, width);
    }
    let scatter = Scatter::of(data, stage);
    if let Some(scatter) = &scatter {
        text.push('\n');
        text += &canvas::draw(scatter, width, HEIGHT, ascii);
        text += &canvas::legend(scatter, width, ascii);
    }
    text.push('\n');
    text + &table(data, stage, scatter.as_ref(), ascii, wanted)
}

/// The rows of a stage in columns; `*` marks the front.
fn table(
    data: &ChartData,
    stage: Stage,
    scatter: Option<&Scatter>,
    ascii: bool,
    wanted: fn(&Row) -> bool,
) -> String {
    let mut rows = vec![
        ["", "method", "setting", &format!("time/{}", stage.unit()), "evaluations", "error", ""]
            .map(str::to_owned)
            .to_vec(),
    ];
    for row in data.of(stage).filter(|row| wanted(row)) {
        rows.push(cells(row, scatter, ascii));
    }
    columns(&rows)
}

fn cells(row: &Row, scatter: Option<&Scatter>, ascii: bool) -> Vec<String> {
    let dash = || if ascii { "-" } else { "–" }.to_owned();
    let index = scatter.and_then(|scatter| scatter.methods.iter().position(|name| *name == row.method));
    let star = if row.front { "*" } else { " " };
    let mark = format!("{star}{}", index.map_or(' ', letter));
    vec![
        mark,
        row.method.clone(),
        row.setting.to_string(),
        row.seconds.map_or_else(dash, |seconds| units::time(seconds, ascii)),
        row.evaluations.map_or_else(dash, |count| count.to_string()),
        row.error.map_or_else(dash, |error| units::error(error, row.at_most, ascii)),
        row.reason.clone().unwrap_or_default(),
    ]
}

/// Columns aligned: words to the left, figures (the fourth to the sixth) to the right.
fn columns(rows: &[Vec<String>]) -> String {
    let count = rows.first().map_or(0, Vec::len);
    let wide = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..count).map(wide).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (column, cell) in row.iter().enumerate() {
            let gap = " ".repeat(widths[column] - cell.chars().count());
            let last = column + 1 == count;
            line += &if (3..6).contains(&column) { gap + cell } else { cell.clone() + &gap };
            line += if last { "" } else { "  " };
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

/// Text in lines of at most `width` characters.
pub(crate) fn wrapped(text: &str, width: usize) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let full = lines
            .last()
            .is_some_and(|line| !line.is_empty() && line.chars().count() + 1 + word.chars().count() > width);
        if full {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            if !line.is_empty() {
                line.push(' ');
            }
            *line += word;
        }
    }
    lines.join("\n") + "\n"
}
