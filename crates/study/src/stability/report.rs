//! The stability of a scene's mechanism, as data, JSON and text.

use std::convert::Infallible;
use std::fmt::Write;
use std::ops::ControlFlow;

use assur_kinematics::{CompileError, Linkage};
use assur_mechanism::Mechanism;
use serde::Serialize;

use super::cycle::{self, GroupHealth};
use super::isolated::Isolated;
use super::margin::{self, Margin};
use super::row::Row;
use super::target::targets;
use super::walk_cycle::Walk;
use super::{differences, scales, turns, walk_group};

/// What was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stability {
    /// Title of the scene.
    pub title: String,
    /// Whether coordinates are angles, rad; otherwise m.
    pub angular: bool,
    /// By group: how near it comes to a singular position.
    pub groups: Vec<GroupHealth>,
    /// By length: the least change that breaks the mechanism, the smallest first.
    pub lengths: Vec<Margin>,
    /// The walks.
    pub rows: Vec<Row>,
    /// Why the mechanism can't be assembled all over its cycle; `groups` and `lengths` are then empty.
    pub failure: Option<String>,
}

/// Studies a mechanism: its own cycle, and walks towards each singular position that its groups have.
///
/// # Errors
///
/// [`CompileError`] if it can't be taken apart into registered groups.
pub fn stability(mechanism: Mechanism) -> Result<Stability, CompileError> {
    match stability_watched(mechanism, &mut |_, _| ControlFlow::<Infallible>::Continue(())) {
        ControlFlow::Continue(found) => found,
        ControlFlow::Break(never) => match never {},
    }
}

/// The same; `tell` is called with the pieces of work that are done and their number before each piece, and may stop it.
///
/// # Errors
///
/// As [`stability`].
pub fn stability_watched<B>(
    mut mechanism: Mechanism,
    tell: &mut impl FnMut(usize, usize) -> ControlFlow<B>,
) -> ControlFlow<B, Result<Stability, CompileError>> {
    // The walks load every link themselves, with the balancing load on the input link.
    mechanism.balance = None;
    let linkage = match Linkage::compile(mechanism) {
        Ok(linkage) => linkage,
        Err(error) => return ControlFlow::Continue(Err(error)),
    };
    let different = different(&linkage);
    // The walks of the cycle are at most as many as the groups; the search for the least health is one piece of them each.
    let total = different.len() + linkage.structure.groups.len() + margin::count(&linkage);
    let mut done = 0;
    let mut step = || {
        done += 1;
        tell(done - 1, total)
    };
    let mut rows = Vec::new();
    for (name, group) in different {
        step()?;
        rows.extend(walk_group::walk(&name, &linkage.structure.groups[group]));
    }
    let (groups, failure) = match cycle::healths(&linkage) {
        Ok(groups) => (groups, None),
        Err(failure) => (Vec::new(), Some(failure)),
    };
    if let Some(walk) = Walk::new(&linkage) {
        for target in targets(&linkage, &groups) {
            step()?;
            walk.to(&target, &mut rows);
        }
        if let Some(q) = cycle::healthiest(&linkage) {
            rows.extend(turns::rows(&linkage, &walk, q, None));
            rows.extend(differences::rows(&linkage, q, "whole mechanism, where it is healthiest"));
            rows.extend(scales::rows(&linkage, q, "whole mechanism, where it is healthiest"));
        }
    }
    let lengths = if failure.is_none() { margin::margins(&linkage, &mut step)? } else { Vec::new() };
    let (title, angular) = (linkage.mechanism.title.clone(), linkage.angular());
    ControlFlow::Continue(Ok(Stability { title, angular, groups, lengths, rows, failure }))
}

/// Groups that differ in kind or lengths, with a name that counts those alike.
fn different(linkage: &Linkage) -> Vec<(String, usize)> {
    let groups = &linkage.structure.groups;
    let alone: Vec<_> = groups.iter().map(|group| Isolated::of(group).map(|alone| alone.frame)).collect();
    let alike = |a: usize, b: usize| {
        groups[a].plugin.name == groups[b].plugin.name && alone[a].is_some() && alone[a] == alone[b]
    };
    let first = |&index: &usize| (0..index).all(|before| !alike(before, index));
    let named = |index: usize| {
        let name = linkage.structure.group_name(&linkage.mechanism, index);
        match (index + 1..groups.len()).filter(|&other| alike(index, other)).count() {
            0 => (name, index),
            more => (format!("{name} and {more} of the same lengths"), index),
        }
    };
    (0..groups.len()).filter(first).map(named).collect()
}

impl Stability {
    /// Whether the mechanism assembles and every row keeps its bound or has a right to refuse.
    pub fn is_ok(&self) -> bool {
        self.failure.is_none() && self.rows.iter().all(|row| row.ok)
    }

    /// As one JSON object in one line.
    ///
    /// # Errors
    ///
    /// From the writer of JSON.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(self).map(|text| text + "\n")
    }

    /// All rows as a table with commas, one header row.
    pub fn to_csv(&self) -> String {
        let mut text =
            "where,method,quantity,distance,health,error,bound,ok,reason,section,along,expected\n".to_owned();
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        for row in &self.rows {
            let error = row.error.map_or_else(String::new, |error| format!("{error:e}"));
            let _ = writeln!(
                text,
                "{},{},{},{:e},{:e},{error},{:e},{},{},{},{},{}",
                quoted(&row.place),
                quoted(&row.method),
                row.quantity,
                row.distance,
                row.health,
                row.bound,
                row.ok,
                quoted(row.reason.as_deref().unwrap_or("")),
                row.law.section,
                quoted(row.law.along),
                quoted(row.law.expected)
            );
        }
        text
    }
}
