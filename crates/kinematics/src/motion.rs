//! Motion of points, links and slides in a solved position.

use std::f64::consts::{PI, TAU};

use assur_group::plane::{dot, minus, perp, plus, vector};
use assur_group::{Body, Order};
use assur_mechanism::{LinkId, Place, PointId, Slide, SlideId};
use assur_number::{Real, elementary};
use serde::Serialize;

use crate::{Linkage, Position};

/// PF0, PF1, PF2 of a point: m, m/rad, m/rad² (per m for a sliding input).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct PointMotion<T = f64> {
    /// Place, m.
    pub pf0: [T; 2],
    /// First derivative with respect to the coordinate.
    pub pf1: [T; 2],
    /// Second derivative with respect to the coordinate.
    pub pf2: [T; 2],
}

/// PF0, PF1, PF2 of the angle of a link (rad) or of the displacement of a slide (m): the value and its derivatives
/// with respect to the coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ScalarMotion<T = f64> {
    /// An angle in (-pi, pi], rad ([`continuous_angle`] makes a sequence of them continuous); or the signed distance
    /// of the sliding point from `through` along the guide, m.
    pub pf0: T,
    /// First derivative.
    pub pf1: T,
    /// Second derivative.
    pub pf2: T,
}

/// The angle that differs from `angle` by full turns and is closest to `near`, rad.
pub fn continuous_angle(angle: f64, near: f64) -> f64 {
    angle + TAU * ((near - angle) / TAU).round()
}

/// An angle in [-pi, pi] as the first one of a motion: -pi becomes pi.
pub fn first_angle(angle: f64) -> f64 {
    if angle <= -PI { PI } else { angle }
}

impl<T: Real> PointMotion<T> {
    /// Motion of a point of a body, given in the body's frame.
    #[inline]
    pub fn of(body: &Body<T>, at: [f64; 2]) -> Self {
        let arm = body.arm(vector(at));
        Self { pf0: plus([body.x, body.y], arm), pf1: body.first(arm), pf2: body.second(arm) }
    }
}

impl<T: Real> ScalarMotion<T> {
    /// Motion of a slide: the distance from `through` to the sliding point along the guide.
    #[inline]
    pub fn of_slide(slide: &Slide, bodies: &[Body<T>]) -> Self {
        let carrier = &bodies[slide.on];
        let point = PointMotion::of(&bodies[slide.link], slide.point);
        let through = PointMotion::of(carrier, slide.through);
        let (s, c) = elementary::sin_cos(slide.angle);
        let along = carrier.turned(vector([c, s]));
        let across = perp(along);
        let (d0, d1, d2) =
            (minus(point.pf0, through.pf0), minus(point.pf1, through.pf1), minus(point.pf2, through.pf2));
        // s = t d with t' = w n, t'' = e n - w² t.
        let (w, e) = (carrier.w1, carrier.w2);
        let turned = w.twice() * dot(across, d1);
        Self {
            pf0: dot(along, d0),
            pf1: dot(along, d1) + w * dot(across, d0),
            pf2: dot(along, d2) + turned + e * dot(across, d0) - w * w * dot(along, d0),
        }
    }
}

/// Longest step of the coordinate, in its units, between two places over which an angle is followed.
const LONGEST_STEP: f64 = 0.05;
/// Most steps between two coordinates.
const MOST_STEPS: f64 = 1e4;

impl Linkage {
    /// Shows the places between two coordinates in short steps, so that what is continuous can be followed from one to the
    /// other; those that can't be assembled are left out.
    pub fn each_between(&self, [from, to]: [f64; 2], mut see: impl FnMut(&Position)) {
        let way = to - from;
        let steps = (way.abs() / self.coordinate_unit() / LONGEST_STEP).ceil().clamp(1.0, MOST_STEPS);
        if steps <= 1.0 {
            return;
        }
        let mut position = self.position();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and 10000")]
        for step in 1..steps as u32 {
            if self.solve(from + way * (f64::from(step) / steps), Order::Place, &mut position).is_ok() {
                see(&position);
            }
        }
    }

    /// Motion of a place fixed in a link.
    pub fn place_motion(&self, place: Place, position: &Position) -> PointMotion {
        PointMotion::of(&position.bodies[place.link], place.at)
    }

    /// Motion of a named point, calculated from the first of its links that was placed (for a pin all its links
    /// agree).
    pub fn point_motion(&self, point: PointId, position: &Position) -> PointMotion {
        let places = &self.mechanism.points[point].places;
        // Ground and input link are exact and come first; the others follow in the order of the scene.
        let rank = |place: &&Place| match place.link {
            0 => 0,
            link if self.mechanism.input.places(link) => 1,
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
        ScalarMotion { pf0: elementary::atan2(body.s, body.c), pf1: body.w1, pf2: body.w2 }
    }

    /// Motion of a slide; that of a driven one between two moving links is the coordinate itself.
    pub fn slide_motion(&self, slide: SlideId, position: &Position) -> ScalarMotion {
        if self.mechanism.input.is_displacement_of(slide) {
            return ScalarMotion { pf0: position.coordinate, pf1: 1.0, pf2: 0.0 };
        }
        ScalarMotion::of_slide(&self.mechanism.slides[slide], &position.bodies)
    }
}
