//! The assembly of the first position.

use assur_group::plane::{dot, minus, vector};
use assur_group::{Body, Number};
use assur_mechanism::Mechanism;
use assur_number::{Dd, Real};
use assur_structure::Structure;

use crate::wide::Wide;
use crate::{Chain, ChainError};

/// Places nearer than this (in parts of the scale) are one: near a change point the wanted places decide by less than
/// what 16 digits see, but not by less than they are written with.
const SAME: f64 = 1e-14;

/// The way of each group, and the placed links.
type First = (Vec<u8>, Vec<Body<f64>>);

/// The way of each group at the coordinate `from`, the one closest to the places of `[assembly]`; and the placed links.
pub(crate) fn first_ways(
    mechanism: &Mechanism,
    structure: &Structure,
    chain: &Chain<f64>,
    wide: Option<&Wide>,
    from: f64,
) -> Result<First, (Vec<u8>, ChainError)> {
    let mut bodies = guessed_bodies(mechanism, chain);
    chain.set_input(from, &mut bodies);
    let mut extended = wide.map(|wide| wide.bodies(Dd::from_f64(from), &bodies));
    let mut ways = vec![0_u8; chain.groups.len()];
    for (i, kernel) in chain.groups.iter().enumerate().filter(|(i, _)| chain.is_needed(*i)) {
        let links = &structure.groups[i].frame.links;
        let mut best: Option<(f64, u8, Vec<Body<f64>>)> = None;
        let mut failure = None;
        for way in 0..u8::try_from(kernel.ways()).unwrap_or(u8::MAX) {
            let mut tried = bodies.clone();
            match kernel.place(&mut tried, usize::from(way)) {
                Ok(_) => {
                    // Twice the digits where they can be had: close to a change point the ways differ by little.
                    let exact = wide.zip(extended.as_ref()).and_then(|(wide, extended)| {
                        let mut tried = extended.clone();
                        wide.kernel(i).place(&mut tried, usize::from(way)).ok()?;
                        Some(miss(mechanism, links, &tried))
                    });
                    let miss = exact.unwrap_or_else(|| miss(mechanism, links, &tried));
                    let hair = SAME * structure.scale;
                    if best.as_ref().is_none_or(|(least, ..)| miss < *least - hair) {
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
        if let (Some(wide), Some(extended)) = (wide, &mut extended)
            && wide.kernel(i).place(extended, usize::from(ways[i])).is_err()
        {
            // A gap that is rounding only: the place of 16 digits must do.
            for &link in links {
                extended[link] = bodies[link].map(Dd::from_f64);
            }
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

/// Root of the sum of squares of the distances of a group's points from their wanted places, m.
fn miss<T: Number>(mechanism: &Mechanism, links: &[usize], bodies: &[Body<T>]) -> f64 {
    let mut sum = T::ZERO;
    for (point, wanted) in &mechanism.assembly {
        let place = mechanism.points[*point].places.iter().find(|place| links.contains(&place.link));
        if let Some(place) = place {
            let off = minus(bodies[place.link].point(vector(place.at)), vector(*wanted));
            sum += dot(off, off);
        }
    }
    sum.sqrt().to_f64()
}
