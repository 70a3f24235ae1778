//! What was found at a point of a sweep, and how the numbers of its columns are read from it.

use assur_analysis::results::{Column, FrictionCycle, Turn};
use assur_book::Range;
use assur_dynamics::{Instant, Regime, Steady};
use assur_force::Joint;
use assur_geometry::{Extremes, PartCourse};
use assur_mechanism::Input;
use assur_number::{Extreme, Statistic};
use assur_shaking::Size;

use crate::angles::Followed;

/// A number of a position of which there is a statistic.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Gathered {
    /// Least determinant of all groups.
    Health,
    /// Least transmission angle of all groups.
    Transmission,
    /// A coordinate of a point, the displacement of a slide, the continuous angle of a link, or the balancing load.
    Column(Column),
    /// The magnitude of the balancing load.
    BalancingSize,
    /// The greatest force of a pin or slide on one of its links; the statistic at the positions is of its square.
    Force(Joint),
    /// The magnitude of the moment of a slide.
    Moment(Joint),
    /// A column of the results as it is.
    Plain(Column),
}

impl Gathered {
    /// Whether it is the same under all loads.
    fn is_of_places(&self) -> bool {
        match self {
            Self::Column(column) => *column != Column::BALANCING,
            other => matches!(other, Self::Health | Self::Transmission),
        }
    }
}

/// How many links of a pin or slide are looked at for its greatest force: the forces on two links are opposite.
pub(crate) fn ends(joint: &Joint) -> usize {
    if joint.links.len() == 2 { 1 } else { joint.links.len() }
}

/// What was found at a point of a sweep.
#[derive(Debug, Default)]
pub(crate) struct Measured {
    /// Of what is gathered, over the positions.
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
    /// The motion of the points, then of the slides, then of the links between positions; empty where it was not asked for, or
    /// the cycle has a part without a solution.
    pub(crate) courses: Vec<PartCourse>,
    /// The speed of an input whose speed is prescribed and constant, rad/s or m/s.
    pub(crate) speed: Option<f64>,
    /// The shaking force; `None` where it was not asked for, or there is none.
    pub(crate) shaking: Option<Size>,
}

impl Measured {
    /// Memory for what is measured.
    pub(crate) fn new(gathered: &[Gathered]) -> Self {
        Self {
            statistics: vec![Statistic::default(); gathered.len()],
            squares: gathered.iter().map(|of| matches!(of, Gathered::Force(_))).collect(),
            angles: vec![Followed::default(); gathered.len()],
            ..Self::default()
        }
    }

    /// Forgets what belongs to loads and motion, and what belongs to the positions whatever the loads, unless these are the same.
    pub(crate) fn clear(&mut self, gathered: &[Gathered], same_positions: bool) {
        for (statistic, of) in self.statistics.iter_mut().zip(gathered) {
            if !same_positions || !of.is_of_places() {
                *statistic = Statistic::default();
            }
        }
        self.ranges.clear();
        (self.last, self.steady, self.shaking, self.friction) = (None, None, None, None);
        if !same_positions {
            self.angles.fill(Followed::default());
            self.distances.clear();
            self.courses.clear();
        }
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

    /// The greatest value of what is gathered under a number, and its coordinate.
    pub(crate) fn greatest(&self, number: usize) -> Option<[f64; 2]> {
        self.extreme(number, Statistic::greatest, |range| range.greatest)
    }

    /// The least value, and its coordinate.
    pub(crate) fn least(&self, number: usize) -> Option<[f64; 2]> {
        self.extreme(number, Statistic::least, |range| range.least)
    }

    /// Mean and root of the mean square.
    pub(crate) fn means(&self, number: usize) -> [Option<f64>; 2] {
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
