//! Periodic regime, drive and flywheel.

use assur_dynamics::{Figures, FlywheelByMethod, Regime, RegimeState};
use assur_mechanism::{Named, PointId};
use assur_motor::{FlywheelSize, RatedMotor};
use assur_words::Text;
use indexmap::IndexMap;
use serde::Serialize;

/// Results on the motion under loads and drive; those that do not apply are absent.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Dynamics {
    /// Moment of inertia of the flywheel, without the rotor, kg m².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flywheel: Option<f64>,
    /// Figures of the regime.
    #[serde(flatten)]
    pub figures: Figures,
    /// The motor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motor: Option<MotorReport>,
    /// Flywheel by each method that applies, kg m².
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub flywheel_by_method: IndexMap<&'static str, f64>,
    /// The flywheel of each method with its formula and the difference from the exact one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub flywheel_methods: Vec<FlywheelByMethod>,
    /// The flywheel on each of the two shafts.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub flywheel_places: Vec<FlywheelSize>,
    /// Where the unevenness follows from the motor: the suitable motors, with the greatest unevenness of each.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub motors_by_unevenness: Vec<MotorAdvice>,
    /// The energy-mass diagram of the regime (Wittenbauer).
    pub energy_mass: EnergyMass,
    /// The regime over the cycle.
    pub regime: RegimeOverCycle,
    /// The point of the input link to which loads and masses are reduced, too.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduction_point: Option<PointReport>,
}

/// The regime over the cycle, and how it was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RegimeOverCycle {
    /// The regime.
    #[serde(flatten)]
    pub found: Regime,
    /// Over a cycle: speeds, moments and inertia (S figs. 8, 9, 12); the end of the cycle is the last row.
    pub course: Vec<RegimeState>,
}

impl Dynamics {
    /// Whether the loads drive and the drive resists: over a cycle the loads do more work than they take.
    pub fn loads_drive(&self) -> bool {
        self.figures.are_loads_driving(-self.regime.found.resistance_work)
    }
}

/// The energy-mass diagram (Wittenbauer): the work of all moments over the reduced inertia of the links, between the two
/// straight lines of the greatest and of the least speed.
///
/// Both lines touch the curve and meet at [`origin`](Self::origin); with a greater flywheel they meet farther to the left and
/// are more nearly parallel.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EnergyMass {
    /// Over the cycle: reduced inertia of the links without flywheel and rotor, kg m² (kg), and work of all moments since the
    /// first position, J.
    pub curve: Vec<[f64; 2]>,
    /// The lines of the greatest and of the least speed.
    pub tangents: [EnergyMassTangent; 2],
    /// Where both lines meet: less the inertia of flywheel and rotor, and less the kinetic energy in the first position.
    pub origin: [f64; 2],
}

/// A line of constant speed in the energy-mass diagram.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EnergyMassTangent {
    /// Half the square of the speed: energy over inertia along the line.
    pub slope: f64,
    /// Where it touches the curve.
    pub touches: [f64; 2],
    /// The coordinate of this position, rad or m.
    pub coordinate: f64,
}

/// The point to which loads and masses are reduced, in addition to the input link (E eqs. 4-6).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PointReport {
    /// The point.
    pub name: Named<PointId>,
    /// |PF1| of the point: force = moment / radius, mass = inertia / radius².
    pub radius: f64,
}

/// The motor that drives.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotorReport {
    /// Designation; empty where the scene gives rated data.
    pub designation: String,
    /// Catalogue; absent where the scene gives rated data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub catalogue: Option<String>,
    /// Its rated data.
    #[serde(flatten)]
    pub rated: RatedMotor,
    /// Mass of the motor, kg.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Length, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Diameter of the housing, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diameter: Option<f64>,
    /// How it works in the regime.
    pub work: MotorWork,
    /// Other suitable motors, the best first; only if the motor was chosen.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub runners_up: Vec<MotorAdvice>,
    /// Warnings: values that the source does not give, limits that are near.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Text>,
}

/// How the motor works in the regime; speeds and torques of its own shaft.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotorWork {
    /// `kloss` or `linear`.
    pub characteristic: &'static str,
    /// Rated torque, N m.
    pub rated_torque: f64,
    /// Breakdown torque, N m, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub breakdown_torque: Option<f64>,
    /// Least and greatest speed, rad/s: the working section.
    pub speed: [f64; 2],
    /// Least and greatest torque, N m.
    pub torque: [f64; 2],
    /// Root mean square torque over a cycle, N m.
    pub rms_torque: f64,
    /// Greatest torque of the load at rest, N m.
    pub starting_load: f64,
    /// The characteristic: speed, torque.
    pub curve: Vec<[f64; 2]>,
    /// The working section: speed, torque.
    pub working_section: Vec<[f64; 2]>,
}

/// A suitable motor, with the greatest unevenness for which it stays on the stable section of its characteristic.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotorAdvice {
    /// Designation.
    pub designation: String,
    /// Catalogue.
    pub catalogue: String,
    /// Rated power, W.
    pub power: f64,
    /// Rated speed, rad/s.
    pub rated_speed: f64,
    /// The ratio that it needs, where that is given by the speeds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// Mass, kg.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// The greatest unevenness and what goes with it; absent if the motor has no regime.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub regime: Option<AdvisedRegime>,
}

/// The regime of the greatest unevenness that a motor allows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AdvisedRegime {
    /// (max - min) / mean of the input speed.
    pub unevenness: f64,
    /// Motor speed / input speed.
    pub ratio: f64,
    /// Moment of inertia of the flywheel for it, kg m²; 0 where none is needed.
    pub flywheel: f64,
    /// Greatest torque of the motor over the cycle, N m.
    pub greatest_torque: f64,
    /// Breakdown torque over this greatest torque, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque_reserve: Option<f64>,
}
