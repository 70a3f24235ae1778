//! Names that results share, made once.

use std::sync::Arc;

use assur_mechanism::{Mechanism, PairId};

/// Names of links, points and slides by index.
#[derive(Debug)]
pub(crate) struct Names {
    pub(crate) links: Vec<Arc<str>>,
    pub(crate) points: Vec<Arc<str>>,
    pub(crate) slides: Vec<Arc<str>>,
}

impl Names {
    pub(crate) fn of(mechanism: &Mechanism) -> Self {
        Self {
            links: mechanism.links.iter().map(|link| link.name.as_str().into()).collect(),
            points: mechanism.points.iter().map(|point| point.name.as_str().into()).collect(),
            slides: mechanism.slides.iter().map(|slide| slide.name.as_str().into()).collect(),
        }
    }

    pub(crate) fn pair(&self, pair: PairId) -> Arc<str> {
        match pair {
            PairId::Pin(point) => Arc::clone(&self.points[point]),
            PairId::Slide(slide) => Arc::clone(&self.slides[slide]),
        }
    }
}
