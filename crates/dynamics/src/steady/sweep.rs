//! One cycle from a given kinetic energy: collocation on each panel by Newton's method, with the derivatives of the
//! energy by its initial value, by the drive and by the flywheel (variational equation).

use super::arc::{Arc, Solution};
use super::collocation::{Lu, Nodal, RULE, S, dot, product};
use super::path::{Data, Datum, Panel, Road};
use crate::{DynamicsError, Shaft};

/// Number of quantities by which the energy is differentiated.
pub(crate) const PARAMETERS: usize = 3;

/// Initial energy.
pub(crate) const BY_ENERGY: usize = 0;
/// Ratio u, or the constant moment.
pub(crate) const BY_DRIVE: usize = 1;
/// Flywheel on its own shaft.
pub(crate) const BY_FLYWHEEL: usize = 2;

/// Panels are halved so often where Newton's method fails.
const MOST_HALVINGS: usize = 12;

/// Newton steps for a panel.
const MOST_STEPS: usize = 30;

/// What is on the shaft, and how its inertia follows from the unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Setup {
    pub(crate) shaft: Shaft,
    /// d(shaft inertia) by ratio and by flywheel.
    pub(crate) inertia_by: [f64; 2],
}

/// Why a panel could not be solved.
#[derive(Debug)]
enum Failure {
    /// Newton's method did not converge; whether the speed went to zero.
    Newton {
        stalled: bool,
    },
    Error(DynamicsError),
}

impl From<DynamicsError> for Failure {
    fn from(error: DynamicsError) -> Self {
        Self::Error(error)
    }
}

/// Moment at a place, and its derivatives.
#[derive(Debug, Clone, Copy, Default)]
struct Force {
    value: f64,
    by_energy: f64,
    by_parameter: [f64; 2],
}

/// A run along the path.
#[derive(Debug)]
pub(crate) struct Sweep<'r, 'a> {
    road: &'r mut Road<'a>,
    setup: Setup,
    energy: f64,
    derivatives: [f64; PARAMETERS],
    /// η or 1/η.
    factor: f64,
    /// Speeds between which the present formulas hold.
    bounds: [f64; 2],
    /// Crossings of such a bound so far.
    crossings: usize,
    arcs: Vec<Arc>,
}

impl<'r, 'a> Sweep<'r, 'a> {
    /// Runs one cycle from the kinetic energy `energy`; `guess` is a run nearby.
    pub(crate) fn run(
        road: &'r mut Road<'a>,
        setup: Setup,
        panels: &[Panel],
        energy: f64,
        guess: Option<&Solution>,
    ) -> Result<Solution, DynamicsError> {
        let by_speed = road.by_speed;
        let mut sweep = Self {
            road,
            setup,
            energy,
            derivatives: [1.0, 0.0, 0.0],
            factor: 1.0,
            bounds: [0.0, f64::INFINITY],
            crossings: 0,
            arcs: Vec::with_capacity(panels.len() + 8),
        };
        let mut near = guess.map_or(&[][..], |solution| &solution.arcs);
        for (index, panel) in panels.iter().enumerate() {
            while let [first, rest @ ..] = near
                && first.x < panel.x
            {
                near = rest;
            }
            let start = near.first().filter(|arc| arc.same_place(panel.x, panel.h)).map(|arc| &arc.energy);
            if by_speed || index == 0 {
                sweep.choose(panel.x, panel.h, 0.0, &panel.data.start)?;
            }
            sweep.advance(panel.x, panel.h, &panel.data, start.copied(), 0)?;
        }
        let Self { energy: end, derivatives, arcs, .. } = sweep;
        Ok(Solution { setup, way: sweep.road.way, start: energy, end, derivatives, arcs })
    }

    fn speed(&self, energy: f64, datum: &Datum) -> f64 {
        (2.0 * energy / (datum.inertia + self.setup.shaft.inertia)).sqrt()
    }

    /// Chooses the formulas for a speed just beside the present one, on the given side.
    fn choose(&mut self, x: f64, h: f64, side: f64, at: &Datum) -> Result<(), DynamicsError> {
        /// Far above rounding, far below any width between two rows of a table.
        const BESIDE: f64 = 1e-10;
        let v = self.speed(self.energy, at) * (1.0 + side * BESIDE);
        let branch = self.setup.shaft.branch(v);
        self.factor = branch.factor;
        self.bounds = branch.speed;
        if self.road.by_speed {
            let [_, speed] = self.road.enter(x + 0.5 * h, v)?;
            self.bounds = [self.bounds[0].max(speed[0]), self.bounds[1].min(speed[1])];
        }
        Ok(())
    }

    #[inline]
    fn force(&mut self, datum: &Datum, x: f64, energy: f64) -> Result<Force, DynamicsError> {
        let inertia = datum.inertia + self.setup.shaft.inertia;
        let v = (2.0 * energy / inertia).sqrt();
        let drive = self.setup.shaft.moment(self.factor, v);
        let [load, load_by_speed] =
            if self.road.by_speed { self.road.moment(x, v)? } else { [datum.moment, 0.0] };
        let by_speed = drive.by_speed + load_by_speed;
        let by_inertia = -by_speed * v / (2.0 * inertia);
        let [by_ratio, by_flywheel] = self.setup.inertia_by;
        Ok(Force {
            value: load + drive.value,
            by_energy: by_speed / (inertia * v),
            by_parameter: [drive.by_parameter + by_inertia * by_ratio, by_inertia * by_flywheel],
        })
    }

    /// Solves a stretch of the path and goes to its end; where the formulas change inside, in several arcs.
    fn advance(
        &mut self,
        x: f64,
        h: f64,
        data: &Data,
        guess: Option<Nodal>,
        halvings: usize,
    ) -> Result<(), DynamicsError> {
        match self.solve(x, h, data, guess) {
            Ok(arc) => match self.first_crossing(&arc) {
                None => {
                    self.keep(arc);
                    Ok(())
                }
                Some((theta, side)) => self.cross(&arc, theta, side, halvings),
            },
            Err(Failure::Error(error)) => Err(error),
            Err(Failure::Newton { .. }) if halvings < MOST_HALVINGS => {
                let half = 0.5 * h;
                for x in [x, x + half] {
                    let data = self.data(x, half)?;
                    self.advance(x, half, &data, None, halvings + 1)?;
                }
                Ok(())
            }
            Err(Failure::Newton { stalled }) => {
                let coordinate = self.road.way.coordinate(x);
                Err(if stalled {
                    DynamicsError::Stalled { coordinate }
                } else {
                    DynamicsError::NoPath { coordinate }
                })
            }
        }
    }

    /// Coefficients of a stretch that is no panel.
    fn data(&mut self, x: f64, h: f64) -> Result<Data, DynamicsError> {
        let at = self.arcs.last().map_or(Datum::default(), |arc| arc.data.nodes[S - 1]);
        let v = if self.arcs.is_empty() { 1.0 } else { self.speed(self.energy, &at) };
        self.road.enter(x + 0.5 * h, v)?;
        self.road.data(x, h, v)
    }

    fn keep(&mut self, arc: Arc) {
        self.energy = arc.energy[S - 1];
        self.derivatives = std::array::from_fn(|p| arc.derivatives[p][S - 1]);
        self.arcs.push(arc);
    }

    /// Newton's method for T_i = T_0 + h sum a_ij M(x_j, T_j).
    fn solve(&mut self, x: f64, h: f64, data: &Data, guess: Option<Nodal>) -> Result<Arc, Failure> {
        let start = self.energy;
        let floor = 1e-9 * start;
        let mut energy = guess.unwrap_or([start; S]);
        let mut forces = [Force::default(); S];
        let mut factors;
        let mut steps = 0;
        loop {
            for (j, force) in forces.iter_mut().enumerate() {
                *force = self.force(&data.nodes[j], x + h * RULE.c[j], energy[j])?;
            }
            let integral = product(&RULE.a, &forces.map(|force| force.value));
            let miss: Nodal = std::array::from_fn(|i| start + h * integral[i] - energy[i]);
            factors = Lu::new(std::array::from_fn(|i| {
                std::array::from_fn(|j| f64::from(u8::from(i == j)) - h * RULE.a[i][j] * forces[j].by_energy)
            }));
            let step = factors.solve(&miss);
            let largest = step.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
            for (t, d) in energy.iter_mut().zip(&step) {
                *t = (*t + d).max(0.05 * *t).max(floor);
            }
            steps += 1;
            let most = energy.iter().fold(start, |most, t| most.max(*t));
            // The step is made already: what is left is its square.
            if largest <= 1e-11 * most {
                break;
            }
            if steps == MOST_STEPS || !largest.is_finite() {
                return Err(Failure::Newton { stalled: energy.iter().any(|t| *t < 1e-2 * start) });
            }
        }
        if energy.iter().any(|t| *t <= 2.0 * floor) {
            return Err(Failure::Newton { stalled: true });
        }
        self.arc(x, h, data, energy, &forces, &factors).map_err(Failure::Error)
    }

    /// The arc with its derivatives: the same linear system with other right-hand sides.
    fn arc(
        &mut self,
        x: f64,
        h: f64,
        data: &Data,
        energy: Nodal,
        forces: &[Force; S],
        factors: &Lu,
    ) -> Result<Arc, DynamicsError> {
        let first = self.force(&data.start, x, self.energy)?.value;
        let mut derivatives = [[0.0; S]; PARAMETERS];
        derivatives[BY_ENERGY] = factors.solve(&[1.0; S]).map(|d| d * self.derivatives[BY_ENERGY]);
        for p in [BY_DRIVE, BY_FLYWHEEL] {
            let sources = product(&RULE.a, &forces.map(|force| force.by_parameter[p - 1]));
            let b = sources.map(|source| self.derivatives[p] + h * source);
            derivatives[p] = factors.solve(&b);
        }
        Ok(Arc {
            x,
            h,
            data: *data,
            start: self.energy,
            energy,
            first_moment: first,
            moment: forces.map(|force| force.value),
            start_derivatives: self.derivatives,
            derivatives,
            factor: self.factor,
        })
    }

    /// Where the speed first leaves its bounds, as part of the arc, and on which side.
    fn first_crossing(&self, arc: &Arc) -> Option<(f64, f64)> {
        const SLACK: f64 = 1e-13;
        let [low, high] = self.bounds;
        if low <= 0.0 && high == f64::INFINITY {
            return None;
        }
        let middle = arc.start + arc.h * dot(&RULE.to_middle, &arc.moment);
        let mut inside = 0.0;
        let nodes = (0..S).map(|i| (RULE.c[i], arc.energy[i], &arc.data.nodes[i]));
        let (before, after): (Vec<_>, Vec<_>) = nodes.partition(|node| node.0 < RULE.middle);
        for (theta, energy, datum) in
            before.into_iter().chain([(RULE.middle, middle, &arc.data.middle)]).chain(after)
        {
            let v = self.speed(energy, datum);
            let side = if v > high * (1.0 + SLACK) {
                1.0
            } else if v < low * (1.0 - SLACK) {
                -1.0
            } else {
                inside = theta;
                continue;
            };
            let level = if side > 0.0 { high } else { low };
            return Some((arc.when(level, &self.setup.shaft, [inside, theta]), side));
        }
        None
    }

    /// Goes to the crossing by the old formulas, and on by the new ones.
    fn cross(&mut self, arc: &Arc, theta: f64, side: f64, halvings: usize) -> Result<(), DynamicsError> {
        /// More in one cycle is no motion but chatter.
        const MOST: usize = 1000;
        let (x, h) = (arc.x + theta * arc.h, (1.0 - theta) * arc.h);
        self.crossings += 1;
        let coordinate = self.road.way.coordinate(x);
        if self.crossings > MOST {
            return Err(DynamicsError::NoPath { coordinate });
        }
        if theta > 1e-9 {
            let part = self.data(arc.x, theta * arc.h)?;
            match self.solve(arc.x, theta * arc.h, &part, None) {
                Ok(part) => self.keep(part),
                Err(Failure::Error(error)) => return Err(error),
                Err(Failure::Newton { .. }) => return Err(DynamicsError::NoPath { coordinate }),
            }
        }
        let at = self.road.datum(x, self.speed(self.energy, &arc.data.start))?;
        let before = self.force(&at, x, self.energy)?.value;
        self.choose(x, h, side, &at)?;
        let after = self.force(&at, x, self.energy)?.value;
        self.jump(&at, [before, after], side).map_err(|()| DynamicsError::Held { coordinate })?;
        if h <= 1e-12 * self.road.way.length {
            return Ok(());
        }
        let v = self.speed(self.energy, &at) * (1.0 + side * 1e-10);
        let data = self.road.data(x, h, v)?;
        self.advance(x, h, &data, None, halvings)
    }

    /// What the moving place of a crossing does to the derivatives, if the moment jumps there.
    fn jump(&mut self, at: &Datum, moments: [f64; 2], side: f64) -> Result<(), ()> {
        let inertia = at.inertia + self.setup.shaft.inertia;
        let half_square = self.energy / inertia;
        // The level T = J v²/2 rises with J.
        let approach = moments[0] - at.slope * half_square;
        let leaving = moments[1] - at.slope * half_square;
        if leaving * side <= 0.0 {
            return Err(());
        }
        let [by_ratio, by_flywheel] = self.setup.inertia_by;
        let level = [0.0, by_ratio * half_square, by_flywheel * half_square];
        for (derivative, level) in self.derivatives.iter_mut().zip(level) {
            // dx = -(dT - dB)/(M before - B'), dT after = dT + (M before - M after) dx
            *derivative -= (moments[0] - moments[1]) * (*derivative - level) / approach;
        }
        Ok(())
    }
}
