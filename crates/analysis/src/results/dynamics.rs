//! Periodic regime, drive and flywheel.

use assur_dynamics::{Advice, Figures, FlywheelByMethod, Regime, RegimeState, SteadyMotor};
use assur_mechanism::ReductionPoint;
use assur_motor::FlywheelSize;
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
    pub motor: Option<SteadyMotor>,
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
    pub motors_by_unevenness: Vec<Advice>,
    /// The energy-mass diagram of the regime (Wittenbauer).
    pub energy_mass: EnergyMass,
    /// The regime over the cycle.
    pub regime: RegimeOverCycle,
    /// The point of the input link to which loads and masses are reduced, too.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduction_point: Option<ReductionPoint>,
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
