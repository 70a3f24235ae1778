//! The assembly of the first position.

use assur_group::Body;
use assur_mechanism::Mechanism;
use assur_structure::Structure;

use crate::read::motion_of;
use crate::{Chain, ChainError};

/// The way of each group, and the placed links.
type First = (Vec<u8>, Vec<Body<f64>>);

/// The way of each group in the first position, the one closest to the places of `[assembly]`; and the placed links.
pub(crate) fn first_ways(
    mechanism: &Mechanism,
    structure: &Structure,
    chain: &Chain<f64>,
) -> Result<First, (Vec<u8>, ChainError)> {
    let mut bodies = guessed_bodies(mechanism, chain);
    chain.set_input(mechanism.input.from, &mut bodies);
    let mut ways = vec![0_u8; chain.groups.len()];
    for (i, kernel) in chain.groups.iter().enumerate().filter(|(i, _)| chain.is_needed(*i)) {
        let links = &structure.groups[i].frame.links;
        let mut best: Option<(f64, u8, Vec<Body<f64>>)> = None;
        let mut failure = None;
        for way in 0..u8::try_from(kernel.ways()).unwrap_or(u8::MAX) {
            let mut tried = bodies.clone();
            match kernel.place(&mut tried, usize::from(way)) {
                Ok(_) => {
                    let miss = miss(mechanism, links, &tried);
                    if best.as_ref().is_none_or(|(least, ..)| miss < *least) {
                        best = Some((miss, way, tried));
                    }
                }
                Err(source) => failure = Some(ChainError { group: i, source }),
            }
        }
        match (best, failure) {
            (Some((_, way, placed)), _) => (ways[i], bodies) = (way, placed),
            (None, Some(failure)) => return Err((ways, failure)),
            (None, None) => {}
        }
    }
    Ok((ways, bodies))
}

/// Starting guess for kinds that iterate: each link at the mean of its wanted points.
fn guessed_bodies(mechanism: &Mechanism, chain: &Chain<f64>) -> Vec<Body<f64>> {
    let mut bodies = chain.bodies();
    for (link, body) in bodies.iter_mut().enumerate().skip(1) {
        let known: Vec<_> = mechanism
            .assembly
            .iter()
            .filter_map(|(point, place)| Some((mechanism.place_in(*point, link)?, *place)))
            .collect();
        match known[..] {
            [] => {}
            [(own, place)] => (body.x, body.y) = (place[0] - own[0], place[1] - own[1]),
            [(own, place), .., (own2, place2)] => {
                let wanted = (place2[1] - place[1]).atan2(place2[0] - place[0]);
                let angle = wanted - (own2[1] - own[1]).atan2(own2[0] - own[0]);
                (body.s, body.c) = angle.sin_cos();
                let arm = body.arm(own);
                body.hang_place(arm, place);
            }
        }
    }
    bodies
}

/// Sum of squares of the distances of a group's points from their wanted places.
fn miss(mechanism: &Mechanism, links: &[usize], bodies: &[Body<f64>]) -> f64 {
    let mut sum = 0.0;
    for (point, wanted) in &mechanism.assembly {
        let place = mechanism.points[*point].places.iter().find(|place| links.contains(&place.link));
        if let Some(place) = place {
            let found = motion_of(&bodies[place.link], place.at).pf0;
            sum += (found[0] - wanted[0]).powi(2) + (found[1] - wanted[1]).powi(2);
        }
    }
    sum
}
