//! The assembly of the first position.

use assur_group::plane::{dot, minus, vector};
use assur_group::{AssurGroup, Body, GroupError, GroupFrame, Mode, Number, certify_generally};
use assur_mechanism::{GROUND, Mechanism};
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::{Chain, ChainError, start::start, wide::Extended};

/// Distances that differ by less than this (in parts of the scale) count as equal. Near a change point the modes
/// differ by less than the resolution of 16 digits, but by more than this.
const SAME: f64 = 1e-14;

/// Where the distances of two modes differ by more than this (in parts of the scale), 16 digits tell which is closer, ...
const CLEARLY: f64 = 1e-6;

/// ... unless the determinant of a group up to there is below this: its place has only half of the digits or less.
const WELL_PLACED: f64 = 1e-3;

/// Guesses of directions that the known places of a group leave open.
const GUESSES: u32 = 48;

/// The mode of each group, and the placed links.
pub(crate) type First = (Vec<u8>, Vec<Body<f64>>);

/// Finds the mode of each group at the coordinate `from` that is closest to the places in `[assembly]`, and places the
/// links. Where a group can't be placed: the modes of the groups before it, and the error.
pub(crate) fn first_ways(
    mechanism: &Mechanism,
    structure: &Structure,
    (chain, extended): (&Chain<f64>, &Extended<'_>),
    from: f64,
) -> Result<First, (Vec<u8>, ChainError)> {
    let wanted = wanted(mechanism, structure);
    let mut bodies = chain.bodies();
    let mut placed = vec![false; chain.bodies().len()];
    placed[GROUND] = true;
    chain.inputs.iter().for_each(|input| placed[input.body()] = true);
    chain.set_input(from, &mut bodies);
    let mut exact = Exact { chain, extended, from, bodies: Vec::new(), groups: 0 };
    let mut least_health = f64::INFINITY;
    let mut ways = vec![0_u8; chain.groups.len()];
    for (group, kernel) in chain.groups.iter().enumerate().filter(|(group, _)| chain.needed[*group]) {
        let iterates = structure.groups[group].plugin.iterates;
        if iterates
            && let Some(modes) =
                kernel.modes(&bodies).map_err(|source| (ways.clone(), ChainError { group, source }))?
        {
            ways[group] = take_nearest(&modes, kernel.frame(), &wanted, &mut bodies);
            kernel.frame().links.iter().for_each(|&link| placed[link] = true);
            continue;
        }
        if iterates {
            best_start(mechanism, kernel.as_ref(), (&placed, &wanted), &mut bodies);
        }
        let (mut candidates, health, failure) = candidates(&wanted, kernel.as_ref(), iterates, &mut bodies);
        least_health = least_health.min(health);
        if let (true, Some(source)) = (candidates.is_empty(), failure) {
            return Err((ways, ChainError { group, source }));
        }
        let is_wanted = kernel.frame().links.iter().any(|&link| !wanted[link].is_empty());
        let chosen = closest(&candidates, SAME * structure.scale);
        let limit = CLEARLY * structure.scale;
        let least = candidates.iter().map(|(_, miss)| *miss).fold(f64::INFINITY, f64::min);
        let rivals = candidates.iter().any(|(way, miss)| *way != chosen && *miss < least + limit);
        if is_wanted && (rivals || candidates.len() > 1 && least_health < WELL_PLACED) {
            exact.measure(group, &mut candidates, &wanted, (&ways, &bodies));
        }
        let needed = structure.ways.iter().filter(|one| one.0 == group && health < WELL_PLACED);
        let needed = needed.map(|one| one.1).find(|way| candidates.iter().any(|one| one.0 == *way));
        ways[group] = needed.unwrap_or_else(|| closest(&candidates, SAME * structure.scale));
        // The group was already placed from the same starting pose.
        let _ = kernel.place(&mut bodies, usize::from(ways[group]));
        if iterates && certify_generally(kernel.frame(), &bodies).is_none() {
            let health = kernel.health(&bodies);
            return Err((ways, ChainError { group, source: GroupError::SingularStart { health } }));
        }
        for &link in &kernel.frame().links {
            placed[link] = true;
        }
    }
    Ok((ways, bodies))
}

/// The modes in which a group can be placed, each with how far it is from the wanted places; the least determinant among them, and why the
/// last of the other modes fails.
fn candidates(
    wanted: &[Vec<Wanted>],
    kernel: &dyn AssurGroup<f64>,
    iterates: bool,
    bodies: &mut [Body<f64>],
) -> (Vec<(u8, f64)>, f64, Option<GroupError>) {
    let (mut found, mut least_health, mut failure) = (Vec::new(), f64::INFINITY, None);
    for way in 0..u8::try_from(kernel.ways()).unwrap_or(u8::MAX) {
        match miss(wanted, kernel, way, bodies) {
            Ok((miss, health)) => {
                found.push((way, miss));
                least_health = least_health.min(health);
            }
            // Whether the position is singular is not known before it is found.
            Err(GroupError::Singular { health }) if iterates => {
                failure = Some(GroupError::SingularStart { health });
            }
            Err(source) => failure = Some(source),
        }
    }
    (found, least_health, failure)
}

/// Sets the links of a group that iterates to a starting pose; where the known places leave directions open, to that of several
/// guesses whose assembly comes closest to the wanted places.
fn best_start(
    mechanism: &Mechanism,
    kernel: &dyn AssurGroup<f64>,
    (placed, wanted): (&[bool], &[Vec<Wanted>]),
    bodies: &mut [Body<f64>],
) {
    let is_open = start(mechanism, kernel.frame(), (placed, 0), bodies);
    let mut best = (f64::INFINITY, 0);
    for guess in (0..GUESSES).filter(|_| is_open) {
        start(mechanism, kernel.frame(), (placed, guess), bodies);
        let found =
            (0..kernel.ways()).filter_map(|way| miss(wanted, kernel, way.try_into().ok()?, bodies).ok());
        let off = found.map(|(off, _)| off).fold(f64::INFINITY, f64::min);
        if off < best.0 - SAME * kernel.frame().scale {
            best = (off, guess);
        }
    }
    start(mechanism, kernel.frame(), (placed, best.1), bodies);
}

/// Places the links of a group in the mode that is closest to the wanted places, of equal ones in the first; returns its mode.
fn take_nearest(
    modes: &[Mode<f64>],
    frame: &GroupFrame,
    wanted: &[Vec<Wanted>],
    bodies: &mut [Body<f64>],
) -> u8 {
    let mut best: Option<(f64, &Mode<f64>)> = None;
    for mode in modes {
        frame.links.iter().zip(&mode.bodies).for_each(|(&link, body)| bodies[link] = *body);
        let off = sum_of_squares(frame, wanted, bodies);
        if best.is_none_or(|(least, _)| off < least) {
            best = Some((off, mode));
        }
    }
    let Some((_, mode)) = best else { return 0 };
    frame.links.iter().zip(&mode.bodies).for_each(|(&link, body)| bodies[link] = *body);
    u8::try_from(mode.way).unwrap_or(0)
}

/// Sum of the squared distances between the points of a group and their wanted places, m².
fn sum_of_squares<T: Number>(frame: &GroupFrame, wanted: &[Vec<Wanted>], bodies: &[Body<T>]) -> T {
    let mut sum = T::ZERO;
    let mut seen = Vec::new();
    for (link, one) in frame.links.iter().flat_map(|&link| wanted[link].iter().map(move |one| (link, one))) {
        if !seen.contains(&one.point) {
            seen.push(one.point);
            let off = minus(bodies[link].point(vector(one.own)), vector(one.place));
            sum += dot(off, off);
        }
    }
    sum
}

/// The mode with the least distance; of equal ones the first.
fn closest(candidates: &[(u8, f64)], same: f64) -> u8 {
    let closer = |best: (u8, f64), other: &(u8, f64)| if other.1 < best.1 - same { *other } else { best };
    candidates.iter().skip(1).fold(candidates.first().copied().unwrap_or_default(), closer).0
}

/// The placed links in 32 digits, as far as they were asked for.
struct Exact<'a> {
    chain: &'a Chain<f64>,
    extended: &'a Extended<'a>,
    from: f64,
    bodies: Vec<Body<Dd>>,
    /// The groups before this one are placed.
    groups: usize,
}

impl Exact<'_> {
    /// Replaces the distances of a group by those in 32 digits, where there are any; `placed`: the modes of the groups
    /// before it, and the links in 16 digits.
    fn measure(
        &mut self,
        group: usize,
        candidates: &mut [(u8, f64)],
        wanted: &[Vec<Wanted>],
        placed: (&[u8], &[Body<f64>]),
    ) {
        let Some(extended) = self.extended.chain() else { return };
        if self.bodies.is_empty() {
            self.bodies = extended.bodies();
            extended.set_input(Dd::from_f64(self.from), &mut self.bodies);
        }
        for earlier in (self.groups..group).filter(|earlier| self.chain.needed[*earlier]) {
            let kernel = &extended.groups[earlier];
            let links = &kernel.frame().links;
            copy(links, placed.1, &mut self.bodies);
            if kernel.place(&mut self.bodies, usize::from(placed.0[earlier])).is_err() {
                // The gap is only rounding: the pose in 16 digits is kept.
                copy(links, placed.1, &mut self.bodies);
            }
        }
        self.groups = group;
        let kernel = extended.groups[group].as_ref();
        copy(&kernel.frame().links, placed.1, &mut self.bodies);
        for (way, found) in candidates {
            if let Ok((exact, _)) = miss(wanted, kernel, *way, &mut self.bodies) {
                *found = exact;
            }
        }
    }
}

/// Sets links in 32 digits to their poses in 16 digits.
fn copy(links: &[usize], from: &[Body<f64>], to: &mut [Body<Dd>]) {
    for &link in links {
        to[link] = from[link].map(Dd::from_f64);
    }
}

/// The place that `[assembly]` gives for a point of a link.
struct Wanted {
    /// Index of the point.
    point: usize,
    /// In the frame of the link, m.
    own: [f64; 2],
    /// In the frame of the ground, m.
    place: [f64; 2],
}

/// The wanted places by link: those of the scene, then those that passive parts need.
fn wanted(mechanism: &Mechanism, structure: &Structure) -> Vec<Vec<Wanted>> {
    let mut wanted: Vec<Vec<Wanted>> = mechanism.links.iter().map(|_| Vec::new()).collect();
    for &(point, place) in mechanism.assembly.iter().chain(&structure.placed) {
        for of in &mechanism.points[point].places {
            wanted[of.link].push(Wanted { point, own: of.at, place });
        }
    }
    wanted
}

/// Root of the sum of the squared distances between a group's points in one mode and their wanted places, m, and the
/// size of its determinant. Leaves the links of the group unchanged.
fn miss<T: Number>(
    wanted: &[Vec<Wanted>],
    kernel: &dyn AssurGroup<T>,
    way: u8,
    bodies: &mut [Body<T>],
) -> Result<(f64, f64), GroupError> {
    let links = &kernel.frame().links;
    let before: Vec<_> = links.iter().map(|&link| bodies[link]).collect();
    let placed = kernel.place(bodies, usize::from(way));
    let sum = sum_of_squares(kernel.frame(), wanted, bodies);
    links.iter().zip(before).for_each(|(&link, before)| bodies[link] = before);
    placed.map(|health| (sum.sqrt().to_f64(), health.abs().to_f64()))
}
