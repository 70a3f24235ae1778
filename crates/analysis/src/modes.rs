//! The modes of every group over the cycle.

use assur_group::Order;
use assur_kinematics::{CountFrom, Courses, Linkage, ModeCourse, ModeMeeting, Unlisted};
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
    /// The mode of the mechanism in the first position.
    pub way: Option<usize>,
    /// Why its modes are not listed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unlisted: Option<Unlisted>,
    /// Number of circuits: what can't be reached without taking the mechanism apart; `None` where modes are not listed.
    pub circuits: Option<usize>,
    /// Number of branches: what can't be reached without a singular position.
    pub branches: Option<usize>,
    /// How many modes there are from a coordinate on.
    pub counts: Vec<CountFrom>,
    /// Each mode, numbered as in the first position; one born later takes the next number.
    pub modes: Vec<ModeCourse>,
    /// Where two modes meet and both go on.
    pub meetings: Vec<ModeMeeting>,
}

/// The modes of every group over the cycle.
pub(crate) fn of(linkage: &Linkage) -> Vec<GroupModes> {
    let mut position = linkage.position();
    let is_placed = linkage.solve_index(0, Order::Place, &mut position).is_ok();
    let group = |index: usize| {
        let found = &linkage.structure.groups[index];
        let way = is_placed.then(|| linkage.modes(index, &position).ok().flatten()).flatten();
        let (unlisted, courses) = match linkage.courses(index) {
            Ok(courses) => (None, Some(courses)),
            Err(why) => (Some(why), None),
        };
        let listed = courses.is_some();
        let Courses { courses: modes, counts, meetings, circuits, branches } = courses.unwrap_or_default();
        GroupModes {
            group: index + 1,
            kind: found.plugin.kind.to_owned(),
            links: found.frame.links.iter().map(|&link| linkage.mechanism.named_link(link)).collect(),
            way: way.filter(|_| listed).map(|modes| modes.number(modes.present)),
            unlisted,
            circuits: listed.then_some(circuits),
            branches: listed.then_some(branches),
            counts,
            modes,
            meetings,
        }
    };
    (0..linkage.structure.groups.len()).map(group).collect()
}
