//! The mechanism of each point of a sweep.
//!
//! The scene is read once. Where a parameter stands in the mechanism is found by reading the scene with two values of
//! it: its places are the numbers that have these values, with the same or with the other sign. A parameter that
//! changes anything else (a count, a table, the kind of a load), or whose ends are not both accepted, has no such
//! places; then every point is read from the text of the scene with its values in it, which always holds and takes
//! longer.

use assur_mechanism::{Mechanism, links_of_length_zero};
use assur_scene::edit::replaced;
use assur_scene::{LEAST, SceneErrors};

use crate::axis::Axis;

/// The scene with its parameters.
#[derive(Debug, Clone)]
pub(crate) struct Variants {
    file: String,
    scene: String,
    /// Where the parameters stand, if setting numbers is enough.
    places: Option<Places>,
}

/// A mechanism and the places of the parameters in it.
#[derive(Debug, Clone)]
struct Places {
    /// The mechanism with the first value of each parameter.
    mechanism: Mechanism,
    /// In the order of [`Mechanism::visit_numbers`].
    setters: Vec<Setter>,
}

/// One place of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Setter {
    /// Index of the number among those that are visited.
    number: usize,
    /// Index of the parameter.
    parameter: usize,
    /// The number is the negative of the parameter.
    negative: bool,
}

impl Variants {
    /// Finds the places of the parameters.
    pub(crate) fn of(file: &str, scene: &str, axes: &[Axis]) -> Self {
        let mut variants = Self { file: file.to_owned(), scene: scene.to_owned(), places: None };
        variants.places = Places::of(&variants, axes);
        variants
    }

    /// The mechanism with these values of the parameters, each in the unit of its range and in SI, by setting numbers
    /// in `scratch`, which was returned by an earlier call, or by reading the text.
    ///
    /// # Errors
    ///
    /// The faults that the reader of scenes finds.
    pub(crate) fn mechanism(
        &self,
        axes: &[Axis],
        numbers: &[f64],
        si: &[f64],
        scratch: Option<Mechanism>,
    ) -> Result<Mechanism, SceneErrors> {
        match &self.places {
            Some(places) if si.iter().all(|value| value.abs() >= LEAST || *value == 0.0) => {
                let mechanism = places.with(si, scratch);
                let Mechanism { links, points, slides, .. } = &mechanism;
                if links_of_length_zero(links.len(), points, slides).is_empty() {
                    return Ok(mechanism);
                }
            }
            _ => {}
        }
        self.read(axes, numbers)
    }

    /// Reads the scene with these values of the parameters, each in the unit of its range.
    ///
    /// # Errors
    ///
    /// The faults that the reader of scenes finds.
    pub(crate) fn read(&self, axes: &[Axis], numbers: &[f64]) -> Result<Mechanism, SceneErrors> {
        let texts: Vec<String> = axes.iter().zip(numbers).map(|(axis, number)| axis.toml(*number)).collect();
        let edits = axes.iter().zip(&texts);
        let edits = edits.flat_map(|(axis, text)| axis.spans.iter().map(move |span| (span, text.as_str())));
        assur_scene::read(&self.file, &replaced(&self.scene, edits))
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
        tried.iter().find_map(|numbers| self.read(axes, numbers).ok())
    }

    /// The text of the scene.
    pub(crate) fn scene(&self) -> &str {
        &self.scene
    }

    /// Whether the mechanisms are made by setting numbers.
    pub(crate) fn sets_numbers(&self) -> bool {
        self.places.is_some()
    }
}

impl Places {
    fn of(variants: &Variants, axes: &[Axis]) -> Option<Self> {
        let mut values: Vec<f64> = axes.iter().map(|axis| axis.from).collect();
        let mut mechanism = variants.read(axes, &values).ok()?;
        let first = numbers(&mut mechanism);
        let mut setters = Vec::new();
        for (parameter, axis) in axes.iter().enumerate() {
            let [from, to] = [axis.from, axis.to].map(|end| axis.si(end));
            values[parameter] = axis.to;
            let mut other = variants.read(axes, &values).ok()?;
            values[parameter] = axis.from;
            for (number, pair) in first.iter().zip(numbers(&mut other)).enumerate() {
                let same = |sign: f64| equal(*pair.0, sign * from) && equal(pair.1, sign * to);
                if !equal(*pair.0, pair.1) {
                    let negative = same(-1.0);
                    if !negative && !same(1.0) {
                        return None;
                    }
                    setters.push(Setter { number, parameter, negative });
                }
            }
            let mut si: Vec<f64> = axes.iter().map(|axis| axis.si(axis.from)).collect();
            si[parameter] = to;
            setters.sort_unstable_by_key(|setter| setter.number);
            let places = Self { mechanism, setters };
            if places.with(&si, None) != other {
                return None;
            }
            Self { mechanism, setters } = places;
        }
        Some(Self { mechanism, setters })
    }

    /// The mechanism with these values of the parameters, SI.
    fn with(&self, si: &[f64], scratch: Option<Mechanism>) -> Mechanism {
        let mut mechanism = scratch.unwrap_or_else(|| self.mechanism.clone());
        let mut index = 0;
        let mut setters = self.setters.iter().peekable();
        mechanism.visit_numbers(|number| {
            while let Some(setter) = setters.next_if(|setter| setter.number == index) {
                let value = si[setter.parameter];
                *number = if setter.negative { -value } else { value };
            }
            index += 1;
        });
        mechanism
    }
}

fn numbers(mechanism: &mut Mechanism) -> Vec<f64> {
    let mut all = Vec::new();
    mechanism.visit_numbers(|number| all.push(*number));
    all
}

fn equal(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}
