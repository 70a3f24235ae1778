//! The results of a scene as JSON.

use assur_analysis::results::{
    Analysis, Check, Cycle, Dynamics, Failure, FrictionCycle, InputReport, Integration, StructureReport,
    Table,
};
use assur_book::catalogue;
use assur_mechanism::Notice;
use assur_words::Text;
use serde::Serialize;

use super::rows::{self, POSITIONS, Rows, TRAJECTORY};
use super::{JsonError, NotFinite, serialized};

/// The version of the format that is written.
const FORMAT: u32 = 1;

/// What stands before the positions.
#[derive(Serialize)]
struct Head<'a> {
    format: u32,
    title: &'a str,
    input: &'a InputReport,
    structure: &'a StructureReport,
}

/// What stands between positions and trajectory.
#[derive(Serialize)]
struct Failures<'a> {
    #[serde(skip_serializing_if = "<[Failure]>::is_empty")]
    failures: &'a [Failure],
}

/// What stands after the trajectory.
#[derive(Serialize)]
struct Tail<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    dynamics: Option<&'a Dynamics>,
    #[serde(skip_serializing_if = "Option::is_none")]
    integration: Option<&'a Integration>,
    #[serde(skip_serializing_if = "Option::is_none")]
    no_motion: Option<&'a Text>,
    #[serde(flatten)]
    friction: Option<&'a FrictionCycle>,
    #[serde(skip_serializing_if = "<[Notice]>::is_empty")]
    notes: &'a [Notice],
    #[serde(flatten)]
    cycle: &'a Cycle,
    #[serde(skip_serializing_if = "<[Check]>::is_empty")]
    checks: &'a [Check],
}

impl<'a> Tail<'a> {
    fn of(analysis: &'a Analysis) -> Self {
        Self {
            dynamics: analysis.dynamics.as_ref(),
            integration: analysis.integration.as_ref(),
            no_motion: analysis.no_motion.as_ref(),
            friction: analysis.friction.as_ref(),
            notes: &analysis.notes,
            cycle: &analysis.cycle,
            checks: &analysis.checks,
        }
    }
}

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
    super::finite(&Failures { failures: &analysis.failures })?;
    super::finite(&Tail::of(analysis))?;
    Ok(analysis)
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
        let Analysis { title, input, structure, failures, trajectory, .. } = finite(analysis)?;
        let mut before = vec![b'{'];
        members(&mut before, &Head { format: FORMAT, title, input, structure }, ascii)?;
        before.extend_from_slice(b",\"positions\":[");
        let mut end = vec![b']'];
        members(&mut end, &Failures { failures }, ascii)?;
        let mut after = Vec::new();
        if !trajectory.is_empty() {
            end.extend_from_slice(b",\"trajectory\":[");
            let mut rows = Rows::new(trajectory.schema(), TRAJECTORY, ascii).text(trajectory);
            rows[0].remove(0);
            after.push(std::mem::replace(&mut end, vec![b']']));
            after.extend(rows);
        }
        members(&mut end, &Tail::of(analysis), ascii)?;
        end.extend_from_slice(b"}\n");
        after.push(end);
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

/// Adds the members of an object to the open one.
fn members<T: Serialize>(out: &mut Vec<u8>, object: &T, ascii: bool) -> Result<(), serde_json::Error> {
    let text = serialized(object, ascii)?;
    let members = &text[1..text.len() - 1];
    if !members.is_empty() && !out.ends_with(b"{") {
        out.push(b',');
    }
    out.extend_from_slice(members);
    Ok(())
}
