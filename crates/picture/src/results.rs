//! What was calculated of a scene: its positions, the data for drawings and tables, and the results of the analysis.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use assur_analysis::results::{Column, Edges, Owner, Quantity, Schema, Table};
use assur_analysis::{AnalysisError, Calculation, Options, plan, unwatched};
use assur_book::{Course, Node, catalogue};
use assur_figure::number::{plain, trimmed};
use assur_force::LoadState;
use assur_group::{GroupError, Order};
use assur_kinematics::{Linkage, Modes, Position, PositionError};
use assur_mechanism::{GROUND, PointId};
use assur_words::{Describe, Text, number, quantity, text};

use crate::arrows::Arrow;
use crate::{Arrows, Found, Outline, Series, Transfer, coordinate_unit};

/// The vectors of all positions: of which kinds, whether of one position alone, whether with the results of the analysis.
type KeptArrows = HashMap<(Arrows, bool, bool), Arc<[Arrow]>>;

/// A group that misses by no more than this part of the mechanism's size is at a change point but for rounding of the lengths.
const BARELY: f64 = 1e-6;

/// What was calculated of a scene.
#[derive(Debug)]
pub struct Results {
    /// The compiled mechanism, with all its groups.
    pub linkage: Arc<Linkage>,
    /// The positions that can't be assembled, by number.
    pub broken: BTreeMap<usize, Broken>,
    /// The whole cycle for drawings.
    pub outline: Outline,
    /// The coordinate, then PF0, PF1, PF2 of points, links and slides.
    pub series: Vec<Series>,
    /// The quantities with two derivatives.
    pub transfers: Vec<Transfer>,
    /// Of a transient motion, whose series are those of its samples, the series of the positions.
    pub(crate) cycle: Option<Vec<Series>>,
    /// The results of the analysis; `None` while it runs, or if there are none.
    pub found: Option<Box<Found>>,
    /// The results by another force analyzer, for the difference.
    pub other: Option<Box<Found>>,
    /// By group, the least determinant over the positions, and the position that has it.
    pub(crate) least_health: Vec<Option<(f64, usize)>>,
    /// The vectors of all positions by what is drawn, kept because a view is drawn many times.
    pub(crate) arrows: RefCell<KeptArrows>,
    /// Modes by group and position, kept because a view is drawn many times.
    modes: RefCell<HashMap<[usize; 2], Option<Arc<Modes>>>>,
}

/// A position that can't be assembled.
#[derive(Debug)]
pub struct Broken {
    /// Why: what, by how much, where.
    pub why: Text,
    /// The links that have a place; the others are at NaN.
    pub pose: Position,
    /// The first group that has none.
    pub group: usize,
    /// Whether the gap is rounding of the lengths: modes of the group meet there.
    pub is_change_point: bool,
}

impl Results {
    /// Calculates the positions of a linkage.
    pub fn of(linkage: Arc<Linkage>) -> Result<Self, AnalysisError> {
        let (table, edges) = positions(&linkage)?;
        let (series, transfers) = series(&linkage, &table, &edges, Column::COORDINATE);
        let missing = (0..linkage.mechanism.input.positions).filter(|index| table.row_of(*index).is_none());
        let broken: BTreeMap<_, _> =
            missing.filter_map(|index| Some((index, broken(&linkage, index)?))).collect();
        let outline = Outline::of(&linkage, broken.values().map(|broken| &broken.pose));
        let least_health =
            (0..linkage.structure.groups.len()).map(|group| least_health(&table, group)).collect();
        let (found, other, arrows, modes, cycle) = (None, None, RefCell::default(), RefCell::default(), None);
        Ok(Self {
            linkage,
            broken,
            outline,
            series,
            transfers,
            cycle,
            found,
            other,
            least_health,
            arrows,
            modes,
        })
    }

    /// The positions that can be assembled.
    pub fn assembled(&self) -> impl Iterator<Item = usize> {
        (0..self.positions()).filter(|index| !self.broken.contains_key(index))
    }

    /// The first position that can be assembled, or 0.
    pub fn first_position(&self) -> usize {
        self.assembled().next().unwrap_or(0)
    }

    /// Those of these positions that can be assembled, for paper: without any two in different parts of the cycle; at least one.
    pub fn chosen(&self, wanted: &[usize]) -> Vec<usize> {
        let count = self.positions();
        let usual = [count / 8, 5 * count / 8];
        let wanted = if wanted.is_empty() { &usual[..] } else { wanted };
        let exists = |position: &usize| *position < count && !self.broken.contains_key(position);
        let mut chosen: Vec<usize> = wanted.iter().copied().filter(exists).collect();
        if chosen.is_empty() {
            chosen.push(self.first_position());
        }
        chosen.dedup();
        chosen
    }

    /// The least determinant of a group over the positions, and the position that has it.
    pub fn least_health(&self, group: usize) -> Option<(f64, usize)> {
        *self.least_health.get(group)?
    }

    /// The group that comes nearest to a singular position, with its least determinant and the position.
    pub fn nearest_group(&self) -> Option<(usize, f64, usize)> {
        let all = self.least_health.iter().enumerate();
        let least = all.filter_map(|(group, least)| least.map(|(health, at)| (group, health, at)));
        least.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The mechanism in a position, or on a part of the way to the next one; `None` where there is no assembly.
    pub fn pose(&self, index: usize, part: f64) -> Option<Position> {
        let (mut pose, from) = (self.linkage.position(), self.coordinate(index));
        let at = if part > 0.0 { from + part * (self.coordinate(index + 1) - from) } else { from };
        self.linkage.solve(at, Order::Second, &mut pose).ok().map(|()| pose)
    }

    /// The mechanism with the state of its motion in a position or sample, or on a part of the way to the next one; `None` where there
    /// is no assembly.
    pub fn moving(&self, index: usize, part: f64) -> Option<(Position, LoadState)> {
        let pose = self.pose(index, part)?;
        let calculation = self.found.as_deref().map(|found| found.plans.calculation());
        let sample = calculation.filter(|_| self.samples().is_some()).and_then(|found| found.sample(index).0);
        let at_rest = || LoadState::prescribed(&self.linkage.mechanism, pose.coordinate);
        let state = match (sample, calculation) {
            (Some(state), _) => LoadState { coordinate: pose.coordinate, ..state },
            (None, Some(calculation)) => calculation.state(pose.coordinate),
            (None, None) => at_rest(),
        };
        Some((pose, state))
    }

    /// The modes of a group in a position; `None` where there is no such group or position, or its kind can't list them.
    pub fn modes(&self, group: usize, position: usize) -> Option<Arc<Modes>> {
        let list = || {
            self.linkage.structure.groups.get(group)?;
            let modes = self.linkage.modes(group, &self.pose(position, 0.0)?).ok()??;
            (!modes.all.is_empty()).then(|| Arc::new(modes))
        };
        self.modes.borrow_mut().entry([group, position]).or_insert_with(list).clone()
    }

    /// Why a position can't be assembled; of one that can, why the first lost one can't.
    pub fn lost(&self, position: usize) -> Option<&Broken> {
        self.broken.get(&position).or_else(|| self.broken.values().next())
    }

    /// The names of the groups.
    pub fn group_names(&self) -> Vec<Text> {
        let structure = &self.linkage.structure;
        let groups = 0..structure.groups.len();
        groups.map(|group| structure.group_name(&self.linkage.mechanism, group)).collect()
    }

    /// What a quantity belongs to: its kind and its name.
    pub fn owner(&self, owner: &Owner) -> (&'static str, &str) {
        let mechanism = &self.linkage.mechanism;
        match *owner {
            Owner::Point(id) => ("point", &mechanism.points[id].name),
            Owner::Link(id) => ("link", &mechanism.links[id].name),
            Owner::Slide(id) => ("slide", &mechanism.slides[id].name),
            _ => ("", ""),
        }
    }

    /// The quantity with two derivatives to which a column belongs.
    pub fn transfer_of(&self, column: usize) -> Option<usize> {
        self.transfers.iter().position(|transfer| transfer.orders.contains(&column))
    }

    /// All series: the transfer functions, then what the analysis found.
    pub fn columns(&self) -> impl Iterator<Item = &Series> {
        self.series.iter().chain(self.found.iter().flat_map(|found| &found.series))
    }

    /// Number of [`columns`](Self::columns).
    pub fn column_count(&self) -> usize {
        self.columns().count()
    }

    /// The series of a short name.
    pub fn named(&self, short: &str) -> Option<&Series> {
        self.columns().find(|series| series.short == short)
    }

    /// A series by its place among [`columns`](Self::columns).
    pub fn column(&self, index: usize) -> Option<&Series> {
        self.columns().nth(index)
    }
}

/// A value this small compared with the size of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// All series, and which of them belong together.
pub(crate) fn series(
    linkage: &Linkage,
    table: &Table,
    edges: &Edges,
    over: Column,
) -> (Vec<Series>, Vec<Transfer>) {
    let (mechanism, schema) = (&linkage.mechanism, Schema::new(&linkage.mechanism));
    let course = if over == Column::COORDINATE {
        let node = |number| {
            let at = mechanism.input.coordinate(number);
            Node { number, at, value: at }
        };
        // Positions that can't be assembled have a coordinate too.
        let count = mechanism.input.positions;
        let end = (!edges.ending.is_empty()).then(|| node(count));
        Course::from_nodes((0..count).map(node), end)
    } else {
        Course::of(table, Some(edges), over, Column::COORDINATE)
    };
    let mut series = vec![Series::of(&schema, Column::COORDINATE, course, 0.0)];
    let mut transfers = Vec::new();
    let moves = |id: &PointId| mechanism.points[*id].places.iter().all(|place| place.link != GROUND);
    let points = (0..mechanism.points.len()).filter(moves).map(Owner::Point);
    let points = points.flat_map(|owner| Column::vector(Quantity::Transfer(0), owner));
    let links = (1..mechanism.links.len()).map(Owner::Link);
    let others = links.chain((0..mechanism.slides.len()).map(Owner::Slide));
    for place in points.chain(others.map(|owner| Column::of(Quantity::Transfer(0), owner))) {
        // Angles are of the order of 1; lengths of that of the mechanism.
        let size = if let Owner::Link(_) = place.owner { 1.0 } else { linkage.structure.scale };
        let first = series.len();
        series.extend((0..=2).map(|order| {
            // Over time derivatives are velocities and accelerations.
            let quantity = match (order, linkage.kind().is_time()) {
                (1, true) => Quantity::Velocity,
                (2, true) => Quantity::Acceleration,
                _ => Quantity::Transfer(order),
            };
            let column = Column { quantity, ..place };
            let course = Course::of(table, Some(edges), over, column);
            Series::of(&schema, column, course, ROUNDING * size)
        }));
        let name = catalogue::subject(&schema, place);
        transfers.push(Transfer { name, owner: place.owner, orders: [first, first + 1, first + 2] });
    }
    (series, transfers)
}

/// The transfer functions of the positions and of what is drawn between and after them, whatever the scene requests and however it
/// is loaded.
fn positions(linkage: &Linkage) -> Result<(Table, Edges), AnalysisError> {
    let mut bare = linkage.clone();
    let mechanism = &mut bare.mechanism;
    if !mechanism.input.kind().is_time() {
        mechanism.motion = None;
    }
    mechanism.drive = None;
    mechanism.loads.clear();
    mechanism.frictions.clear();
    let options = Options { whole: true, ..Options::default() };
    let mut plan = plan(mechanism, &bare.structure, &options);
    plan.reduction = false;
    let calculation = Calculation::planned(Arc::new(bare), plan, None, &options, &mut unwatched)?;
    let table = calculation.analyze(&mut unwatched)?.positions;
    let edges = calculation.edges(&table);
    Ok((table, edges))
}

/// The least determinant of a group, from its condition number, which a singular position lacks.
fn least_health(table: &Table, group: usize) -> Option<(f64, usize)> {
    let column = table.schema().find(Column::of(Quantity::Condition, Owner::Group(group)))?;
    let healths = table.each(column).map(|condition| condition.map_or(0.0, f64::recip));
    healths.zip(table.numbers().iter().copied()).min_by(|a, b| a.0.total_cmp(&b.0))
}

/// A position that can't be assembled, with what there is of it.
fn broken(linkage: &Linkage, index: usize) -> Option<Broken> {
    let mut pose = linkage.position();
    pose.bodies.iter_mut().skip(1).for_each(|body| body.x = f64::NAN);
    let error = linkage.solve_index(index, Order::Second, &mut pose).err()?;
    let placed = |link: &usize| pose.bodies[*link].x.is_finite();
    let groups = &linkage.structure.groups;
    let group = groups.iter().position(|group| !group.frame.links.iter().all(placed)).unwrap_or(error.group);
    let why = failure(linkage, index, &error);
    let limit = BARELY * linkage.structure.scale;
    let is_change_point = matches!(error.source, GroupError::NoAssembly { gap_m } if gap_m <= limit);
    Some(Broken { why, pose, group: group.min(error.group), is_change_point })
}

/// Why a position does not exist, the most important first: what, by how much, where.
fn failure(linkage: &Linkage, index: usize, error: &PositionError) -> Text {
    let GroupError::NoAssembly { gap_m } = error.source else {
        return text!("say-no-assembly", reason = error.describe());
    };
    let (unit, factor) = coordinate_unit(linkage);
    let at = quantity(plain(factor * error.coordinate), unit);
    let place = text!("position-at", position = number(index), at = at);
    let gap = quantity(trimmed(1e3 * gap_m, 4), "mm");
    let group = linkage.structure.group_name(&linkage.mechanism, error.group).short();
    let range = linkage.range.filter(|range| !range.full);
    let ends = range.map(|range| [range.low, range.high].map(|end| quantity(plain(factor * end), unit)));
    // A kind that iterates does not know by how much it misses.
    match (gap_m > 0.0, ends) {
        (true, Some([from, to])) => {
            text!("say-misses-beyond", gap = gap, place = place, group = group, from = from, to = to)
        }
        (true, None) => text!("say-misses", gap = gap, place = place, group = group),
        (false, Some([from, to])) => {
            text!("say-lost-beyond", place = place, group = group, from = from, to = to)
        }
        (false, None) => text!("say-lost", place = place, group = group),
    }
}
