//! A quantity over the cycle: its greatest and least values, and where it rests.

use assur_group::Order;
use assur_kinematics::{Linkage, Position, PositionError, continuous_angle};
use assur_mechanism::{self as mechanism, Mechanism, Range};
use assur_number::{elementary, search};
use serde::Serialize;

/// A quantity whose values differ by less than this part of the largest one is constant.
const CONSTANT: f64 = 1e-11;

/// Part of its largest size below which a derivative is zero.
const ZERO: f64 = 1e-9;

/// Local maxima of the samples within this part of the range from the greatest are searched for the greatest value.
const NEAR_GREATEST: f64 = 0.02;

/// Golden sections of the search for an extreme without derivative: down to rounding of the value.
const SECTIONS: usize = 45;

/// Least and greatest value of a quantity over the cycle, found between positions.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Extremes {
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
    /// Coordinate of the least value, rad or m.
    pub at_min: f64,
    /// Coordinate of the greatest value, rad or m.
    pub at_max: f64,
}

impl Extremes {
    /// From the least value to the greatest.
    pub fn range(&self) -> f64 {
        self.max - self.min
    }

    /// The greatest magnitude.
    pub fn size(&self) -> f64 {
        self.min.abs().max(self.max.abs())
    }
}

/// Value of a vector and its first two derivatives with respect to the coordinate.
pub(crate) type Motion<const N: usize> = [[f64; N]; 3];

/// A vector over the cycle.
pub(crate) struct VectorCourse<'a, const N: usize> {
    pub(crate) cycle: &'a Cycle<'a>,
    of: Box<dyn Fn(&Position) -> Motion<N> + 'a>,
    /// Its values at the samples of the cycle.
    pub(crate) samples: Vec<Motion<N>>,
    angular: bool,
}

/// A position in which a quantity has no speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rest {
    pub(crate) coordinate: f64,
    /// Whether the motion goes back from there; otherwise it pauses and goes on.
    pub(crate) reverses: bool,
}

impl<'a, const N: usize> VectorCourse<'a, N> {
    /// A vector that is a function of the position.
    pub(crate) fn of(cycle: &'a Cycle<'a>, of: impl Fn(&Position) -> Motion<N> + 'a) -> Self {
        let samples = cycle.samples.iter().map(&of).collect();
        Self { cycle, of: Box::new(of), samples, angular: false }
    }

    /// An angle, which becomes continuous over the cycle.
    pub(crate) fn angle(cycle: &'a Cycle<'a>, of: impl Fn(&Position) -> Motion<N> + 'a) -> Self {
        let mut course = Self::of(cycle, of);
        for i in 1..course.samples.len() {
            let near = course.samples[i - 1][0][0];
            let angle = &mut course.samples[i][0][0];
            *angle = continuous_angle(*angle, near);
        }
        Self { angular: true, ..course }
    }

    /// Its value at any coordinate near a sample.
    pub(crate) fn at(
        &self,
        coordinate: f64,
        sample: usize,
        position: &mut Position,
    ) -> Result<Motion<N>, PositionError> {
        self.cycle.linkage.solve(coordinate, Order::Second, position)?;
        let mut motion = (self.of)(position);
        if self.angular {
            motion[0][0] = continuous_angle(motion[0][0], self.samples[sample][0][0]);
        }
        Ok(motion)
    }

    /// Least and greatest value of a part: its value and its first two derivatives, NaN where one is not known.
    pub(crate) fn extremes(&self, part: impl Fn(&Motion<N>) -> [f64; 3]) -> Result<Extremes, PositionError> {
        let (at_max, max) = self.greatest(&part)?;
        let (at_min, least) = self.greatest(|motion| part(motion).map(|x| -x))?;
        let inside = |coordinate| self.cycle.inside(coordinate);
        Ok(Extremes { min: -least, max, at_min: inside(at_min), at_max: inside(at_max) })
    }

    /// Coordinate and size of the greatest value of a part.
    fn greatest(&self, part: impl Fn(&Motion<N>) -> [f64; 3]) -> Result<(f64, f64), PositionError> {
        let values: Vec<f64> = self.samples.iter().map(|motion| part(motion)[0]).collect();
        let coordinate = |sample: usize| self.cycle.samples[sample].coordinate;
        let (mut best, mut least) = (0, f64::INFINITY);
        for (i, &value) in values.iter().enumerate() {
            least = least.min(value);
            if value > values[best] {
                best = i;
            }
        }
        let range = values[best] - least;
        let mut found = (coordinate(best), values[best]);
        if range <= CONSTANT * values[best].abs().max(least.abs()) {
            // The samples are shifted against the first position.
            return Ok((self.cycle.linkage.mechanism.input.from, values[best]));
        }
        let last = values.len() - 1;
        let mut position = self.cycle.linkage.position();
        // The first sample of a closed cycle is the last one as well.
        for i in usize::from(self.cycle.period.is_some())..=last {
            let before = i.saturating_sub(1);
            let next = match (i == last, self.cycle.period) {
                (false, _) => (i + 1, coordinate(i + 1)),
                (true, Some(period)) => (1, coordinate(1) + period),
                (true, None) => (i, coordinate(i)),
            };
            let is_top = (i == 0 || values[i] > values[before]) && values[i] >= values[next.0];
            if !is_top || values[i] < values[best] - NEAR_GREATEST * range {
                continue;
            }
            let mut value = |q: f64| Ok::<_, PositionError>(part(&self.at(q, i, &mut position)?));
            let [low, high] = [coordinate(before), next.1];
            let at = if value(low)?[1] > 0.0 && value(high)?[1] < 0.0 {
                search::try_newton_root(low, high, |q| value(q).map(|[_, slope, bend]| (slope, bend)))?
            } else {
                search::try_least(low, high, SECTIONS, |q| value(q).map(|[value, ..]| -value))?.0
            };
            let top = value(at)?[0];
            if top > found.1 {
                found = (at, top);
            }
        }
        Ok(found)
    }

    /// Whether it rests over the whole cycle; `unit`: a derivative that counts as motion.
    pub(crate) fn rests_always(&self, unit: f64) -> bool {
        self.largest_derivative() <= CONSTANT * unit
    }

    fn largest_derivative(&self) -> f64 {
        self.samples.iter().map(|motion| product(&motion[1], &motion[1]).sqrt()).fold(0.0, f64::max)
    }

    /// The positions of rest, in the order of the motion, without any where it [rests always](Self::rests_always). The square of the
    /// first derivative has a minimum in each.
    pub(crate) fn rests(&self, unit: f64) -> Result<Vec<Rest>, PositionError> {
        if self.rests_always(unit) {
            return Ok(Vec::new());
        }
        let zero = ZERO * self.largest_derivative();
        let slope = |motion: &Motion<N>| product(&motion[1], &motion[2]);
        let mut position = self.cycle.linkage.position();
        let mut found = Vec::new();
        for (i, pair) in self.samples.windows(2).enumerate() {
            if !(slope(&pair[0]) < 0.0 && slope(&pair[1]) >= 0.0) {
                continue;
            }
            let [low, high] = [i, i + 1].map(|sample| self.cycle.samples[sample].coordinate);
            let coordinate = search::try_newton_root(low, high, |q| {
                let motion = self.at(q, i, &mut position)?;
                Ok((slope(&motion), product(&motion[2], &motion[2])))
            })?;
            let motion = self.at(coordinate, i, &mut position)?;
            if product(&motion[1], &motion[1]).sqrt() <= zero {
                // At rest in a sample, the motion goes on as in the next one.
                let rests = product(&pair[1][1], &pair[1][1]).sqrt() <= zero;
                let after = self.samples.get(i + 2).filter(|_| rests).unwrap_or(&pair[1]);
                let reverses = product(&pair[0][1], &after[1]) < 0.0;
                found.push(Rest { coordinate: self.cycle.inside(coordinate), reverses });
            }
        }
        self.add_turns_at_jumps(zero, &mut found)?;
        let input = &self.cycle.linkage.mechanism.input;
        found.sort_by(|a, b| (input.sign() * a.coordinate).total_cmp(&(input.sign() * b.coordinate)));
        Ok(found)
    }
}

impl<const N: usize> VectorCourse<'_, N> {
    /// Adds the instants at which the speed of a drive jumps and the motion goes back from there: they are no rests. `zero`: a derivative
    /// up to which nothing moves.
    fn add_turns_at_jumps(&self, zero: f64, found: &mut Vec<Rest>) -> Result<(), PositionError> {
        let (input, samples) = (&self.cycle.linkage.mechanism.input, &self.cycle.samples);
        let [from, to] = [0, samples.len() - 1].map(|sample| samples[sample].coordinate);
        let beside = BESIDE_JUMPS * (to - from);
        let mut position = self.cycle.linkage.position();
        let laws = input.drivers.iter().filter_map(|driver| driver.law.as_ref());
        for (time, _) in laws.flat_map(|law| law.breaks().take(INTERVALS)) {
            let sample = samples.partition_point(|sample| sample.coordinate < time).min(samples.len() - 1);
            let before = self.at(time - beside, sample, &mut position)?[1];
            let after = self.at(time + beside, sample, &mut position)?[1];
            let moves = [before, after].iter().all(|rate| product(rate, rate).sqrt() > zero);
            let is_known = found.iter().any(|rest| (rest.coordinate - time).abs() <= beside);
            if moves && !is_known && product(&before, &after) < 0.0 {
                found.push(Rest { coordinate: time, reverses: true });
            }
        }
        Ok(())
    }
}

/// Part of the motion by which the speeds on either side of a jump are taken beside it: more than that within which an instant is at it.
const BESIDE_JUMPS: f64 = 1e-7;

fn product<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Intervals between sampled coordinates: two dead points of one quantity are rarely nearer than half a degree.
const INTERVALS: usize = 720;

/// Part of an interval by which the samples of a closed cycle are shifted, so that dead points in symmetric positions lie
/// between samples.
const SHIFT: f64 = 0.381_966;

/// Difference of poses, in typical lengths, below which the mechanism has returned to its first position.
const RETURNED: f64 = 1e-9;

/// The sampled cycle of a mechanism.
#[derive(Debug)]
pub(crate) struct Cycle<'a> {
    pub(crate) linkage: &'a Linkage,
    /// Increasing coordinates; those of a closed cycle cover it once, the last repeats the first.
    pub(crate) samples: Vec<Position>,
    /// Length of the cycle if the mechanism has returned at its end.
    pub(crate) period: Option<f64>,
}

impl<'a> Cycle<'a> {
    /// Solves the mechanism over the cycle (or range) of its scene.
    pub(crate) fn of(linkage: &'a Linkage) -> Result<Self, PositionError> {
        let input = &linkage.mechanism.input;
        let [_, end] = input.ends();
        let length = match input.range {
            Range::Cycle(length) => length,
            Range::To(to) => (to - input.from).abs(),
        };
        let at = |coordinate: f64| {
            let mut position = linkage.position();
            linkage.solve(coordinate, Order::Second, &mut position).map(|()| position)
        };
        let cyclic = input.is_cycle() && returned(&at(input.from)?, &at(end)?, linkage);
        let step = length / INTERVALS as f64;
        let start = input.from.min(end) + if cyclic { SHIFT * step } else { 0.0 };
        let samples = (0..=INTERVALS).map(|i| at(start + step * i as f64)).collect::<Result<_, _>>()?;
        Ok(Self { linkage, samples, period: cyclic.then_some(length) })
    }

    /// A coordinate moved by whole cycles to where the scene counts its positions from; rounding before the first
    /// position is taken away.
    pub(crate) fn inside(&self, coordinate: f64) -> f64 {
        let Some(period) = self.period else { return coordinate };
        let input = &self.linkage.mechanism.input;
        let way = (input.sign() * (coordinate - input.from)).rem_euclid(period);
        let rounding = 8.0 * f64::EPSILON * (period + input.from.abs());
        if way < rounding || period - way < rounding { input.from } else { input.from + input.sign() * way }
    }
}

fn returned(first: &Position, last: &Position, linkage: &Linkage) -> bool {
    let scale = linkage.structure.scale;
    first.bodies.iter().zip(&last.bodies).all(|(a, b)| {
        let apart =
            (elementary::hypot(a.x - b.x, a.y - b.y) / scale).max(elementary::hypot(a.c - b.c, a.s - b.s));
        apart <= RETURNED
    })
}

/// The stroke of a slide, of a rocking link, or of a point that goes to and fro on its path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stroke {
    /// Displacement between the dead points, m; of a link its angle of swing, rad; of a point the distance between its
    /// farthest dead points, m.
    pub stroke: f64,
    /// Coordinates of the dead points, where the motion reverses, rad or m, in the order of the motion.
    pub dead_points: Vec<f64>,
    /// For two dead points in a closed cycle: the intervals of the coordinate from the first to the second and from the
    /// second to the first, rad or m, positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub intervals: Option<[f64; 2]>,
    /// The longer interval over the shorter one: the ratio of the times of the two strokes at constant input speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_ratio: Option<f64>,
    /// Angle of overlap: half the difference of the intervals, rad or m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub overlap: Option<f64>,
    /// Mean speeds over the two intervals for a prescribed constant input speed, m/s or rad/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_speeds: Option<[f64; 2]>,
}

impl Stroke {
    /// The stroke between the positions of rest of a quantity with its displacement; `None` where the quantity does not go to and
    /// fro.
    pub(crate) fn of(
        rests: &[Rest],
        period: Option<f64>,
        mechanism: &Mechanism,
        stroke: f64,
    ) -> Option<Self> {
        let dead = rests.iter().filter(|rest| rest.reverses).map(|rest| rest.coordinate);
        let dead_points: Vec<f64> = dead.collect();
        if dead_points.len() < 2 {
            return None;
        }
        let intervals = match (period, dead_points.as_slice()) {
            (Some(period), [first, second]) => {
                let out = (second - first).abs();
                Some([out, period - out])
            }
            _ => None,
        };
        let ordered = intervals.map(|[out, back]| [out.max(back), out.min(back)]);
        let speed = match mechanism.motion {
            Some(mechanism::Motion::Prescribed { speed, acceleration: 0.0 }) if speed != 0.0 => {
                Some(speed.abs())
            }
            _ => None,
        };
        Some(Self {
            stroke,
            dead_points,
            intervals,
            time_ratio: ordered.map(|[long, short]| long / short),
            overlap: ordered.map(|[long, short]| 0.5 * (long - short)),
            mean_speeds: intervals.zip(speed).map(|(ways, speed)| ways.map(|way| stroke * speed / way)),
        })
    }
}
