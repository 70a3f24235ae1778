//! Motion of points, links and slides in a solved position.

use std::f64::consts::TAU;

use assur_group::Body;
use assur_mechanism::{LinkId, Place, PointId, SlideId};
use serde::Serialize;

use crate::{Linkage, Position};

/// PF0, PF1, PF2 of a point: m, m/rad, m/rad² (per m for a sliding input).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct PointMotion {
    /// Place, m.
    pub pf0: [f64; 2],
    /// First derivative with respect to the coordinate.
    pub pf1: [f64; 2],
    /// Second derivative with respect to the coordinate.
    pub pf2: [f64; 2],
}

/// PF0, PF1, PF2 of the angle of a link (rad) or of the displacement of a slide (m): the value and its derivatives
/// with respect to the coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ScalarMotion {
    /// An angle in (-pi, pi], rad ([`continuous_angle`] makes a sequence of them continuous); or the signed distance
    /// of the sliding point from `through` along the guide, m.
    pub pf0: f64,
    /// First derivative.
    pub pf1: f64,
    /// Second derivative.
    pub pf2: f64,
}

/// The angle that differs from `angle` by full turns and is closest to `near`, rad.
pub fn continuous_angle(angle: f64, near: f64) -> f64 {
    angle + TAU * ((near - angle) / TAU).round()
}

/// Motion of a point of a body, given in the body's frame.
pub(crate) fn motion_of(body: &Body<f64>, at: [f64; 2]) -> PointMotion {
    let arm = body.arm(at);
    PointMotion { pf0: [body.x + arm[0], body.y + arm[1]], pf1: body.first(arm), pf2: body.second(arm) }
}

impl Linkage {
    /// Motion of a place fixed in a link.
    pub fn place_motion(&self, place: Place, position: &Position) -> PointMotion {
        motion_of(&position.bodies[place.link], place.at)
    }

    /// Motion of a named point, calculated from the first of its links that was placed (for a pin all its links
    /// agree).
    pub fn point_motion(&self, point: PointId, position: &Position) -> PointMotion {
        let places = &self.mechanism.points[point].places;
        // Ground and input link are exact and come first; the others follow in the order of the scene.
        let rank = |place: &&Place| match place.link {
            0 => 0,
            link if link == self.mechanism.input.link => 1,
            _ => 2,
        };
        places
            .iter()
            .min_by_key(rank)
            .map_or_else(PointMotion::default, |place| self.place_motion(*place, position))
    }

    /// Motion of a link.
    pub fn link_motion(&self, link: LinkId, position: &Position) -> ScalarMotion {
        let body = &position.bodies[link];
        ScalarMotion { pf0: body.s.atan2(body.c), pf1: body.w1, pf2: body.w2 }
    }

    /// Motion of a slide.
    pub fn slide_motion(&self, slide: SlideId, position: &Position) -> ScalarMotion {
        let found = &self.mechanism.slides[slide];
        let (slider, carrier) = (&position.bodies[found.link], &position.bodies[found.on]);
        let point = motion_of(slider, found.point);
        let through = motion_of(carrier, found.through);
        let (s, c) = found.angle.sin_cos();
        let along = carrier.turned([c, s]);
        let across = [-along[1], along[0]];
        let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let (d0, d1, d2) =
            (minus(point.pf0, through.pf0), minus(point.pf1, through.pf1), minus(point.pf2, through.pf2));
        // s = t d with t' = w n, t'' = e n - w² t.
        let (w, e) = (carrier.w1, carrier.w2);
        ScalarMotion {
            pf0: dot(along, d0),
            pf1: dot(along, d1) + w * dot(across, d0),
            pf2: dot(along, d2) + 2.0 * w * dot(across, d1) + e * dot(across, d0) - w * w * dot(along, d0),
        }
    }
}
