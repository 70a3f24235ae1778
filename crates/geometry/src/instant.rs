//! Centers of the motion of a link in one position.

use assur_group::Body;
use assur_group::plane::{minus, mirrored, perp, plus, scaled, times};
use serde::Serialize;

use crate::centers::{CenterAt, center};
use crate::relative::seen_from;

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
