//! The modes of every group over the cycle.

use assur_group::Order;
use assur_kinematics::{Linkage, ModeSpan};
use assur_mechanism::{LinkId, Named};
use serde::Serialize;

/// The modes of a group over a turn of a pinned input, or over the range of the scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupModes {
    /// The group, from 1 in solving order.
    pub group: usize,
    /// The registered kind.
    pub kind: String,
    /// Its links.
    pub links: Vec<Named<LinkId>>,
    /// The mode of the mechanism in the first position; results call it `way`.
    #[serde(rename = "way")]
    pub mode: Option<usize>,
    /// Number of circuits: what can't be reached without taking the mechanism apart; `None` where the kind can't list modes.
    pub circuits: Option<usize>,
    /// Number of branches: what can't be reached without a singular position.
    pub branches: Option<usize>,
    /// How many modes there are from a coordinate on.
    pub counts: Vec<CountFrom>,
    /// Each mode, numbered as in the first position; one born later takes the next number.
    pub modes: Vec<ModeSpan>,
    /// Where two modes meet and both go on.
    pub meetings: Vec<Meeting>,
}

/// A number of modes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CountFrom {
    /// The first coordinate, rad or m.
    pub from: f64,
    /// The number.
    pub modes: usize,
}

/// Where two modes meet and both go on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Meeting {
    /// The coordinate, rad or m.
    pub at: f64,
    /// The modes; results call them `ways`.
    #[serde(rename = "ways")]
    pub modes: [usize; 2],
}

/// The modes of every group over the cycle.
pub(crate) fn of(linkage: &Linkage) -> Vec<GroupModes> {
    let mut position = linkage.position();
    let is_placed = linkage.solve_index(0, Order::Place, &mut position).is_ok();
    let group = |index: usize| {
        let found = &linkage.structure.groups[index];
        let first = is_placed.then(|| linkage.modes(index, &position).ok().flatten()).flatten();
        let spans = linkage.mode_spans(index);
        let all = spans.clone().unwrap_or_default();
        GroupModes {
            group: index + 1,
            kind: found.plugin.kind.to_owned(),
            links: found.frame.links.iter().map(|&link| linkage.mechanism.named_link(link)).collect(),
            mode: first.filter(|_| spans.is_some()).map(|modes| modes.number(modes.present)),
            circuits: spans.as_ref().map(|all| all.circuits),
            branches: spans.as_ref().map(|all| all.branches),
            counts: all.counts.iter().map(|&(from, modes)| CountFrom { from, modes }).collect(),
            modes: all.spans,
            meetings: all.meetings.iter().map(|&(at, modes)| Meeting { at, modes }).collect(),
        }
    };
    (0..linkage.structure.groups.len()).map(group).collect()
}
