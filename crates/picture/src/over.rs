//! Over what the results of a scene are shown: its positions over the coordinate, or the samples of a motion over time.

use assur_analysis::results::{Column, Table};
use assur_figure::Axis;
use assur_figure::number::plain;
use assur_words::{Text, number, quantity, text};

use crate::plots::coordinate_axis;
use crate::results::series;
use crate::{Found, Look, Results, Series, coordinate_unit};

/// A horizontal axis on which curves stand.
#[derive(Debug, Clone)]
pub struct Base {
    /// The axis.
    pub axis: Axis,
    /// From SI to its unit.
    pub factor: f64,
    /// The present place on it.
    pub cursor: f64,
}

/// Most frames of an animation of a motion over time.
const FRAMES: usize = 48;

/// A coordinate within this fraction of a step from a position counts as that position.
const AT_POSITION: f64 = 1e-6;

impl Results {
    /// Takes the results of the analysis. Of a transient motion its samples are shown in place of the positions.
    pub fn take(&mut self, found: Box<Found>) {
        if let Some(cycle) = self.cycle.take() {
            self.series = cycle;
        }
        if let Some(samples) = &found.samples {
            let (series, _) = series(&self.linkage, samples, &found.edges, Column::TIME);
            self.cycle = Some(std::mem::replace(&mut self.series, series));
            self.broken.clear();
            self.least_health.clear();
        }
        self.arrows.borrow_mut().clear();
        self.found = Some(found);
    }

    /// The coordinate and the transfer functions over the positions, where the samples of a motion over time are shown too.
    pub fn of_cycle(&self) -> &[Series] {
        self.cycle.as_ref().unwrap_or(&self.series)
    }

    /// The samples of a transient motion, which are shown in place of the positions.
    pub fn samples(&self) -> Option<&Table> {
        self.found.as_ref()?.samples.as_ref()
    }

    /// Number of positions, or of samples.
    pub fn positions(&self) -> usize {
        self.samples().map_or(self.linkage.mechanism.input.positions, Table::len)
    }

    /// The coordinate (rad or m) of a position or sample.
    pub fn coordinate(&self, index: usize) -> f64 {
        match self.samples() {
            Some(_) => self.series[0].course.get(index).unwrap_or(f64::NAN),
            None => self.linkage.mechanism.input.coordinate(index),
        }
    }

    /// The place (rad, m, or s) of a position or sample on horizontal axes, with a fraction between two of them.
    fn place_at(&self, at: f64) -> f64 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the number of a position"
        )]
        let whole = (at.max(0.0) as usize).min(self.positions().saturating_sub(1));
        let place = |index: usize| match self.samples() {
            Some(samples) => samples.get(index, Column::TIME).unwrap_or(f64::NAN),
            None => self.linkage.mechanism.input.coordinate(index),
        };
        let (from, part) = (place(whole), at - whole as f64);
        if part > 0.0 { from + part * (place(whole + 1) - from) } else { from }
    }

    /// The unit of horizontal axes, and its factor from SI.
    pub fn axis_unit(&self) -> (&'static str, f64) {
        if self.samples().is_some() { ("s", 1.0) } else { coordinate_unit(&self.linkage) }
    }

    /// The horizontal axis of curves over the positions, or over the time of the samples.
    pub fn base(&self, look: &Look<'_>) -> Base {
        let (_, factor) = self.axis_unit();
        let axis = || {
            let ends = [0, self.positions() - 1].map(|index| self.place_at(index as f64));
            Axis::around(text!("motion-time"), ends, 0.0).of_coordinate("s")
        };
        let axis = if self.samples().is_some() { axis() } else { coordinate_axis(&self.linkage) };
        Base { axis, factor, cursor: self.on_axis(look.at()) }
    }

    /// The horizontal axis of curves over the positions, with the cursor at the place of a sample in the cycle.
    pub(crate) fn base_of_cycle(&self, look: &Look<'_>) -> Base {
        if self.samples().is_none() {
            return self.base(look);
        }
        let (input, factor) = (&self.linkage.mechanism.input, coordinate_unit(&self.linkage).1);
        let cursor = match input.period() {
            Some(period) => input.from + input.sign() * period * self.part_of_cycle(look),
            None => self.coordinate(look.position),
        };
        Base { axis: coordinate_axis(&self.linkage), factor, cursor: factor * cursor }
    }

    /// The part of the cycle that has passed, from 0 to 1.
    pub(crate) fn part_of_cycle(&self, look: &Look<'_>) -> f64 {
        let input = &self.linkage.mechanism.input;
        match (self.samples(), input.period()) {
            (Some(_), Some(period)) => {
                (input.sign() * (self.coordinate(look.position) - input.from) / period).rem_euclid(1.0)
            }
            _ => look.at() / (self.positions() - usize::from(!self.is_cycle())).max(1) as f64,
        }
    }

    /// Whether the positions are those of a cycle, whose end is no position of its own.
    pub fn is_cycle(&self) -> bool {
        self.samples().is_none() && self.linkage.mechanism.input.is_cycle()
    }

    /// The positions of an animation: all that can be assembled, or so many samples that an animation can show them.
    pub fn frames(&self) -> impl Iterator<Item = usize> {
        let step = self.samples().map_or(1, |samples| samples.len().div_ceil(FRAMES).max(1));
        self.assembled().step_by(step)
    }

    /// The place of a position or sample on horizontal axes, with a fraction between two of them, in the unit that is shown.
    pub fn on_axis(&self, at: f64) -> f64 {
        self.axis_unit().1 * self.place_at(at)
    }

    /// The position nearest to a coordinate (rad or m), or the sample nearest to a time (s).
    pub fn nearest(&self, at: f64) -> usize {
        let end = self.positions() - usize::from(!self.is_cycle());
        let distance = |number: &usize| (self.place_at(*number as f64) - at).abs();
        let near = (0..=end).min_by(|one, other| distance(one).total_cmp(&distance(other)));
        // The end of a cycle is its first position again.
        near.unwrap_or(0) % self.positions()
    }

    /// The position or sample that is nearest in its cycle to a coordinate, rad or m: of samples the first one.
    pub fn nearest_in_cycle(&self, at: f64) -> usize {
        let Some(period) = self.samples().and(self.linkage.mechanism.input.period()) else {
            return self.nearest(at);
        };
        let apart = |number: &usize| {
            let turns = (self.coordinate(*number) - at) / period;
            (turns - turns.round()).abs()
        };
        (0..self.positions()).min_by(|one, other| apart(one).total_cmp(&apart(other))).unwrap_or(0)
    }

    /// The positions between which a coordinate, rad or m, lies, twice the same one where it lies in it; `closes`: whether the end of
    /// the cycle is its first position.
    pub fn among(&self, at: f64, closes: bool) -> [usize; 2] {
        let count = self.positions();
        let [first, next] = [0, 1].map(|index| self.coordinate(index));
        let part = (at - first) / (next - first);
        let is_end = !closes && part > count as f64 - 0.5;
        if !is_end && (part - part.round()).abs() <= AT_POSITION {
            return [self.nearest(at); 2];
        }
        let before = (0..count).rev().find(|number| *number as f64 <= part).unwrap_or(0);
        [before, (before + 1) % count]
    }

    /// `position 6, 45 deg`, `instant 6, 1.2 s, 45 deg`.
    pub fn place(&self, position: usize) -> Text {
        let series = &self.series[0];
        let (at, position_number) =
            (quantity(plain(series.at(position)), series.unit.name), number(position));
        match self.time(position) {
            Some(time) => text!("instant-at", instant = position_number, time = time, at = at),
            None => text!("position-at", position = position_number, at = at),
        }
    }

    /// The time of a sample from the start of its motion; `None` for positions.
    pub fn time(&self, sample: usize) -> Option<Text> {
        let time = self.samples()?.get(sample, Column::TIME)?;
        Some(quantity(plain(time), "s"))
    }
}
