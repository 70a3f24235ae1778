//! What was found at a point of a sweep, and how the numbers of its columns are read from it.

use assur_analysis::results::{Column, FrictionCycle, Turn};
use assur_book::Range;
use assur_dynamics::{Instant, Regime, Steady};
use assur_force::Joint;
use assur_geometry::{Extremes, PartCourse};
use assur_kinematics::{LanePosition, Linkage, continuous_angle, first_angle};
use assur_mechanism::{Input, LinkId};
use assur_number::{Extreme, Lanes, Statistic, elementary};
use assur_shaking::Size;

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
    BalancingSize(Column),
    /// The greatest force of a pin or slide on one of its links; the statistic at the positions is of its square.
    Force(Joint),
    /// The magnitude of the moment of a slide.
    Moment(Joint),
    /// A column of the results as it is.
    Plain(Column),
}

impl Gathered {
    /// Whether it depends on the positions only, so that it is kept while only loads change.
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
    /// Which of the statistics are of squared values.
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

/// An angle that differs by more than this (rad) from what the transfer functions at both ends of a step let expect is
/// not joined over the whole step.
const UNCLEAR: f64 = 0.5;

/// The angle of a link, followed along the coordinate.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Followed {
    /// Coordinate, angle (rad) and its derivative in the last position; `None` before the first.
    last: Option<[f64; 3]>,
}

impl Followed {
    /// The angle (rad) in those of eight solved positions that are marked: in (-pi, pi] in the first one of all, then continuous.
    pub(crate) fn follow(
        &mut self,
        (linkage, link): (&Linkage, LinkId),
        position: &LanePosition,
        valid: [bool; Lanes::WIDTH],
    ) -> Lanes {
        let body = &position.bodies[link];
        let mut angles = Lanes::default();
        for lane in (0..Lanes::WIDTH).filter(|&lane| valid[lane]) {
            let [c, s, rate, to] = [body.c, body.s, body.w1, position.coordinates].map(|of| of.0[lane]);
            let plain = elementary::atan2(s, c);
            let angle = self.last.map_or_else(
                || first_angle(plain),
                |[from, angle, before]| {
                    let expected = angle + 0.5 * (before + rate) * (to - from);
                    let joined = continuous_angle(plain, expected);
                    // Comparing this way round, an angle that is not a number is unclear too.
                    let is_clear = (joined - expected).abs() <= UNCLEAR;
                    if is_clear { joined } else { in_steps(linkage, link, [from, to], angle, plain) }
                },
            );
            self.last = Some([to, angle, rate]);
            angles.0[lane] = angle;
        }
        angles
    }
}

/// The angle of a link at the end of a step, joined in short steps to that at its start; where the mechanism can't be
/// assembled in between, the nearest angle is used.
fn in_steps(linkage: &Linkage, link: LinkId, ends: [f64; 2], start: f64, end: f64) -> f64 {
    let mut angle = start;
    linkage.each_between(ends, |position| {
        let body = &position.bodies[link];
        angle = continuous_angle(elementary::atan2(body.s, body.c), angle);
    });
    continuous_angle(end, angle)
}
