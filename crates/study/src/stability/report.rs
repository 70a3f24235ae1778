//! The stability of a scene's mechanism, as data, JSON and CSV.

use std::ops::ControlFlow;

use assur_kinematics::{CompileError, Linkage};
use assur_mechanism::{CoordinateKind, Mechanism, Name};
use assur_report::csv::{CsvError, finished};
use assur_words::Text;
use serde::Serialize;

use super::friction::{FrictionHealth, friction};
use super::margin::{self, Margin};
use super::nearest::{self, GroupHealth};
use super::row::Comparison;
use super::target::targets;
use super::walk::Walk;

/// The stability of a mechanism: margins, walks, and what could not be examined.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stability {
    /// Title of the scene.
    pub title: Name,
    /// Whether coordinates are angles, rad; otherwise m, or s over time.
    #[serde(rename = "angular")]
    pub kind: CoordinateKind,
    /// By group: how near it comes to a singular position.
    pub groups: Vec<GroupHealth>,
    /// By length: the least change at which assembly fails, the smallest first.
    pub lengths: Vec<Margin>,
    /// By group with dry friction: how near it comes to jamming.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub friction: Vec<FrictionHealth>,
    /// The walks.
    pub rows: Vec<Comparison>,
    /// Number of places of least health without a walk, because the mechanism has very many groups; the worst places
    /// have one.
    pub places_left_out: usize,
    /// Why the mechanism can't be assembled over its whole cycle; `groups` and `lengths` are then empty.
    pub failure: Option<Text>,
}

/// Studies a mechanism: its own cycle, its lengths, and walks to the position where each of its groups is nearest to a
/// singular one.
///
/// `watch` is called before each piece of work with the number of finished pieces and of all pieces; it breaks to stop.
pub fn stability(
    mut mechanism: Mechanism,
    watch: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> ControlFlow<(), Result<Stability, CompileError>> {
    // The walks apply their own loads to every link, with the balancing load on the input link.
    let balance = mechanism.balance.take();
    let linkage = match Linkage::compile(mechanism) {
        Ok(linkage) => linkage,
        Err(error) => return ControlFlow::Continue(Err(error)),
    };
    let (groups, failure) = match nearest::nearest(&linkage) {
        Ok(groups) => (groups, None),
        Err(failure) => (Vec::new(), Some(failure)),
    };
    let (targets, places_left_out) = targets(&linkage, &groups);
    let lengths = if failure.is_none() { margin::lengths(&linkage) } else { Vec::new() };
    let blocks = if linkage.mechanism.frictions.is_empty() { 0 } else { linkage.groups().len() + 1 };
    let total = targets.len() + blocks + lengths.len();
    let mut done = 0;
    let mut step = || {
        done += 1;
        watch(done - 1, total)
    };
    let mut rows = Vec::new();
    if let Some(walk) = Walk::new(&linkage) {
        for target in &targets {
            step()?;
            walk.to(target, &mut rows);
        }
    }
    // Friction under the loads of the scene, balanced where it says.
    let mut rubbing = linkage.clone();
    rubbing.mechanism.balance = balance;
    let friction = friction(&rubbing, &mut rows, &mut step)?;
    let lengths = margin::margins(&linkage, &lengths, &mut step)?;
    let (title, kind) = (linkage.mechanism.title.clone(), linkage.kind());
    let found = Stability { title, kind, groups, lengths, friction, rows, places_left_out, failure };
    ControlFlow::Continue(Ok(found))
}

impl Stability {
    /// Whether the mechanism assembles, and every row keeps its bound or may have no result.
    pub fn is_ok(&self) -> bool {
        self.failure.is_none() && !self.rows.iter().any(|row| row.finding.failed())
    }

    /// All rows as a table with commas, one header row.
    pub fn to_csv(&self) -> Result<String, CsvError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for row in &self.rows {
            writer.serialize(row)?;
        }
        finished(writer)
    }
}
