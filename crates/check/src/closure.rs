//! Closure: at every pair both bodies have the same place, PF1 and PF2.

use assur_group::{Body, Pair, PairGeometry};
use assur_words::{Text, text};

use crate::subject::{Solved, Subject};
use crate::{check::Collector, elements::place_motion, kinetics::ROUNDINGS};

const NAMES: [Text; 3] = [text!("check-closure-pf0"), text!("check-closure-pf1"), text!("check-closure-pf2")];
const REASON: Text = text!("check-closure-reason");

/// Closure error of a pair: the gap and the size of the largest term, for each order.
type Gap = [(f64, f64); 3];

/// The closure errors of the positions that were added.
pub(crate) struct Closure {
    collectors: [Collector; 3],
    /// By link: its [spread](Subject::spread).
    spreads: Vec<f64>,
}

impl Closure {
    pub(crate) fn new(subject: &Subject<'_>) -> Self {
        let structure = &subject.linkage.structure;
        let spreads = (0..structure.links).map(|link| subject.spread(link)).collect();
        Self { collectors: NAMES.map(|check| Collector::new(check, REASON)), spreads }
    }

    pub(crate) fn add(&mut self, subject: &Subject<'_>, one: &Solved) {
        let (linkage, bodies) = (subject.linkage, &one.position.bodies);
        let gaps: Vec<Gap> = linkage.structure.pairs.iter().map(|named| gap(&named.pair, bodies)).collect();
        let sizes = [0, 1, 2].map(|order| gaps.iter().map(|gap: &Gap| gap[order].1).fold(0.0, f64::max));
        let lost = [0, 1, 2].map(|order| subject.lost_by_interpolation(one, order));
        // What is passive is not solved for: it need only fit.
        let passive = linkage.structure.passive.iter().flat_map(|passive| passive.frame.pairs());
        let first_passive = passive.map(|pair| pair.id).min().unwrap_or(usize::MAX);
        let fits =
            linkage.misfits.iter().map(|misfit| misfit.limit).fold(0.0, f64::max) / linkage.structure.scale;
        for (id, gap) in gaps.iter().enumerate() {
            for (order, (open, _)) in gap.iter().enumerate() {
                let size = sizes[order];
                let rounding = ROUNDINGS * f64::EPSILON * lost[order];
                let limit = size * if id < first_passive { rounding } else { rounding.max(fits) };
                let unit = subject.unit(order, true);
                self.collectors[order].offer_of(one.index, open / unit, limit / unit, size / unit, || {
                    let pair = linkage.structure.pair_name(&linkage.mechanism, id);
                    text!("check-pair", pair)
                });
            }
        }
        // Where the position is interpolated, the determinant does not matter.
        let across = linkage.is_interpolated(one.position.coordinate);
        let turned = lost[0] / if across { 1.0 } else { one.health };
        for (id, body) in bodies.iter().enumerate().take(linkage.structure.links).skip(1) {
            // The direction of a link is a unit vector.
            let off = (body.c * body.c + body.s * body.s - 1.0).abs();
            let limit = ROUNDINGS * f64::EPSILON * turned * self.spreads[id];
            self.collectors[0].offer(one.index, off, limit, || {
                text!("check-direction", link = &linkage.mechanism.links[id].name)
            });
        }
    }

    pub(crate) fn collectors(self) -> impl Iterator<Item = Collector> {
        self.collectors.into_iter()
    }
}

fn gap(pair: &Pair, bodies: &[Body<f64>]) -> Gap {
    let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
    match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => {
            let (one, two) = (place_motion(a, at_a), place_motion(b, at_b));
            let sizes = [0, 1, 2].map(|order| size(a, at_a, order) + size(b, at_b, order));
            [0, 1, 2].map(|order| {
                let open = (one[order][0] - two[order][0]).hypot(one[order][1] - two[order][1]);
                (open, sizes[order])
            })
        }
        PairGeometry::Slide { point, through, angle, tilt } => slide_gap(a, b, point, through, angle, tilt),
    }
}

/// Size of the terms of which the motion of a place consists. The direction of a body follows from differences of places, so
/// that the rounding of the places is in its turning arm.
fn size(body: &Body<f64>, at: [f64; 2], order: usize) -> f64 {
    let far = at[0].hypot(at[1]) + body.x.hypot(body.y);
    let first = body.x1.hypot(body.y1);
    match order {
        0 => far,
        1 => first + body.w1.abs() * far,
        _ => body.x2.hypot(body.y2) + (body.w2.abs() + body.w1 * body.w1) * far + 2.0 * body.w1.abs() * first,
    }
}

/// The point stays on the line: in the frame of the guide, the component n of the relative motion is zero in every
/// order. Both bodies turn by the same angle (angles are compared as lengths at the arm of the point).
///
/// The distance d along the guide is the difference of two places. It is small against them where guide and pins nearly
/// meet, but its rounding is that of the places. That rounding is multiplied by w in the first order and by e + w² in
/// the second, and the rounding of d' by 2 w. So the sizes of the places count there, not those of d and d': near a
/// singular position w grows with the inverse of d, but the rounding that it multiplies does not become smaller with d.
fn slide_gap(a: &Body<f64>, b: &Body<f64>, point: [f64; 2], through: [f64; 2], angle: f64, tilt: f64) -> Gap {
    let (s, c) = angle.sin_cos();
    let along = [b.c * c - b.s * s, b.s * c + b.c * s];
    let across = [-along[1], along[0]];
    let (one, two) = (place_motion(a, point), place_motion(b, through));
    let d = [0, 1, 2].map(|k| [one[k][0] - two[k][0], one[k][1] - two[k][1]]);
    let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
    // (n d)' = n d' - w t d;  (n d)'' = n d'' - 2 w t d' - e t d - w² n d.
    let (w, e) = (b.w1, b.w2);
    let open = [
        dot(across, d[0]),
        dot(across, d[1]) - w * dot(along, d[0]),
        dot(across, d[2]) - 2.0 * w * dot(along, d[1]) - e * dot(along, d[0]) - w * w * dot(across, d[0]),
    ];
    let far = d[0][0].hypot(d[0][1]);
    let own = [0, 1, 2].map(|k| size(a, point, k) + size(b, through, k));
    let extra = [far, w.abs() * own[0], 2.0 * w.abs() * own[1] + (e.abs() + w * w) * own[0]];
    let (ts, tc) = tilt.sin_cos();
    let wanted = [along[0] * tc - along[1] * ts, along[1] * tc + along[0] * ts];
    // The angle, not only its sine: a body turned by 180 degrees is an error.
    let turn = (wanted[0] * a.s - wanted[1] * a.c).atan2(wanted[0] * a.c + wanted[1] * a.s);
    let turns = [turn, a.w1 - b.w1, a.w2 - b.w2];
    let rates = [1.0, a.w1.abs() + b.w1.abs(), a.w2.abs() + b.w2.abs()];
    let lever = point[0].hypot(point[1]) + through[0].hypot(through[1]) + far;
    [0, 1, 2].map(|k| (open[k].abs().max(turns[k].abs() * lever), own[k] + extra[k] + rates[k] * lever))
}
