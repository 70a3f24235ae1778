//! A second scene beside the open one: its curves, and the differences.

use super::series::Series;
use super::state::State;
use super::study::Study;
use super::text::fill;
use super::theme::Role;

/// The second scene.
#[derive(Debug)]
pub(crate) struct Compared {
    pub(crate) name: String,
    study: Box<Study>,
}

impl Compared {
    /// The same quantity of the second scene, in the same unit.
    pub(crate) fn series(&self, own: &Series) -> Option<&Series> {
        self.study.series.iter().find(|other| other.short == own.short && other.unit == own.unit)
    }

    /// Own value less that of the second scene; NaN where one has none.
    pub(crate) fn difference(&self, own: &Series, position: usize) -> Option<f64> {
        let other = self.series(own)?;
        Some(own.values.get(position)? - other.values.get(position)?)
    }
}

impl State {
    /// Takes a second scene; one that has other positions can't be compared.
    pub(crate) fn take_compared(&mut self, other: Result<Box<Study>, String>) {
        let Some(study) = &self.study else { return };
        match other {
            Ok(other) if other.positions() == study.positions() => {
                let mut name = other.source.short_name();
                if name == study.source.short_name() {
                    name = other.source.name();
                }
                self.compared = Some(Compared { name, study: other });
            }
            Ok(other) => {
                let text = fill(
                    self.texts.other_positions,
                    &[&other.source.short_name(), &other.positions(), &study.positions()],
                );
                self.say(Role::Bad, text);
            }
            Err(text) => self.fault = Some((self.texts.fault_title, text)),
        }
    }
}
