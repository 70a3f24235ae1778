//! A group of class II as its closed forms want it: every pair read from the link of the group.

use crate::{BuildError, GroupFrame, Pair, PairGeometry};

/// Two links, three pairs, in the order outer - inner - outer.
///
/// `first` is read from link 1, `second` from link 2; the inner pair from link 1 (link 1 is `a`). So a pair P is always
/// "the link of the group slides on the other body", whichever of the two carries the guide in the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dyad {
    /// Bodies of link 1 and link 2.
    pub links: [usize; 2],
    /// Outer pair of link 1, seen from link 1.
    pub first: Pair,
    /// Pair between the links, seen from link 1.
    pub inner: Pair,
    /// Outer pair of link 2, seen from link 2.
    pub second: Pair,
    /// Which of `first`, `inner`, `second` were turned round: their reactions must be turned back.
    pub turned: [bool; 3],
}

/// A pin seen from a link of the group.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinEnd {
    /// The pin in the frame of the link, m.
    pub own: [f64; 2],
    /// The other body.
    pub body: usize,
    /// The pin in the frame of the other body, m.
    pub at: [f64; 2],
}

/// A slide seen from a link of the group: `own` stays on a line of the other body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlideEnd {
    /// Point of the link on the line, in the frame of the link, m.
    pub own: [f64; 2],
    /// The other body.
    pub body: usize,
    /// Point of the other body on the line, in its frame, m.
    pub through: [f64; 2],
    /// Direction of the line in the frame of the other body, rad.
    pub angle: f64,
    /// Angle of the link's x axis from the line, rad.
    pub tilt: f64,
}

impl Dyad {
    /// Reads a group as a dyad, link 1 being the first link; `None` if it is not two links with three pairs.
    pub fn of(frame: &GroupFrame) -> Option<Self> {
        let (&[one, two], [inner], [p, q]) = (&frame.links[..], &frame.inner[..], &frame.outer[..]) else {
            return None;
        };
        let (first, second) = if p.joins(one) && q.joins(two) {
            (p, q)
        } else if p.joins(two) && q.joins(one) {
            (q, p)
        } else {
            return None;
        };
        let seen = |pair: &Pair, from: usize| if pair.a == from { *pair } else { pair.turned_round() };
        let turned = [first.a != one, inner.a != one, second.a != two];
        Some(Self {
            links: [one, two],
            first: seen(first, one),
            inner: seen(inner, one),
            second: seen(second, two),
            turned,
        })
    }

    /// The same dyad with link 1 and link 2 exchanged.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            links: [self.links[1], self.links[0]],
            first: self.second,
            inner: self.inner.turned_round(),
            second: self.first,
            turned: [self.turned[2], !self.turned[1], self.turned[0]],
        }
    }

    /// Whether the pairs outer - inner - outer are slides in this pattern.
    pub fn is(&self, slides: [bool; 3]) -> bool {
        [self.first.is_slide(), self.inner.is_slide(), self.second.is_slide()] == slides
    }

    /// The dyad in the sense in which it has this pattern of slides: as it stands, else reversed.
    pub fn of_pattern(frame: &GroupFrame, slides: [bool; 3]) -> Option<Self> {
        let dyad = Self::of(frame)?;
        if dyad.is(slides) {
            return Some(dyad);
        }
        let reversed = dyad.reversed();
        reversed.is(slides).then_some(reversed)
    }

    /// As [`of_pattern`](Self::of_pattern), for the builder of a kind.
    ///
    /// # Errors
    ///
    /// [`BuildError`] where the group has another pattern.
    pub fn built(frame: &GroupFrame, slides: [bool; 3]) -> Result<Self, BuildError> {
        let fault = || {
            let letters = slides.map(|slide| if slide { 'P' } else { 'R' });
            BuildError::new(format!("the pairs are not {}-{}-{}", letters[0], letters[1], letters[2]))
        };
        Self::of_pattern(frame, slides).ok_or_else(fault)
    }
}

impl Pair {
    /// The pair as a pin seen from its body `a`.
    pub fn pin_end(&self) -> Option<PinEnd> {
        match self.geometry {
            PairGeometry::Pin { at_a, at_b } => Some(PinEnd { own: at_a, body: self.b, at: at_b }),
            PairGeometry::Slide { .. } => None,
        }
    }

    /// The pair as a slide seen from its body `a`.
    pub fn slide_end(&self) -> Option<SlideEnd> {
        match self.geometry {
            PairGeometry::Slide { point, through, angle, tilt } => {
                Some(SlideEnd { own: point, body: self.b, through, angle, tilt })
            }
            PairGeometry::Pin { .. } => None,
        }
    }
}
