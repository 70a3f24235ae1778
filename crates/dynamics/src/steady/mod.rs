//! The steady regime: the periodic speed over a cycle, and the ratio and flywheel that give it what is wanted.
//!
//! [`Survey`] looks at the machine once: J, J' and Q at the nodes of panels between all jumps of the loads. Everything after that
//! (shooting, ratio, flywheel) reuses them, unless a load depends on the speed. [`Survey::solve`] finds a [`Regime`].

mod approximate;
mod arc;
mod collocation;
mod crossing;
mod curve;
mod newton;
mod path;
mod regime;
mod report;
mod shooting;
mod start;
mod sweep;
mod tuning;

use assur_integrator::Motion;
use assur_motor::Characteristic;

use crate::DynamicsError;
use approximate::Diagram;
use path::{Road, Way};
use shooting::Shooter;

pub use regime::Regime;
pub use report::{Effort, FlywheelByMethod, RegimeState, Trial, Turn};

/// Accuracy to which polynomials resolve the machine before the regime is known.
const RESOLVE: f64 = 1e-9;

/// The cycle that is looked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleRequest {
    /// Coordinate at which a cycle begins, rad.
    pub start: f64,
    /// Its length, rad, positive.
    pub length: f64,
    /// Wanted mean speed with its sign, rad/s: (max + min)/2.
    pub mean_speed: f64,
    /// The part of J(q) that does not vary, kg m²: the input link about its pin. For the methods of the textbooks.
    pub constant_inertia: f64,
}

/// What drives, and what of it is wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveRequest {
    /// The torque.
    pub torque: TorqueRequest,
    /// Given flywheel, kg m² on its own shaft; `None`: find it from `unevenness`.
    pub flywheel: Option<f64>,
    /// The flywheel sits on the motor shaft.
    pub flywheel_on_motor: bool,
    /// Wanted unevenness; needed where the flywheel is.
    pub unevenness: Option<f64>,
}

/// Torque of the drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TorqueRequest {
    /// None.
    None,
    /// The constant moment that makes the work of a cycle zero.
    Balance,
    /// A constant moment along the coordinate, N m.
    Constant(f64),
    /// An asynchronous motor.
    Motor {
        /// Its characteristic.
        characteristic: Characteristic,
        /// Rotor, kg m² on its own shaft; 0: not modelled.
        rotor: f64,
        /// Given ratio; `None`: find it from the mean speed.
        ratio: Option<f64>,
        /// Efficiency of the reducer, (0, 1].
        efficiency: f64,
    },
}

/// A machine looked at over one cycle.
#[derive(Debug)]
pub struct Survey<'a> {
    shooter: Shooter<'a>,
    diagram: Diagram,
    request: CycleRequest,
}

impl<'a> Survey<'a> {
    /// Evaluates a machine (without its drive) over a cycle.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::OverTime`], [`DynamicsError::NoCycle`], [`DynamicsError::Equation`] where a position fails.
    pub fn new(motion: &'a mut dyn Motion, request: CycleRequest) -> Result<Self, DynamicsError> {
        if motion.dependence().moment_on_time {
            return Err(DynamicsError::OverTime);
        }
        let usable = |value: f64| value.is_finite() && value != 0.0;
        if !usable(request.length) || !usable(request.mean_speed) || request.length < 0.0 {
            return Err(DynamicsError::NoCycle);
        }
        let way = Way { start: request.start, sense: request.mean_speed.signum(), length: request.length };
        let mut road = Road::new(motion, way);
        let panels = road.panels(request.mean_speed.abs(), RESOLVE)?;
        let diagram = Diagram::new(&panels, &request);
        Ok(Self { shooter: Shooter { road, panels, cycles: 0 }, diagram, request })
    }

    /// Mean of the reduced resisting moment over the cycle, N m, against the motion.
    pub fn mean_resistance(&self) -> f64 {
        self.diagram.mean_moment
    }

    /// The wanted mean speed without its sign, rad/s.
    pub fn wanted_speed(&self) -> f64 {
        self.request.mean_speed.abs()
    }

    /// Work of the resistance over a cycle, J; negative where the loads drive.
    pub fn resistance_work(&self) -> f64 {
        self.diagram.resistance
    }

    /// Power that the motor must have (S stage 5), W: mean resistance work / (time of a cycle * efficiency), at the
    /// wanted mean speed. Negative where the loads drive; then nothing is divided by the efficiency.
    pub fn required_power(&self, efficiency: f64) -> f64 {
        let power = self.diagram.resistance * self.request.mean_speed.abs() / self.request.length;
        if power > 0.0 { power / efficiency } else { power }
    }

    /// Greatest resisting moment over the cycle, N m, against the motion.
    pub fn greatest_resistance(&self) -> f64 {
        let nodes =
            self.shooter.panels.iter().flat_map(|panel| panel.data.nodes.iter().chain([&panel.data.start]));
        nodes.map(|node| -node.moment_at(self.wanted_speed())).fold(f64::NEG_INFINITY, f64::max)
    }
}

#[cfg(test)]
mod tests;
