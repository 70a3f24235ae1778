//! Centers of the motion of a link in one position.

use assur_group::Body;
use assur_group::plane::{cross, minus, mirrored, perp, plus, scaled, times};
use assur_kinematics::{Linkage, PointMotion, Position};
use assur_mechanism::{LinkId, Named};
use assur_number::{ROUNDING, elementary};
use serde::Serialize;

use crate::rigid::{RigidParts, modulus};

/// Centers of the motion of one link as seen from another link (or from the ground), in the frame of that one, m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Centers {
    /// The instant center, a point of the fixed centrode.
    pub center: CenterAt,
    /// The instant center in the frame of the link, a point of the moving centrode; `None` at infinity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub on_link: Option<[f64; 2]>,
    /// The inflection pole: the inflection circle, whose points pass through points of inflection of their paths, has the
    /// diameter from the instant center to it; `None` where the center is at infinity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inflection_pole: Option<[f64; 2]>,
    /// The pole of accelerations at constant input speed: the point whose PF2 is zero; `None` for a translation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration_pole: Option<[f64; 2]>,
}

impl Centers {
    /// The centers of a link that never moves against the other one: every point is a center.
    pub(crate) const RIGID: Self =
        Self { center: CenterAt::Everywhere, on_link: None, inflection_pole: None, acceleration_pole: None };
}

/// Centers of the motion of `body` as seen from `observer`; both need PF2. `scale`: a typical length, m.
pub fn centers_of(body: &Body<f64>, observer: &Body<f64>, scale: f64) -> Centers {
    let seen = seen_from(body, observer);
    let center = center(&seen, &Body::ground(), scale);
    let origin = [seen.x, seen.y];
    let (w, e) = (seen.w1, seen.w2);
    let (mut on_link, mut inflection_pole) = (None, None);
    if let CenterAt::Point(point) = center {
        let arm = minus(point, origin);
        on_link = Some(times(arm, mirrored([seen.c, seen.s])));
        // A point at r from the center has PF1 = w x r and PF2 = a + e x r - w² r, a being the PF2 of the center. They are
        // parallel where r² = r a / w².
        inflection_pole = Some(plus(point, scaled(1.0 / (w * w), seen.second(arm))));
    }
    // Zero PF2 at r from the origin: second + e x r - w² r = 0.
    let size = w.powi(4) + e * e;
    let second = [seen.x2, seen.y2];
    let acceleration_pole = (on_link.is_some() || e != 0.0)
        .then(|| plus(origin, scaled(1.0 / size, plus(scaled(w * w, second), scaled(e, perp(second))))));
    let acceleration_pole = acceleration_pole.filter(|pole| pole.iter().all(|x| x.is_finite()));
    Centers { center, on_link, inflection_pole, acceleration_pole }
}

/// Pose and derivatives of `body` in the frame of `observer`.
pub(crate) fn seen_from(body: &Body<f64>, observer: &Body<f64>) -> Body<f64> {
    let back = |vector: [f64; 2]| times(vector, mirrored([observer.c, observer.s]));
    let (w, e) = (observer.w1, observer.w2);
    let arm = minus([body.x, body.y], [observer.x, observer.y]);
    // Velocity relative to the observer, along the axes of the ground; then Coriolis' theorem.
    let first = minus(minus([body.x1, body.y1], [observer.x1, observer.y1]), scaled(w, perp(arm)));
    let second = minus([body.x2, body.y2], [observer.x2, observer.y2]);
    let carried = plus(scaled(e, perp(arm)), plus(scaled(-w * w, arm), scaled(2.0 * w, perp(first))));
    let ([x, y], [c, s]) = (back(arm), back([body.c, body.s]));
    let ([x1, y1], [x2, y2]) = (back(first), back(minus(second, carried)));
    Body { x, y, c, s, x1, y1, w1: body.w1 - w, x2, y2, w2: body.w2 - e }
}

/// Sine of the angle between PF1 and PF2 below which the path is straight there.
const STRAIGHT: f64 = 1e-13;

/// Curvature of the path of a point in one position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Curvature {
    /// Signed curvature, 1/m: positive where the path turns left while the coordinate grows.
    pub curvature: f64,
    /// The center of curvature, m; `None` where the path is straight.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub center: Option<[f64; 2]>,
}

impl Curvature {
    /// Curvature from the motion of a point; `None` where the point rests (`speed`: the greatest magnitude of its PF1).
    pub fn of(motion: &PointMotion, speed: f64) -> Option<Self> {
        let [pf1, pf2] = [motion.pf1, motion.pf2];
        let size = elementary::hypot(pf1[0], pf1[1]);
        if size <= 1e-9 * speed {
            return None;
        }
        let turn = cross(pf1, pf2);
        if turn.abs() <= STRAIGHT * size * (elementary::hypot(pf2[0], pf2[1])).max(speed) {
            return Some(Self { curvature: 0.0, center: None });
        }
        let center = plus(motion.pf0, scaled(size * size / turn, perp(pf1)));
        Some(Self { curvature: turn / size.powi(3), center: Some(center) })
    }
}

/// A relative PF1 below this part of a typical length is rounding: that of the places, which a turn by 1 rad moves by
/// about a typical length.
const LAST_PLACES: f64 = 16.0 * f64::EPSILON;

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

impl CenterAt {
    /// Its place, m; `None` where there is no single one.
    pub fn point(self) -> Option<[f64; 2]> {
        if let Self::Point(place) = self { Some(place) } else { None }
    }
}

/// The instant center of one link relative to another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Center {
    /// The link.
    pub link: Named<LinkId>,
    /// The other link; `ground` for an absolute center.
    pub against: Named<LinkId>,
    /// Where.
    pub at: CenterAt,
}

/// The centers of all pairs of links: the absolute ones first, then the relative ones. `position` needs PF1.
pub fn instant_centers(linkage: &Linkage, position: &Position) -> Vec<Center> {
    let mechanism = &linkage.mechanism;
    let parts = RigidParts::of_structure(linkage);
    let mut list = Vec::new();
    for against in 0..mechanism.links.len() {
        for link in against + 1..mechanism.links.len() {
            let [one, two] = [link, against].map(|id| &position.bodies[id]);
            let at = if parts.joins(link, against) {
                CenterAt::Everywhere
            } else {
                center(one, two, linkage.structure.scale)
            };
            let [link, against] = [link, against].map(|id| mechanism.named_link(id));
            list.push(Center { link, against, at });
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
    if turn.abs() * scale > ROUNDING * motion {
        // slip + turn x (P - origin) = 0
        return CenterAt::Point(plus(origin, scaled(1.0 / turn, perp(slip))));
    }
    let size = modulus(slip);
    if size > (ROUNDING * motion).max(LAST_PLACES * scale) {
        return CenterAt::Direction(scaled(1.0 / size, perp(slip)));
    }
    CenterAt::Everywhere
}
