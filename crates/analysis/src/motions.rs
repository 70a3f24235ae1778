//! Places, transfer functions and rates of one position.

use std::sync::Arc;

use crate::plan::Wanted;
use crate::results::{Derivatives, Named, Rates, Transfer};
use assur_kinematics::{Linkage, Position};

use crate::names::Names;

pub(crate) fn links(
    linkage: &Linkage,
    wanted: &Wanted,
    names: &Names,
    position: &Position,
    angles: &[f64],
) -> Named<Derivatives> {
    let each = wanted.links.iter().map(|&id| {
        let found = linkage.link_motion(id, position);
        let motion = Derivatives { pf0: angles[id], pf1: found.pf1, pf2: found.pf2 };
        (Arc::clone(&names.links[id]), motion)
    });
    each.collect()
}

pub(crate) fn points(
    linkage: &Linkage,
    wanted: &Wanted,
    names: &Names,
    position: &Position,
) -> Named<Transfer> {
    let each = wanted.points.iter().map(|&(id, place)| {
        let found = linkage.place_motion(place, position);
        (Arc::clone(&names.points[id]), Transfer { pf0: found.pf0, pf1: found.pf1, pf2: found.pf2 })
    });
    each.collect()
}

pub(crate) fn slides(
    linkage: &Linkage,
    wanted: &Wanted,
    names: &Names,
    position: &Position,
) -> Named<Derivatives> {
    let each = wanted.slides.iter().map(|&id| {
        let found = linkage.slide_motion(id, position);
        (Arc::clone(&names.slides[id]), Derivatives { pf0: found.pf0, pf1: found.pf1, pf2: found.pf2 })
    });
    each.collect()
}

/// Velocities, or with `second` accelerations: v = PF1 w, a = PF2 w² + PF1 e.
pub(crate) fn rates(
    motions: (&Named<Derivatives>, &Named<Transfer>, &Named<Derivatives>),
    speed: f64,
    acceleration: f64,
    second: bool,
) -> Rates {
    let rate =
        |pf1: f64, pf2: f64| if second { pf2 * speed * speed + pf1 * acceleration } else { pf1 * speed };
    let scalar = |motions: &Named<Derivatives>| {
        motions.0.iter().map(|(name, m)| (Arc::clone(name), rate(m.pf1, m.pf2))).collect()
    };
    let vector = |(name, m): &(Arc<str>, Transfer)| {
        (Arc::clone(name), [rate(m.pf1[0], m.pf2[0]), rate(m.pf1[1], m.pf2[1])])
    };
    Rates {
        links: scalar(motions.0),
        points: motions.1.0.iter().map(vector).collect(),
        slides: scalar(motions.2),
    }
}
