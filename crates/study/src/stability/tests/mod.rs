//! Tests of the study of a scene, and of the methods themselves on mechanisms and motions that are close to failure.
//!
//! Each row of the bench is one method at one distance from failure, with the error that it may have there.
//! `docs/measured/stability.md` is written from these rows (see [`page`]).

mod bench;
mod differences;
mod groups;
mod isolated;
mod metamorphic;
mod near;
mod page;
mod scales;
mod scene;
mod shipped;
mod turns;
mod walk_group;

use std::ops::ControlFlow;

use assur_all as _;
use assur_group::Order;
use assur_kinematics::{CompileError, Linkage};
use assur_mechanism::Mechanism;
use assur_report::text::Style;

use super::nearest::Grid;
use super::{Comparison, Stability, stability};

/// What the rows of a section are about, and what is expected of a method there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Law {
    /// Kind of walk, as the heading of a chapter.
    section: &'static str,
    /// What the distance is: an identity, or the words.
    along: &'static str,
    /// What the bound follows from: an identity, or the words.
    expected: &'static str,
}

/// Walks of a mechanism along its coordinate.
static CYCLE: Law =
    Law { section: "Along the cycle", along: "stability-along", expected: "stability-expected" };

/// Rows with their law.
struct Section {
    law: &'static Law,
    rows: Vec<Comparison>,
}

/// What is told of a study in English.
fn told(found: &Stability) -> String {
    assur_report::text::told(Style::english(), |page| found.tell(page))
}

/// The study of a mechanism that nobody stops.
pub(super) fn studied(mechanism: Mechanism) -> Result<Stability, CompileError> {
    match stability(mechanism, &mut |_, _| ControlFlow::Continue(())) {
        ControlFlow::Continue(found) => found,
        ControlFlow::Break(()) => unreachable!("nobody stops it"),
    }
}

/// The coordinate of the cycle at which the least health of all groups is greatest; `None` where nothing assembles.
fn healthiest(linkage: &Linkage) -> Option<f64> {
    let mut position = linkage.position();
    let mut least = |q: f64| {
        linkage.solve(q, Order::Place, &mut position).ok()?;
        let health = position.health.iter().fold(1.0_f64, |least, health| least.min(health.abs()));
        (!linkage.is_interpolated(q)).then_some((q, health))
    };
    let all = Grid::of(linkage, 1).coordinates.into_iter().filter_map(&mut least);
    all.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(q, _)| q)
}

/// Rows as those of a mechanism of this name that approaches what the words say.
fn named(mut rows: Vec<Comparison>, name: &str, words: &str) -> Vec<Comparison> {
    for row in &mut rows {
        row.finding.place = assur_words::name(format!("{name}, {words}"));
    }
    rows
}
