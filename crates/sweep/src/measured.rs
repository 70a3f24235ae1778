//! What was found at a point of a sweep.

use assur_analysis::results::{FrictionCycle, Turn};
use assur_book::Range;
use assur_dynamics::{Instant, Regime, Steady};
use assur_geometry::Extremes;
use assur_mechanism::Input;
use assur_number::{Extreme, Statistic};
use assur_shaking::Size;

use crate::angles::Followed;
use crate::between::PartCourse;
use crate::layout::{Find, Gathered, Layout};

/// What was found at a point of a sweep.
#[derive(Debug, Default)]
pub(crate) struct Measured {
    /// Of what the layout gathers, over the positions.
    pub(crate) statistics: Vec<Statistic>,
    /// Which of them are of squares.
    squares: Vec<bool>,
    /// Of an angle that is gathered: how it continues.
    pub(crate) angles: Vec<Followed>,
    /// What is gathered, between the positions too; empty where that was not asked for.
    pub(crate) ranges: Vec<Option<Range>>,
    /// The distances of points from places between positions; empty where the cycle has a part without a solution.
    pub(crate) distances: Vec<Extremes>,
    /// The input, which gives the coordinates of the positions.
    pub(crate) input: Option<Input>,
    /// The last state of a transient motion.
    pub(crate) last: Option<Instant>,
    pub(crate) steady: Option<Box<Steady>>,
    /// Dry friction over the cycle.
    pub(crate) friction: Option<FrictionCycle>,
    /// The motion of points, slides and links between positions; empty where it was not asked for, or the cycle has a part without a
    /// solution.
    pub(crate) courses: Vec<PartCourse>,
    /// The speed of an input whose speed is prescribed and constant, rad/s or m/s.
    pub(crate) speed: Option<f64>,
    /// The shaking force; `None` where it was not asked for, or there is none.
    pub(crate) shaking: Option<Size>,
}

/// Numbers of a statistic, by its number.
pub(crate) const LEAST: Find = |found, number| Some(found.least(number)?[0]);
pub(crate) const LEAST_AT: Find = |found, number| Some(found.least(number)?[1]);
pub(crate) const GREATEST: Find = |found, number| Some(found.greatest(number)?[0]);
pub(crate) const GREATEST_AT: Find = |found, number| Some(found.greatest(number)?[1]);
pub(crate) const TRAVEL: Find = |found, number| Some(found.greatest(number)?[0] - found.least(number)?[0]);
pub(crate) const MEAN: Find = |found, number| found.means(number)[0];
pub(crate) const RMS: Find = |found, number| found.means(number)[1];

impl Measured {
    /// Memory for what is measured.
    pub(crate) fn new(layout: &Layout) -> Self {
        let count = layout.gathered.len();
        Self {
            statistics: vec![Statistic::default(); count],
            squares: layout.gathered.iter().map(|of| matches!(of, Gathered::Force(_))).collect(),
            angles: vec![Followed::default(); count],
            ..Self::default()
        }
    }

    /// Forgets what belongs to the positions whatever the loads.
    pub(crate) fn clear_positions(&mut self, layout: &Layout) {
        self.clear(layout, Gathered::is_of_places);
        self.angles.fill(Followed::default());
        self.distances.clear();
        self.courses.clear();
    }

    /// Forgets what belongs to loads and motion.
    pub(crate) fn clear_forces(&mut self, layout: &Layout) {
        self.clear(layout, |of| !of.is_of_places());
        self.ranges.clear();
        (self.last, self.steady, self.shaking, self.friction) = (None, None, None, None);
    }

    fn clear(&mut self, layout: &Layout, wanted: impl Fn(&Gathered) -> bool) {
        let of = self.statistics.iter_mut().zip(&layout.gathered);
        of.filter(|(_, of)| wanted(of)).for_each(|(statistic, _)| *statistic = Statistic::default());
    }

    /// An extreme with its coordinate, rad or m; none where it grows without limit.
    fn extreme(
        &self,
        number: usize,
        at_positions: fn(&Statistic) -> Option<Extreme>,
        between: fn(&Range) -> Turn,
    ) -> Option<[f64; 2]> {
        if let Some(range) = self.ranges.get(number) {
            let Turn { value, at, .. } = between(range.as_ref()?);
            return value.is_finite().then_some([value, at]);
        }
        let found = at_positions(&self.statistics[number])?;
        let value = if self.squares[number] { found.value.sqrt() } else { found.value };
        Some([value, self.input.as_ref()?.coordinate(found.number)])
    }

    fn greatest(&self, number: usize) -> Option<[f64; 2]> {
        self.extreme(number, Statistic::greatest, |range| range.greatest)
    }

    fn least(&self, number: usize) -> Option<[f64; 2]> {
        self.extreme(number, Statistic::least, |range| range.least)
    }

    /// Mean and root of the mean square.
    fn means(&self, number: usize) -> [Option<f64>; 2] {
        if let Some(range) = self.ranges.get(number) {
            let means = range.as_ref().and_then(|range| range.means);
            return [means.map(|means| means.mean), means.map(|means| means.rms)];
        }
        let found = &self.statistics[number];
        if self.squares[number] { [None, found.mean().map(f64::sqrt)] } else { [found.mean(), found.rms()] }
    }

    /// The periodic regime.
    pub(crate) fn regime(&self) -> Option<&Regime> {
        self.steady.as_ref().map(|found| &found.regime)
    }
}
