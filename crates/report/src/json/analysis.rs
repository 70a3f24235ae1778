//! The results of a scene as JSON.

use assur_analysis::results::{Analysis, Table};
use assur_book::catalogue;

use super::rows::{self, POSITIONS, Rows, TRAJECTORY};
use super::{JsonError, NotFinite, serialized};

/// The version of the format that is written.
const FORMAT: u32 = 1;

/// The results, if all their numbers are finite.
pub fn finite(analysis: &Analysis) -> Result<&Analysis, NotFinite> {
    let place = |list: &str, table: &Table, (row, column): (usize, usize)| {
        let schema = table.schema();
        let path = catalogue::path(schema, schema.columns()[column]).unwrap_or_default();
        NotFinite { place: format!("{list}[{row}]{}", rows::spelled(&path)) }
    };
    if let Some(at) = analysis.survey.not_finite {
        return Err(place("positions", &analysis.positions, at));
    }
    if let Some(at) = analysis.trajectory.not_finite() {
        return Err(place("trajectory", &analysis.trajectory, at));
    }
    super::finite(analysis)
}

/// The text of results around that of their positions.
#[derive(Debug)]
pub struct Around {
    rows: Rows,
    /// The text before the positions.
    pub before: Vec<u8>,
    /// The text after them, in parts.
    pub after: Vec<Vec<u8>>,
}

impl Around {
    /// Of an analysis; `ascii`: other characters are escaped.
    pub fn of(analysis: &Analysis, ascii: bool) -> Result<Self, JsonError> {
        let text = serialized(finite(analysis)?, ascii)?;
        // Only UTF-8 was written; a quotation mark within a name is escaped, so the first such key is that of the table.
        let text = String::from_utf8_lossy(&text);
        let rows_at = |from: usize, key: &str| {
            let found = text[from..].find(&format!("\"{key}\":[]"));
            found.map_or(text.len(), |at| from + at + key.len() + 4)
        };
        let mut at = rows_at(0, "positions");
        let before = format!("{{\"format\":{FORMAT},{}", &text[1..at]).into_bytes();
        let mut after = Vec::new();
        if !analysis.trajectory.is_empty() {
            let begin = rows_at(at, "trajectory");
            let mut rows =
                Rows::new(analysis.trajectory.schema(), TRAJECTORY, ascii).text(&analysis.trajectory);
            rows[0].remove(0);
            after.push(text[at..begin].into());
            after.extend(rows);
            at = begin;
        }
        after.push(format!("{}\n", &text[at..]).into_bytes());
        let mut rows = Rows::new(analysis.positions.schema(), POSITIONS, ascii);
        rows.several(&analysis.several)?;
        Ok(Self { rows, before, after })
    }

    /// The text of some positions in parts, each position after a comma: the first of all stands without it.
    pub fn rows(&self, table: &Table) -> Vec<Vec<u8>> {
        self.rows.text(table)
    }
}

/// Results that keep all positions as one line of JSON; `ascii`: other characters are escaped.
pub fn to_json(analysis: &Analysis, ascii: bool) -> Result<String, JsonError> {
    let Around { rows, before, after } = Around::of(analysis, ascii)?;
    let rows = rows.text(&analysis.positions).concat();
    let text = [&before, rows.get(1..).unwrap_or_default(), &after.concat()].concat();
    // Only UTF-8 was written.
    Ok(String::from_utf8_lossy(&text).into_owned())
}
