//! The periodic regime: a cycle that ends with the speed with which it began.

use super::path::{Path, PathPanel};
use super::run::run_cycle;
use super::segment::{BY_DRIVE, Misses, Setup};
use super::solution::{Closing, CycleSolution, Iteration, Stretch, extremes};
use crate::{DynamicsError, drive::TorqueSource};

/// Newton steps towards a periodic cycle.
const MOST_ITERATIONS: usize = 60;

/// A multiplier this near to 1 means that nothing restores the speed.
const NEUTRAL: f64 = 1e-9;

/// Allowed residual of the equation between the nodes, as part of the energy.
const RESIDUAL: f64 = 2e-13;

/// Allowed error of the square of the speed and of the time between the nodes, as part of them: the quotients of what is resolved
/// are less smooth than it is, most of all where the machine nearly stalls.
const SPEED: f64 = 1e-9;

/// Allowed error of the moments in the equation with the acceleration that is read between the nodes, as part of the greatest.
const MOMENT: f64 = 1e-8;

/// Finds periodic cycles of one machine.
pub(crate) struct Shooting<'a> {
    pub(crate) path: Path<'a>,
    pub(crate) panels: Vec<PathPanel>,
    /// Cycles run so far.
    pub(crate) cycles: usize,
}

/// Newton's step of the initial energy. Where the motion departs from its present speed (a motor beyond its breakdown),
/// Newton's method would lead to the unstable regime: there the step follows the motion.
fn restoring_step(found: &CycleSolution, number: usize) -> Result<f64, DynamicsError> {
    /// Number of cycles of the motion that one such step covers.
    const AHEAD: f64 = 4.0;
    let (gap, energy, left) = (found.end - found.start, found.start, 1.0 - found.multiplier());
    if number == 1 && left.abs() < NEUTRAL {
        return Err(DynamicsError::NoRegime { work: gap, energy });
    }
    if left < NEUTRAL {
        return Ok((AHEAD * gap).clamp(-0.3 * energy, 0.3 * energy));
    }
    Ok((gap / left).clamp(-0.7 * energy, 2.0 * energy))
}

impl Shooting<'_> {
    /// Rejects a machine that has no inertia somewhere, between the nodes too.
    pub(crate) fn check_inertia(&self, setup: &Setup) -> Result<(), DynamicsError> {
        /// Inertia below this part of the greatest counts as none: polynomials resolve it to 1e-9.
        const NOTHING: f64 = 1e-8;
        let piece = |panel: &PathPanel| Stretch {
            x: panel.x,
            h: panel.h,
            values: panel.coefficients.values(|node| node.inertia + setup.drive.inertia),
            slopes: panel.coefficients.values(|node| node.slope),
        };
        let Some([least, greatest]) = extremes(self.panels.iter().map(piece)) else { return Ok(()) };
        if least.value > NOTHING * greatest.value {
            return Ok(());
        }
        let coordinate = self.path.cycle.coordinate(least.x);
        let inertia = if least.value < -NOTHING * greatest.value { least.value } else { 0.0 };
        Err(DynamicsError::NoInertia { coordinate, inertia })
    }

    /// One cycle from the given initial energy.
    pub(crate) fn run(
        &mut self,
        setup: Setup,
        energy: f64,
        guess: Option<&CycleSolution>,
    ) -> Result<CycleSolution, DynamicsError> {
        self.cycles += 1;
        run_cycle(&mut self.path, setup, &self.panels, energy, guess)
    }

    /// The periodic cycle nearest to a start, by Newton's method; `iterations` receives each cycle.
    pub(crate) fn close(
        &mut self,
        mut setup: Setup,
        closing: Closing,
        mut energy: f64,
        mut guess: Option<CycleSolution>,
        iterations: &mut Vec<Iteration>,
    ) -> Result<CycleSolution, DynamicsError> {
        /// Corrections below this part are rounding.
        const ROUNDING: f64 = 1e-13;
        let mut before = f64::INFINITY;
        for number in 1..=MOST_ITERATIONS {
            let found = self.run(setup, energy, guess.as_ref())?;
            iterations.push(found.iteration(number));
            let gap = found.end - found.start;
            let relative = match closing {
                Closing::Free => return Ok(found),
                Closing::Speed => {
                    let step = restoring_step(&found, number)?;
                    energy += step;
                    (step / energy).abs()
                }
                Closing::Moment => {
                    let step = -gap / found.derivatives[BY_DRIVE];
                    if let TorqueSource::Constant(moment) = &mut setup.drive.source {
                        *moment += step;
                    }
                    (gap / energy).abs()
                }
            };
            if relative <= ROUNDING || (relative < 1e-10 && relative > 0.3 * before) {
                return Ok(found);
            }
            before = relative;
            guess = Some(found);
        }
        Err(DynamicsError::NotPeriodic { cycles: MOST_ITERATIONS, residual: before })
    }

    /// Halves the panels on which the solution is not resolved; returns what it misses and whether any panel was halved.
    pub(crate) fn refine(&mut self, found: &CycleSolution) -> Result<(Misses, bool), DynamicsError> {
        /// Shortest panel, as part of the cycle.
        const LEAST: f64 = 1.0 / 65536.0;
        let drive = &found.setup.drive;
        let terms = found.segments.iter().map(|segment| segment.terms(drive)).fold(0.0, f64::max);
        let mut worst = Misses { residual: 0.0, speed: 0.0, moment: 0.0 };
        let mut marked = vec![false; self.panels.len()];
        for segment in &found.segments {
            let misses = segment.misses(drive);
            let Misses { residual, speed, moment } = misses;
            worst = worst.or(&misses);
            let resolved = residual <= RESIDUAL && speed <= SPEED && moment <= MOMENT * terms;
            let middle = segment.x + 0.5 * segment.h;
            let panel = self.panels.partition_point(|panel| panel.x <= middle).saturating_sub(1);
            marked[panel] |= !resolved && self.panels[panel].h > LEAST * self.path.cycle.length;
        }
        if !marked.contains(&true) {
            return Ok((worst, false));
        }
        let old = std::mem::take(&mut self.panels);
        for (panel, marked) in old.into_iter().zip(marked) {
            if !marked {
                self.panels.push(panel);
                continue;
            }
            let half = 0.5 * panel.h;
            let v = found.speed_at(panel.x + half);
            for x in [panel.x, panel.x + half] {
                let coefficients = self.path.coefficients(x, half, v)?;
                self.panels.push(PathPanel { x, h: half, coefficients });
            }
        }
        Ok((worst, true))
    }
}
