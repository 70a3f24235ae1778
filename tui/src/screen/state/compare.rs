//! A second scene for comparison with the open one: its drawing, its curves, and the differences.

use super::scene::Scene;
use super::series::Series;

/// The second scene.
#[derive(Debug)]
pub(crate) struct Compared {
    pub(crate) name: String,
    pub(crate) scene: Box<Scene>,
    /// Whether it is the open scene as it was before its numbers were changed.
    pub(crate) before: bool,
}

impl Compared {
    /// The corresponding quantity of the second scene, in the same unit.
    pub(crate) fn series(&self, own: &Series) -> Option<&Series> {
        self.scene.named(&own.short).filter(|other| other.unit == own.unit)
    }

    /// Own value minus that of the second scene; NaN if one of them has none.
    pub(crate) fn difference(&self, own: &Series, position: usize) -> Option<f64> {
        Some(own.at(position) - self.series(own)?.at(position))
    }
}
