//! Where the links of a mechanism lie in its first position, also while it is no mechanism yet.

use assur_group::{Body, Order};
use assur_kinematics::{CompileError, Linkage, PositionError, decompose};
use assur_mechanism::{GROUND, LinkId, Mechanism};
use assur_structure::{PassivePart, Structure, StructureError};
use assur_words::Text;

use crate::guess::guess;
use crate::pose::{Line, Pose, angle_of};

/// Most positions that are tried where the first can't be assembled.
const MOST_TRIED: usize = 48;

/// The size of a mechanism that has none, m.
const NO_SIZE: f64 = 0.1;

/// A mechanism with the places of its links.
#[derive(Debug, Clone)]
pub struct Sketch {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// The pose of each link; `None` where nothing tells it.
    pub bodies: Vec<Option<Pose>>,
    /// Whether the pose of each link is that of an assembled position; otherwise it is guessed.
    pub solved: Vec<bool>,
    /// The coordinate (rad, m or s) at which it is drawn: that of the first position, or of the first that can be assembled.
    pub coordinate: f64,
}

/// Places the links of a mechanism in the first position, or in the first that can be assembled. What is loose or can't be assembled is
/// placed by the points whose places are known from `[assembly]` or from placed links.
pub fn sketch(mechanism: &Mechanism) -> Sketch {
    let mut bodies = vec![None; mechanism.links.len()];
    let mut coordinate = mechanism.input.from;
    if let Some((found, at)) = solved(mechanism) {
        (bodies, coordinate) = (found, at);
    }
    if let Some(ground) = bodies.first_mut() {
        *ground = Some(Pose::GROUND);
    }
    let solved = bodies.iter().map(Option::is_some).collect();
    guess(mechanism, &mut bodies);
    Sketch { mechanism: mechanism.clone(), bodies, solved, coordinate }
}

impl Sketch {
    /// The place of a named point in the plane, m.
    pub fn place(&self, point: &str) -> Option<[f64; 2]> {
        self.place_of(self.mechanism.point(point)?)
    }

    /// The named points that have a place, with their places in the plane, m.
    pub fn points(&self) -> impl Iterator<Item = (&str, [f64; 2])> {
        let places = (0..self.mechanism.points.len()).map(|point| self.place_of(point));
        self.mechanism.points.iter().zip(places).filter_map(|(point, at)| Some((point.name.as_str(), at?)))
    }

    /// The line of the guide of a slide in the plane: the point through which it goes, m, and its direction, rad.
    pub fn guide(&self, slide: &str) -> Option<([f64; 2], f64)> {
        self.guide_of(self.mechanism.slides.iter().position(|found| found.name == slide)?)
    }

    /// The pose of a link, `ground` included.
    pub fn pose(&self, link: &str) -> Option<Pose> {
        self.bodies[self.mechanism.link(link)?]
    }

    /// The greatest distance between the named points along an axis of the plane, m; 100 mm where all are at one place.
    pub fn size(&self) -> f64 {
        size_of(self.points().map(|(_, at)| at))
    }

    /// Whether all links are assembled in the first position.
    pub fn is_assembled(&self) -> bool {
        self.solved.iter().all(|solved| *solved)
            && self.coordinate.to_bits() == self.mechanism.input.from.to_bits()
    }

    fn place_of(&self, point: usize) -> Option<[f64; 2]> {
        place_of(&self.mechanism, &self.bodies, point)
    }

    pub(crate) fn guide_of(&self, slide: usize) -> Option<Line> {
        let slide = &self.mechanism.slides[slide];
        let pose = self.bodies[slide.on]?;
        Some((pose.point(slide.through), pose.angle + slide.angle))
    }
}

/// The greatest extent of some places along an axis, m.
pub(crate) fn size_of(places: impl Iterator<Item = [f64; 2]>) -> f64 {
    let mut ends: Option<[[f64; 2]; 2]> = None;
    for at in places {
        let [low, high] = ends.get_or_insert([at, at]);
        for axis in 0..2 {
            low[axis] = low[axis].min(at[axis]);
            high[axis] = high[axis].max(at[axis]);
        }
    }
    let size = ends.map_or(0.0, |[low, high]| (high[0] - low[0]).max(high[1] - low[1]));
    if size > 0.0 { size } else { NO_SIZE }
}

/// The place of a point: on a placed link, or as `[assembly]` has it.
pub(crate) fn place_of(mechanism: &Mechanism, bodies: &[Option<Pose>], point: usize) -> Option<[f64; 2]> {
    let on_link = mechanism.points[point].places.iter().find_map(|of| Some(bodies[of.link]?.point(of.at)));
    let wanted = || mechanism.assembly.iter().find(|(wanted, _)| *wanted == point).map(|(_, at)| *at);
    on_link.or_else(wanted)
}

/// The poses of the links that can be solved, and the coordinate. Links that are loose, or whose group has no solution, are left out.
fn solved(mechanism: &Mechanism) -> Option<(Vec<Option<Pose>>, f64)> {
    if mechanism.input.drivers.iter().any(|driver| driver.link == GROUND) {
        return None;
    }
    let mut out: Vec<LinkId> = Vec::new();
    loop {
        let faulty = match structure(mechanism, &out) {
            Err(error) => at_fault(mechanism, &error),
            Ok(structure) => match position(mechanism, &structure, out.is_empty()) {
                Ok((bodies, at)) => {
                    let pose = |(link, body): (usize, &Body<f64>)| {
                        (!out.contains(&link))
                            .then(|| Pose { at: body.origin(), angle: angle_of([body.c, body.s]) })
                    };
                    return Some((bodies.iter().enumerate().map(pose).collect(), at));
                }
                Err(links) => links,
            },
        };
        let before = out.len();
        for link in faulty {
            if !out.contains(&link) && !mechanism.input.places(link) {
                out.push(link);
            }
        }
        if out.len() == before {
            return None;
        }
    }
}

/// The groups of a mechanism without some links.
fn structure(mechanism: &Mechanism, out: &[LinkId]) -> Result<Structure, StructureError> {
    if out.is_empty() {
        return decompose(mechanism);
    }
    let parts: Vec<_> = out.iter().map(|link| PassivePart::Link(*link)).collect();
    let mut structure = Structure::without(mechanism, &parts)?;
    structure.passive.clear();
    Ok(structure)
}

/// The links that an error names; of those that surplus pairs lock only the last.
fn at_fault(mechanism: &Mechanism, error: &StructureError) -> Vec<LinkId> {
    let ids = |names: &[String]| names.iter().filter_map(|name| mechanism.link(name)).collect::<Vec<_>>();
    match error {
        StructureError::Loose { links, .. } | StructureError::NoPlugin { links, .. } => ids(links),
        StructureError::Surplus { links, .. } | StructureError::SlideAngles { links, .. } => {
            ids(links).into_iter().max().into_iter().collect()
        }
        StructureError::Held { slide, .. } => {
            let found = mechanism.slides.iter().find(|found: &&assur_mechanism::Slide| found.name == **slide);
            found.map(|slide| slide.link).into_iter().collect()
        }
        StructureError::DependentInput { .. } | StructureError::Registry(_) => Vec::new(),
    }
}

/// The bodies in the first position, or (`any`) in the first that can be assembled, and its coordinate; else the links of the group
/// that has no solution.
fn position(
    mechanism: &Mechanism,
    structure: &Structure,
    any: bool,
) -> Result<(Vec<Body<f64>>, f64), Vec<LinkId>> {
    let needed = vec![true; structure.groups.len()];
    let named = |structure: &Structure, group: &Text| {
        let found =
            (0..structure.groups.len()).find(|index| structure.group_name(mechanism, *index) == *group);
        found.map(|index| structure.groups[index].frame.links.clone()).unwrap_or_default()
    };
    let compiled = Linkage::compile_for(mechanism.clone(), structure.clone(), &needed);
    let mut linkage = compiled.map_err(|error| match error {
        CompileError::NoStart { group, .. } | CompileError::Build { group, .. } => named(structure, &group),
        CompileError::Structure(error) => at_fault(mechanism, &error),
    })?;
    let error = match first(&linkage) {
        Ok(bodies) => return Ok((bodies, mechanism.input.from)),
        Err(error) => error,
    };
    let iterates = structure.groups.iter().any(|group| group.plugin.iterates);
    let input = &mechanism.input;
    let tried = (1..input.positions).step_by(input.positions.div_ceil(MOST_TRIED).max(1));
    for index in tried.filter(|_| any && (iterates || error.elsewhere.is_some())) {
        let mut other = mechanism.clone();
        other.input.from = input.coordinate(index);
        let from = other.input.from;
        let Ok((varied, ..)) = linkage.varied(other, &needed) else { break };
        linkage = varied;
        if let Ok(bodies) = first(&linkage) {
            return Ok((bodies, from));
        }
    }
    Err(structure.groups[error.group].frame.links.clone())
}

/// The bodies in the first position.
fn first(linkage: &Linkage) -> Result<Vec<Body<f64>>, Box<PositionError>> {
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Place, &mut position).map_err(Box::new)?;
    position.bodies.truncate(linkage.mechanism.links.len());
    Ok(position.bodies)
}
