//! The shaking force over the whole cycle: samples that are close where it changes quickly, and what is greatest between
//! them.

use assur_kinematics::PositionError;
use assur_number::{ROUNDING, elementary, search};

use crate::samples::{Sample, Sampler};

/// An interval is halved until the values in its middle differ by less than this part of the greatest from the line
/// between its ends, so that no peak is narrower than the samples.
const STRAIGHT: f64 = 0.02;

/// How often an interval is halved at most: a jump of an acceleration is then enclosed in 1/4096 of it.
const HALVINGS: u32 = 12;

/// Golden sections of the search between samples: they reduce an interval to 4e-6 of its width, and what a smooth top loses
/// by the square of that, to less than rounding.
const SECTIONS: usize = 26;

/// A quantity whose values differ by less than this part of the greatest is constant: its tops are rounding.
const CONSTANT: f64 = ROUNDING;

/// Force and moment on the ground over the cycle.
pub(crate) struct ShakingCourse<'s, 'a> {
    pub(crate) sampler: &'s mut Sampler<'a>,
    /// In the order of the motion, both ends of the cycle included.
    pub(crate) samples: Vec<Sample>,
}

impl<'s, 'a> ShakingCourse<'s, 'a> {
    /// Halves the intervals between samples, which cover the cycle with both of its ends.
    pub(crate) fn of(sampler: &'s mut Sampler<'a>, given: &[Sample]) -> Result<Self, PositionError> {
        let scales = Scales::of(given);
        let mut course = Self { sampler, samples: given.first().cloned().into_iter().collect() };
        for ends in given.windows(2) {
            course.halve([&ends[0], &ends[1]], &scales, HALVINGS)?;
        }
        Ok(course)
    }

    /// Appends the samples after the first of two up to the second.
    fn halve(&mut self, ends: [&Sample; 2], scales: &Scales, halvings: u32) -> Result<(), PositionError> {
        let [low, high] = ends;
        let middle = self.sampler.at(f64::midpoint(low.coordinate, high.coordinate))?;
        if halvings > 0 && scales.bent(ends, &middle) {
            self.halve([low, &middle], scales, halvings - 1)?;
            return self.halve([&middle, high], scales, halvings - 1);
        }
        self.samples.extend([middle, high.clone()]);
        Ok(())
    }

    /// The greatest value of a quantity over the cycle, found between samples; 0 if it is negative.
    pub(crate) fn greatest(&mut self, of: impl Fn(&Sample) -> f64) -> Result<f64, PositionError> {
        Ok(self.tops(&of)?.iter().map(of).fold(0.0, f64::max))
    }

    /// The places of the greatest value of a quantity, and of those tops that could be greater if they were searched
    /// more finely.
    pub(crate) fn tops(&mut self, of: impl Fn(&Sample) -> f64) -> Result<Vec<Sample>, PositionError> {
        let values: Vec<f64> = self.samples.iter().map(&of).collect();
        let greatest = values.iter().copied().fold(0.0, f64::max);
        let least = values.iter().copied().fold(greatest, f64::min);
        if greatest - least <= CONSTANT * greatest {
            let at = values.iter().position(|&value| value >= greatest);
            return Ok(at.map(|at| self.samples[at].clone()).into_iter().collect());
        }
        let mut found = Vec::new();
        for (i, &value) in values.iter().enumerate() {
            let (before, after) = (i.saturating_sub(1), (i + 1).min(values.len() - 1));
            let drop = value - values[before].min(values[after]);
            // The vertex of the parabola through three samples is above the middle one by a quarter of the drop at most.
            if value >= values[before].max(values[after]) && drop > 0.0 && value + drop >= greatest {
                found.push(self.top(i, [before, after], &of)?);
            }
        }
        Ok(found)
    }

    /// The top near a sample, or the sample if nothing greater is found.
    fn top(
        &mut self,
        at: usize,
        ends: [usize; 2],
        of: impl Fn(&Sample) -> f64,
    ) -> Result<Sample, PositionError> {
        let [low, high] = ends.map(|end| self.samples[end].coordinate);
        let (coordinate, _) =
            search::try_least(low, high, SECTIONS, |q| self.sampler.at(q).map(|sample| -of(&sample)))?;
        let found = self.sampler.at(coordinate)?;
        let sample = &self.samples[at];
        Ok(if of(&found) > of(sample) { found } else { sample.clone() })
    }
}

/// The greatest values over the samples, or what is rounding in them if that is more.
struct Scales {
    force: f64,
    moment: f64,
    /// The greatest size of what a unit counterweight on each carrier adds to force and moment.
    units: Vec<f64>,
}

impl Scales {
    fn of(samples: &[Sample]) -> Self {
        let greatest = |of: &dyn Fn(&Sample) -> f64| samples.iter().map(of).fold(0.0, f64::max);
        let above = |value: f64, terms: f64| value.max(ROUNDING / STRAIGHT * terms);
        let count = samples.first().map_or(0, |sample| sample.units.len());
        Self {
            force: above(
                greatest(&|at| elementary::hypot(at.force[0], at.force[1])),
                greatest(&|at| at.terms.force),
            ),
            moment: above(greatest(&|at| at.moment.abs()), greatest(&|at| at.terms.moment)),
            units: (0..count).map(|i| greatest(&|at| at.units[i].size())).collect(),
        }
    }

    /// Whether the middle of an interval is off the line between its ends.
    fn bent(&self, [low, high]: [&Sample; 2], middle: &Sample) -> bool {
        let off = |of: &dyn Fn(&Sample) -> f64| (of(middle) - f64::midpoint(of(low), of(high))).abs();
        let vector =
            |of: &dyn Fn(&Sample) -> [f64; 2]| elementary::hypot(off(&|at| of(at)[0]), off(&|at| of(at)[1]));
        let unit = |(i, scale): (usize, &f64)| {
            let of = |axis: usize| vector(&move |at| at.units[i].forces[axis]);
            of(0).max(of(1)) > STRAIGHT * scale
        };
        vector(&|at| at.force) > STRAIGHT * self.force
            || off(&|at| at.moment) > STRAIGHT * self.moment
            || self.units.iter().enumerate().any(unit)
    }
}
