//! What has transfer functions: every named place on every moving link, centers of mass, links and slides.

use assur_group::Body;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{LinkId, Mechanism, Place, SlideId};
use assur_number::Real;
use assur_words::{Text, text};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Element {
    /// A place; the number of the point that is named there, or none for a center of mass.
    Place(Place, Option<usize>),
    /// The angle of a link.
    Link(LinkId),
    /// The displacement of a slide.
    Slide(SlideId),
}

/// PF0, PF1, PF2 of an element; one number for links and slides, the second is then 0.
pub(crate) type Motion = [[f64; 2]; 3];

/// All elements. A pin is one element on each of its links: they are calculated separately and must agree.
pub(crate) fn elements(linkage: &Linkage) -> Vec<Element> {
    let mechanism = &linkage.mechanism;
    let mut all = Vec::new();
    for (id, point) in mechanism.points.iter().enumerate() {
        let moving = point.places.iter().filter(|place| place.link != 0);
        all.extend(moving.map(|place| Element::Place(*place, Some(id))));
    }
    for (link, found) in mechanism.links.iter().enumerate().skip(1) {
        if found.mass > 0.0 {
            all.push(Element::Place(Place { link, at: found.center }, None));
        }
        all.push(Element::Link(link));
    }
    all.extend((0..mechanism.slides.len()).map(Element::Slide));
    all
}

impl Element {
    pub(crate) fn name(self, linkage: &Linkage) -> Text {
        let mechanism = &linkage.mechanism;
        let link = |link: LinkId| &mechanism.links[link].name;
        match self {
            Self::Place(place, Some(id)) => {
                let point = &mechanism.points[id].name;
                text!("check-point-on", point, link = link(place.link))
            }
            Self::Place(place, None) => text!("check-center-of-mass", link = link(place.link)),
            Self::Link(id) => text!("check-link", link = link(id)),
            Self::Slide(id) => text!("check-slide", slide = &mechanism.slides[id].name),
        }
    }

    /// The link of the element; for a slide both links.
    pub(crate) fn links(self, linkage: &Linkage) -> [LinkId; 2] {
        match self {
            Self::Place(place, _) => [place.link; 2],
            Self::Link(link) => [link; 2],
            Self::Slide(id) => {
                let slide = &linkage.mechanism.slides[id];
                [slide.link, slide.on]
            }
        }
    }

    /// Number of components of its transfer functions.
    pub(crate) fn components(self) -> usize {
        if matches!(self, Self::Place(..)) { 2 } else { 1 }
    }

    /// Whether its PF0 is a length; otherwise an angle.
    pub(crate) fn is_length(self) -> bool {
        !matches!(self, Self::Link(_))
    }

    /// The transfer functions; an angle is counted from that of `reference`, so it never jumps.
    pub(crate) fn motion(self, linkage: &Linkage, position: &Position, reference: &Position) -> Motion {
        match self {
            Self::Place(place, _) => {
                let found = linkage.place_motion(place, position);
                [found.pf0, found.pf1, found.pf2]
            }
            Self::Link(link) => {
                let (body, from) = (&position.bodies[link], &reference.bodies[link]);
                let turn = (from.c * body.s - from.s * body.c).atan2(from.c * body.c + from.s * body.s);
                [[turn, 0.0], [body.w1, 0.0], [body.w2, 0.0]]
            }
            Self::Slide(slide) => {
                let found = linkage.slide_motion(slide, position);
                [[found.pf0, 0.0], [found.pf1, 0.0], [found.pf2, 0.0]]
            }
        }
    }

    /// The transfer functions from the bodies, in any number type. For a link, PF0 is the sine of its angle from
    /// `reference`, whose derivative there is that of the angle.
    pub(crate) fn motion_of<T: Real>(
        self,
        mechanism: &Mechanism,
        bodies: &[Body<T>],
        reference: &[Body<T>],
    ) -> [[T; 2]; 3] {
        match self {
            Self::Place(place, _) => place_motion(&bodies[place.link], place.at),
            Self::Link(link) => {
                let (body, from) = (&bodies[link], &reference[link]);
                let sine = from.c * body.s - from.s * body.c;
                [sine, body.w1, body.w2].map(|number| [number, T::ZERO])
            }
            Self::Slide(slide) => {
                let found = &mechanism.slides[slide];
                let carrier = &bodies[found.on];
                let one = place_motion(&bodies[found.link], found.point);
                let two = place_motion(carrier, found.through);
                let d = [0, 1, 2].map(|k| [one[k][0] - two[k][0], one[k][1] - two[k][1]]);
                let (s, c) = T::from_f64(found.angle).sin_cos();
                let t = carrier.turned([c, s]);
                let along = |d: [T; 2]| t[0] * d[0] + t[1] * d[1];
                let across = |d: [T; 2]| t[0] * d[1] - t[1] * d[0];
                // s = t d with t' = w n, t'' = e n - w² t.
                let (w, e) = (carrier.w1, carrier.w2);
                let first = along(d[1]) + w * across(d[0]);
                let turned = (w * across(d[1])).twice() + e * across(d[0]) - w * w * along(d[0]);
                [along(d[0]), first, along(d[2]) + turned].map(|number| [number, T::ZERO])
            }
        }
    }
}

/// PF0, PF1 and PF2 of a place of a body.
pub(crate) fn place_motion<T: Real>(body: &Body<T>, at: [f64; 2]) -> [[T; 2]; 3] {
    let arm = body.arm(at.map(T::from_f64));
    [[body.x + arm[0], body.y + arm[1]], body.first(arm), body.second(arm)]
}
