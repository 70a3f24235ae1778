//! Dry friction in pairs.

use crate::{LinkId, Mechanism, PairId};

/// Dry (Coulomb) friction of a pin or slide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// The pair; no other entry has it.
    pub pair: PairId,
    /// Coefficient f, not negative.
    pub coefficient: f64,
    /// The surfaces that slide on each other.
    pub surfaces: Surfaces,
}

/// The surfaces that slide on each other in a pair with friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surfaces {
    /// A pin: on each other link of it acts the moment f r |R| against its turning relative to the owner, R the force of the
    /// pin on that link.
    Journal {
        /// Radius r of the journal, m.
        radius: f64,
        /// The link whose journal it is.
        owner: LinkId,
    },
    /// A slide that is pressed at one point: the force f |N| against the sliding, N the normal force.
    Place,
    /// A slide that is pressed on both ends of its contact: the force f (|N/2 + M/l| + |N/2 - M/l|) against the sliding, M
    /// the moment of the normal forces about the middle of the contact.
    Faces {
        /// Length l of the contact along the guide, m.
        length: f64,
        /// What the middle of the contact travels with.
        middle: Middle,
        /// Distance h of the faces from the guide line, m, one on each side.
        offset: f64,
    },
}

/// What the middle of the contact of a slide travels with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Middle {
    /// The point of the sliding link.
    Point,
    /// The point of the guide: a bushing.
    Through,
}

impl Mechanism {
    /// The links that turn or slide on another in a pair with friction, each with that other: of a pin all links but the owner of the
    /// journal, in the order of the file, of a slide the sliding link.
    pub fn friction_links(&self, friction: &Friction) -> Vec<[LinkId; 2]> {
        match (friction.pair, friction.surfaces) {
            (PairId::Pin(point), Surfaces::Journal { owner, .. }) => {
                let links = self.points[point].places.iter().map(|place| place.link);
                links.filter(|link| *link != owner).map(|link| [link, owner]).collect()
            }
            (PairId::Slide(slide), _) => vec![[self.slides[slide].link, self.slides[slide].on]],
            (PairId::Pin(_), _) => Vec::new(),
        }
    }
}
