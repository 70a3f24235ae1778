//! Harmonics over a cycle.

use std::f64::consts::TAU;

use crate::data::Harmonic;
use crate::samples::Sample;

/// Greatest order that is given.
const GREATEST: usize = 12;

/// Harmonics of samples that are equally spaced over a cycle of this length.
pub(crate) fn harmonics(samples: &[Sample], period: f64) -> Vec<Harmonic> {
    let count = samples.len() as f64;
    let of = |order: usize| {
        let factor = if order == 0 { 1.0 / count } else { 2.0 / count };
        let mut sum = Harmonic { order, ..Harmonic::default() };
        for sample in samples {
            let (sin, cos) = (order as f64 * TAU * sample.coordinate / period).sin_cos();
            let add = |to: &mut [f64; 2], value: f64| {
                to[0] += factor * value * cos;
                to[1] += factor * value * sin;
            };
            add(&mut sum.x, sample.force[0]);
            add(&mut sum.y, sample.force[1]);
            add(&mut sum.moment, sample.moment);
            add(&mut sum.torque, sample.torque);
        }
        sum
    };
    (0..=GREATEST).map(of).collect()
}
