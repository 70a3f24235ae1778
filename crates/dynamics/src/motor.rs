//! The motor of a scene: given by its data, looked up, or chosen (S stage 5); and how it works in a steady regime.

use assur_mechanism::{MotorChoice, Torque};
use assur_motor::{
    Candidate, Characteristic, CharacteristicKind, Motor, MotorFilter, MotorWarning, PassedOver, RatedMotor,
    SelectionRequest, catalogues, check_breakdown, check_rms, check_rotor_inertia, check_starting,
    find_motor, list_motors, nearest, rms_torque, select,
};
use assur_words::text;

use crate::{DynamicsError, Regime};

/// The motor that drives.
#[derive(Debug, Clone, PartialEq)]
pub struct DriveMotor {
    /// Designation as the catalogue prints it; `None` for a motor given by its data.
    pub designation: Option<String>,
    /// The data of which the characteristic is computed.
    pub rated: RatedMotor,
    /// The mechanical characteristic.
    pub characteristic: Characteristic,
    /// Row of the catalogue, with mass and size.
    pub row: Option<&'static Motor>,
    /// Other suitable motors, with the ratio that each would need, the best first; only if the motor was chosen.
    pub runners_up: Vec<Candidate<'static>>,
    /// The motors that were not taken, and why; only if the motor was chosen.
    pub passed_over: Vec<PassedOver<'static>>,
}

impl DriveMotor {
    /// Rotor, kg m²; 0 where it is not known.
    pub fn rotor(&self) -> f64 {
        self.rated.inertia.unwrap_or(0.0)
    }

    /// A warning where the rotor counts as massless, since its inertia is not known.
    pub(crate) fn unknown_rotor(&self) -> Option<MotorWarning> {
        match self.row {
            Some(row) => check_rotor_inertia(row),
            None => {
                self.rated.inertia.is_none().then(|| MotorWarning::RotorInertiaUnknown {
                    designation: text!("dynamics-motor-by-data"),
                })
            }
        }
    }

    /// The motor of a scene, if its torque is that of a motor. For choosing one, `need` gives the power at the motor
    /// shaft, W, and the speed of the input, rad/s.
    pub(crate) fn of(
        torque: &Torque,
        need: impl FnOnce() -> Result<[f64; 2], DynamicsError>,
    ) -> Result<Option<Self>, DynamicsError> {
        let Torque::Motor { motor, catalogue, max_speed, characteristic: kind } = torque else {
            return Ok(None);
        };
        let of_row = |row: &'static Motor| Self::new(row.rated_data(), *kind, Some(row));
        let motor = match motor {
            MotorChoice::Rated(rated) => {
                let inertia = rated.inertia.filter(|inertia| *inertia > 0.0);
                Self::new(RatedMotor { inertia, ..*rated }, *kind, None)
            }
            MotorChoice::Designation(designation) => of_row(find_motor(catalogue.as_deref(), designation)?),
            MotorChoice::Auto => {
                let [required_power, input_speed] = need()?;
                let filter = MotorFilter { catalogue: catalogue.clone(), ..MotorFilter::default() };
                let request = SelectionRequest {
                    required_power,
                    input_speed,
                    max_motor_speed: *max_speed,
                    characteristic: *kind,
                };
                let found = select(list_motors(&catalogues()?, &filter)?, &request)
                    .map_err(DynamicsError::Selection)?;
                let (runners_up, passed_over) = (found.runners_up, found.passed_over);
                of_row(found.chosen.motor).map(|motor| Self { runners_up, passed_over, ..motor })
            }
        };
        motor.map(Some)
    }

    /// By its data, and its row of a catalogue.
    fn new(
        rated: RatedMotor,
        kind: CharacteristicKind,
        row: Option<&'static Motor>,
    ) -> Result<Self, DynamicsError> {
        let characteristic = Characteristic::new(kind, &rated).map_err(DynamicsError::Rated)?;
        let designation = row.map(|row| row.designation.clone());
        let (runners_up, passed_over) = (Vec::new(), Vec::new());
        Ok(Self { designation, rated, characteristic, row, runners_up, passed_over })
    }

    /// The next of the other suitable motors in its place; `None` after the last one.
    pub(crate) fn next(&self) -> Option<Self> {
        let (next, others) = self.runners_up.split_first()?;
        let motor = Self::new(next.motor.rated_data(), self.characteristic.kind(), Some(next.motor)).ok()?;
        Some(Self { runners_up: others.to_vec(), ..motor })
    }
}

/// How the motor works in the regime. Torques and speeds of its own shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyMotor {
    /// The motor.
    pub motor: DriveMotor,
    /// Least and greatest speed of the motor, rad/s: the working section.
    pub speed: [f64; 2],
    /// Least and greatest torque, N m.
    pub torque: [f64; 2],
    /// Root mean square torque over a cycle, N m.
    pub rms_torque: f64,
    /// Torque of the load at rest on the motor shaft, N m: the greatest of all positions of the cycle.
    pub starting_load: f64,
    /// Warnings for the engineer.
    pub warnings: Vec<MotorWarning>,
}

impl SteadyMotor {
    /// The motor in a regime. `resistance`: greatest resisting moment over the cycle, reduced to the input, N m; `efficiency`: of
    /// the reducer.
    pub(crate) fn new(motor: DriveMotor, regime: &Regime, resistance: f64, efficiency: f64) -> Self {
        let (characteristic, ratio) = (motor.characteristic, regime.figures.ratio.unwrap_or(1.0));
        let speed = [ratio * regime.figures.speed_min.abs(), ratio * regime.figures.speed_max.abs()];
        let of_nodes = regime.solution.weighted_speeds().into_iter();
        let nodes: Vec<(f64, f64)> =
            of_nodes.map(|(v, time)| (characteristic.torque(ratio * v), time)).collect();
        let ends = speed.map(|speed| characteristic.torque(speed));
        let torques = nodes.iter().map(|(torque, _)| *torque).chain(ends);
        let torque = torques.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], torque| {
            [low.min(torque), high.max(torque)]
        });
        let rms_torque = rms_torque(nodes);
        let starting_load = (resistance / (ratio * efficiency)).max(0.0);
        let starting_ratio = motor.row.and_then(|row| row.starting_torque_ratio);
        let warnings = [
            check_breakdown(&characteristic, speed),
            check_starting(&characteristic, starting_ratio, starting_load),
            check_rms(&characteristic, rms_torque),
            motor.unknown_rotor(),
        ];
        let warnings = warnings.into_iter().flatten().collect();
        Self { motor, speed, torque, rms_torque, starting_load, warnings }
    }

    /// Keeps of all motors that were `refused` those nearest before this one, if it was chosen.
    pub(crate) fn passed_over(&mut self, refused: Vec<PassedOver<'static>>) {
        if let Some(row) = self.motor.row {
            self.motor.passed_over = nearest(refused, row);
        }
    }

    /// `count` points (speed rad/s, torque N m) of the characteristic between two speeds of the motor.
    pub fn curve(&self, [low, high]: [f64; 2], count: usize) -> Vec<[f64; 2]> {
        let last = count.saturating_sub(1).max(1) as f64;
        let point = |speed: f64| [speed, self.motor.characteristic.torque(speed)];
        (0..count).map(|i| point(low + (high - low) * (i as f64) / last)).collect()
    }
}
