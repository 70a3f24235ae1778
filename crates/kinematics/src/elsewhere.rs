//! Where a mechanism could be assembled that can't be in its first position.

use std::f64::consts::PI;

use assur_mechanism::Mechanism;
use assur_number::search::bisect;
use assur_structure::Structure;

use crate::{Chain, follow::coordinate_unit};

/// Coordinates that are tried to either side of the first position.
const TRIED: u32 = 720;

/// How far a sliding input is moved, in sizes of the mechanism.
const FAR: f64 = 4.0;

/// The values of the coordinate nearest to that of the first position with which all groups have an assembly, from the least to the
/// greatest; `None` where none is found, where a group iterates, which has no pose to begin with, and over time.
pub(crate) fn elsewhere(
    mechanism: &Mechanism,
    structure: &Structure,
    chain: &Chain<f64>,
) -> Option<[f64; 2]> {
    if mechanism.input.kind().is_time() || structure.groups.iter().any(|group| group.plugin.iterates) {
        return None;
    }
    let mut bodies = chain.bodies();
    let mut is_assembled = |coordinate: f64| {
        chain.set_input(coordinate, &mut bodies);
        let mut groups = chain.groups.iter().zip(&chain.needed).filter(|(_, needed)| **needed);
        groups.all(|(kernel, _)| (0..kernel.ways()).any(|way| kernel.place(&mut bodies, way).is_ok()))
    };
    let way = if mechanism.input.is_angle() { PI } else { FAR * coordinate_unit(mechanism, structure) };
    let from = mechanism.input.from;
    let at = |number: u32, side: f64| from + side * way * f64::from(number) / f64::from(TRIED);
    let tried = (1..=TRIED).flat_map(|number| [(number, 1.0), (number, -1.0)]);
    let (first, side) = tried.into_iter().find(|(number, side)| is_assembled(at(*number, *side)))?;
    let last = (first..TRIED).take_while(|number| is_assembled(at(*number, side))).last()?;
    // The ends lie between a coordinate with an assembly and one without.
    let mut end =
        |inside: u32, outside: u32| bisect(at(inside, side), at(outside, side), 0.0, &mut is_assembled)[0];
    let [near, far] = [end(first, first - 1), end(last, last + 1)];
    Some([near.min(far), near.max(far)])
}
