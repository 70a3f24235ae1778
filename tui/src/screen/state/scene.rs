//! An open scene: its linkage, its positions, and the data for drawings and tables.

use std::borrow::Cow;
use std::path::PathBuf;
use std::sync::Arc;

use assur_analysis::MOST_KEPT;
use assur_figure::Bounds;
use assur_group::{GroupError, Order};
use assur_kinematics::{CompileError, Linkage, Position, PositionError};
use assur_mechanism::{GROUND, Range};
use assur_scene::edit::{Document, SceneValue};

use super::found::Found;
use super::series::{Owner, Series, Transfer};
use super::transfer::{self, coordinate_unit};
use crate::number::plain;

/// The source of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Source {
    /// A file.
    File(PathBuf),
    /// One of the shipped scenes, by its name without the ending.
    Shipped(&'static str),
}

impl Source {
    /// The name to show.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::File(path) => path.display().to_string(),
            Self::Shipped(name) => format!("{name}.toml"),
        }
    }

    /// The name without its folder.
    pub(crate) fn short_name(&self) -> String {
        match self {
            Self::File(path) => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            Self::Shipped(name) => format!("{name}.toml"),
        }
    }
}

/// An open scene.
#[derive(Debug)]
pub(crate) struct Scene {
    pub(crate) source: Source,
    /// Its text, and the numbers in it.
    pub(crate) text: String,
    pub(crate) values: Vec<SceneValue>,
    pub(crate) linkage: Arc<Linkage>,
    /// The solved positions, by number; `None` where there is no assembly.
    pub(crate) poses: Vec<Option<Position>>,
    /// Why a position can't be assembled.
    pub(crate) failures: Vec<Option<String>>,
    /// Of a position that can't be assembled, the links that have their places, and the first group that has none.
    pub(crate) broken: Vec<Option<(Position, usize)>>,
    /// Closely spaced positions over the whole cycle, for paths; `None` where there is no assembly.
    pub(crate) fine: Vec<Option<Position>>,
    /// Paths of the points over the whole cycle, m; empty for points of the ground.
    pub(crate) paths: Vec<Vec<[f64; 2]>>,
    /// Least and greatest displacement of each slide, m.
    pub(crate) strokes: Vec<[f64; 2]>,
    /// Bounds of the drawing over the whole cycle.
    pub(crate) bounds: Bounds,
    /// Every quantity over the positions.
    pub(crate) series: Vec<Series>,
    /// The quantities with two derivatives.
    pub(crate) transfers: Vec<Transfer>,
    /// The results of the analysis; `None` while it runs, or if there are none.
    pub(crate) found: Option<Box<Found>>,
    /// The results by another force analyzer, for the difference.
    pub(crate) other: Option<Box<Found>>,
    /// Why there is no analysis.
    pub(crate) fault: Option<String>,
}

/// Number of positions added between the scene's own to make a path smooth.
const PATH_POINTS: usize = 240;

impl Scene {
    /// Reads and compiles a scene.
    ///
    /// # Errors
    ///
    /// The errors as text, complete with file and line.
    pub(crate) fn read(source: Source, text: &str) -> Result<Self, String> {
        let name = source.name();
        let mechanism = assur_scene::read(&name, text).map_err(|errors| errors.to_string())?;
        let positions = mechanism.input.positions;
        if positions > MOST_KEPT {
            return Err(format!(
                "error: the scene has {positions} positions, and the terminal UI shows at most {MOST_KEPT}; take fewer \
                 `positions` in [input], or write them all: assur analyze {name} -o positions.parquet\n"
            ));
        }
        let linkage = Linkage::compile(mechanism).map_err(|error| {
            let located = match &error {
                CompileError::Structure(error) => crate::files::located(&name, text, error),
                _ => None,
            };
            located.map_or_else(|| format!("error: {error}\n  {name}\n"), |errors| errors.to_string())
        })?;
        let (mut poses, mut failures, mut broken) = (Vec::new(), Vec::new(), Vec::new());
        for index in 0..linkage.mechanism.input.positions {
            let mut position = nowhere(&linkage);
            let error = linkage.solve_index(index, Order::Second, &mut position).err();
            failures.push(error.as_ref().map(|error| failure(&linkage, index, error)));
            let (pose, rest) = match error {
                None => (Some(position), None),
                Some(error) => (None, Some((error.group, position))),
            };
            poses.push(pose);
            broken.push(rest.map(|(group, position)| {
                let placed = first_without_place(&linkage, &position).min(group);
                (position, placed)
            }));
        }
        let fine = fine_positions(&linkage);
        let paths = paths(&linkage, &fine);
        let strokes = strokes(&linkage, &fine);
        let (series, transfers) = transfer::series(&linkage, &poses);
        Ok(Self {
            source,
            text: text.to_owned(),
            values: Document::of(text).values(),
            bounds: bounds(&linkage, &fine, &paths, &strokes, &broken),
            linkage: Arc::new(linkage),
            poses,
            failures,
            broken,
            fine,
            paths,
            strokes,
            series,
            transfers,
            found: None,
            other: None,
            fault: None,
        })
    }

    /// Number of positions.
    pub(crate) fn positions(&self) -> usize {
        self.poses.len()
    }

    /// Whether the positions close a cycle: the first follows the last.
    pub(crate) fn closed(&self) -> bool {
        matches!(self.linkage.mechanism.input.range, Range::Cycle(_))
            && self.failures.iter().all(Option::is_none)
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

    /// The mechanism at a number of a position, also between two of them; `None` where there is no assembly.
    pub(crate) fn pose(&self, at: f64) -> Option<Cow<'_, Position>> {
        let number = at.floor();
        let input = &self.linkage.mechanism.input;
        let index = (0..self.poses.len()).find(|index| *index as f64 == number)?;
        if at == number {
            return self.poses[index].as_ref().map(Cow::Borrowed);
        }
        let [from, to] = [index, index + 1].map(|index| input.coordinate(index));
        let mut position = self.linkage.position();
        let solved = self.linkage.solve(from + (at - number) * (to - from), Order::Second, &mut position);
        solved.ok().map(|()| Cow::Owned(position))
    }

    /// The first position that exists, or 0.
    pub(crate) fn first_position(&self) -> usize {
        self.poses.iter().position(Option::is_some).unwrap_or(0)
    }
}

/// Storage for a position in which no link has a place yet.
fn nowhere(linkage: &Linkage) -> Position {
    let mut position = linkage.position();
    position.bodies.iter_mut().skip(1).for_each(|body| body.x = f64::NAN);
    position
}

/// The first group with a link that has no place.
fn first_without_place(linkage: &Linkage, position: &Position) -> usize {
    let placed = |link: &usize| position.bodies[*link].x.is_finite();
    let groups = &linkage.structure.groups;
    groups.iter().position(|group| !group.frame.links.iter().all(placed)).unwrap_or(groups.len())
}

/// Why a position does not exist, the most important first: what, by how much, where.
fn failure(linkage: &Linkage, index: usize, error: &PositionError) -> String {
    let GroupError::NoAssembly { gap_m } = error.source else {
        return format!("no assembly: {error}");
    };
    let (unit, factor) = coordinate_unit(linkage);
    let coordinate = format!("{} {unit}", plain(factor * error.coordinate));
    let gap = format!("{:.4}", 1e3 * gap_m);
    let group = linkage.structure.group_name(&linkage.mechanism, error.group);
    format!("no assembly: misses by {gap} mm in position {index}, {coordinate}; {group}")
}

/// Closely spaced positions, for drawings of the whole cycle.
fn fine_positions(linkage: &Linkage) -> Vec<Option<Position>> {
    let input = &linkage.mechanism.input;
    let (from, to) = match input.range {
        Range::Cycle(cycle) => (input.from, input.from + input.direction.sign() * cycle),
        Range::To(to) => (input.from, to),
    };
    (0..=PATH_POINTS)
        .map(|i| {
            let mut position = linkage.position();
            let coordinate = from + (to - from) * i as f64 / PATH_POINTS as f64;
            linkage.solve(coordinate, Order::Place, &mut position).is_ok().then_some(position)
        })
        .collect()
}

fn paths(linkage: &Linkage, fine: &[Option<Position>]) -> Vec<Vec<[f64; 2]>> {
    let points = &linkage.mechanism.points;
    (0..points.len())
        .map(|id| {
            if points[id].places.iter().any(|place| place.link == GROUND) {
                return Vec::new();
            }
            fine.iter()
                .map(|p| p.as_ref().map_or([f64::NAN; 2], |p| linkage.point_motion(id, p).pf0))
                .collect()
        })
        .collect()
}

fn strokes(linkage: &Linkage, fine: &[Option<Position>]) -> Vec<[f64; 2]> {
    (0..linkage.mechanism.slides.len())
        .map(|id| {
            let displacements = fine.iter().flatten().map(|position| linkage.slide_motion(id, position).pf0);
            displacements.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], s| [l.min(s), h.max(s)])
        })
        .collect()
}

fn bounds(
    linkage: &Linkage,
    fine: &[Option<Position>],
    paths: &[Vec<[f64; 2]>],
    strokes: &[[f64; 2]],
    broken: &[Option<(Position, usize)>],
) -> Bounds {
    let mut bounds = Bounds::EMPTY;
    for (position, _) in broken.iter().flatten() {
        let places = linkage.mechanism.points.iter().flat_map(|point| &point.places);
        let at = places.map(|place| position.bodies[place.link].point(place.at));
        at.filter(|at| at[0].is_finite()).for_each(|at| bounds.add(at));
    }
    for point in &linkage.mechanism.points {
        point.places.iter().filter(|place| place.link == GROUND).for_each(|place| bounds.add(place.at));
    }
    paths.iter().flatten().for_each(|at| bounds.add(*at));
    for (slide, &[low, high]) in linkage.mechanism.slides.iter().zip(strokes) {
        for position in fine.iter().flatten().step_by(8) {
            let body = &position.bodies[slide.on];
            let (s, c) = slide.angle.sin_cos();
            let (through, along) = (body.point(slide.through), body.turned([c, s]));
            for d in [low, high] {
                bounds.add([through[0] + d * along[0], through[1] + d * along[1]]);
            }
        }
    }
    bounds
}

impl Scene {
    /// What a quantity belongs to: its kind and its name.
    pub(crate) fn owner(&self, owner: &Owner) -> (&'static str, &str) {
        let mechanism = &self.linkage.mechanism;
        match *owner {
            Owner::Point(id) => ("point", &mechanism.points[id].name),
            Owner::Link(id) => ("link", &mechanism.links[id].name),
            Owner::Slide(id) => ("slide", &mechanism.slides[id].name),
        }
    }

    /// How many series there are: the transfer functions, then what the analysis found.
    pub(crate) fn column_count(&self) -> usize {
        self.series.len() + self.found.as_ref().map_or(0, |found| found.series.len())
    }

    /// The series of a short name.
    pub(crate) fn named(&self, short: &str) -> Option<&Series> {
        (0..self.column_count()).filter_map(|index| self.column(index)).find(|series| series.short == short)
    }

    /// One of them.
    pub(crate) fn column(&self, index: usize) -> Option<&Series> {
        match index.checked_sub(self.series.len()) {
            None => self.series.get(index),
            Some(beyond) => self.found.as_ref()?.series.get(beyond),
        }
    }
}
