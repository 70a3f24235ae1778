//! The machine along one cycle: coefficients of its equation over the way x, which grows with the motion.
//!
//! With x = sense * (q - q0) and v = sense * w the equation J e + J' w²/2 = Q reads d(J v²/2)/dx = M, M the moment along the
//! path: the kinetic energy T(x) is the integral of the moment (E eq. 1).

use assur_integrator::{Motion, MotionError, Piece, State};

use super::collocation::{Nodal, RULE, S};
use crate::DynamicsError;

/// Part of the cycle below which a piece is rounding.
const NARROW: f64 = 1e-11;

/// Coefficients at one place of the path, of the machine alone.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Datum {
    /// J.
    pub(crate) inertia: f64,
    /// dJ/dx.
    pub(crate) slope: f64,
    /// Moment of the loads along the path, the part that does not depend on the speed.
    pub(crate) moment: f64,
    /// Its derivative by the speed: on a smooth piece loads are linear in it (dampers, rows of tables).
    pub(crate) by_speed: f64,
}

impl Datum {
    /// Moment of the loads along the path at speed `v`.
    #[inline]
    pub(crate) fn moment_at(&self, v: f64) -> f64 {
        self.moment + self.by_speed * v
    }
}

/// Coefficients over a panel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Data {
    pub(crate) start: Datum,
    pub(crate) middle: Datum,
    pub(crate) nodes: [Datum; S],
    /// Speeds v between which the moments hold.
    pub(crate) speed: [f64; 2],
}

/// A part of the path on which the coefficients are one smooth formula, well resolved by one polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Panel {
    pub(crate) x: f64,
    pub(crate) h: f64,
    pub(crate) data: Data,
}

/// Where the cycle begins, which way it goes, and how long it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Way {
    pub(crate) start: f64,
    pub(crate) sense: f64,
    pub(crate) length: f64,
}

impl Way {
    pub(crate) fn coordinate(&self, x: f64) -> f64 {
        self.start + self.sense * x
    }

    /// The place of a coordinate in the cycle, in [0, length).
    pub(crate) fn place(&self, coordinate: f64) -> f64 {
        let x = (self.sense * (coordinate - self.start)).rem_euclid(self.length);
        if x < self.length { x } else { 0.0 }
    }
}

/// The machine, evaluated along the path.
pub(crate) struct Road<'a> {
    motion: &'a mut dyn Motion,
    pub(crate) way: Way,
    /// The moment of the loads depends on the speed.
    pub(crate) by_speed: bool,
    /// Evaluations of the machine so far.
    pub(crate) evaluations: usize,
}

impl std::fmt::Debug for Road<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Road").field("way", &self.way).finish_non_exhaustive()
    }
}

impl<'a> Road<'a> {
    pub(crate) fn new(motion: &'a mut dyn Motion, way: Way) -> Self {
        let by_speed = motion.dependence().moment_on_speed;
        Self { motion, way, by_speed, evaluations: 0 }
    }

    fn state(&self, x: f64, v: f64) -> State {
        State { time: 0.0, coordinate: self.way.coordinate(x), speed: self.way.sense * v }
    }

    fn failed(&self, x: f64, source: MotionError) -> DynamicsError {
        DynamicsError::Equation { coordinate: self.way.coordinate(x), source }
    }

    /// Chooses the formulas that hold just after `x` at a speed beside `v`, and returns their bounds in x and v.
    pub(crate) fn enter(&mut self, x: f64, v: f64) -> Result<[[f64; 2]; 2], DynamicsError> {
        let state = self.state(x, v);
        let Piece { coordinate: [a, b], speed: [c, d], .. } =
            self.motion.enter(&state).map_err(|source| self.failed(x, source))?;
        let start = self.way.start;
        Ok(if self.way.sense > 0.0 {
            [[a - start, b - start], [c, d]]
        } else {
            [[start - b, start - a], [-d, -c]]
        })
    }

    fn reduced(&mut self, x: f64, v: f64) -> Result<Datum, DynamicsError> {
        self.evaluations += 1;
        let state = self.state(x, v);
        let found = self.motion.reduced(&state).map_err(|source| self.failed(x, source))?;
        let sense = self.way.sense;
        let (slope, moment) = (sense * found.inertia_derivative, sense * found.moment);
        if found.inertia.is_finite() && slope.is_finite() && moment.is_finite() {
            return Ok(Datum { inertia: found.inertia, slope, moment, by_speed: 0.0 });
        }
        Err(self.failed(x, MotionError::NotFinite { acceleration: moment / found.inertia }))
    }

    /// Coefficients at `x` by the formulas entered last; `v` is a speed near which they are wanted.
    pub(crate) fn datum(&mut self, x: f64, v: f64) -> Result<Datum, DynamicsError> {
        let mut datum = self.reduced(x, v)?;
        if self.by_speed {
            let half = self.reduced(x, 0.5 * v)?.moment;
            datum.by_speed = (datum.moment - half) / (0.5 * v);
            datum.moment = 2.0 * half - datum.moment;
        }
        Ok(datum)
    }

    /// Coefficients over a stretch whose formulas hold near the speed `v`.
    pub(crate) fn data(&mut self, x: f64, h: f64, v: f64) -> Result<Data, DynamicsError> {
        let [_, speed] = self.enter(x + 0.5 * h, v)?;
        let mut data = Data {
            start: self.datum(x, v)?,
            middle: self.datum(x + h * RULE.middle, v)?,
            nodes: [Datum::default(); S],
            speed,
        };
        for (node, c) in data.nodes.iter_mut().zip(&RULE.c) {
            *node = self.datum(x + h * c, v)?;
        }
        self.check_linear(x + h * RULE.middle, v, &data.middle)?;
        Ok(data)
    }

    fn check_linear(&mut self, x: f64, v: f64, datum: &Datum) -> Result<(), DynamicsError> {
        /// Rounding of the moments, which are differences of larger ones.
        const ROUNDING: f64 = 1e-8;
        if !self.by_speed {
            return Ok(());
        }
        let (found, expected) = (self.reduced(x, 1.5 * v)?.moment, datum.moment_at(1.5 * v));
        let scale = datum.moment.abs() + (datum.by_speed * v).abs() + datum.inertia * v * v;
        if (found - expected).abs() > ROUNDING * scale {
            return Err(DynamicsError::NotLinear { coordinate: self.way.coordinate(x) });
        }
        Ok(())
    }

    /// Places where the formulas change along the path, 0 and the length included.
    fn corners(&mut self, v: f64) -> Result<Vec<f64>, DynamicsError> {
        let (length, mut x) = (self.way.length, 0.0);
        let narrow = NARROW * length;
        let mut corners = vec![0.0];
        while x < length - narrow {
            let mut ahead = 0.0;
            let end = loop {
                let [[_, end], _] = self.enter(x + ahead, v)?;
                if end > x + narrow {
                    break end.min(length);
                }
                ahead = if ahead == 0.0 { 1e-3 * narrow } else { 4.0 * ahead };
                if ahead > length {
                    break length;
                }
            };
            x = if end > length - narrow { length } else { end };
            corners.push(x);
        }
        Ok(corners)
    }

    /// Cuts the cycle into panels on which polynomials resolve the coefficients to `tolerance` (relative), at the
    /// speed `v`.
    pub(crate) fn panels(&mut self, v: f64, tolerance: f64) -> Result<Vec<Panel>, DynamicsError> {
        let corners = self.corners(v)?;
        let mut panels = Vec::new();
        let mut scale = Datum::default();
        for ends in corners.windows(2) {
            // Longest first guess: an eighth of a cycle.
            let longest = self.way.length / 8.0;
            let parts = (1..8_u8).find(|n| (ends[1] - ends[0]) / f64::from(*n) <= longest).unwrap_or(8);
            let h = (ends[1] - ends[0]) / f64::from(parts);
            for part in 0..parts {
                self.cut(ends[0] + f64::from(part) * h, h, v, tolerance, &mut scale, &mut panels)?;
            }
        }
        Ok(panels)
    }

    fn cut(
        &mut self,
        x: f64,
        h: f64,
        v: f64,
        tolerance: f64,
        scale: &mut Datum,
        panels: &mut Vec<Panel>,
    ) -> Result<(), DynamicsError> {
        /// A panel is not cut below this part of the cycle: there the coefficients are not smooth, or noise.
        const LEAST: f64 = 1.0 / 16384.0;
        let data = self.data(x, h, v)?;
        for node in &data.nodes {
            scale.inertia = scale.inertia.max(node.inertia.abs());
            scale.moment = scale.moment.max(node.moment_at(v).abs());
        }
        let miss = |field: &dyn Fn(&Datum) -> f64| {
            let values: Nodal = data.nodes.map(|node| field(&node));
            RULE.interpolate(field(&data.start), &values, RULE.middle) - field(&data.middle)
        };
        // What a moment does is measured by the kinetic energy: one that vanishes but for rounding is resolved.
        let moment = scale.moment.max(scale.inertia * v * v / self.way.length);
        let good = miss(&|d| d.inertia).abs() <= tolerance * scale.inertia
            && miss(&|d| d.moment_at(v)).abs() <= tolerance * moment;
        if good || h < LEAST * self.way.length {
            panels.push(Panel { x, h, data });
            return Ok(());
        }
        self.cut(x, 0.5 * h, v, tolerance, scale, panels)?;
        self.cut(x + 0.5 * h, 0.5 * h, v, tolerance, scale, panels)
    }
}
