//! The flywheel by the methods of the textbooks, which take the driving moment as constant over the cycle.
//!
//! With the work ΔA(x) of all moments from the start of the cycle, the wanted mean speed w and unevenness δ:
//!
//! ```text
//! excess work         J = (max ΔA - min ΔA)/(w² δ)                                   E eq. 10
//! less inertia        the same less constant and mean variable inertia               E eq. 9
//! Mertsalov           J = range of (ΔA - Jv w²/2)/(w² δ), less the constant inertia
//! Wittenbauer         J = (max(ΔA - J w₁²/2) - min(ΔA - J w₀²/2))/(w² δ), w₁,₀ = w (1 ± δ/2)
//! ```
//!
//! The last one is exact where the moments depend on the coordinate alone: of all places the straight line of the
//! greatest speed touches the energy-mass diagram from one side, that of the least from the other.

use super::CycleRequest;
use super::collocation::{Nodal, RULE, S, dot, product};
use super::curve::{Piece, extremes};
use super::path::{Datum, Panel};

/// What the methods need of a cycle, at the mean speed.
#[derive(Debug, Clone)]
pub(crate) struct Diagram {
    panels: Vec<Panel>,
    /// Mean speed, at which moments over speed are taken, rad/s.
    speed: f64,
    /// Moment of the drive that makes the work of a cycle zero, N m.
    pub(crate) mean_moment: f64,
    /// Mean of J over the cycle, kg m².
    pub(crate) mean_inertia: f64,
    /// ΔA at the start and at the nodes of each panel.
    work: Vec<[f64; S + 1]>,
    /// Work of the resisting moments over a cycle, J.
    pub(crate) resistance: f64,
}

/// The diagram's results for the inertia on the input shaft that does not vary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Approximations {
    /// max ΔA - min ΔA, J.
    pub(crate) excess_work: f64,
    pub(crate) excess: f64,
    pub(crate) less_inertia: f64,
    pub(crate) mertsalov: f64,
    pub(crate) wittenbauer: f64,
}

impl Diagram {
    pub(crate) fn new(panels: &[Panel], request: &CycleRequest) -> Self {
        let (length, v) = (request.length, request.mean_speed.abs());
        let (weights, last) = (&RULE.a[S - 1], S - 1);
        let over = |panel: &Panel, field: &dyn Fn(&Datum) -> f64| {
            panel.h * dot(weights, &panel.data.nodes.map(|node| field(&node)))
        };
        let total: f64 = panels.iter().map(|panel| over(panel, &|d| d.moment_at(v))).sum();
        let inertia: f64 = panels.iter().map(|panel| over(panel, &|d| d.inertia)).sum();
        let mean_moment = -total / length;
        let mut level = 0.0;
        let mut work = Vec::with_capacity(panels.len());
        for panel in panels {
            let moments = panel.data.nodes.map(|node| node.moment_at(v) + mean_moment);
            let done = product(&RULE.a, &moments);
            let mut values = [level; S + 1];
            for (value, done) in values[1..].iter_mut().zip(done) {
                *value += panel.h * done;
            }
            level = values[last + 1];
            work.push(values);
        }
        Self {
            panels: panels.to_vec(),
            speed: v,
            mean_moment,
            mean_inertia: inertia / length,
            work,
            resistance: -total,
        }
    }

    /// Least and greatest ΔA - k J.
    fn range(&self, k: f64) -> [f64; 2] {
        let piece = |(panel, work): (&Panel, &[f64; S + 1])| {
            let value = |work: f64, datum: &Datum| work - k * datum.inertia;
            let slope = |datum: &Datum| datum.moment_at(self.speed) + self.mean_moment - k * datum.slope;
            let nodes = &panel.data.nodes;
            let values: Nodal = std::array::from_fn(|i| value(work[i + 1], &nodes[i]));
            Piece {
                x: panel.x,
                h: panel.h,
                start: value(work[0], &panel.data.start),
                values,
                start_slope: slope(&panel.data.start),
                slopes: nodes.map(|node| slope(&node)),
            }
        };
        let pieces: Vec<Piece> = self.panels.iter().zip(&self.work).map(piece).collect();
        extremes(&pieces).map_or([0.0; 2], |[least, greatest]| [least.value, greatest.value])
    }

    /// `constant`: the part of J(q) that does not vary, kg m²; `rotor`: reduced rotor.
    pub(crate) fn approximate(
        &self,
        speed: f64,
        unevenness: f64,
        constant: f64,
        rotor: f64,
    ) -> Approximations {
        let square = speed * speed;
        let by = 1.0 / (square * unevenness);
        let [low, high] = self.range(0.0);
        let excess_work = high - low;
        let [low, high] = self.range(0.5 * square);
        let mertsalov = (high - low) * by - constant - rotor;
        Approximations {
            excess_work,
            excess: excess_work * by,
            less_inertia: excess_work * by - self.mean_inertia - rotor,
            mertsalov,
            wittenbauer: self.wittenbauer(speed, unevenness).0 - rotor,
        }
    }

    /// Constant inertia beside J(q), kg m², and the energy at the start of the cycle, J.
    pub(crate) fn wittenbauer(&self, speed: f64, unevenness: f64) -> (f64, f64) {
        let square = |part: f64| 0.5 * (speed * (1.0 + part * 0.5 * unevenness)).powi(2);
        let (fast, slow) = (square(1.0), square(-1.0));
        let (high, low) = (self.range(fast)[1], self.range(slow)[0]);
        let inertia = (high - low) / (fast - slow);
        // The greatest speed is reached where T0 + ΔA - J fast is greatest: there it equals inertia * fast.
        (inertia, inertia * fast - high)
    }
}
