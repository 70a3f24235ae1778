//! The modes of every group over the cycle.

use assur_group::Order;
use assur_kinematics::{Course, CourseEnd, Linkage, Unlisted};
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

/// A mode as far as it exists without a gap.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ModeCourse {
    /// Its number.
    pub way: usize,
    /// First coordinate, rad or m.
    pub from: f64,
    /// Last coordinate.
    pub to: f64,
    /// How it begins.
    pub begins: CourseEnd,
    /// How it ends.
    pub ends: CourseEnd,
    /// The circuit, from 0.
    pub circuit: usize,
    /// The branch, from 0.
    pub branch: usize,
}

/// Where two modes meet and both go on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Meeting {
    /// The coordinate, rad or m.
    pub at: f64,
    /// The modes.
    pub ways: [usize; 2],
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
        let all = courses.clone().unwrap_or_default();
        let mode = |(way, course): (usize, &Course)| ModeCourse {
            way,
            from: course.from,
            to: course.to,
            begins: course.ends[0],
            ends: course.ends[1],
            circuit: course.circuit,
            branch: course.branch,
        };
        GroupModes {
            group: index + 1,
            kind: found.plugin.kind.to_owned(),
            links: found.frame.links.iter().map(|&link| linkage.mechanism.named_link(link)).collect(),
            way: way.filter(|_| courses.is_some()).map(|modes| modes.number(modes.present)),
            unlisted,
            circuits: courses.as_ref().map(|all| all.circuits),
            branches: courses.as_ref().map(|all| all.branches),
            counts: all.counts.iter().map(|&(from, modes)| CountFrom { from, modes }).collect(),
            modes: all.courses.iter().enumerate().map(mode).collect(),
            meetings: all.meetings.iter().map(|&(at, ways)| Meeting { at, ways }).collect(),
        }
    };
    (0..linkage.structure.groups.len()).map(group).collect()
}
