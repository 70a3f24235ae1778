//! The mechanism of each point of a sweep.
//!
//! The scene is read once, and the reader tells where in the mechanism a number stands. A parameter that changes anything else
//! (a count, a table, the kind of a load), or an end of whose range is outside of its limits, has no such place; then every point is
//! read from the text of the scene with its values in it, which always holds and takes longer.

use assur_mechanism::{Mechanism, links_of_length_zero};
use assur_scene::{LEAST, SceneErrors, edit::replaced};

use crate::axis::Axis;

/// The scene with its parameters.
#[derive(Debug, Clone)]
pub(crate) struct Variants {
    file: String,
    /// The text of the scene.
    pub(crate) scene: String,
    /// The mechanism of the scene itself.
    pub(crate) base: Mechanism,
    /// Whether setting numbers is enough: the parameters in the order in which they are set.
    order: Option<Vec<usize>>,
}

impl Variants {
    /// The variants of a scene, whose mechanism is `base`.
    pub(crate) fn of(file: &str, scene: &str, base: Mechanism, axes: &[Axis]) -> Self {
        let mut order: Vec<usize> = (0..axes.len()).collect();
        // A point that is named in another place has no effect there if a number takes the place of its name.
        order.sort_by_key(|parameter| axes[*parameter].replaces_words);
        // A scale is set by the law that the scene has.
        let is_scaled = |axis: &Axis| axes.iter().any(|scale| scale.scales(axis));
        let order = axes.iter().all(|axis| axis.is_free() && !is_scaled(axis)).then_some(order);
        Self { file: file.to_owned(), scene: scene.to_owned(), base, order }
    }

    /// The mechanism with these values of the parameters, each in the unit of its range and in SI, by setting numbers
    /// in `scratch`, which was returned by an earlier call, or by reading the text.
    pub(crate) fn mechanism(
        &self,
        axes: &[Axis],
        numbers: &[f64],
        si: &[f64],
        scratch: Option<Mechanism>,
    ) -> Result<Mechanism, SceneErrors> {
        match &self.order {
            Some(order) if si.iter().all(|value| value.abs() >= LEAST || *value == 0.0) => {
                let mut mechanism = scratch.unwrap_or_else(|| self.base.clone());
                for parameter in order {
                    axes[*parameter].set(&mut mechanism, si[*parameter]);
                }
                let Mechanism { links, points, slides, .. } = &mechanism;
                if links_of_length_zero(links.len(), points, slides).is_empty() {
                    return Ok(mechanism);
                }
            }
            _ => {}
        }
        self.read(axes, numbers)
    }

    /// The mechanism with these values of the parameters, each in the unit of its range.
    pub(crate) fn at(&self, axes: &[Axis], numbers: &[f64]) -> Result<Mechanism, SceneErrors> {
        let si: Vec<f64> = axes.iter().zip(numbers).map(|(axis, number)| axis.si(*number)).collect();
        self.mechanism(axes, numbers, &si, None)
    }

    /// Reads the scene with these values of the parameters, each in the unit of its range.
    pub(crate) fn read(&self, axes: &[Axis], numbers: &[f64]) -> Result<Mechanism, SceneErrors> {
        assur_scene::read(&self.file, &self.text(axes, numbers))
    }

    /// The text of the scene with these values of the parameters, each in the unit of its range.
    pub(crate) fn text(&self, axes: &[Axis], numbers: &[f64]) -> String {
        let texts: Vec<String> = axes.iter().zip(numbers).map(|(axis, number)| axis.toml(*number)).collect();
        let edits = axes.iter().zip(&texts);
        let edits = edits.flat_map(|(axis, text)| axis.spans.iter().map(move |span| (span, text.as_str())));
        replaced(&self.scene, edits)
    }

    /// The mechanism of a point at which as few parameters as possible are zero, so that no load or mass is missing there;
    /// `None` if the reader accepts none of those that are tried.
    pub(crate) fn richest(&self, axes: &[Axis]) -> Option<Mechanism> {
        let ends = |first: fn(&Axis) -> [f64; 2]| -> Vec<f64> {
            axes.iter()
                .map(|axis| first(axis).into_iter().find(|end| *end != 0.0).unwrap_or(axis.from))
                .collect()
        };
        let tried = [ends(|axis| [axis.to, axis.from]), ends(|axis| [axis.from, axis.to])];
        tried.iter().find_map(|numbers| self.at(axes, numbers).ok())
    }

    /// Whether the mechanisms are made by setting numbers.
    pub(crate) fn sets_numbers(&self) -> bool {
        self.order.is_some()
    }
}
