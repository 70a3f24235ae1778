//! The results of a scene as JSON.

use assur_analysis::results::{
    Analysis, Check, Cycle, Dynamics, Failure, InputReport, Integration, StructureReport, Table,
};
use serde::Serialize;

use super::rows::{self, Form, POSITIONS, Rows, TRAJECTORY};
use super::{JsonError, NotFinite, quoted, serialized};

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
    no_motion: Option<&'a str>,
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    notes: &'a [String],
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
            no_motion: analysis.no_motion.as_deref(),
            notes: &analysis.notes,
            cycle: &analysis.cycle,
            checks: &analysis.checks,
        }
    }
}

/// The results, if all their numbers are finite.
///
/// # Errors
///
/// [`NotFinite`] with the first number that is not.
pub fn finite(analysis: &Analysis) -> Result<&Analysis, NotFinite> {
    finite_rows(&analysis.positions, "positions")?;
    finite_rows(&analysis.trajectory, "trajectory")?;
    super::finite(&Failures { failures: &analysis.failures })?;
    super::finite(&Tail::of(analysis))?;
    Ok(analysis)
}

fn finite_rows(table: &Table, list: &str) -> Result<(), NotFinite> {
    let Some((row, column)) = table.not_finite() else { return Ok(()) };
    let schema = table.schema();
    let path = rows::path(schema, schema.columns()[column]).unwrap_or_default();
    Err(NotFinite { place: format!("{list}[{row}]{}", rows::spelled(&path)) })
}

/// The results as one line of JSON; `ascii`: other characters are escaped.
///
/// # Errors
///
/// [`JsonError`] for a number that is not finite.
pub fn to_json(analysis: &Analysis, ascii: bool) -> Result<String, JsonError> {
    let analysis = finite(analysis)?;
    let mut out = vec![b'{'];
    let head = Head {
        format: FORMAT,
        title: &analysis.title,
        input: &analysis.input,
        structure: &analysis.structure,
    };
    members(&mut out, &head, ascii)?;
    rows(&mut out, "positions", &analysis.positions, POSITIONS, ascii);
    members(&mut out, &Failures { failures: &analysis.failures }, ascii)?;
    if !analysis.trajectory.is_empty() {
        rows(&mut out, "trajectory", &analysis.trajectory, TRAJECTORY, ascii);
    }
    members(&mut out, &Tail::of(analysis), ascii)?;
    out.extend_from_slice(b"}\n");
    // Only UTF-8 was written.
    Ok(String::from_utf8_lossy(&out).into_owned())
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

/// Adds an array of the rows of a table.
fn rows(out: &mut Vec<u8>, key: &str, table: &Table, form: Form, ascii: bool) {
    out.extend_from_slice(format!(",{}:[", quoted(key, ascii)).as_bytes());
    Rows::new(table, form, ascii).write(table, true, out);
    out.push(b']');
}
