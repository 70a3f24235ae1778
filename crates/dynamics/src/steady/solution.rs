//! A solved cycle: its extreme speeds, its times, the state at any place, and its derivatives with respect to the
//! parameters; and the extremes of any function that is known with its derivative at the nodes of panels.

use assur_number::search::bisect;
use serde::Serialize;

use super::path::{CyclePath, RULE, S, Values};
use super::segment::{BY_DRIVE, BY_ENERGY, BY_FLYWHEEL, PARAMETERS, Segment, Setup};

/// What makes the cycle close.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Closing {
    /// The initial speed: the drive or the loads depend on the speed.
    Speed,
    /// The constant moment of the drive; the initial speed is free.
    Moment,
    /// Nothing: the work of a cycle is zero already, and the initial speed is free.
    Free,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CycleSolution {
    pub(crate) setup: Setup,
    pub(crate) cycle: CyclePath,
    /// T at the start and at the end.
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// Derivatives of the energy at the end.
    pub(crate) derivatives: [f64; PARAMETERS],
    pub(crate) segments: Vec<Segment>,
}

/// Least and greatest speed of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpeedRange {
    pub(crate) least: ExtremeSpeed,
    pub(crate) greatest: ExtremeSpeed,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ExtremeSpeed {
    pub(crate) at: Extreme,
    /// v, rad/s.
    pub(crate) value: f64,
    /// Its derivatives with respect to the parameters at a fixed place.
    derivatives: [f64; PARAMETERS],
}

impl SpeedRange {
    pub(crate) fn mean(&self) -> f64 {
        0.5 * (self.least.value + self.greatest.value)
    }

    pub(crate) fn unevenness(&self) -> f64 {
        (self.greatest.value - self.least.value) / self.mean()
    }

    /// Change of mean and unevenness along a direction of the parameters.
    pub(crate) fn change(&self, direction: &[f64; PARAMETERS]) -> [f64; 2] {
        let along = |speed: &ExtremeSpeed| -> f64 {
            speed.derivatives.iter().zip(direction).map(|(a, b)| a * b).sum()
        };
        let (low, high) = (along(&self.least), along(&self.greatest));
        let mean = 0.5 * (low + high);
        [mean, ((high - low) - self.unevenness() * mean) / self.mean()]
    }
}

impl CycleSolution {
    /// Least and greatest speed; `None` for a cycle without segments.
    pub(crate) fn speed_range(&self) -> Option<SpeedRange> {
        let drive = &self.setup.drive;
        let piece = |segment: &Segment| Stretch {
            x: segment.x,
            h: segment.h,
            values: segment.half_squares(drive),
            slopes: segment.accelerations(drive),
        };
        let [least, greatest] = extremes(self.segments.iter().map(piece))?;
        Some(SpeedRange { least: self.extreme_speed(least), greatest: self.extreme_speed(greatest) })
    }

    fn extreme_speed(&self, at: Extreme) -> ExtremeSpeed {
        let segment = &self.segments[at.piece];
        let value = (2.0 * at.value).sqrt();
        let inertia = segment.inertia_at(at.theta) + self.setup.drive.inertia;
        let [by_ratio, by_flywheel] = self.setup.inertia_by;
        let by_inertia = [0.0, by_ratio, by_flywheel];
        let energies = segment.derivatives.map(|values| RULE.interpolate(&values, at.theta));
        // v²/2 = T/J
        let derivatives =
            std::array::from_fn(|p| (energies[p] - at.value * by_inertia[p]) / (inertia * value));
        ExtremeSpeed { at, value, derivatives }
    }

    /// The changes of the parameters that keep the cycle closed: per unit of the level (ratio or initial energy), and
    /// per unit of the flywheel.
    pub(crate) fn directions(&self, closing: Closing) -> [[f64; PARAMETERS]; 2] {
        let [m, d, f] = [BY_ENERGY, BY_DRIVE, BY_FLYWHEEL].map(|p| self.derivatives[p]);
        match closing {
            Closing::Speed => [[d / (1.0 - m), 1.0, 0.0], [f / (1.0 - m), 0.0, 1.0]],
            Closing::Moment => [[1.0, (1.0 - m) / d, 0.0], [0.0, -f / d, 1.0]],
            Closing::Free => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        }
    }

    /// dT(end)/dT(start): the regime is stable below 1.
    pub(crate) fn multiplier(&self) -> f64 {
        self.derivatives[BY_ENERGY]
    }

    /// This cycle as a step of the iteration, with that number.
    pub(crate) fn iteration(&self, number: usize) -> Iteration {
        let speed = |energy: f64, segment: Option<&Segment>, node: usize| {
            let inertia = segment.map_or(0.0, |segment| segment.coefficients.nodes[node].inertia);
            self.cycle.sense * (2.0 * energy / (inertia + self.setup.drive.inertia)).sqrt()
        };
        let speed_start = speed(self.start, self.segments.first(), 0);
        let speed_end = speed(self.end, self.segments.last(), S);
        Iteration { number, speed_start, speed_end, residual: speed_end - speed_start }
    }

    fn index(&self, x: f64) -> usize {
        self.segments.partition_point(|segment| segment.x <= x).saturating_sub(1)
    }

    /// Speed along the path at a place, rad/s.
    pub(crate) fn speed_at(&self, x: f64) -> f64 {
        self.segments.get(self.index(x)).map_or(0.0, |segment| {
            let half_squares = segment.half_squares(&self.setup.drive);
            (2.0 * RULE.interpolate(&half_squares, (x - segment.x) / segment.h)).sqrt()
        })
    }

    /// Speeds at the nodes, rad/s, each with its share of the time, s.
    pub(crate) fn weighted_speeds(&self) -> Vec<(f64, f64)> {
        let of = |segment: &Segment| {
            let (h, weights) = (segment.h, RULE.a[S - 1]);
            let speeds = segment.half_squares(&self.setup.drive).map(|half| (2.0 * half).sqrt());
            (0..S).map(move |i| (speeds[i + 1], h * weights[i] / speeds[i + 1]))
        };
        self.segments.iter().flat_map(of).collect()
    }

    /// Time at the start and the nodes of each segment, and of the whole cycle: the integral of dx/v.
    pub(crate) fn times(&self) -> (Vec<Values>, f64) {
        let mut now = 0.0;
        let of = |segment: &Segment| {
            let slowness = segment.half_squares(&self.setup.drive).map(|half| 1.0 / (2.0 * half).sqrt());
            let times = RULE.integrals(&slowness).map(|part| now + segment.h * part);
            now = times[S];
            times
        };
        let times = self.segments.iter().map(of).collect();
        (times, now)
    }

    /// Time, speed, acceleration, moments and inertia at a coordinate, at a jump just after it; `times` are those of
    /// [`times`](Self::times).
    pub(crate) fn state(&self, times: &[Values], coordinate: f64) -> RegimeState {
        let [x, after] = self.cycle.place(coordinate);
        let index = self.index(after);
        let (Some(segment), Some(times)) = (self.segments.get(index), times.get(index)) else {
            return RegimeState { coordinate, ..RegimeState::default() };
        };
        let (sense, drive) = (self.cycle.sense, &self.setup.drive);
        let at = |values: &Values| RULE.interpolate(values, (x - segment.x) / segment.h);
        let half_squares = segment.half_squares(drive);
        let driving = |half: f64| drive.moment(segment.factor, (2.0 * half).sqrt()).value;
        let loads = std::array::from_fn(|i| segment.moment[i] - driving(half_squares[i]));
        let half = at(&half_squares);
        RegimeState {
            coordinate,
            time: at(times),
            speed: sense * (2.0 * half).sqrt(),
            acceleration: sense * at(&segment.accelerations(drive)),
            first_turn: None,
            drive: sense * driving(half),
            load: sense * at(&loads),
            inertia: at(&segment.coefficients.values(|node| node.inertia)),
            inertia_derivative: sense * at(&segment.coefficients.values(|node| node.slope)),
        }
    }
}

/// The function on one panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    /// Path coordinate of its start.
    pub(crate) x: f64,
    pub(crate) h: f64,
    /// Values at the start and at the nodes.
    pub(crate) values: Values,
    /// Derivative with respect to x at the start and at the nodes.
    pub(crate) slopes: Values,
}

/// An extreme value and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extreme {
    /// Index of the panel.
    pub(crate) piece: usize,
    /// Part of the panel.
    pub(crate) theta: f64,
    /// Path coordinate.
    pub(crate) x: f64,
    pub(crate) value: f64,
}

/// Least and greatest value; ends of panels, where the derivative may jump, included. Of equal values the first.
pub(crate) fn extremes(pieces: impl Iterator<Item = Stretch>) -> Option<[Extreme; 2]> {
    let mut found: Option<[Extreme; 2]> = None;
    for (index, piece) in pieces.enumerate() {
        let at =
            |theta: f64, value: f64| Extreme { piece: index, theta, x: piece.x + theta * piece.h, value };
        let between = |theta: f64| at(theta, RULE.interpolate(&piece.values, theta));
        note(&mut found, at(0.0, piece.values[0]));
        for i in 1..=S {
            let [before, after] = [piece.slopes[i - 1], piece.slopes[i]];
            if before * after < 0.0 {
                let keeps = |theta: f64| RULE.interpolate(&piece.slopes, theta) * before.signum() > 0.0;
                let [low, high] = bisect(RULE.c[i - 1], RULE.c[i], 2.0 * f64::EPSILON, keeps);
                note(&mut found, between(f64::midpoint(low, high)));
            } else if after == 0.0 {
                note(&mut found, between(RULE.c[i]));
            }
        }
        note(&mut found, at(1.0, piece.values[S]));
    }
    found
}

fn note(found: &mut Option<[Extreme; 2]>, new: Extreme) {
    let Some([least, greatest]) = found else {
        *found = Some([new, new]);
        return;
    };
    // Where two panels meet, rounding must not decide.
    let slack = 4.0 * f64::EPSILON * new.value.abs();
    if new.value < least.value - slack {
        *least = new;
    }
    if new.value > greatest.value + slack {
        *greatest = new;
    }
}

/// One cycle of the iteration to the periodic regime (S fig. 10).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Iteration {
    /// Number of the cycle, from 1.
    pub number: usize,
    /// Speed at its start, rad/s, signed.
    pub speed_start: f64,
    /// Speed at its end, rad/s, signed.
    pub speed_end: f64,
    /// End less start, rad/s: zero for the periodic regime.
    pub residual: f64,
}

/// The steady regime at one coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct RegimeState {
    /// The coordinate, rad.
    pub coordinate: f64,
    /// Time since the start of the cycle, s.
    #[serde(skip)]
    pub time: f64,
    /// Speed, rad/s, signed.
    pub speed: f64,
    /// Acceleration, rad/s², signed.
    #[serde(skip)]
    pub acceleration: f64,
    /// Speed in the first cycle from the mean speed, rad/s, signed; absent where the machine stalls in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_turn: Option<f64>,
    /// Moment of the drive on the input link, N m, along the coordinate.
    pub drive: f64,
    /// Reduced moment of the loads, N m, along the coordinate.
    pub load: f64,
    /// Reduced inertia of the machine, without flywheel and rotor, kg m².
    pub inertia: f64,
    /// Its derivative with respect to the coordinate, kg m²/rad.
    pub inertia_derivative: f64,
}
