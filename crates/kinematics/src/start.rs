//! Starting poses of a group whose solution is iterated, at the first position.

use assur_group::plane::{direction, minus};
use assur_group::{Body, GroupFrame, PairGeometry, health_generally};
use assur_mechanism::{GROUND, Mechanism, Point};
use assur_number::elementary;
use assur_structure::Structure;

use crate::{Chain, CompileError};

/// A start whose dimensionless determinant is below this is changed: the first step of the iteration would lead
/// anywhere.
const LEAST_DETERMINANT: f64 = 1e-6;

/// Changes of a singular start that are tried.
const MOST_TURNS: u32 = 6;

/// Angle by which the first change turns the first link, rad: large against `LEAST_DETERMINANT`, small against the
/// angles between two assemblies.
const TURN: f64 = 0.02;

/// Certainty of a link of which one point is known, and no direction.
const OPEN: u8 = 2;

/// Between two guesses of an open direction, rad: the golden angle, so that few guesses are spread evenly.
const GUESS: f64 = 2.399_963_229_728_653;

/// Sets the links of a group to a starting pose: from the points whose places are known, because `[assembly]` gives
/// them or a placed link (the ground, the input link, a link of an earlier group) has them, and from the slides.
///
/// `placed` says of each link whether it is placed. A start that is singular is changed a little where that helps. Returns
/// whether the direction of a link remained open; `guess` numbers the guesses of such directions.
pub(crate) fn start(
    mechanism: &Mechanism,
    frame: &GroupFrame,
    (placed, guess): (&[bool], u32),
    bodies: &mut [Body<f64>],
) -> bool {
    let mut known = Known::new(mechanism, frame, placed, bodies);
    let mut is_open = false;
    let mut left = frame.links.clone();
    // The link about which most is known first: its points are then known to its neighbors. Of equals the first.
    while let Some(next) = (0..left.len()).rev().max_by_key(|&next| known.certainty(left[next], bodies)) {
        let link = left.remove(next);
        if matches!(known.certainty(link, bodies), OPEN | 0) {
            is_open = true;
            [bodies[link].c, bodies[link].s] = direction(GUESS * f64::from(guess) * (left.len() + 1) as f64);
        }
        known.put(link, bodies);
    }
    leave_singular(frame, bodies);
    is_open
}

/// Returns an error for a group that is solved, can't list its assemblies, and has no place in `[assembly]`.
pub(crate) fn refuse_without_start(
    mechanism: &Mechanism,
    structure: &Structure,
    chain: &Chain<f64>,
) -> Result<(), CompileError> {
    for (index, group) in structure.groups.iter().enumerate() {
        let is_free = !group.plugin.iterates || chain.groups[index].lists_modes() || !chain.needed[index];
        let is_known = |link: usize| {
            let mut before = structure.groups[..index].iter();
            link == GROUND
                || mechanism.input.places(link)
                || before.any(|one| one.frame.column(link).is_some())
        };
        // A point that joins the group to what is known says nothing new.
        let is_own = |point: &&Point| {
            let mut places = point.places.iter().map(|place| place.link);
            places.clone().any(|link| group.frame.column(link).is_some()) && !places.any(is_known)
        };
        if is_free || mechanism.assembly.iter().any(|(point, _)| is_own(&&mechanism.points[*point])) {
            continue;
        }
        let own: Vec<&Point> = mechanism.points.iter().filter(is_own).collect();
        let pins: Vec<&Point> = own.iter().copied().filter(|point| point.is_pin()).collect();
        let points = if pins.is_empty() { own } else { pins };
        let points = points.iter().map(|point| point.name.to_string()).collect();
        let group = Box::new(structure.group_name(mechanism, index));
        return Err(CompileError::NoStart { group, points });
    }
    Ok(())
}

/// A point of a link: in the frame of the link and in that of the ground, m.
type Located = ([f64; 2], [f64; 2]);

/// What is known about the places of points.
struct Known<'a> {
    mechanism: &'a Mechanism,
    frame: &'a GroupFrame,
    /// By link: whether its pose is known or guessed.
    placed: Vec<bool>,
    /// By point: its place in the frame of the ground, m.
    places: Vec<Option<[f64; 2]>>,
}

impl<'a> Known<'a> {
    fn new(mechanism: &'a Mechanism, frame: &'a GroupFrame, placed: &[bool], bodies: &[Body<f64>]) -> Self {
        let mut places = vec![None; mechanism.points.len()];
        for &(point, place) in &mechanism.assembly {
            places[point] = Some(place);
        }
        for (point, place) in mechanism.points.iter().zip(&mut places) {
            if let Some(of) = point.places.iter().find(|of| placed[of.link]) {
                *place = Some(bodies[of.link].point(of.at));
            }
        }
        Self { mechanism, frame, placed: placed.to_vec(), places }
    }

    /// The known points of a link.
    fn points(&self, link: usize) -> impl Iterator<Item = Located> {
        let all = self.mechanism.points.iter().zip(&self.places);
        all.filter_map(move |(point, place)| {
            let of = point.places.iter().find(|of| of.link == link)?;
            place.map(|place| (of.at, place))
        })
    }

    /// Two known points of a link: the first, and the one farthest from it if it is elsewhere.
    fn two(&self, link: usize) -> Option<(Located, Option<Located>)> {
        let first = self.points(link).next()?;
        let distance = |own: [f64; 2]| elementary::hypot(own[0] - first.0[0], own[1] - first.0[1]);
        let far = self.points(link).max_by(|a, b| distance(a.0).total_cmp(&distance(b.0)));
        Some((first, far.filter(|far| distance(far.0) > 0.0)))
    }

    /// Direction of a link that a slide on a placed link gives, with a point of it and about where that lies.
    fn guided(&self, link: usize, bodies: &[Body<f64>]) -> Option<([f64; 2], [f64; 2], [f64; 2])> {
        self.frame.pairs().filter(|pair| pair.joins(link)).find_map(|pair| {
            let PairGeometry::Slide { point, through, angle, tilt } = pair.geometry else { return None };
            let (other, turn, own, place) = if pair.a == link {
                (pair.b, angle + tilt, point, through)
            } else {
                (pair.a, -(angle + tilt), through, point)
            };
            let other = self.placed[other].then(|| &bodies[other])?;
            Some((other.turned(direction(turn)), own, other.point(place)))
        })
    }

    /// How much is known about a link.
    fn certainty(&self, link: usize, bodies: &[Body<f64>]) -> u8 {
        match (self.two(link), self.guided(link, bodies)) {
            (Some((_, Some(_))), _) => 4,
            (Some((_, None)), Some(_)) => 3,
            (Some((_, None)), None) => OPEN,
            (None, Some(_)) => 1,
            (None, None) => 0,
        }
    }

    /// Places a link; its points are then known.
    fn put(&mut self, link: usize, bodies: &mut [Body<f64>]) {
        match (self.two(link), self.guided(link, bodies)) {
            (Some(((own, place), Some((own2, place2)))), _) => {
                let ([dx, dy], [ox, oy]) = (minus(place2, place), minus(own2, own));
                let (s, c) = elementary::sin_cos(elementary::atan2(dy, dx) - elementary::atan2(oy, ox));
                bodies[link].put([c, s], own, place);
            }
            (Some(((own, place), None)), Some((along, ..))) | (None, Some((along, own, place))) => {
                bodies[link].put(along, own, place);
            }
            (Some(((own, place), None)), None) => {
                bodies[link].put([bodies[link].c, bodies[link].s], own, place);
            }
            (None, None) => {}
        }
        self.placed[link] = true;
        for (point, place) in self.mechanism.points.iter().zip(&mut self.places) {
            if let Some(of) = point.places.iter().find(|of| of.link == link) {
                place.get_or_insert_with(|| bodies[link].point(of.at));
            }
        }
    }
}

/// Turns the links of a singular start by small, different angles until it is regular. If it is not after all turns,
/// the start stays as it was.
fn leave_singular(frame: &GroupFrame, bodies: &mut [Body<f64>]) {
    let before: Vec<_> = frame.links.iter().map(|&link| bodies[link]).collect();
    for turn in 1..=MOST_TURNS {
        if health_generally(frame, bodies) > LEAST_DETERMINANT {
            return;
        }
        for (i, (&link, before)) in frame.links.iter().zip(&before).enumerate() {
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let turned = before.turned(direction(side * TURN * f64::from(turn) / (i + 1) as f64));
            [bodies[link].c, bodies[link].s] = turned;
        }
    }
    if health_generally(frame, bodies) <= LEAST_DETERMINANT {
        frame.links.iter().zip(before).for_each(|(&link, before)| bodies[link] = before);
    }
}
