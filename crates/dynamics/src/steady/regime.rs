//! The request for a steady regime, the periodic regime that answers it, and how it was found.

use assur_force::tolerance;
use assur_motor::Characteristic;
use assur_words::Text;
use serde::Serialize;

use super::solution::{CycleSolution, Iteration, RegimeState};
use super::{path::Values, tuning::Trial};
use crate::InputDrive;

/// The figures of a periodic regime. Speeds and coordinates have the signs of the coordinate; "least" and "greatest"
/// speed are meant without the sign, so that a machine that runs clockwise is the mirror image of one that does not.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Figures {
    /// Motor speed / input speed; `None` without a motor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// Mean speed (greatest + least)/2, rad/s.
    pub mean_speed: f64,
    /// (greatest - least)/mean.
    pub unevenness: f64,
    /// Least speed, rad/s.
    pub speed_min: f64,
    /// Greatest speed, rad/s.
    pub speed_max: f64,
    /// Where the speed is least, rad, within the first cycle.
    pub coordinate_at_min: f64,
    /// Where the speed is greatest, rad.
    pub coordinate_at_max: f64,
    /// Work of all moments from the least speed to the greatest, J (E example 2).
    pub excess_work: f64,
    /// Artobolevsky's dynamic unevenness: 2 δ/(angle from the least speed to the greatest), 1/rad; `None` where both are at
    /// one place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dynamic_unevenness: Option<f64>,
    /// Power needed on the motor shaft, W, at the wanted mean speed; negative where the loads drive.
    pub required_power: f64,
    /// Constant moment of the drive, N m, positive along the direction of the motion, as `torque` of a scene is; `None`
    /// with a motor or without drive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque: Option<f64>,
}

impl Figures {
    /// Whether the loads drive the machine, which do this work over a cycle, J.
    pub fn are_loads_driving(&self, work: f64) -> bool {
        /// A work below this part of the excess work is rounding.
        const ROUNDING: f64 = 1e-9;
        work > ROUNDING * self.excess_work
    }
}

/// The periodic regime; results have its numbers that are no figures and no flywheels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Regime {
    /// Mean of the resisting moment over the cycle, reduced to the input, N m, against the motion.
    pub mean_resistance: f64,
    /// Work of the resistance over a cycle, J; negative where the loads drive.
    pub resistance_work: f64,
    /// Time of a cycle, s.
    pub cycle_time: f64,
    /// Floquet multiplier, the factor of a small change of the speed over a cycle: the regime is stable below 1; 1 if
    /// nothing restores the speed.
    pub multiplier: f64,
    /// Flywheel and rotor reduced to the input, kg m².
    #[serde(rename = "shaft_inertia")]
    pub drive_inertia: f64,
    /// The requested unevenness is achieved without a flywheel.
    pub flywheel_needless: bool,
    /// Cost of the solution, and its accuracy.
    #[serde(flatten)]
    pub effort: Effort,
    /// Iteration to the periodic regime from the mean speed (S fig. 10); empty if the machine stalls in its first cycle.
    #[serde(rename = "iteration")]
    pub iterations: Vec<Iteration>,
    /// Trials of ratio and flywheel (S stage 6).
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub trials: Vec<Trial>,
    /// Flywheel on its own shaft, without the rotor, kg m²: the given one, or the one found (0: none is needed).
    #[serde(skip)]
    pub flywheel: f64,
    /// Its figures.
    #[serde(skip)]
    pub figures: Figures,
    /// The flywheel by the methods of the textbooks, and exactly.
    #[serde(skip)]
    pub flywheel_by_method: Vec<FlywheelByMethod>,
    /// How far moments of drive, loads and inertia that are read of the solution may leave the equation of motion unmet, N m.
    #[serde(skip)]
    pub error_of_moments: f64,
    #[serde(skip)]
    pub(crate) solution: CycleSolution,
    /// The first cycle from the mean speed; `None` if the machine stalls in it.
    #[serde(skip)]
    pub(crate) first: Option<CycleSolution>,
    #[serde(skip)]
    pub(crate) times: Vec<Values>,
}

impl Regime {
    /// The drive as it was found: an equation of motion with it has this regime.
    pub fn drive(&self) -> InputDrive {
        self.solution.setup.drive
    }

    /// Time, speed, acceleration, moments and inertia at a coordinate, from the polynomials of the solution; at a jump
    /// of a load, the values just after it in the direction of motion. The speed of the first cycle is left out.
    pub fn state(&self, coordinate: f64) -> RegimeState {
        self.solution.state(&self.times, coordinate)
    }

    /// Speed in the first cycle from the mean speed (S fig. 9) at the coordinate, rad/s, signed; `None` if the machine stalls
    /// in that cycle.
    pub fn first_cycle_speed(&self, coordinate: f64) -> Option<f64> {
        let first = self.first.as_ref()?;
        let cycle = &first.cycle;
        let way = cycle.sense * (coordinate - cycle.start);
        // This cycle does not end with the speed of its beginning.
        let ends = (way - cycle.length).abs() <= tolerance(coordinate, Some(cycle.length));
        let x = if ends { cycle.length } else { cycle.path_coordinate(coordinate) };
        Some(cycle.sense * first.speed_at(x)).filter(|speed| speed.is_finite())
    }
}

/// A flywheel by one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FlywheelByMethod {
    /// Name: `excess-work`, `excess-work-less-inertia`, `mertsalov`, `wittenbauer`, `exact`.
    pub method: &'static str,
    /// Formula and source.
    pub formula: Text,
    /// Moment of inertia on the flywheel's own shaft, without the rotor, kg m²; negative where the method finds that the
    /// machine has more inertia than needed.
    pub flywheel: f64,
    /// (this - exact)/exact; `None` where the exact flywheel is zero.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference: Option<f64>,
}

/// How the regime was found, and the cost.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Effort {
    /// Cycles run.
    pub cycles: usize,
    /// Evaluations of the mechanism.
    pub evaluations: usize,
    /// Panels of order 15 over the cycle.
    pub panels: usize,
    /// Largest residual of the equation between the nodes, part of the kinetic energy.
    pub residual: f64,
}

/// The cycle of the regime.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleRequest {
    /// Coordinate at which a cycle begins, rad.
    pub start: f64,
    /// Its length, rad, positive.
    pub length: f64,
    /// Requested mean speed with its sign, rad/s: (max + min)/2.
    pub mean_speed: f64,
    /// The part of J(q) that does not vary, kg m²: the input link about its pin. For the methods of the textbooks.
    pub constant_inertia: f64,
}

/// What drives, and which of its quantities are to be found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveRequest {
    /// The torque.
    pub torque: TorqueRequest,
    /// Given flywheel, kg m² on its own shaft; `None`: find it from `unevenness`.
    pub flywheel: Option<f64>,
    /// The flywheel sits on the motor shaft.
    pub flywheel_on_motor: bool,
    /// Requested unevenness; needed if the flywheel is to be found.
    pub unevenness: Option<f64>,
}

impl DriveRequest {
    /// The same with another motor in the place of its own.
    pub(crate) fn with(&self, other: &Characteristic, of_other: f64) -> Self {
        let mut drive = *self;
        if let TorqueRequest::Motor { characteristic, rotor, .. } = &mut drive.torque {
            (*characteristic, *rotor) = (*other, of_other);
        }
        drive
    }
}

/// Torque of the drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TorqueRequest {
    /// None.
    None,
    /// The constant moment that makes the work of a cycle zero.
    Balance,
    /// A constant moment, N m, positive along the motion.
    Constant(f64),
    /// An asynchronous motor.
    Motor {
        /// Its characteristic.
        characteristic: Characteristic,
        /// Rotor, kg m² on its own shaft; 0: not modeled.
        rotor: f64,
        /// Given ratio; `None`: find it from the mean speed.
        ratio: Option<f64>,
        /// Efficiency of the reducer, (0, 1].
        efficiency: f64,
    },
}
