//! The periodic regime: a cycle that ends with the speed with which it began.

use super::arc::Solution;
use super::collocation::S;
use super::curve::{Extreme, Piece, extremes};
use super::path::{Panel, Road};
use super::report::Turn;
use super::sweep::{BY_DRIVE, BY_ENERGY, BY_FLYWHEEL, PARAMETERS, Setup, Sweep};
use crate::DynamicsError;
use crate::shaft::Source;

/// Newton steps towards a periodic cycle.
const MOST_TURNS: usize = 60;

/// A multiplier this near to 1 means that no speed restores itself.
const NEUTRAL: f64 = 1e-9;

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

/// Finds periodic cycles of one machine.
#[derive(Debug)]
pub(crate) struct Shooter<'a> {
    pub(crate) road: Road<'a>,
    pub(crate) panels: Vec<Panel>,
    /// Cycles run so far.
    pub(crate) cycles: usize,
}

/// Least and greatest speed of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Swing {
    pub(crate) least: Speed,
    pub(crate) greatest: Speed,
}

/// An extreme speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Speed {
    pub(crate) at: Extreme,
    /// v, rad/s.
    pub(crate) value: f64,
    /// Its derivatives at a fixed place.
    pub(crate) derivatives: [f64; PARAMETERS],
}

impl Swing {
    pub(crate) fn mean(&self) -> f64 {
        0.5 * (self.least.value + self.greatest.value)
    }

    pub(crate) fn unevenness(&self) -> f64 {
        (self.greatest.value - self.least.value) / self.mean()
    }

    /// Change of mean and unevenness along a direction of the parameters.
    pub(crate) fn change(&self, direction: &[f64; PARAMETERS]) -> [f64; 2] {
        let along =
            |speed: &Speed| -> f64 { speed.derivatives.iter().zip(direction).map(|(a, b)| a * b).sum() };
        let (low, high) = (along(&self.least), along(&self.greatest));
        let mean = 0.5 * (low + high);
        [mean, ((high - low) - self.unevenness() * mean) / self.mean()]
    }
}

impl Solution {
    fn curve(&self) -> Vec<Piece> {
        let piece = |arc: &super::arc::Arc| {
            let places: [super::arc::Place; S + 1] = std::array::from_fn(|i| arc.place(i, &self.setup.shaft));
            Piece {
                x: arc.x,
                h: arc.h,
                start: places[0].half_square,
                values: std::array::from_fn(|i| places[i + 1].half_square),
                start_slope: places[0].acceleration,
                slopes: std::array::from_fn(|i| places[i + 1].acceleration),
            }
        };
        self.arcs.iter().map(piece).collect()
    }

    /// Least and greatest speed; `None` for a cycle without arcs.
    pub(crate) fn swing(&self) -> Option<Swing> {
        let [least, greatest] = extremes(&self.curve())?;
        Some(Swing { least: self.speed(least), greatest: self.speed(greatest) })
    }

    fn speed(&self, at: Extreme) -> Speed {
        let arc = &self.arcs[at.piece];
        let value = (2.0 * at.value).sqrt();
        let inertia = arc.inertia_at(at.theta) + self.setup.shaft.inertia;
        let [by_ratio, by_flywheel] = self.setup.inertia_by;
        let by_inertia = [0.0, by_ratio, by_flywheel];
        let energies = arc.derivatives_at(at.theta);
        // v²/2 = T/J
        let derivatives =
            std::array::from_fn(|p| (energies[p] - at.value * by_inertia[p]) / (inertia * value));
        Speed { at, value, derivatives }
    }

    /// How the parameters change together so that the cycle stays closed: per unit of the level (ratio or initial energy),
    /// and per unit of the flywheel.
    pub(crate) fn directions(&self, closing: Closing) -> [[f64; PARAMETERS]; 2] {
        let [m, d, f] = [BY_ENERGY, BY_DRIVE, BY_FLYWHEEL].map(|p| self.derivatives[p]);
        match closing {
            Closing::Speed => [[d / (1.0 - m), 1.0, 0.0], [f / (1.0 - m), 0.0, 1.0]],
            Closing::Moment => [[1.0, (1.0 - m) / d, 0.0], [0.0, -f / d, 1.0]],
            Closing::Free => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        }
    }

    /// dT(end)/dT(start): below 1, the regime is stable.
    pub(crate) fn multiplier(&self) -> f64 {
        self.derivatives[BY_ENERGY]
    }

    fn turn(&self, number: usize) -> Turn {
        let speed =
            |energy: f64, arc: Option<&super::arc::Arc>, last: bool| {
                let datum = arc.map_or_else(Default::default, |arc| {
                    if last { arc.data.nodes[S - 1] } else { arc.data.start }
                });
                self.way.sense * (2.0 * energy / (datum.inertia + self.setup.shaft.inertia)).sqrt()
            };
        let (start, end) =
            (speed(self.start, self.arcs.first(), false), speed(self.end, self.arcs.last(), true));
        Turn { number, speed_start: start, speed_end: end, residual: end - start }
    }
}

/// Newton's step of the initial energy. Where the motion flees from its present speed instead (a motor beyond its
/// breakdown), Newton's method would lead to the unstable regime: there the step goes where the motion goes.
fn restoring_step(found: &Solution, number: usize) -> Result<f64, DynamicsError> {
    /// Cycles that one step makes in the direction of the motion.
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

impl Shooter<'_> {
    /// Refuses a machine without inertia somewhere.
    pub(crate) fn check_inertia(&self, setup: &Setup) -> Result<(), DynamicsError> {
        for panel in &self.panels {
            let nodes = panel.data.nodes.iter().chain([&panel.data.start]);
            let inertia = nodes.map(|node| node.inertia).fold(f64::INFINITY, f64::min) + setup.shaft.inertia;
            if inertia.is_nan() || inertia <= 0.0 {
                return Err(DynamicsError::NoInertia {
                    coordinate: self.road.way.coordinate(panel.x),
                    inertia,
                });
            }
        }
        Ok(())
    }

    /// One cycle from the given initial energy.
    pub(crate) fn run(
        &mut self,
        setup: Setup,
        energy: f64,
        guess: Option<&Solution>,
    ) -> Result<Solution, DynamicsError> {
        self.cycles += 1;
        Sweep::run(&mut self.road, setup, &self.panels, energy, guess)
    }

    /// The periodic cycle nearest to a start, by Newton's method; `turns` takes what each cycle did.
    pub(crate) fn close(
        &mut self,
        mut setup: Setup,
        closing: Closing,
        mut energy: f64,
        mut guess: Option<Solution>,
        turns: &mut Vec<Turn>,
    ) -> Result<Solution, DynamicsError> {
        /// Corrections below this part are rounding.
        const ROUNDING: f64 = 1e-13;
        let mut before = f64::INFINITY;
        for number in 1..=MOST_TURNS {
            let found = self.run(setup, energy, guess.as_ref())?;
            turns.push(found.turn(number));
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
                    if let Source::Constant(moment) = &mut setup.shaft.source {
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
        Err(DynamicsError::NotPeriodic { cycles: MOST_TURNS, residual: before })
    }

    /// Runs cycle after cycle until the speed at the start changes by less than `tolerance` (relative): the slow
    /// method, for comparison.
    pub(crate) fn settle(
        &mut self,
        setup: Setup,
        mut energy: f64,
        tolerance: f64,
        most: usize,
    ) -> Result<(Solution, Vec<Turn>), DynamicsError> {
        let mut turns = Vec::new();
        let mut guess: Option<Solution> = None;
        for number in 1..=most {
            let found = self.run(setup, energy, guess.as_ref())?;
            turns.push(found.turn(number));
            let residual = ((found.end - found.start) / found.start).abs();
            if residual <= tolerance {
                return Ok((found, turns));
            }
            energy = found.end;
            guess = Some(found);
        }
        let residual = turns.last().map_or(f64::NAN, |turn| (turn.residual / turn.speed_start).abs());
        Err(DynamicsError::NotPeriodic { cycles: most, residual })
    }

    /// Halves the panels on which the solution misses the equation by more than `tolerance` of the energy; the
    /// worst miss and whether there was anything to halve.
    pub(crate) fn refine(&mut self, found: &Solution, tolerance: f64) -> Result<(f64, bool), DynamicsError> {
        /// Not below this part of the cycle.
        const LEAST: f64 = 1.0 / 65536.0;
        let mut worst: f64 = 0.0;
        let mut marked = vec![false; self.panels.len()];
        for arc in &found.arcs {
            let miss = arc.residual(found.middle_moment(arc)) / arc.start;
            worst = worst.max(miss);
            let panel = self.panels.partition_point(|panel| panel.x <= arc.x + 0.5 * arc.h).saturating_sub(1);
            marked[panel] |= miss > tolerance && self.panels[panel].h > LEAST * self.road.way.length;
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
                let data = self.road.data(x, half, v)?;
                self.panels.push(Panel { x, h: half, data });
            }
        }
        Ok((worst, true))
    }
}

impl Solution {
    /// Moment by the equation in the middle of an arc.
    fn middle_moment(&self, arc: &super::arc::Arc) -> f64 {
        let inertia = arc.data.middle.inertia + self.setup.shaft.inertia;
        let v = (2.0 * arc.middle_energy() / inertia).sqrt();
        arc.data.middle.moment_at(v) + self.setup.shaft.moment(arc.factor, v).value
    }

    /// Speed along the path at a place, rad/s.
    pub(crate) fn speed_at(&self, x: f64) -> f64 {
        self.arc(x).map_or(0.0, |arc| {
            let theta = (x - arc.x) / arc.h;
            (2.0 * arc.energy_at(theta) / (arc.inertia_at(theta) + self.setup.shaft.inertia)).sqrt()
        })
    }
}
