//! The flywheel by the methods of the textbooks, which take the driving moment as constant over the cycle.
//!
//! With the work ΔA(x) of all moments from the start of the cycle, the wanted mean speed w and unevenness δ:
//!
//! ```text
//! excess work         J = (max ΔA - min ΔA)/(w² δ)                                   E eq. 10
//! less inertia        excess work, minus constant and mean variable inertia          E eq. 9
//! Mertsalov           J = range of (ΔA - Jv w²/2)/(w² δ), less the constant inertia
//! Wittenbauer         J = (max(ΔA - J w₁²/2) - min(ΔA - J w₀²/2))/(w² δ), w₁,₀ = w (1 ± δ/2)
//! ```
//!
//! The last one is exact where the moments depend on the coordinate alone: the straight line of the greatest speed and
//! that of the least touch the energy-mass diagram from either side.

use assur_words::text;

use super::path::{Coefficients, PathPanel, RULE, S, Values};
use super::regime::FlywheelByMethod;
use super::solution::{Stretch, extremes};
use super::tuning::{Tuned, TuningTarget};

/// The data of a cycle that the methods need: the work of all moments over the path, at the mean speed.
#[derive(Debug, Clone)]
pub(crate) struct WorkDiagram {
    panels: Vec<PathPanel>,
    /// Mean speed, at which moments that depend on the speed are evaluated, rad/s.
    pub(crate) speed: f64,
    /// Moment of the drive that makes the work of a cycle zero, N m.
    pub(crate) mean_moment: f64,
    /// Mean of J over the cycle, kg m².
    pub(crate) mean_inertia: f64,
    /// ΔA at the start and at the nodes of each panel.
    work: Vec<Values>,
    /// Work of the resisting moments over a cycle, J.
    pub(crate) resistance: f64,
}

impl WorkDiagram {
    /// Over the panels of a cycle of this length, at a mean speed.
    pub(crate) fn new(panels: &[PathPanel], length: f64, speed: f64) -> Self {
        let over = |panel: &PathPanel, field: &dyn Fn(&Coefficients) -> f64| {
            panel.h * RULE.integral(&panel.coefficients.values(field))
        };
        let total: f64 = panels.iter().map(|panel| over(panel, &|c| c.moment_at(speed))).sum();
        let inertia: f64 = panels.iter().map(|panel| over(panel, &|c| c.inertia)).sum();
        let mean_moment = -total / length;
        let mut level = 0.0;
        let work_over = |panel: &PathPanel| {
            let moments = panel.coefficients.values(|c| c.moment_at(speed) + mean_moment);
            let work = RULE.integrals(&moments).map(|done| level + panel.h * done);
            level = work[S];
            work
        };
        let work = panels.iter().map(work_over).collect();
        let mean_inertia = inertia / length;
        Self { panels: panels.to_vec(), speed, mean_moment, mean_inertia, work, resistance: -total }
    }

    /// Least and greatest ΔA - k J.
    fn range(&self, k: f64) -> [f64; 2] {
        let piece = |(panel, work): (&PathPanel, &Values)| {
            let inertia = panel.coefficients.values(|c| c.inertia);
            Stretch {
                x: panel.x,
                h: panel.h,
                values: std::array::from_fn(|i| work[i] - k * inertia[i]),
                slopes: panel
                    .coefficients
                    .values(|c| c.moment_at(self.speed) + self.mean_moment - k * c.slope),
            }
        };
        let found = extremes(self.panels.iter().zip(&self.work).map(piece));
        found.map_or([0.0; 2], |[least, greatest]| [least.value, greatest.value])
    }

    /// max ΔA - min ΔA, J.
    pub(crate) fn excess_work(&self) -> f64 {
        let [low, high] = self.range(0.0);
        high - low
    }

    /// The flywheel by each method of the textbooks, and the exact one; `constant_inertia`: the part of J(q) that does not vary,
    /// kg m².
    pub(crate) fn flywheels(
        &self,
        Tuned { unknowns, range, .. }: &Tuned,
        target: &TuningTarget,
        constant_inertia: f64,
    ) -> Vec<FlywheelByMethod> {
        let (speed, exact) = (range.mean(), unknowns.flywheel);
        let unevenness = target.unevenness.unwrap_or(range.unevenness());
        let ratio = unknowns.ratio().unwrap_or(1.0);
        let rotor = ratio * ratio * target.rotor;
        let to_own_shaft = if target.on_motor { 1.0 / (ratio * ratio) } else { 1.0 };
        let square = speed * speed;
        let by = 1.0 / (square * unevenness);
        let excess = self.excess_work() * by;
        let [low, high] = self.range(0.5 * square);
        let row = |method, formula, reduced: f64| {
            let flywheel = reduced * to_own_shaft;
            let difference = Some((flywheel - exact) / exact).filter(|value| value.is_finite());
            FlywheelByMethod { method, formula, flywheel, difference }
        };
        let less_inertia = excess - self.mean_inertia - rotor;
        let mertsalov = (high - low) * by - constant_inertia - rotor;
        let wittenbauer = self.wittenbauer(speed, unevenness).0 - rotor;
        vec![
            row("excess-work", text!("dynamics-flywheel-excess-work"), excess),
            row("excess-work-less-inertia", text!("dynamics-flywheel-less-inertia"), less_inertia),
            row("mertsalov", text!("dynamics-flywheel-mertsalov"), mertsalov),
            row("wittenbauer", text!("dynamics-flywheel-wittenbauer"), wittenbauer),
            FlywheelByMethod {
                method: "exact",
                formula: text!("dynamics-flywheel-exact"),
                flywheel: exact,
                difference: Some(0.0),
            },
        ]
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
