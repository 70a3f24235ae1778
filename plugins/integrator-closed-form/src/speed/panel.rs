//! A panel of the speed with the polynomials of time and way.

use assur_integrator::{CountedEquation, Curve, MotionError, Node, State};
use assur_number::elementary;
use assur_number::panel::chebyshev::{NODES, Series, WITH_ENDS, divided, integral, inverse, tail, value};
use assur_number::search::root;

/// A root of the moment further away than this is not used (x = 1 is the end of the panel).
const FURTHEST: f64 = 3.0;

/// A panel over x in [-1, 1].
#[derive(Debug, Clone, Copy)]
pub(super) struct SpeedPanel {
    /// Speed at x = -1.
    start: f64,
    /// Half of the length, with the sign of the direction.
    half: f64,
    pub(super) pole: Option<Pole>,
    /// Without a pole 1/e, with one (w - pole)/e: with respect to the parameter x.
    slowness: Series,
    /// Integrals from x = -1: the time and the displacement, without the share of the pole.
    time: Series,
    way: Series,
    /// Acceleration at x = 1.
    pub(super) last: f64,
    /// Errors of speed and displacement from the fits.
    pub(super) error: [f64; 2],
    /// x at which the acceleration vanishes, if a panel made for that would be shorter, or reach beyond this one.
    vanishing: Option<f64>,
}

/// The speed that the motion approaches asymptotically.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pole {
    pub(super) speed: f64,
    /// Its place in the panel.
    x: f64,
    /// (w - pole)/e there, s: minus the time in which the distance falls to 1/e of itself.
    residue: f64,
}

/// A place in a panel: the time and the displacement since its start, and the derivative of the displacement with
/// respect to the parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) speed: f64,
    pub(super) time: f64,
    pub(super) way: f64,
    pub(super) way_rate: f64,
}

impl SpeedPanel {
    /// Fits a panel of that length (with the sign of the acceleration) from a state.
    pub(super) fn fit(
        equation: &mut CountedEquation<'_>,
        from: &Node,
        length: f64,
    ) -> Result<Self, MotionError> {
        let start = from.state.speed;
        let half = 0.5 * length;
        let mut values = [from.acceleration; NODES];
        for (e, x) in values.iter_mut().zip(WITH_ENDS.nodes).skip(1) {
            *e = equation.acceleration(&State { speed: start + half * (1.0 + x), ..from.state })?;
        }
        let fit = WITH_ENDS.fit(&values);
        let mut panel = Self {
            start,
            half,
            pole: None,
            slowness: fit,
            time: fit,
            way: fit,
            last: values[NODES - 1],
            error: [f64::INFINITY; 2],
            vanishing: None,
        };
        // The first node at which the acceleration no longer leads along the panel.
        match (1..NODES).find(|j| values[*j] * half.signum() <= 0.0) {
            Some(node) => panel.with_pole(&fit, &values, node),
            None => panel.without_pole(&fit, &values),
        }
        Ok(panel)
    }

    /// Length with the sign of the direction.
    pub(super) fn length(&self) -> f64 {
        2.0 * self.half
    }

    /// The speed at the end, or the asymptotic one.
    pub(super) fn last_speed(&self) -> f64 {
        self.pole.map_or(self.speed(1.0), |pole| pole.speed)
    }

    fn speed(&self, x: f64) -> f64 {
        self.start + self.half * (1.0 + x)
    }

    fn without_pole(&mut self, fit: &Series, values: &[f64; NODES]) {
        self.slowness = WITH_ENDS.fit(&values.map(f64::recip));
        let of_way: [f64; NODES] = std::array::from_fn(|j| self.speed(WITH_ENDS.nodes[j]) / values[j]);
        let of_way = WITH_ENDS.fit(&of_way);
        self.time = integral(&self.slowness, self.half);
        self.way = integral(&of_way, self.half);
        // The integral of T_k is smaller than T_k by about k.
        let time = self.half.abs() * tail(&self.slowness) / NODES as f64;
        let most = values.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
        self.error = [time * most, time * 2.0 * self.half.abs()];
        self.vanishing = root_beyond(fit);
    }

    /// The acceleration vanishes before this node: e = (x - pole) h, and with g = 1/h
    /// ∫ dw/e = g(pole) ln|x - pole| + ∫ (g - g(pole))/(x - pole) dx, ∫ w dw/e = (speed of the pole) t + ∫ g dw.
    fn with_pole(&mut self, fit: &Series, values: &[f64; NODES], node: usize) {
        let nodes = WITH_ENDS.nodes;
        let x = if values[node] == 0.0 {
            nodes[node]
        } else {
            root(nodes[node - 1], nodes[node], f64::EPSILON, |x| value(fit, x) * self.half.signum())
        };
        let h = divided(fit, x);
        let g = nodes.map(|x| self.half / value(&h, x));
        self.slowness = WITH_ENDS.fit(&g);
        self.time = integral(&divided(&self.slowness, x), 1.0);
        self.way = integral(&self.slowness, self.half);
        let mut speed = self.speed(x);
        // A speed below rounding counts as zero: otherwise the displacement would grow without end.
        if speed.abs() <= 16.0 * f64::EPSILON * (self.start.abs() + self.half.abs()) {
            speed = 0.0;
        }
        let residue = value(&self.slowness, x);
        self.pole = Some(Pole { speed, x, residue });
        let (least, most) = g
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(least, most), g| (least.min(g.abs()), most.max(g.abs())));
        let distance = (speed - self.start).abs();
        let lost = distance * tail(&self.slowness);
        // The pole: by the fit, and as a place in a panel of that length.
        let of_pole = tail(fit) * most + 4.0 * f64::EPSILON * self.half.abs();
        self.error = [lost / least + of_pole, lost + of_pole * least];
        self.vanishing = Some(x).filter(|x| *x < 0.5);
    }

    /// The length from the same start that just includes the speed at which the moment vanishes, if that is near.
    pub(super) fn length_to_pole(&self) -> Option<f64> {
        /// Margin beyond the pole.
        const MARGIN: f64 = 1.2;
        self.vanishing.map(|x| MARGIN * (x + 1.0) * self.half.abs())
    }

    /// The parameter at the start: x without a pole; with one the logarithm by which the distance has fallen.
    pub(super) fn first(&self) -> f64 {
        if self.pole.is_some() { 0.0 } else { -1.0 }
    }

    /// The parameter at a speed with the acceleration `e` there; infinite where the moment vanishes before.
    pub(super) fn parameter(&self, speed: f64, e: f64) -> f64 {
        let x = ((speed - self.start) / self.half - 1.0).clamp(-1.0, 1.0);
        let Some(pole) = self.pole else { return x };
        if e * self.half <= 0.0 {
            return f64::INFINITY;
        }
        // The distance to the pole from the remaining moment: a difference of speeds would cancel.
        let left = (e * value(&self.slowness, x) / self.half).abs();
        elementary::ln((pole.x + 1.0) / left).max(0.0)
    }

    /// The place at a parameter.
    pub(super) fn at(&self, p: f64) -> Place {
        let Some(pole) = self.pole else {
            let (speed, time_rate) = (self.speed(p), self.half * value(&self.slowness, p));
            let (time, way) = (value(&self.time, p), value(&self.way, p));
            return Place { speed, time, way, way_rate: speed * time_rate };
        };
        let left = (pole.x + 1.0) * elementary::exp(-p);
        let x = pole.x - left;
        let speed = pole.speed - self.half * left;
        let time = value(&self.time, x) - pole.residue * p;
        let time_rate = -value(&self.slowness, x);
        let way = pole.speed * time + value(&self.way, x);
        Place { speed, time, way, way_rate: speed * time_rate }
    }

    /// The displacement from the start to where the motion ends after an infinite time.
    pub(super) fn whole_way(&self) -> f64 {
        match self.pole {
            Some(pole) if pole.speed == 0.0 => value(&self.way, pole.x),
            Some(pole) => pole.speed * f64::INFINITY,
            None => self.at(1.0).way,
        }
    }

    /// The parameter at a time since the start, between parameters (the last may be infinite).
    pub(super) fn at_time(&self, time: f64, ends: [f64; 2]) -> f64 {
        let Some(pole) = self.pole else {
            return solve(ends, time, |x| (value(&self.time, x), self.half * value(&self.slowness, x)));
        };
        solve(ends, time, |p| {
            let x = pole.x - (pole.x + 1.0) * elementary::exp(-p);
            (value(&self.time, x) - pole.residue * p, -value(&self.slowness, x))
        })
    }

    /// The parameter at a displacement since the start, over which the speed keeps its sign.
    pub(super) fn at_way(&self, way: f64, ends: [f64; 2]) -> f64 {
        let sign = way.signum();
        solve(ends, way * sign, |p| {
            let place = self.at(p);
            (place.way * sign, place.way_rate * sign)
        })
    }
}

/// Root of a series beyond x = 1 by Newton's method, if Kantorovich's condition shows that there is one (with a margin
/// that excludes double roots).
fn root_beyond(series: &Series) -> Option<f64> {
    const CERTAIN: f64 = 0.35;
    let slopes = divided(series, 1.0);
    let (p, slope, bend) =
        (value(series, 1.0), value(&slopes, 1.0), 2.0 * value(&divided(&slopes, 1.0), 1.0));
    let x = 1.0 - p / slope;
    Some(x).filter(|x| *x > 1.0 && *x < FURTHEST && (p * bend).abs() < CERTAIN * slope * slope)
}

/// The parameter at which a growing function (given with its derivative) has a value; the last bound may be infinite.
fn solve([mut low, mut high]: [f64; 2], wanted: f64, function: impl Fn(f64) -> (f64, f64)) -> f64 {
    /// A correction d leaves an error of about d².
    const ENOUGH: f64 = 3e-9;
    if high == f64::INFINITY {
        high = low + 1.0;
        while high < f64::MAX && function(high).0 < wanted {
            (low, high) = (high, 2.0 * high + 1.0);
        }
    }
    inverse(wanted, [low, high], 0.5 * (low + high), ENOUGH, function)
}

/// The motion through a panel.
#[derive(Debug, Clone)]
pub(crate) struct Passage {
    pub(super) panel: Box<SpeedPanel>,
    /// Parameters at its ends; the last may be infinite.
    pub(super) ends: [f64; 2],
}

impl Curve for Passage {
    fn at(&self, from: &State, time: f64) -> State {
        let place = self.panel.at(self.panel.at_time(time - from.time, self.ends));
        State { time, coordinate: from.coordinate + place.way, speed: place.speed }
    }
}
