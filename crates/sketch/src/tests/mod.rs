//! Building in steps, judged by what the program makes of the text.

mod adding;
mod changing;
mod placing;
mod settled;

use assur_all as _;

use assur_mechanism::Mechanism;

use crate::{Sketch, sketch};

/// Numbers from a seed.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub(crate) fn pick<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        let bits = self.unit().to_bits() >> 8;
        &all[usize::try_from(bits).unwrap() % all.len()]
    }
}

pub(crate) fn read(text: &str) -> Mechanism {
    match assur_scene::reading("built.toml", text) {
        Ok(reading) => reading.mechanism,
        Err(errors) => panic!("{errors}\n{text}"),
    }
}

pub(crate) fn drawn(text: &str) -> Sketch {
    sketch(&read(text))
}
