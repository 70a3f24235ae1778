//! An open scene: its linkage, its positions, and the data for drawings and tables; and a second one for comparison.

use std::borrow::Cow;
use std::sync::Arc;

use assur_analysis::results::Owner;
use assur_group::{GroupError, Order};
use assur_kinematics::{Linkage, Modes, Position, PositionError};
use assur_mechanism::MOST_PARTS_DRAWN;
use assur_words::{Describe, Text, name, number, quantity, text};

use super::found::Found;
use super::outline::Outline;
use super::transfer;
use crate::number::plain;
use crate::session::Session;
use assur_picture::{Series, Transfer, coordinate_unit};

#[derive(Debug)]
pub(crate) struct Scene {
    pub(crate) session: Arc<Session>,
    pub(crate) linkage: Arc<Linkage>,
    /// The solved positions, by number; `None` where there is no assembly.
    pub(crate) poses: Vec<Option<Position>>,
    /// The positions that can't be assembled, by number.
    pub(crate) broken: Vec<Option<Broken>>,
    pub(crate) outline: Outline,
    /// Every quantity over the positions.
    pub(crate) series: Vec<Series>,
    /// The quantities with two derivatives.
    pub(crate) transfers: Vec<Transfer>,
    /// The results of the analysis; `None` while it runs, or if there are none.
    pub(crate) found: Option<Box<Found>>,
    /// The results by another force analyzer, for the difference.
    pub(crate) other: Option<Box<Found>>,
    /// Why there is no analysis.
    pub(crate) fault: Option<Text>,
}

/// A position that can't be assembled.
#[derive(Debug)]
pub(crate) struct Broken {
    /// Why: what, by how much, where.
    pub(crate) why: Text,
    /// The links that have a place; the others are at NaN.
    pub(crate) pose: Position,
    /// The first group that has none.
    pub(crate) group: usize,
}

impl Scene {
    /// Compiles a scene and solves its positions.
    ///
    /// # Errors
    ///
    /// The errors as text, complete with file and line.
    pub(crate) fn of(session: impl Into<Arc<Session>>) -> Result<Self, Text> {
        let session = session.into();
        refuse_large(&session)?;
        let linkage = session.linkage().map_err(|error| session.fault(&error.into()))?;
        let solved = (0..linkage.mechanism.input.positions).map(|index| solve(&linkage, index));
        let (poses, broken): (Vec<_>, Vec<Option<Broken>>) = solved.unzip();
        let outline = Outline::of(&linkage, broken.iter().flatten().map(|broken| &broken.pose));
        let (series, transfers) = transfer::series(&linkage).map_err(|error| session.fault(&error))?;
        let (found, other, fault) = (None, None, None);
        Ok(Self { session, linkage, poses, broken, outline, series, transfers, found, other, fault })
    }

    pub(crate) fn positions(&self) -> usize {
        self.poses.len()
    }

    /// Whether the positions are those of a cycle, whose end is no position of its own.
    pub(crate) fn is_cycle(&self) -> bool {
        self.linkage.mechanism.input.is_cycle()
    }

    /// The least determinant of a group over the positions, and the position that has it.
    pub(crate) fn least_health(&self, group: usize) -> Option<(f64, usize)> {
        let healths = self.poses.iter().enumerate().filter_map(|(position, pose)| {
            let health = pose.as_ref()?.health.get(group)?.abs();
            health.is_finite().then_some((health, position))
        });
        healths.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The group that comes nearest to a singular position, with its least determinant and the position.
    pub(crate) fn nearest_group(&self) -> Option<(usize, f64, usize)> {
        let groups = 0..self.linkage.structure.groups.len();
        let least =
            groups.filter_map(|group| self.least_health(group).map(|(health, at)| (group, health, at)));
        least.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The mechanism in a position, or on a part of the way to the next one; `None` where there is no assembly.
    pub(crate) fn pose(&self, index: usize, part: f64) -> Option<Cow<'_, Position>> {
        if part > 0.0 {
            let [from, to] = [index, index + 1].map(|index| self.linkage.mechanism.input.coordinate(index));
            let mut position = self.linkage.position();
            let solved = self.linkage.solve(from + part * (to - from), Order::Second, &mut position);
            return solved.ok().map(|()| Cow::Owned(position));
        }
        self.poses.get(index)?.as_ref().map(Cow::Borrowed)
    }

    /// The modes of a group in the first position; `None` where there is no such group or position, or its kind can't list them.
    pub(crate) fn first_modes(&self, group: usize) -> Option<Modes> {
        let first = self.poses.first()?.as_ref()?;
        self.linkage.structure.groups.get(group)?;
        self.linkage.modes(group, first).ok()?.filter(|modes| !modes.all.is_empty())
    }

    /// The first position that exists, or 0.
    pub(crate) fn first_position(&self) -> usize {
        self.poses.iter().position(Option::is_some).unwrap_or(0)
    }

    /// What a quantity belongs to: its kind and its name.
    pub(crate) fn owner(&self, owner: &Owner) -> (&'static str, &str) {
        let mechanism = &self.linkage.mechanism;
        match *owner {
            Owner::Point(id) => ("point", &mechanism.points[id].name),
            Owner::Link(id) => ("link", &mechanism.links[id].name),
            Owner::Slide(id) => ("slide", &mechanism.slides[id].name),
            _ => ("", ""),
        }
    }

    /// All series: the transfer functions, then what the analysis found.
    pub(crate) fn columns(&self) -> impl Iterator<Item = &Series> {
        self.series.iter().chain(self.found.iter().flat_map(|found| &found.series))
    }

    pub(crate) fn column_count(&self) -> usize {
        self.columns().count()
    }

    /// The coordinate at a number of a position, also between two or after the last one, in the unit that is shown.
    pub(crate) fn coordinate_at(&self, at: f64) -> f64 {
        assur_picture::coordinate_at(&self.linkage, at)
    }

    /// The coordinate of a position with its unit.
    pub(crate) fn coordinate(&self, position: usize) -> Text {
        let series = &self.series[0];
        quantity(plain(series.at(position)), series.unit.clone())
    }

    /// `position 6, 45 deg`.
    pub(crate) fn place(&self, position: usize) -> Text {
        text!("position-at", position = number(position), at = self.coordinate(position))
    }

    /// The series of a short name.
    pub(crate) fn named(&self, short: &str) -> Option<&Series> {
        self.columns().find(|series| series.short == short)
    }

    pub(crate) fn column(&self, index: usize) -> Option<&Series> {
        self.columns().nth(index)
    }
}

/// Refuses a scene that is too large to be drawn.
fn refuse_large(session: &Session) -> Result<(), Text> {
    let (mechanism, scene) = (&session.mechanism, || name(session.source.name()));
    let (parts, positions) = (mechanism.parts(), mechanism.input.positions);
    if parts > MOST_PARTS_DRAWN {
        let most = number(MOST_PARTS_DRAWN);
        return Err(text!("say-too-many-parts", parts = number(parts), most = most, scene = scene()));
    }
    let most = mechanism.most_kept();
    if positions > most {
        let [positions, most] = [positions, most].map(number);
        return Err(text!("say-too-many-positions", positions = positions, most = most, scene = scene()));
    }
    Ok(())
}

/// Solves a position: its pose, or what there is of it.
fn solve(linkage: &Linkage, index: usize) -> (Option<Position>, Option<Broken>) {
    let mut pose = linkage.position();
    pose.bodies.iter_mut().skip(1).for_each(|body| body.x = f64::NAN);
    let Err(error) = linkage.solve_index(index, Order::Second, &mut pose) else { return (Some(pose), None) };
    let placed = |link: &usize| pose.bodies[*link].x.is_finite();
    let groups = &linkage.structure.groups;
    let group = groups.iter().position(|group| !group.frame.links.iter().all(placed)).unwrap_or(error.group);
    let why = failure(linkage, index, &error);
    (None, Some(Broken { why, pose, group: group.min(error.group) }))
}

/// Why a position does not exist, the most important first: what, by how much, where.
fn failure(linkage: &Linkage, index: usize, error: &PositionError) -> Text {
    let GroupError::NoAssembly { gap_m } = error.source else {
        return text!("say-no-assembly", reason = error.describe());
    };
    let (unit, factor) = coordinate_unit(linkage);
    let at = quantity(plain(factor * error.coordinate), unit);
    let place = text!("position-at", position = number(index), at = at);
    let gap = quantity(format_args!("{:.4}", 1e3 * gap_m), "mm");
    let group = linkage.structure.group_name(&linkage.mechanism, error.group);
    match linkage.range.filter(|range| !range.full) {
        Some(range) => {
            let [from, to] = [range.low, range.high].map(|end| quantity(plain(factor * end), unit));
            text!("say-misses-beyond", gap = gap, place = place, group = group, from = from, to = to)
        }
        None => text!("say-misses", gap = gap, place = place, group = group),
    }
}

#[derive(Debug)]
pub(crate) struct Compared {
    pub(crate) name: Text,
    pub(crate) scene: Box<Scene>,
    /// Whether it is the open scene as it was before its numbers were changed.
    pub(crate) before: bool,
}

impl Compared {
    /// The corresponding quantity of the second scene, in the same unit.
    pub(crate) fn series(&self, own: &Series) -> Option<&Series> {
        self.scene.named(&own.short).filter(|other| other.unit == own.unit)
    }

    /// Own value minus that of the second scene; NaN if one of them has none.
    pub(crate) fn difference(&self, own: &Series, position: usize) -> Option<f64> {
        Some(own.at(position) - self.series(own)?.at(position))
    }
}
