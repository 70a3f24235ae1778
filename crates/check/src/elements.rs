//! What has transfer functions: every named place on every moving link, centers of mass, links and slides.

use assur_kinematics::{Linkage, Position};
use assur_mechanism::{LinkId, Place, SlideId};

/// One element.
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

/// All elements. A pin is one on each of its links: they are solved apart and must agree.
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
    pub(crate) fn name(self, linkage: &Linkage) -> String {
        let mechanism = &linkage.mechanism;
        let link = |link: LinkId| mechanism.links[link].name.as_str();
        match self {
            Self::Place(place, Some(id)) => {
                format!("point {} on {}", mechanism.points[id].name, link(place.link))
            }
            Self::Place(place, None) => format!("center of mass of {}", link(place.link)),
            Self::Link(id) => format!("link {}", link(id)),
            Self::Slide(id) => format!("slide {}", mechanism.slides[id].name),
        }
    }

    /// Whether its PF0 is a length; otherwise an angle.
    pub(crate) fn is_length(self) -> bool {
        !matches!(self, Self::Link(_))
    }

    /// The transfer functions; an angle is counted from that of `reference`, so that it never jumps.
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
}
