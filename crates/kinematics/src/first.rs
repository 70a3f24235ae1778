//! The assembly of the first position.

use assur_group::plane::{dot, minus, vector};
use assur_group::{AssurGroup, Body, GroupError, Number};
use assur_mechanism::{GROUND, Mechanism};
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::start::start;
use crate::{Chain, ChainError};

/// Distances that differ by less than this (in parts of the scale) count as equal. Near a change point the ways
/// differ by less than the resolution of 16 digits, but by more than this.
const SAME: f64 = 1e-14;

/// The way of each group, and the placed links.
pub(crate) type First = (Vec<u8>, Vec<Body<f64>>);

/// Finds the way of each group at the coordinate `from` that is closest to the places in `[assembly]`, and places the
/// links. Where a group can't be placed: the ways of the groups before it, and the error.
pub(crate) fn first_ways(
    mechanism: &Mechanism,
    structure: &Structure,
    (chain, extended): (&Chain<f64>, Option<&Chain<Dd>>),
    from: f64,
) -> Result<First, (Vec<u8>, ChainError)> {
    let wanted = wanted(mechanism);
    let mut bodies = chain.bodies();
    let mut placed = vec![false; mechanism.links.len()];
    (placed[GROUND], placed[chain.input.link()]) = (true, true);
    chain.set_input(from, &mut bodies);
    let mut wide: Vec<_> = bodies.iter().map(|body| body.map(Dd::from_f64)).collect();
    if let Some(extended) = extended {
        extended.set_input(Dd::from_f64(from), &mut wide);
    }
    let mut ways = vec![0_u8; chain.groups.len()];
    for (group, kernel) in chain.groups.iter().enumerate().filter(|(group, _)| chain.is_needed(*group)) {
        let extended = extended.map(|chain| chain.groups[group].as_ref());
        let links = &kernel.frame().links;
        let iterates = structure.groups[group].plugin.iterates;
        if iterates {
            start(mechanism, kernel.frame(), &placed, &mut bodies);
            copy(links, &bodies, &mut wide);
        }
        let mut best: Option<(f64, u8)> = None;
        let mut failure = None;
        for way in 0..u8::try_from(kernel.ways()).unwrap_or(u8::MAX) {
            match miss(&wanted, kernel.as_ref(), way, &mut bodies) {
                Ok(found) => {
                    // In 32 digits where possible: close to a change point the ways differ by little.
                    let exact = extended.and_then(|kernel| miss(&wanted, kernel, way, &mut wide).ok());
                    let found = exact.unwrap_or(found);
                    if best.is_none_or(|(least, _)| found < least - SAME * structure.scale) {
                        best = Some((found, way));
                    }
                }
                // Whether the position is singular is not known before it is found.
                Err(GroupError::Singular { health }) if iterates => {
                    failure = Some(ChainError { group, source: GroupError::SingularStart { health } });
                }
                Err(source) => failure = Some(ChainError { group, source }),
            }
        }
        match (best, failure) {
            (Some((_, way)), _) => ways[group] = way,
            (None, Some(failure)) => return Err((ways, failure)),
            (None, None) => {}
        }
        // The group was already placed from the same starting pose.
        let _ = kernel.place(&mut bodies, usize::from(ways[group]));
        if extended.is_none_or(|kernel| kernel.place(&mut wide, usize::from(ways[group])).is_err()) {
            // The gap is only rounding: the pose in 16 digits is kept.
            copy(links, &bodies, &mut wide);
        }
        for &link in links {
            placed[link] = true;
        }
    }
    Ok((ways, bodies))
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

/// The wanted places by link.
fn wanted(mechanism: &Mechanism) -> Vec<Vec<Wanted>> {
    let mut wanted: Vec<Vec<Wanted>> = mechanism.links.iter().map(|_| Vec::new()).collect();
    for &(point, place) in &mechanism.assembly {
        for of in &mechanism.points[point].places {
            wanted[of.link].push(Wanted { point, own: of.at, place });
        }
    }
    wanted
}

/// Root of the sum of the squared distances between a group's points in one way and their wanted places, m. Leaves
/// the links of the group unchanged.
fn miss<T: Number>(
    wanted: &[Vec<Wanted>],
    kernel: &dyn AssurGroup<T>,
    way: u8,
    bodies: &mut [Body<T>],
) -> Result<f64, GroupError> {
    let links = &kernel.frame().links;
    let before: Vec<_> = links.iter().map(|&link| bodies[link]).collect();
    let placed = kernel.place(bodies, usize::from(way));
    let mut sum = T::ZERO;
    let mut seen = Vec::new();
    for (link, one) in links.iter().flat_map(|&link| wanted[link].iter().map(move |one| (link, one))) {
        if !seen.contains(&one.point) {
            seen.push(one.point);
            let off = minus(bodies[link].point(vector(one.own)), vector(one.place));
            sum += dot(off, off);
        }
    }
    links.iter().zip(before).for_each(|(&link, before)| bodies[link] = before);
    placed.map(|_| sum.sqrt().to_f64())
}
