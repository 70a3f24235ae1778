//! The modes of every group over the cycle.

use assur_group::Order;
use assur_kinematics::{Linkage, ModeCourses, Unlisted};
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
    /// The modes; none where they are not listed.
    #[serde(flatten)]
    pub courses: ModeCourses,
}

/// The modes of every group over the cycle.
pub fn modes(linkage: &Linkage) -> Vec<GroupModes> {
    let mut position = linkage.position();
    let is_placed = linkage.solve_index(0, Order::Place, &mut position).is_ok();
    let group = |index: usize| {
        let found = &linkage.structure.groups[index];
        let way = is_placed.then(|| linkage.modes(index, &position).ok().flatten()).flatten();
        let (unlisted, courses) = match linkage.courses(index) {
            Ok(courses) => (None, courses),
            Err(why) => (Some(why), ModeCourses::default()),
        };
        GroupModes {
            group: index + 1,
            kind: found.plugin.kind.to_owned(),
            links: found.frame.links.iter().map(|&link| linkage.mechanism.named_link(link)).collect(),
            way: way.filter(|_| unlisted.is_none()).map(|modes| modes.number(modes.present)),
            unlisted,
            courses,
        }
    };
    (0..linkage.structure.groups.len()).map(group).collect()
}
