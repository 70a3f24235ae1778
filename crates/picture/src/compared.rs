//! A second scene beside the open one.

use assur_words::Text;

use crate::{Results, Series};

/// A second scene for comparison.
#[derive(Debug)]
pub struct Compared {
    /// Its name.
    pub name: Text,
    /// The name of the first scene beside it.
    pub own: Text,
    /// Its results.
    pub results: Box<Results>,
    /// Whether it is the open scene as it was before its numbers were changed.
    pub before: bool,
}

impl Compared {
    /// The corresponding quantity of the second scene, in the same unit.
    pub fn series(&self, own: &Series) -> Option<&Series> {
        self.results.named(&own.short).filter(|other| other.unit == own.unit)
    }

    /// Own value at a position less that of the second scene, at a sample that at the same time; NaN if one of them has none.
    pub fn difference(&self, own: &Series, position: usize) -> Option<f64> {
        let theirs = self.series(own)?;
        let other = match self.results.samples() {
            Some(_) => {
                let node = own.course.nodes().iter().find(|node| node.number == position);
                node.and_then(|node| theirs.course.between(node.at))
            }
            None => theirs.course.get(position),
        };
        Some(own.at(position) - theirs.unit.factor * other.unwrap_or(f64::NAN))
    }
}
