//! Counts and lists in words.

use assur_mechanism::{LinkId, Mechanism};
use assur_structure::Structure;

/// `1 group`, `2 groups`.
pub(super) fn count(number: usize, one: &str) -> String {
    if number == 1 { format!("1 {one}") } else { format!("{number} {one}s") }
}

/// Names in backquotes, separated by commas.
pub(super) fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    names.into_iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Links in backquotes.
pub(super) fn links(mechanism: &Mechanism, ids: &[LinkId]) -> String {
    listed(ids.iter().map(|&id| mechanism.links[id].name.as_str()))
}

/// The names of the groups that are not selected; of many only the first ones.
pub(super) fn others(mechanism: &Mechanism, structure: &Structure, chosen: &[bool]) -> String {
    /// More names would hide the rest of the sentence.
    const MOST: usize = 6;
    let left: Vec<_> = (0..chosen.len()).filter(|index| !chosen[*index]).collect();
    let names: Vec<_> =
        left.iter().take(MOST).map(|&index| structure.group_name(mechanism, index).to_string()).collect();
    let more = if left.len() > MOST { format!(" and {} more", left.len() - MOST) } else { String::new() };
    format!("{}{more}", names.join(", "))
}

/// One stage of the calculation.
pub(super) struct Stage {
    /// The result of the stage.
    pub(super) name: &'static str,
    /// Why it is run; or why not, and what would make it run.
    pub(super) reason: String,
    /// The method; `None` for a stage that is not run.
    pub(super) method: Option<String>,
}

pub(super) fn run(name: &'static str, reason: impl Into<String>, method: impl Into<String>) -> Stage {
    Stage { name, reason: reason.into(), method: Some(method.into()) }
}

pub(super) fn left_out(name: &'static str, reason: impl Into<String>) -> Stage {
    Stage { name, reason: reason.into(), method: None }
}
