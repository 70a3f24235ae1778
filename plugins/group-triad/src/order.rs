//! The order of the modes.

use std::f64::consts::PI;

use assur_group::plane::{dot, length, minus};
use assur_group::{AssurGroup, Body, SlideJoint};
use assur_number::{Real, elementary};

use crate::{kernel::Legged, leg::Hold, mover::Freedom};

/// Directions that differ by less than this are one that the pairs give.
const SAME: f64 = 1e-9;

/// What a mode is sorted by: direction of the first ternary link in the order of the scene, as cosine and sine; displacement of
/// the slide that gives it, m.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Key {
    direction: [f64; 2],
    displacement: f64,
}

/// The key of the present pose.
pub(crate) fn key<T: Real>(kernel: &Legged<T>, bodies: &[Body<T>]) -> Key {
    let plate = kernel.plate.link;
    let base = kernel.base.as_ref().map(|base| base.link);
    let links = &AssurGroup::<T>::frame(kernel).links;
    let first = links.iter().copied().find(|link| *link == plate || Some(*link) == base).unwrap_or(plate);
    let mover = kernel.base.as_ref().filter(|base| base.link == first).unwrap_or(&kernel.plate);
    let slides = kernel.legs.iter().filter_map(|leg| match &leg.hold {
        Hold::Pp { outer, .. } => Some(outer),
        _ => None,
    });
    let own = match &mover.freedom {
        Freedom::Shift(slide) => Some(slide),
        _ => None,
    };
    let displacement = slides.chain(own).next().map_or(0.0, |slide| displacement(slide, bodies));
    let body = &bodies[first];
    Key { direction: [body.c.to_f64(), body.s.to_f64()], displacement }
}

/// The displacement of a slide, as the scene counts it, m.
fn displacement<T: Real>(slide: &SlideJoint<T>, bodies: &[Body<T>]) -> f64 {
    let through = bodies[slide.body].point(slide.through);
    let way = dot(slide.guide(bodies), minus(bodies[slide.link].point(slide.own), through)).to_f64();
    if slide.turned { -way } else { way }
}

/// Sorts by the angle, in (-pi, pi]; where all have the same, by the displacement.
pub(crate) fn sort<M>(modes: &mut [(Key, M)]) {
    let apart = |one: &Key, other: &Key| length(minus(one.direction, other.direction));
    let is_given = modes.windows(2).all(|two| apart(&two[0].0, &two[1].0) < SAME);
    let angle = |key: &Key| {
        let angle = elementary::atan2(key.direction[1], key.direction[0]);
        if angle <= -PI { PI } else { angle }
    };
    let number = |key: &Key| if is_given { key.displacement } else { angle(key) };
    modes.sort_by(|(a, _), (b, _)| number(a).total_cmp(&number(b)));
}
