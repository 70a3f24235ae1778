//! Panel after panel along the coordinate, through pieces and turning points, to the end.

use assur_integrator::{
    Curve, EquationOfMotion, EventKind, IntegrationError, Integrator, MotionError, Request, Run, State,
    Trajectory, Until,
};
use assur_words::text;

use crate::clock::{Clock, EnergyPanel, Rests, Values, factor};

/// If a turning point is nearer to the start than this part of the panel, the panel is fitted again with that length.
const TOO_NEAR: f64 = 0.2;

/// Least part of its length to which a panel is shortened at once.
const NEAREST: f64 = 1e-3;

/// Largest growth of the kinetic energy over a panel. With a slower start its speed would be lost in the rounding of
/// the work, and with it the time, since 1/w is nearly singular there. The relative loss is eps times the root of this
/// factor.
const RISE: f64 = 1e6;

/// First panel, rad (m), where nothing else limits it.
const FIRST_PANEL: f64 = 0.5;

/// Least tolerance of the time: the roundings of a fit.
const CLOCK_ROUNDING: f64 = 1e-13;

/// The motion through a panel.
#[derive(Debug, Clone)]
struct Passage {
    panel: Box<EnergyPanel>,
    clock: Clock,
}

impl Curve for Passage {
    fn at(&self, _: &State, time: f64) -> State {
        let (x, energy) = self.clock.at(time);
        State { time, coordinate: self.panel.coordinate(x), speed: self.panel.speed(x, energy) }
    }
}

/// How the motion through a panel ends.
#[derive(Debug, Clone, Copy)]
enum Ending {
    EnergyPanel,
    /// At a bound of the piece, or at the requested coordinate (`true`).
    Bound(f64, bool),
    Turning(f64),
}

/// The solution in progress.
pub(crate) struct March<'a> {
    run: Run<'a, Passage>,
    /// Kinetic energy here, and the largest so far, N m.
    energy: f64,
    largest: f64,
    /// Next panel, without sign, rad (m).
    length: f64,
    /// J and Q here, if known.
    known: Option<Values>,
}

/// Advances in panels of the coordinate.
pub(crate) struct Energy;

impl Integrator for Energy {
    fn solve(
        &self,
        motion: &mut dyn EquationOfMotion,
        request: &Request,
    ) -> Result<Trajectory, IntegrationError> {
        let run = Run::new(motion, request);
        let mut march = March { run, energy: 0.0, largest: 0.0, length: FIRST_PANEL, known: None };
        march.begin()?;
        while !march.run.finished {
            if march.run.is_exhausted() {
                return Err(march.run.too_many_steps(march.step(), None));
            }
            march.run.check_way(march.run.node.state.coordinate)?;
            march.advance()?;
        }
        march.run.conclude()
    }
}

impl March<'_> {
    fn begin(&mut self) -> Result<(), IntegrationError> {
        let moving = self.run.begin()?;
        let state = self.run.node.state;
        let (inertia, _) = self.run.equation.work(&state).map_err(|source| self.run.failed(source))?;
        self.energy = 0.5 * inertia * state.speed * state.speed;
        self.largest = self.energy;
        if moving { Ok(()) } else { self.run.coast_to_end() }
    }

    /// Tolerance of a fit: half of the requested one, since errors of speed and time add up, but no less than rounding
    /// allows.
    fn tolerance(&self) -> f64 {
        (0.5 * self.run.request.tolerance).max(1e-14)
    }

    /// Time of the next panel at the present speed, s.
    fn step(&self) -> f64 {
        self.length / self.run.node.state.speed.abs().max(f64::MIN_POSITIVE)
    }

    /// Enters the piece ahead, or stays at rest.
    fn enter_next(&mut self) -> Result<(), IntegrationError> {
        self.known = None;
        let moving = self.run.enter_next(false)?;
        if self.run.node.state.speed == 0.0 {
            self.energy = 0.0;
        }
        if moving { Ok(()) } else { self.run.coast_to_end() }
    }

    /// Starts again from rest, if the remaining speed is lost in rounding.
    fn restart(&mut self) -> Result<(), IntegrationError> {
        self.run.equation.cost.rejected += 1;
        self.run.node.state.speed = 0.0;
        self.enter_next()
    }

    fn direction(&self) -> f64 {
        let node = &self.run.node;
        if node.state.speed == 0.0 { node.acceleration.signum() } else { node.state.speed.signum() }
    }

    /// Length of the next panel, and whether it ends at the bound.
    fn plan(&self, bound: f64) -> (f64, bool) {
        let node = &self.run.node;
        let room = (bound - node.state.coordinate).abs();
        let left = self.run.request.latest() - node.state.time;
        let mut length = self.length;
        if left.is_finite() {
            let push = (node.acceleration * self.direction()).max(0.0);
            let reach = left * (node.state.speed.abs() + 0.5 * left * push);
            length = length.min(1.1 * reach).max(1e-6 * self.length);
        }
        if length * 1.05 >= room { (room, true) } else { (length, false) }
    }

    fn advance(&mut self) -> Result<(), IntegrationError> {
        let direction = self.direction();
        let (bound, is_goal) = self.run.coordinate_ahead(direction);
        let (length, at_bound) = self.plan(bound);
        let state = self.run.node.state;
        let from = State { speed: direction * state.speed.abs().max(f64::MIN_POSITIVE), ..state };
        let energies = (self.energy, self.largest);
        let fitted =
            EnergyPanel::fit(&mut self.run.equation, &from, direction * length, self.known, energies);
        let panel = match fitted {
            Ok(panel) => panel,
            Err(source) => return self.shorten(length, 0.5, Some(source)),
        };
        let factor = factor(self.tolerance(), panel.error);
        if panel.error > self.tolerance() {
            return self.shorten(length, factor.clamp(0.1, 0.7), None);
        }
        let rise = panel.most_energy() / self.energy.max(f64::MIN_POSITIVE);
        let ending = match panel.turning(self.energy <= 0.0) {
            None if self.energy > 0.0 && rise > RISE => return self.shorten_or_restart(length, RISE / rise),
            Some(x) if 0.5 * (x + 1.0) < TOO_NEAR => {
                return self.shorten_or_restart(length, (0.75 * (x + 1.0)).max(NEAREST));
            }
            Some(x) => Ending::Turning(x),
            None if at_bound => Ending::Bound(bound, is_goal),
            None => Ending::EnergyPanel,
        };
        let grown = length * factor.clamp(0.3, 3.0);
        self.length = if at_bound { self.length.max(grown) } else { grown };
        self.pass(&panel, ending)
    }

    /// Length that is lost in the rounding of the coordinate.
    fn least(&self) -> f64 {
        16.0 * f64::EPSILON * self.run.node.state.coordinate.abs().max(1e-12)
    }

    /// A panel that is too long for its slow start. The start counts as rest if the displacement that corresponds to
    /// its speed is lost in rounding.
    fn shorten_or_restart(&mut self, length: f64, by: f64) -> Result<(), IntegrationError> {
        if length * by > self.least() { self.shorten(length, by, None) } else { self.restart() }
    }

    fn shorten(&mut self, length: f64, by: f64, source: Option<MotionError>) -> Result<(), IntegrationError> {
        self.run.equation.cost.rejected += 1;
        self.length = length * by;
        if self.length > self.least() {
            return Ok(());
        }
        let step = self.step();
        Err(self.run.stuck(step, source))
    }

    /// Advances through a fitted panel to its end, to the turning point in it, or to the latest time.
    fn pass(&mut self, panel: &EnergyPanel, ending: Ending) -> Result<(), IntegrationError> {
        let latest = self.run.request.latest();
        let turning = if let Ending::Turning(x) = ending { Some(x) } else { None };
        let until = turning.unwrap_or(1.0);
        let rests = Rests { at_start: self.energy <= 0.0, at_end: turning.is_some() };
        let begin = self.run.node.state.time;
        let tolerance = self.tolerance().max(CLOCK_ROUNDING);
        let clock = Clock::measure(panel, (until, rests), (begin, latest), tolerance);
        let clock = clock.ok_or_else(|| self.run.not_reached(text!("integrator-energy-creeps")))?;
        self.run.equation.cost.steps += 1;
        self.largest = self.largest.max(panel.most_energy());
        let end = clock.end();
        let passage = Passage { panel: Box::new(*panel), clock };
        if end >= latest {
            let state = passage.at(&self.run.node.state, latest);
            self.run.record(passage, end);
            self.run.node.state = state;
            self.run.time_is_over()?;
            return self.run.finish();
        }
        self.run.record(passage, end);
        self.energy = panel.energy(until);
        let speed = panel.speed(until, self.energy);
        self.run.node.state = State { time: end, coordinate: panel.coordinate(until), speed };
        let (inertia, moment) = panel.last;
        self.known = Some(panel.last);
        self.run.node.acceleration = moment / inertia;
        match ending {
            Ending::EnergyPanel => Ok(()),
            Ending::Turning(_) => self.turn(panel.length),
            Ending::Bound(bound, is_goal) => {
                self.run.node.state.coordinate = bound;
                if is_goal {
                    return self.run.finish();
                }
                self.run.event(EventKind::Coordinate);
                self.enter_next()
            }
        }
    }

    /// At a turning point: the end, a reversal, or rest. `before` has the sign of the speed before it.
    fn turn(&mut self, before: f64) -> Result<(), IntegrationError> {
        self.run.node.state.speed = 0.0;
        self.energy = 0.0;
        if self.run.request.until == Until::Turn {
            return self.run.finish();
        }
        let state = self.run.node.state;
        self.enter_next()?;
        if self.run.node.acceleration * before < 0.0 {
            self.run.reversal(state, before)?;
        }
        Ok(())
    }
}
