//! All modes of a group over a cycle: where they begin, meet and end, and which of them belong to one circuit.
//!
//! From sample to sample a mode goes to the nearest one of the same way. Where that is doubtful, because the number changes or two
//! modes that may meet are nearer to each other than they move, the step is halved, down to a length at which nothing but a
//! meeting, a beginning or an end is left.

use std::f64::consts::TAU;

use assur_group::{Body, GroupError, Mode};
use assur_number::elementary;
use serde::Serialize;

mod event;

use crate::{Linkage, modes::by_ways};

/// Steps over the cycle.
const SAMPLES: u32 = 720;

/// A beginning, a meeting or an end is found to this, in units of the coordinate.
const SHORTEST: f64 = 1e-11;

/// Beyond this distance past an event, in units of the coordinate, the number of modes is reliable in spite of rounding.
const BEHIND: f64 = 1e-9;

/// A meeting after which both modes go on is found to this: nearer to it the two can't be told apart.
const SHORTEST_EQUAL: f64 = 1e-6;

/// A place farther away than this, in parts of the scale, may be on either side of infinity.
const FAR_AWAY: f64 = 1e3;

/// Farthest way of a mode in a step, see [`Walk::apart`].
const FARTHEST: f64 = 0.3;

/// Opposite places farther away than this, in parts of the scale, are nearer to each other over infinity than [`FARTHEST`].
const OPPOSITE: f64 = 6.0;

/// Two modes within this of each other on the shortest step are about to meet: their distance grows with its root.
const TOGETHER: f64 = 1e-3;

/// Two modes left over by an event, which have met or begin, are within this of each other up to [`BEHIND`] it.
const PAIR: f64 = 1e-2;

/// The sign of a smaller determinant may be rounding: the determinant is the root of a difference.
const UNSIGNED: f64 = 1e-6;

/// A cycle with more courses than this has modes that can't be told apart: rounding makes them begin and end.
const MOST_COURSES: usize = 500;

/// Where the middle of a step is taken, so that no singular position of round numbers is hit.
const MIDDLE: f64 = 0.493;

/// How a course begins or ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CourseEnd {
    /// With the cycle.
    Cycle,
    /// Together with another mode, by its number.
    With(usize),
    /// Its links run to infinity.
    Infinity,
    /// Groups before it have no place beyond.
    Barrier,
}

/// A mode as far as it exists without a gap.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ModeCourse {
    /// Its number.
    pub way: usize,
    /// The first coordinate, rad or m.
    pub from: f64,
    /// The last one.
    pub to: f64,
    /// How it begins.
    pub begins: CourseEnd,
    /// How it ends.
    pub ends: CourseEnd,
    /// The circuit: what can be reached without taking the mechanism apart; from 0.
    pub circuit: usize,
    /// The branch: what can be reached without a singular position; from 0.
    pub branch: usize,
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
pub struct ModeMeeting {
    /// The coordinate, rad or m.
    pub at: f64,
    /// The numbers of the modes.
    pub ways: [usize; 2],
}

/// All modes of a group over a cycle.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ModeCourses {
    /// Number of circuits: what can't be reached without taking the mechanism apart; `None` where modes are not listed.
    pub circuits: Option<usize>,
    /// Number of branches: what can't be reached without a singular position.
    pub branches: Option<usize>,
    /// How many modes there are from a coordinate on.
    pub counts: Vec<CountFrom>,
    /// Each mode, by its number: first those of the first position in their order; one that begins later takes the next number.
    pub modes: Vec<ModeCourse>,
    /// Where two modes meet and both go on.
    pub meetings: Vec<ModeMeeting>,
}

/// Why the modes of a group have no courses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unlisted {
    /// Its kind doesn't list modes.
    ByKind,
    /// Up to this coordinate, rad or m, rounding made modes begin or end that can't be told apart.
    At(f64),
}

/// The modes at a coordinate with their numbers; `None` where the groups before can't be placed.
type Present = Option<Vec<(usize, Mode<f64>)>>;

struct Walk<'a> {
    linkage: &'a Linkage,
    group: usize,
    /// Unit of the coordinate, negative where it falls.
    unit: f64,
    found: ModeCourses,
    now: (f64, Present),
    /// Whether a mode that is not far away began or ended alone, which only rounding can make.
    is_lost: bool,
}

impl Linkage {
    /// All modes of a group over a turn of a pinned input, or over the range of the scene; the groups before it are in their
    /// present assembly.
    ///
    /// # Errors
    ///
    /// [`Unlisted`] where its kind can't list them, and where some can't be told apart.
    pub fn courses(&self, group: usize) -> Result<ModeCourses, Unlisted> {
        let lists = !self.structure.groups[group].plugin.iterates || self.groups()[group].lists_modes();
        if lists { Walk::over(self, group) } else { Err(Unlisted::ByKind) }
    }

    /// The modes of a group at a coordinate, in their order.
    fn modes_at(&self, group: usize, q: f64) -> Option<Vec<Mode<f64>>> {
        let mut bodies = self.starting_bodies(q);
        self.chain.set_input(q, &mut bodies);
        let ways = self.ways.at(q);
        let mut before = self.ancestors(group);
        before.pop();
        for ancestor in before {
            self.groups()[ancestor].place(&mut bodies, usize::from(ways[ancestor])).ok()?;
        }
        let kernel = self.groups()[group].as_ref();
        if !self.structure.groups[group].plugin.iterates {
            return Some(by_ways(kernel, &bodies));
        }
        match kernel.modes(&bodies) {
            Ok(all) => all,
            Err(GroupError::NoAssembly { .. }) => Some(Vec::new()),
            Err(_) => None,
        }
    }
}

impl<'a> Walk<'a> {
    fn over(linkage: &'a Linkage, group: usize) -> Result<ModeCourses, Unlisted> {
        let input = &linkage.mechanism.input;
        let last = input.coordinate(input.positions.saturating_sub(1));
        let length = if linkage.kind().is_angle() { TAU * input.sign() } else { last - input.from };
        let unit = linkage.coordinate_unit().copysign(length);
        let mut walk = Self {
            linkage,
            group,
            unit,
            found: ModeCourses::default(),
            now: (input.from, None),
            is_lost: false,
        };
        let first = walk.modes_at(input.from);
        walk.now.1 = first.map(|all| {
            all.into_iter().map(|mode| (walk.begin(input.from, CourseEnd::Cycle), mode)).collect()
        });
        walk.count(input.from);
        let start = walk.now.1.clone().unwrap_or_default();
        for step in 1..=SAMPLES {
            walk.sample(input.from + length * f64::from(step) / f64::from(SAMPLES));
            if walk.is_lost || walk.found.modes.len() > MOST_COURSES {
                return Err(Unlisted::At(walk.now.0));
            }
        }
        let end = walk.now.1.take().unwrap_or_default();
        for (number, _) in &end {
            walk.end(*number, CourseEnd::Cycle);
        }
        let is_same =
            |one: &Mode<f64>, other: &Mode<f64>| walk.apart(one, other) < TOGETHER && one.way == other.way;
        let closing = |(number, mode): &(usize, Mode<f64>)| {
            let again = start.iter().find(|(_, first)| linkage.kind().is_angle() && is_same(mode, first))?;
            Some([*number, again.0])
        };
        let closed: Vec<[usize; 2]> = end.iter().filter_map(closing).collect();
        walk.found.group(&closed);
        Ok(walk.found)
    }

    fn modes_at(&self, q: f64) -> Option<Vec<Mode<f64>>> {
        self.linkage.modes_at(self.group, q)
    }

    /// Begins a course at a coordinate; its number.
    fn begin(&mut self, from: f64, end: CourseEnd) -> usize {
        let (way, ends) = (self.found.modes.len(), CourseEnd::Cycle);
        self.found.modes.push(ModeCourse { way, from, to: from, begins: end, ends, circuit: 0, branch: 0 });
        way
    }

    /// Ends a course at the present coordinate.
    fn end(&mut self, number: usize, end: CourseEnd) {
        let course = &mut self.found.modes[number];
        (course.to, course.ends) = (self.now.0, end);
    }

    fn count(&mut self, from: f64) {
        let modes = self.now.1.as_ref().map_or(0, Vec::len);
        if self.found.counts.last().is_none_or(|last| last.modes != modes) {
            self.found.counts.push(CountFrom { from, modes });
        }
    }

    /// Goes on to a sample, or beside it where a group can turn freely there and has no mode.
    fn sample(&mut self, to: f64) {
        let (next, present) = (self.modes_at(to), self.now.1.as_ref().map(Vec::len));
        if present > Some(0) && next.as_ref().is_some_and(Vec::is_empty) {
            let beside = to + SHORTEST_EQUAL * self.unit;
            let modes = self.modes_at(beside);
            if modes.as_ref().map(Vec::len) == present {
                return self.advance(beside, modes);
            }
        }
        self.advance(to, next);
    }

    /// Goes on to a coordinate with its modes.
    fn advance(&mut self, to: f64, mut next: Option<Vec<Mode<f64>>>) {
        if (to - self.now.0) * self.unit <= 0.0 {
            // An event reaches beyond it.
            return;
        }
        let is_equal = self.now.1.as_ref().map(Vec::len) == next.as_ref().map(Vec::len);
        // Modes that are about to vanish run faster the nearer they are to that: they don't meet yet.
        let is_near = |mode| self.now.1.iter().flatten().any(|(_, one)| self.apart(one, mode) < TOGETHER);
        let is_meeting = is_equal && next.iter().flatten().all(is_near);
        let shortest = if is_meeting { SHORTEST_EQUAL } else { SHORTEST };
        let is_short = (to - self.now.0).abs() <= shortest * self.unit.abs();
        let continued = match (&self.now.1, &next) {
            (None, None) => Some(None),
            (Some(now), Some(next)) => self.continued(now, next).map(Some),
            _ => None,
        };
        let mut behind = to;
        let numbers = match continued {
            Some(numbers) => numbers,
            None if is_short || self.found.modes.len() > MOST_COURSES => {
                if !is_meeting {
                    behind = to + BEHIND * self.unit;
                    next = self.modes_at(behind);
                }
                self.event(to, next.as_deref())
            }
            None => {
                let middle = self.now.0 + MIDDLE * (to - self.now.0);
                self.advance(middle, self.modes_at(middle));
                return self.advance(to, next);
            }
        };
        let numbered = |(numbers, next): (Vec<usize>, Vec<_>)| numbers.into_iter().zip(next).collect();
        self.now = (behind, numbers.zip(next).map(numbered));
        self.count(to);
    }

    /// The numbers of the next modes where it is certain which is which.
    fn continued(&self, now: &[(usize, Mode<f64>)], next: &[Mode<f64>]) -> Option<Vec<usize>> {
        let is_clear = |one: &Mode<f64>, other: &Mode<f64>, moved: f64| {
            one.way == other.way || self.apart(one, other) > 2.0 * moved
        };
        let mut taken: Vec<(usize, f64)> = Vec::with_capacity(next.len());
        for mode in next {
            let (at, moved) = self.nearest(now, mode)?;
            if taken.iter().any(|(other, _)| *other == at) || is_turned(&now[at].1, mode, self.scale()) {
                return None;
            }
            taken.push((at, moved));
        }
        let is_certain = taken.len() == now.len()
            && taken.iter().enumerate().all(|(j, (a, one))| {
                taken.iter().enumerate().skip(j + 1).all(|(k, (b, other))| {
                    let moved = one.max(*other);
                    is_clear(&now[*a].1, &now[*b].1, moved) && is_clear(&next[j], &next[k], moved)
                })
            });
        is_certain.then(|| taken.into_iter().map(|(at, _)| now[at].0).collect())
    }

    /// The nearest mode of the same way with its distance; `None` where it is far.
    fn nearest(&self, now: &[(usize, Mode<f64>)], mode: &Mode<f64>) -> Option<(usize, f64)> {
        let same = now.iter().enumerate().filter(|(_, (_, one))| one.way == mode.way);
        let near = same.map(|(at, (_, one))| (at, self.apart(one, mode)));
        near.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, moved)| *moved < FARTHEST)
    }

    fn scale(&self) -> f64 {
        self.linkage.structure.scale
    }

    /// Distance of two modes; of far places as seen on a sphere, on which infinity is a point.
    fn apart(&self, one: &Mode<f64>, other: &Mode<f64>) -> f64 {
        let distance = |(a, b): (&Body<f64>, &Body<f64>)| {
            let [far, farther] = [a, b].map(|body| {
                elementary::hypot(elementary::hypot(body.x / self.scale(), body.y / self.scale()), 1.0)
            });
            let place = elementary::hypot(a.x - b.x, a.y - b.y) / (self.scale() * far * farther);
            place.max(elementary::hypot(a.c - b.c, a.s - b.s))
        };
        one.bodies.iter().zip(&other.bodies).map(distance).fold(0.0, f64::max)
    }
}

/// Whether a link is far away on opposite sides.
fn is_turned(one: &Mode<f64>, other: &Mode<f64>, scale: f64) -> bool {
    one.bodies.iter().zip(&other.bodies).any(|(a, b)| {
        let is_far = elementary::hypot(a.x, a.y).min(elementary::hypot(b.x, b.y)) > OPPOSITE * scale;
        is_far && a.x * b.x + a.y * b.y < 0.0
    })
}

impl ModeCourses {
    /// Numbers circuits and branches; `closed`: courses that go on in others at the end of the cycle.
    fn group(&mut self, closed: &[[usize; 2]]) {
        let closed = || closed.iter().copied();
        let ends = self.modes.iter().flat_map(|mode| [mode.begins, mode.ends].map(|end| (mode.way, end)));
        let together = ends.filter_map(|(way, end)| match end {
            CourseEnd::With(other) => Some([way, other]),
            _ => None,
        });
        let met = self.meetings.iter().map(|meeting| meeting.ways);
        let (circuits, circuit_count) = parts(self.modes.len(), closed().chain(met).chain(together));
        // The end of a course that has met another one is not where its beginning can go without that meeting.
        let has_met = |number: usize| self.meetings.iter().any(|one| one.ways.contains(&number));
        let (branches, branch_count) = parts(self.modes.len(), closed().filter(|[last, _]| !has_met(*last)));
        (self.circuits, self.branches) = (Some(circuit_count), Some(branch_count));
        for (number, course) in self.modes.iter_mut().enumerate() {
            (course.circuit, course.branch) = (circuits[number], branches[number]);
        }
    }
}

/// The number of the part of each of `count` elements of which some are joined, and the number of parts.
fn parts(count: usize, joined: impl Iterator<Item = [usize; 2]>) -> (Vec<usize>, usize) {
    let mut of: Vec<usize> = (0..count).collect();
    for [a, b] in joined {
        let (low, high) = (of[a].min(of[b]), of[a].max(of[b]));
        of.iter_mut().filter(|one| **one == high).for_each(|one| *one = low);
    }
    let mut all = of.clone();
    all.sort_unstable();
    all.dedup();
    let numbers = of.iter().map(|one| all.binary_search(one).unwrap_or(0)).collect();
    (numbers, all.len())
}
