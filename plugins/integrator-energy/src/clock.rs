//! A panel of the coordinate with the polynomials of J and of the kinetic energy; and time along it: t = ∫ dq/w, and the
//! inverse, the place at a time.

use std::f64::consts::{FRAC_PI_2, PI};

use assur_integrator::{CountedEquation, MotionError, State};
use assur_number::elementary;
use assur_number::panel::chebyshev::{
    INSIDE, NODES, Series, WITH_ENDS, divided, first_zero, integral, inverse, swing, tail, value,
};

/// Number of halvings after which the time counts as infinite: the motion creeps into an equilibrium.
const DEPTH: u32 = 40;

/// Number of parts of a panel after which its time counts as infinite, too.
const MOST_LEAVES: usize = 4096;

/// Largest part of the time of a panel that may be lost to rounding; beyond it the remaining energy is not known, and
/// the motion creeps.
const NOISE: f64 = 1e-8;

/// Part of a panel on which the time is one polynomial.
#[derive(Debug, Clone, Copy)]
struct Leaf {
    /// Bounds of the parameter.
    from: f64,
    to: f64,
    /// Time since the start of the leaf, over [-1, 1].
    time: Series,
    rate: Series,
    /// Time at its start and its end, s.
    begin: f64,
    end: f64,
}

/// The panel up to `until`, with its times.
#[derive(Debug, Clone)]
pub(crate) struct Clock {
    /// x at which the motion through the panel ends.
    until: f64,
    rests: Rests,
    /// The energy without its zeros.
    energy: Series,
    leaves: Vec<Leaf>,
    /// Accuracy of finding a place from its time, in parts of a leaf.
    fineness: f64,
}

/// At which ends of the panel the mechanism is at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Rests {
    pub(crate) at_start: bool,
    pub(crate) at_end: bool,
}

/// A place in the panel.
#[derive(Debug, Clone, Copy)]
struct PanelPoint {
    x: f64,
    /// The zeros of the energy that were divided out.
    zeros: f64,
    /// dx/dp over the root of the zeros: finite where both vanish.
    slope: f64,
}

impl Clock {
    /// Computes the time, to `tolerance` of the time of the panel, from `begin` up to x = `until` or to the time
    /// `latest`, whichever is reached first; `None` where it does not end.
    pub(crate) fn measure(
        panel: &EnergyPanel,
        (until, rests): (f64, Rests),
        (begin, latest): (f64, f64),
        tolerance: f64,
    ) -> Option<Self> {
        let energy = panel.energy_without_zeros(rests.at_start, rests.at_end.then_some(until));
        let fineness = (1e-3 * tolerance).max(4.0 * f64::EPSILON);
        let mut clock = Self { until, rests, energy, leaves: Vec::with_capacity(1), fineness };
        // Parameters from 0 to 1; the stack holds the intervals still to be computed, the nearest on top.
        let mut waiting = vec![(0.0, 1.0, 0)];
        let (mut now, mut whole) = (begin, 0.0);
        while let Some((from, to, depth)) = waiting.pop() {
            let leaf = clock.leaf(panel, from, to, now);
            let width = to - from;
            let own = leaf.0[0].abs() * width;
            if whole == 0.0 && own.is_finite() {
                whole = own;
            }
            let roundings = (clock.roundings(from, to) * own).min(NOISE * whole);
            let allowed = (tolerance * own.max(whole)).max(roundings);
            if tail(&leaf.0) * width <= allowed {
                now = leaf.1.end;
                clock.leaves.push(leaf.1);
                if now > latest {
                    break;
                }
            } else if depth == DEPTH || clock.leaves.len() >= MOST_LEAVES {
                return None;
            } else {
                let middle = 0.5 * (from + to);
                waiting.extend([(middle, to, depth + 1), (from, middle, depth + 1)]);
            }
        }
        Some(clock)
    }

    /// Relative rounding error of dt between two parameters: where little energy remains, it is a difference of works,
    /// and halving does not make it more exact.
    fn roundings(&self, from: f64, to: f64) -> f64 {
        let left = |p: f64| value(&self.energy, self.place(p).x).abs();
        16.0 * f64::EPSILON * swing(&self.energy) / left(from).min(left(to)).max(f64::MIN_POSITIVE)
    }

    /// The place at the parameter p from 0 to 1. With a rest, x + 1 = span sin²(πp/2), until - x = span cos²(πp/2).
    fn place(&self, p: f64) -> PanelPoint {
        let span = self.until + 1.0;
        let (sin, cos) = elementary::sin_cos(FRAC_PI_2 * p);
        let cosine =
            |zeros: f64, slope: f64| PanelPoint { x: span * sin * sin - 1.0, zeros, slope: PI * slope };
        match (self.rests.at_start, self.rests.at_end) {
            (false, false) => PanelPoint { x: span * p - 1.0, zeros: 1.0, slope: span },
            (true, false) => cosine(span * sin * sin, span.sqrt() * cos),
            (false, true) => cosine(span * cos * cos, span.sqrt() * sin),
            (true, true) => cosine(span * span * sin * sin * cos * cos, 1.0),
        }
    }

    fn leaf(&self, panel: &EnergyPanel, from: f64, to: f64, begin: f64) -> (Series, Leaf) {
        let half = 0.5 * (to - from);
        let values: [f64; NODES] = std::array::from_fn(|j| {
            let PanelPoint { x, slope, .. } = self.place(from + half * (1.0 + INSIDE.nodes[j]));
            // A negative radicand is rounding on a motion that creeps: no time is found over it, only on its sides.
            panel.slowness(x) * slope / value(&self.energy, x).sqrt()
        });
        let fit = INSIDE.fit(&values);
        let time = integral(&fit, half);
        let rate = fit.map(|c| half * c);
        (fit, Leaf { from, to, time, rate, begin, end: begin + value(&time, 1.0) })
    }

    /// Time at the end, s.
    pub(crate) fn end(&self) -> f64 {
        self.leaves.last().map_or(0.0, |leaf| leaf.end)
    }

    /// x and the energy there at a time.
    pub(crate) fn at(&self, time: f64) -> (f64, f64) {
        let last = self.leaves.len().saturating_sub(1);
        let index = self.leaves.partition_point(|leaf| leaf.end < time).min(last);
        let place = match self.leaves.get(index) {
            Some(leaf) => {
                let y = leaf.when(time - leaf.begin, self.fineness);
                self.place(leaf.from + 0.5 * (leaf.to - leaf.from) * (1.0 + y))
            }
            None => self.place(0.0),
        };
        (place.x, place.zeros * value(&self.energy, place.x))
    }
}

impl Leaf {
    /// Place in [-1, 1] at a time since the start; the time is a growing function of the place.
    fn when(&self, time: f64, fineness: f64) -> f64 {
        let duration = self.end - self.begin;
        if time >= duration {
            return 1.0;
        }
        // The last correction d leaves an error of about d².
        let enough = 0.1 * fineness.sqrt();
        let start = (2.0 * time / duration - 1.0).max(-1.0);
        inverse(time, [-1.0, 1.0], start, enough, |y| (value(&self.time, y), value(&self.rate, y)))
    }
}

/// J and Q at a node.
pub(crate) type Values = (f64, f64);

/// A panel over x in [-1, 1].
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnergyPanel {
    /// Coordinate at x = -1, rad (m).
    pub(crate) start: f64,
    /// Length with the sign of the direction, rad (m).
    pub(crate) length: f64,
    inertia: Series,
    /// Kinetic energy T, N m.
    energy: Series,
    /// J and Q at x = 1.
    pub(crate) last: Values,
    /// Largest error of the fits, relative.
    pub(crate) error: f64,
}

impl EnergyPanel {
    /// Fits a panel. `first` are the values at its start where they are known, `energy` is T there, and `largest`
    /// the largest T so far: the energy is right compared to that.
    pub(crate) fn fit(
        equation: &mut CountedEquation<'_>,
        from: &State,
        length: f64,
        first: Option<Values>,
        (energy, largest): (f64, f64),
    ) -> Result<Self, MotionError> {
        let (mut inertias, mut moments) = ([0.0; NODES], [0.0; NODES]);
        for (j, x) in WITH_ENDS.nodes.iter().enumerate() {
            let known = if j == 0 { first } else { None };
            let state = State { coordinate: from.coordinate + 0.5 * length * (1.0 + x), ..*from };
            (inertias[j], moments[j]) = match known {
                Some(values) => values,
                None => equation.work(&state)?,
            };
        }
        let (inertia, moment) = (WITH_ENDS.fit(&inertias), WITH_ENDS.fit(&moments));
        let mut work = integral(&moment, 0.5 * length);
        work[0] += energy;
        let scale = largest.max(work[0].abs()).max(swing(&work));
        // The integral of T_k is smaller than T_k by about k.
        let of_work = 0.5 * length.abs() * tail(&moment) / (NODES as f64 * scale);
        let error = of_work.max(0.5 * tail(&inertia) / inertia[0].abs());
        let last = (inertias[NODES - 1], moments[NODES - 1]);
        Ok(Self { start: from.coordinate, length, inertia, energy: work, last, error })
    }

    pub(crate) fn coordinate(&self, x: f64) -> f64 {
        self.start + 0.5 * self.length * (1.0 + x)
    }

    /// T at x.
    pub(crate) fn energy(&self, x: f64) -> f64 {
        value(&self.energy, x)
    }

    /// The energy without its zeros: divided by (x + 1) if the motion starts from rest, and by (until - x) if it ends
    /// at rest there.
    pub(crate) fn energy_without_zeros(&self, starts: bool, ends: Option<f64>) -> Series {
        let mut series = self.energy;
        if starts {
            series = divided(&series, -1.0);
        }
        if let Some(until) = ends {
            series = divided(&series, until).map(|c| -c);
        }
        series
    }

    /// Seconds for a unit of x at the energy 1 N m: (L/2) √(J/2).
    pub(crate) fn slowness(&self, x: f64) -> f64 {
        0.5 * self.length.abs() * (0.5 * value(&self.inertia, x)).sqrt()
    }

    /// Speed at `x` for an energy there, rad/s (m/s): w = √(2 T/J), E eq. 1.
    pub(crate) fn speed(&self, x: f64, energy: f64) -> f64 {
        (2.0 * energy.max(0.0) / value(&self.inertia, x)).sqrt().copysign(self.length)
    }

    /// An upper bound of T in the panel.
    pub(crate) fn most_energy(&self) -> f64 {
        self.energy[0] + swing(&self.energy)
    }

    /// First x at which T falls to zero, if it does, after a start from rest or in motion.
    pub(crate) fn turning(&self, from_rest: bool) -> Option<f64> {
        if self.energy[0] - swing(&self.energy) > 0.0 {
            return None;
        }
        first_zero(&self.energy_without_zeros(from_rest, None))
    }
}

/// Factor of the length that brings the error of a fit to the tolerance.
pub(crate) fn factor(tolerance: f64, error: f64) -> f64 {
    0.85 * elementary::powf(tolerance / error.max(1e-30), 1.0 / (NODES - 1) as f64)
}
