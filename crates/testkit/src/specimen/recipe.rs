//! The parameters of a specimen, and the search for one.

use std::f64::consts::TAU;

use assur_group::{GroupPlugin, Order, groups};
use assur_kinematics::Linkage;
use assur_mechanism::{Driver, GROUND, Input, InputPair, Mechanism, Range, Sense};

use super::draft::{Draft, Drive};

/// The parameters of a specimen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recipe {
    /// Number of groups, 1 to 5.
    pub groups: usize,
    /// The only registered kind of group to use, by name, or any kinds of two links.
    pub only: Option<&'static str>,
    /// Whether there are loads, a motion and a balancing load that does not act on the input.
    pub loads: bool,
}

/// A mechanism with the poses in which it was constructed.
#[derive(Debug, Clone, PartialEq)]
pub struct Specimen {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Origin and angle of each link in the first position, the ground first.
    pub poses: Vec<[f64; 3]>,
    /// Names of the kinds of its groups, in the order of construction.
    pub kinds: Vec<&'static str>,
    /// Smallest dimensionless determinant of a group over the positions.
    pub health: f64,
}

/// Positions with a smaller determinant are not used.
pub(super) const LEAST_HEALTH: f64 = 0.05;

/// Greatest number of constructions for one seed.
pub(super) const TRIES: u64 = 400;

/// Number of positions of a range, and of a cycle.
const POSITIONS: [usize; 2] = [5, 12];

/// Names of the registered kinds of groups that have a pattern, for [`Recipe::only`]; empty if the registry is faulty.
pub fn kinds() -> Vec<&'static str> {
    let all = groups().unwrap_or_default();
    all.iter().filter(|kind| has_links(kind)).map(|kind| kind.name).collect()
}

impl Recipe {
    /// Any kinds and all loads.
    pub fn of(groups: usize) -> Self {
        Self { groups, only: None, loads: true }
    }

    /// Constructs a mechanism, the same for the same seed and the same registered kinds; `None` if none of many
    /// constructions stayed away from singular positions, or if there is no such kind.
    pub fn specimen(&self, seed: u64) -> Option<Specimen> {
        let mut kinds = groups().ok()?;
        kinds.retain(|kind| {
            self.only.map_or_else(|| is_dyad(kind), |only| only == kind.name && has_links(kind))
        });
        self.of_kinds(seed, &kinds)
    }

    /// The same with groups of all kinds that have a pattern; about one in two is a dyad.
    pub fn mixed(&self, seed: u64) -> Option<Specimen> {
        self.of_kinds(seed, &Self::mixed_kinds()?)
    }

    /// All kinds that have a pattern; about one in two is a dyad.
    pub(super) fn mixed_kinds() -> Option<Vec<&'static GroupPlugin>> {
        let mut kinds = groups().ok()?;
        kinds.retain(|kind| has_links(kind));
        let dyads: Vec<_> = kinds.iter().copied().filter(|kind| is_dyad(kind)).collect();
        let others = kinds.len() - dyads.len();
        for _ in 1..others / dyads.len().max(1) {
            kinds.extend(&dyads);
        }
        Some(kinds)
    }

    fn of_kinds(&self, seed: u64, kinds: &[&'static GroupPlugin]) -> Option<Specimen> {
        let attempt = |attempt| self.attempt(seed.wrapping_mul(TRIES).wrapping_add(attempt), kinds);
        (0..TRIES).find_map(attempt)
    }

    /// Adds a group of one of these kinds; its name.
    pub(super) fn group(draft: &mut Draft, registered: &[&'static GroupPlugin]) -> Option<&'static str> {
        let kind = registered.get(draft.rng.below(registered.len()))?;
        let pattern = kind.pattern?;
        let bodies = earlier_bodies(draft, pattern.outer.len());
        draft.group(&pattern, &bodies)?;
        Some(kind.name)
    }

    fn attempt(&self, seed: u64, registered: &[&'static GroupPlugin]) -> Option<Specimen> {
        let mut draft = Draft::new(seed);
        let sliding = draft.rng.chance(0.25);
        let drive = draft.driven(GROUND, sliding);
        let mut kinds = Vec::new();
        for _ in 0..self.groups {
            kinds.push(Self::group(&mut draft, registered)?);
        }
        let poses = draft.poses.iter().map(|pose| [pose.x, pose.y, pose.angle]).collect();
        let mechanism = mechanism_of(&mut draft, &[drive]);
        let (mut mechanism, health) = with_range(&mut draft, mechanism)?;
        if self.loads {
            super::loads::add(&mut draft, &mut mechanism);
        }
        Some(Specimen { mechanism, poses, kinds, health })
    }
}

/// Whether a kind has a pattern with links that it places; where all links are driven there is nothing to draw.
fn has_links(kind: &GroupPlugin) -> bool {
    kind.pattern.is_some_and(|pattern| pattern.links > 0)
}

fn is_dyad(kind: &GroupPlugin) -> bool {
    kind.pattern.is_some_and(|pattern| pattern.links == 2)
}

/// Draws this number of earlier bodies, the ground and the newest ones more often; neighbors in the list differ.
fn earlier_bodies(draft: &mut Draft, wanted: usize) -> Vec<usize> {
    let count = draft.links.len();
    let mut bodies: Vec<usize> = Vec::with_capacity(wanted);
    while bodies.len() < wanted {
        let body = match draft.rng.below(4) {
            0 => GROUND,
            1 => count - 1,
            _ => draft.rng.below(count),
        };
        if bodies.last() != Some(&body) {
            bodies.push(body);
        }
    }
    bodies
}

/// The parts of the mechanism in the order in which a reader of the scene meets them.
pub(super) fn mechanism_of(draft: &mut Draft, drives: &[Drive]) -> Mechanism {
    let mut order: Vec<usize> = (0..draft.points.len()).collect();
    draft.points.iter_mut().for_each(|point| point.places.sort_by_key(|place| place.link));
    order.sort_by_key(|&id| (draft.points[id].places[0].link, id));
    let points: Vec<_> = order.iter().map(|&id| draft.points[id].clone()).collect();
    draft.points.clone_from(&points);
    let driver = |drive: &Drive| {
        let pair = match drive.pair {
            InputPair::Pin(old) => InputPair::Pin(order.iter().position(|&id| id == old).unwrap_or(0)),
            slide @ InputPair::Slide(_) => slide,
        };
        let label = draft.links[drive.link].name.clone();
        Driver { link: drive.link, on: drive.on, pair, label, law: None }
    };
    let drivers: Vec<_> = drives.iter().map(driver).collect();
    let moving = |point: &&usize| points[**point].places[0].link != GROUND;
    let assembly = (0..points.len()).collect::<Vec<_>>();
    let assembly = assembly.iter().filter(moving).map(|&id| (id, draft.world_of(id))).collect();
    let from = drives.first().map_or(0.0, |drive| drive.from);
    let (positions, range) = (POSITIONS[0], Range::To(from));
    let input = Input { drivers, is_list: false, name: None, from, positions, range, direction: Sense::Ccw };
    Mechanism {
        title: "Specimen".into(),
        links: draft.links.clone(),
        points,
        slides: draft.slides.clone(),
        input,
        assembly,
        ..Mechanism::default()
    }
}

/// A whole cycle if the mechanism is nowhere near a singular position, otherwise such a range around the start.
fn with_range(draft: &mut Draft, mut mechanism: Mechanism) -> Option<(Mechanism, f64)> {
    let unit = if mechanism.input.is_angle() { 1.0 } else { draft.size };
    let way = draft.rng.signed(0.2, 1.2) * unit;
    mechanism.input.range = Range::To(mechanism.input.from + way);
    let linkage = Linkage::compile(mechanism.clone()).ok()?;
    let range = linkage.range?;
    let input = &mut mechanism.input;
    if range.full && draft.rng.chance(0.9) {
        input.positions = POSITIONS[1];
        input.range = Range::Cycle(if draft.rng.chance(0.2) { 2.0 * TAU } else { TAU });
        input.direction = if draft.rng.chance(0.5) { Sense::Cw } else { Sense::Ccw };
        let cycle = health(&linkage, input, 40);
        if cycle > LEAST_HEALTH {
            return Some((mechanism, cycle));
        }
    }
    let input = &mut mechanism.input;
    (input.positions, input.direction) = (POSITIONS[0], Sense::Ccw);
    for part in [1.0, 0.4, 0.15] {
        input.range = Range::To(input.from + part * way);
        let least = health(&linkage, input, 10);
        if least > LEAST_HEALTH {
            return Some((mechanism, least));
        }
    }
    None
}

/// Smallest determinant over `finer` times as many positions, which shows singular positions between the others
/// (guides that become parallel would let links run to infinity); 0 if a position can't be solved.
pub(super) fn health(linkage: &Linkage, input: &Input, finer: usize) -> f64 {
    let mut position = linkage.position();
    let input = Input { positions: finer * input.positions, ..input.clone() };
    let mut least = f64::INFINITY;
    for index in 0..input.positions {
        if linkage.solve(input.coordinate(index), Order::Place, &mut position).is_err() {
            return 0.0;
        }
        least = position.health.iter().fold(least, |a, b| a.min(b.abs()));
    }
    least
}
