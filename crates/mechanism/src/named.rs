//! Parts of a mechanism by their ids, with the names under which results are written.

use std::borrow::Borrow;
use std::fmt;
use std::ops::Deref;

use assur_words::Text;
use serde::{Serialize, Serializer};

use crate::{LinkId, Mechanism, Name, PairId, PointId, SlideId};

/// A link, point, slide or pair: who looks for it has its id, and who writes it has its name. As a key it is its name, which no
/// other part of its kind has.
#[derive(Debug, Clone, Eq)]
pub struct Named<I> {
    /// Which one it is.
    pub id: I,
    /// Its name.
    pub name: Name,
}

impl<I> Deref for Named<I> {
    type Target = Name;

    fn deref(&self) -> &Name {
        &self.name
    }
}

impl<I> fmt::Display for Named<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.name, f)
    }
}

impl<I> Serialize for Named<I> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.name.serialize(serializer)
    }
}

impl<I> PartialEq for Named<I> {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl<I> PartialEq<&str> for Named<I> {
    fn eq(&self, other: &&str) -> bool {
        self.name == **other
    }
}

impl<I> std::hash::Hash for Named<I> {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl<I> Borrow<str> for Named<I> {
    fn borrow(&self) -> &str {
        &self.name
    }
}

impl<I> From<&Named<I>> for Text {
    fn from(named: &Named<I>) -> Self {
        Self::from(&named.name)
    }
}

impl Mechanism {
    /// A link with its name.
    pub fn named_link(&self, id: LinkId) -> Named<LinkId> {
        Named { id, name: self.links[id].name.clone() }
    }

    /// A point with its name.
    pub fn named_point(&self, id: PointId) -> Named<PointId> {
        Named { id, name: self.points[id].name.clone() }
    }

    /// A slide with its name.
    pub fn named_slide(&self, id: SlideId) -> Named<SlideId> {
        Named { id, name: self.slides[id].name.clone() }
    }

    /// A pin or slide with its name.
    pub fn named_pair(&self, id: PairId) -> Named<PairId> {
        let name = match id {
            PairId::Pin(point) => &self.points[point].name,
            PairId::Slide(slide) => &self.slides[slide].name,
        };
        Named { id, name: name.clone() }
    }
}
