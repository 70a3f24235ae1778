//! Instant centers, absolute and relative.

use assur_group::Body;
use assur_group::plane::{minus, perp, plus, scaled};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::GROUND;
use serde::Serialize;

/// A relative rotation below this part of the relative motion, over a typical length, counts as zero.
const STILL: f64 = 1e-12;

/// A relative PF1 below this part of a typical length is rounding: that of the places, which a turn by 1 rad moves by
/// about a typical length.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Where an instant center is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CenterAt {
    /// At this place, m.
    Point([f64; 2]),
    /// At infinity, in this direction (a unit vector): the links do not rotate relative to each other.
    Direction([f64; 2]),
    /// The links do not move relative to each other in this position: every point is a center.
    Everywhere,
}

/// The instant center of one link relative to another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Center {
    /// The link.
    pub link: String,
    /// The other link; `ground` for an absolute center.
    pub against: String,
    /// Where.
    pub at: CenterAt,
}

/// The centers of all pairs of links: the absolute ones first, then the relative ones. `position` needs PF1.
pub fn instant_centers(linkage: &Linkage, position: &Position) -> Vec<Center> {
    let links = &linkage.mechanism.links;
    let mut list = Vec::new();
    for against in 0..links.len() {
        for link in against + 1..links.len() {
            let [one, two] = [link, against].map(|id| &position.bodies[id]);
            let name = if against == GROUND { "ground".to_owned() } else { links[against].name.clone() };
            let at = center(one, two, linkage.structure.scale);
            list.push(Center { link: links[link].name.clone(), against: name, at });
        }
    }
    list
}

/// The point in which two bodies have one velocity.
pub(crate) fn center(one: &Body<f64>, two: &Body<f64>, scale: f64) -> CenterAt {
    let origin = [one.x, one.y];
    let other = two.first(minus(origin, [two.x, two.y]));
    let slip = minus([one.x1, one.y1], other);
    let turn = one.w1 - two.w1;
    let motion = modulus([one.x1, one.y1]) + modulus(other) + scale * (one.w1.abs() + two.w1.abs());
    if turn.abs() * scale > STILL * motion {
        // slip + turn x (P - origin) = 0
        return CenterAt::Point(plus(origin, scaled(1.0 / turn, perp(slip))));
    }
    let size = modulus(slip);
    if size > (STILL * motion).max(ROUNDING * scale) {
        return CenterAt::Direction(scaled(1.0 / size, perp(slip)));
    }
    CenterAt::Everywhere
}

fn modulus(v: [f64; 2]) -> f64 {
    v[0].hypot(v[1])
}
