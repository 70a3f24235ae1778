//! The machine along one cycle: coefficients of its equation over the path coordinate x.

use std::sync::LazyLock;

use assur_force::tolerance;
use assur_integrator::{EquationOfMotion, MotionError, Piece, State, Stretch};
use assur_number::panel::Radau;

use crate::DynamicsError;

/// Coefficients of the equation at one place of the path, of the machine without its drive.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Coefficients {
    /// J.
    pub(crate) inertia: f64,
    /// dJ/dx.
    pub(crate) slope: f64,
    /// Moment of the loads along the path, the part that does not depend on the speed.
    pub(crate) moment: f64,
    /// Its derivative with respect to the speed: on a smooth piece loads are linear in it (dampers, rows of tables).
    pub(crate) by_speed: f64,
}

impl Coefficients {
    /// Moment of the loads along the path at speed `v`.
    #[inline]
    pub(crate) fn moment_at(&self, v: f64) -> f64 {
        self.moment + self.by_speed * v
    }
}

/// Coefficients at the places of a panel at which the equation is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct NodalCoefficients {
    /// At the start and at the nodes.
    pub(crate) nodes: [Coefficients; S + 1],
    pub(crate) middle: Coefficients,
    /// Interval of the speed v in which the moments are valid.
    pub(crate) speed: [f64; 2],
}

impl NodalCoefficients {
    /// One of the coefficients at the start and at the nodes.
    pub(crate) fn values(&self, field: impl Fn(&Coefficients) -> f64) -> Values {
        self.nodes.map(|node| field(&node))
    }
}

/// A part of the path on which the coefficients are one smooth formula, well resolved by one polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PathPanel {
    pub(crate) x: f64,
    pub(crate) h: f64,
    pub(crate) coefficients: NodalCoefficients,
}

/// Where the cycle begins, the direction of the motion (1 or -1), and the length of the cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CyclePath {
    pub(crate) start: f64,
    pub(crate) sense: f64,
    pub(crate) length: f64,
}

impl CyclePath {
    pub(crate) fn coordinate(&self, x: f64) -> f64 {
        self.start + self.sense * x
    }

    /// The path coordinate of a coordinate, in [0, length).
    pub(crate) fn path_coordinate(&self, coordinate: f64) -> f64 {
        let x = (self.sense * (coordinate - self.start)).rem_euclid(self.length);
        if x < self.length { x } else { 0.0 }
    }

    /// The path coordinates of a coordinate and of the place just after it in the direction of motion, further than
    /// rounding. The first may be a rounding before 0, never after the second.
    pub(crate) fn place(&self, coordinate: f64) -> [f64; 2] {
        let beyond = tolerance(coordinate, Some(self.length));
        let after = self.path_coordinate(coordinate + self.sense * beyond);
        let x = self.path_coordinate(coordinate);
        [if x > after { x - self.length } else { x }, after]
    }
}

/// The machine, evaluated along the path.
pub(crate) struct Path<'a> {
    motion: &'a mut dyn EquationOfMotion,
    pub(crate) cycle: CyclePath,
    /// The moment of the loads depends on the speed.
    pub(crate) by_speed: bool,
    /// The moment of the loads changes where several variables together make it.
    pub(crate) switches: bool,
    /// Number of evaluations of the machine.
    pub(crate) evaluations: usize,
}

impl<'a> Path<'a> {
    pub(crate) fn new(motion: &'a mut dyn EquationOfMotion, cycle: CyclePath) -> Self {
        let dependence = motion.dependence();
        let (by_speed, switches) = (dependence.moment_on_speed, dependence.moment_switches);
        Self { motion, cycle, by_speed, switches, evaluations: 0 }
    }

    pub(crate) fn state(&self, x: f64, v: f64) -> State {
        State { time: 0.0, coordinate: self.cycle.coordinate(x), speed: self.cycle.sense * v }
    }

    fn failed(&self, x: f64, source: MotionError) -> DynamicsError {
        DynamicsError::Equation { coordinate: self.cycle.coordinate(x), source }
    }

    /// Chooses the formulas that are valid just after `x` at a speed near `v`, and returns their bounds in x and v.
    pub(crate) fn enter(&mut self, x: f64, v: f64) -> Result<[[f64; 2]; 2], DynamicsError> {
        let state = self.state(x, v);
        let Piece { coordinate: [a, b], speed: [c, d], .. } =
            self.motion.enter(&state).map_err(|source| self.failed(x, source))?;
        let start = self.cycle.start;
        Ok(if self.cycle.sense > 0.0 {
            [[a - start, b - start], [c, d]]
        } else {
            [[start - b, start - a], [-d, -c]]
        })
    }

    /// Whether the formulas entered last hold throughout a stretch, see [`EquationOfMotion::holds`].
    pub(crate) fn holds(&self, stretch: &Stretch) -> Option<bool> {
        self.motion.holds(stretch)
    }

    /// Coefficients at `x` and the speed `v` by the formulas entered last, the whole moment in its first part.
    pub(crate) fn reduced(&mut self, x: f64, v: f64) -> Result<Coefficients, DynamicsError> {
        self.evaluations += 1;
        let state = self.state(x, v);
        let found = self.motion.reduced(&state).map_err(|source| self.failed(x, source))?;
        let sense = self.cycle.sense;
        let (slope, moment) = (sense * found.inertia_derivative, sense * found.moment);
        if found.inertia.is_finite() && slope.is_finite() && moment.is_finite() {
            return Ok(Coefficients { inertia: found.inertia, slope, moment, by_speed: 0.0 });
        }
        Err(self.failed(x, MotionError::NotFinite { inertia: found.inertia, moment }))
    }

    /// Coefficients at `x` by the formulas entered last; `v` is a speed near which they are needed.
    fn at(&mut self, x: f64, v: f64) -> Result<Coefficients, DynamicsError> {
        let mut found = self.reduced(x, v)?;
        if self.by_speed {
            let half = self.reduced(x, 0.5 * v)?.moment;
            found.by_speed = (found.moment - half) / (0.5 * v);
            found.moment = 2.0 * half - found.moment;
        }
        Ok(found)
    }

    /// Coefficients over a stretch of the path whose formulas are valid near the speed `v`.
    pub(crate) fn coefficients(
        &mut self,
        x: f64,
        h: f64,
        v: f64,
    ) -> Result<NodalCoefficients, DynamicsError> {
        let [_, speed] = self.enter(x + 0.5 * h, v)?;
        self.coefficients_entered([x, h], v, speed)
    }

    /// Coefficients over a stretch by the formulas entered last, which are valid in this interval of the speed.
    pub(crate) fn coefficients_entered(
        &mut self,
        [x, h]: [f64; 2],
        v: f64,
        speed: [f64; 2],
    ) -> Result<NodalCoefficients, DynamicsError> {
        let mut found = NodalCoefficients { speed, ..NodalCoefficients::default() };
        for (node, c) in found.nodes.iter_mut().zip(&RULE.c) {
            *node = self.at(x + h * c, v)?;
        }
        found.middle = self.at(x + h * RULE.middle, v)?;
        self.check_linear(x + h * RULE.middle, v, &found.middle)?;
        Ok(found)
    }

    fn check_linear(&mut self, x: f64, v: f64, at: &Coefficients) -> Result<(), DynamicsError> {
        /// Rounding of the moments, which are differences of larger ones.
        const ROUNDING: f64 = 1e-8;
        if !self.by_speed {
            return Ok(());
        }
        let (found, expected) = (self.reduced(x, 1.5 * v)?.moment, at.moment_at(1.5 * v));
        let scale = at.moment.abs() + (at.by_speed * v).abs() + at.inertia * v * v;
        if (found - expected).abs() > ROUNDING * scale {
            return Err(DynamicsError::NotLinear(self.cycle.coordinate(x)));
        }
        Ok(())
    }

    /// Places where the formulas change along the path, 0 and the length included.
    fn corners(&mut self, v: f64) -> Result<Vec<f64>, DynamicsError> {
        let (length, mut x) = (self.cycle.length, 0.0);
        // As wide as what counts as lying on a jump: between that and a wider bound a state would have another side here.
        let narrow = tolerance(self.cycle.coordinate(length), Some(length));
        let mut corners = vec![0.0];
        while x < length - narrow {
            let mut ahead = 0.0;
            let end = loop {
                let [[_, end], _] = self.enter(x + ahead, v)?;
                if end > x + narrow {
                    // Where the formulas end at a constant speed.
                    let end = end.min(length);
                    let change = self.first_switch([x, end - x], &[0.5 * v * v; S + 1]);
                    break change.map_or(end, |[_, after]| x + after * (end - x));
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
    pub(crate) fn panels(&mut self, v: f64, tolerance: f64) -> Result<Vec<PathPanel>, DynamicsError> {
        let corners = self.corners(v)?;
        let mut panels = Vec::new();
        let mut scale = Coefficients::default();
        for ends in corners.windows(2) {
            // Longest first guess: an eighth of a cycle.
            let longest = self.cycle.length / 8.0;
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
        scale: &mut Coefficients,
        panels: &mut Vec<PathPanel>,
    ) -> Result<(), DynamicsError> {
        /// A panel is not cut below this part of the cycle: the coefficients are not smooth there, or noise.
        const LEAST: f64 = 1.0 / 16384.0;
        let coefficients = self.coefficients(x, h, v)?;
        for node in &coefficients.nodes[1..] {
            scale.inertia = scale.inertia.max(node.inertia.abs());
            scale.moment = scale.moment.max(node.moment_at(v).abs());
        }
        let miss = |field: &dyn Fn(&Coefficients) -> f64| {
            RULE.interpolate(&coefficients.values(field), RULE.middle) - field(&coefficients.middle)
        };
        // The scale of the moment's error is the kinetic energy: a moment that vanishes but for rounding counts as
        // resolved.
        let moment = scale.moment.max(scale.inertia * v * v / self.cycle.length);
        let good = miss(&|d| d.inertia).abs() <= tolerance * scale.inertia
            && miss(&|d| d.moment_at(v)).abs() <= tolerance * moment;
        if good || h < LEAST * self.cycle.length {
            panels.push(PathPanel { x, h, coefficients });
            return Ok(());
        }
        self.cut(x, 0.5 * h, v, tolerance, scale, panels)?;
        self.cut(x + 0.5 * h, 0.5 * h, v, tolerance, scale, panels)
    }
}

/// Number of nodes in (0, 1].
pub(crate) const S: usize = 8;

/// One number for the start of a panel and one for each node.
pub(crate) type Values = [f64; S + 1];

/// The rule, computed once.
pub(crate) static RULE: LazyLock<Radau<S, { S + 1 }>> = LazyLock::new(Radau::new);

#[cfg(test)]
mod tests;
