//! The motor of a scene: given by its data, looked up, or chosen (S stage 5); and how it works in a steady regime.

use std::borrow::Cow;

use assur_mechanism::{MotorChoice, Torque};
use assur_motor::{
    Candidate, Characteristic, CharacteristicKind, Motor, MotorFilter, MotorWarning, PassedOver,
    SelectionRequest, catalogues, check_breakdown, check_rms, check_rotor_inertia, check_starting,
    find_motor, list_motors, nearest, rms_torque, select, starting_torque,
};
use assur_words::{name, text};
use serde::Serialize;

use crate::{DynamicsError, Regime};

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DriveMotor {
    /// The row of its catalogue; owned where the scene gives the rated data.
    motor: Cow<'static, Motor>,
    pub(crate) characteristic: Characteristic,
    /// Other suitable motors, with the ratio that each would need, the best first; only if the motor was chosen.
    pub(crate) runners_up: Vec<Candidate<'static>>,
    /// The motors that were not taken, and why; only if the motor was chosen.
    pub(crate) passed_over: Vec<PassedOver<'static>>,
}

/// The row of a catalogue; `None` for a motor given by its data.
#[expect(clippy::ptr_arg, reason = "what is borrowed lives as long as its catalogue")]
fn row(motor: &Cow<'static, Motor>) -> Option<&'static Motor> {
    if let Cow::Borrowed(row) = motor { Some(row) } else { None }
}

impl DriveMotor {
    /// Its row of a catalogue; `None` for a motor given by its data.
    pub(crate) fn row(&self) -> Option<&'static Motor> {
        row(&self.motor)
    }

    /// Rotor, kg m²; 0 where it is not known.
    pub(crate) fn rotor(&self) -> f64 {
        self.motor.rotor_inertia.unwrap_or(0.0)
    }

    /// A warning where the rotor counts as massless, since its inertia is not known.
    pub(crate) fn unknown_rotor(&self) -> Option<MotorWarning> {
        let by_data = || text!("dynamics-motor-by-data");
        let designation = self.row().map_or_else(by_data, |row| name(row.designation.clone()));
        check_rotor_inertia(self.motor.rotor_inertia, designation)
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
        let of_row = |row: &'static Motor| Self::new(Cow::Borrowed(row), *kind);
        let motor = match motor {
            MotorChoice::Rated(rated) => {
                let motor = Motor {
                    rated_power: rated.power,
                    synchronous_speed: rated.synchronous_speed,
                    rated_speed: rated.rated_speed,
                    max_torque_ratio: rated.max_torque_ratio,
                    rotor_inertia: rated.inertia.filter(|inertia| *inertia > 0.0),
                    ..Motor::default()
                };
                Self::new(Cow::Owned(motor), *kind)
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

    fn new(motor: Cow<'static, Motor>, kind: CharacteristicKind) -> Result<Self, DynamicsError> {
        let characteristic = Characteristic::new(kind, &motor.rated_data()).map_err(DynamicsError::Rated)?;
        Ok(Self { motor, characteristic, runners_up: Vec::new(), passed_over: Vec::new() })
    }

    /// The next of the other suitable motors in its place; `None` after the last one.
    pub(crate) fn next(&self) -> Option<Self> {
        let (next, others) = self.runners_up.split_first()?;
        let motor = Self::new(Cow::Borrowed(next.motor), self.characteristic.kind).ok()?;
        Some(Self { runners_up: others.to_vec(), ..motor })
    }
}

/// Points of the curves over the speed.
const CURVE: usize = 61;

/// The motor that drives in a steady regime.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SteadyMotor {
    /// The row of its catalogue; owned where the scene gives the rated data.
    #[serde(flatten)]
    pub motor: Cow<'static, Motor>,
    /// How it works in the regime.
    pub work: MotorWork,
    /// Other motors that have the power, keep the limit of speed and start against the load, with the ratio that each would need, the
    /// best first; only if the motor was chosen.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub runners_up: Vec<Candidate<'static>>,
    /// The motors that were not taken, and why; only if the motor was chosen.
    #[serde(skip)]
    pub passed_over: Vec<PassedOver<'static>>,
    /// Warnings for the engineer.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<MotorWarning>,
}

/// How the motor works in the regime. Torques and speeds of its own shaft.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotorWork {
    /// The mechanical characteristic.
    #[serde(flatten)]
    pub characteristic: Characteristic,
    /// Least and greatest speed of the motor, rad/s: the working section.
    pub speed: [f64; 2],
    /// Least and greatest torque, N m.
    pub torque: [f64; 2],
    /// Root mean square torque over a cycle, N m.
    pub rms_torque: f64,
    /// Torque of the load at rest on the motor shaft, N m: the greatest of all positions of the cycle.
    pub starting_load: f64,
    /// Torque of the motor at rest, N m; `None` where neither catalogue nor characteristic gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub starting_torque: Option<f64>,
    /// The characteristic up to a tenth above the synchronous speed: speed, torque.
    pub curve: Vec<[f64; 2]>,
    /// The working section: speed, torque.
    pub working_section: Vec<[f64; 2]>,
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
        let starting_ratio = motor.motor.starting_torque_ratio;
        let warnings = [
            check_breakdown(&characteristic, speed),
            check_starting(&characteristic, starting_ratio, starting_load),
            check_rms(&characteristic, rms_torque),
            motor.unknown_rotor(),
        ];
        let warnings = warnings.into_iter().flatten().collect();
        let curve = curve(&characteristic, [0.0, 1.1 * characteristic.synchronous_speed]);
        let working_section = self::curve(&characteristic, speed);
        let work = MotorWork {
            characteristic,
            speed,
            torque,
            rms_torque,
            starting_load,
            starting_torque: starting_torque(&characteristic, starting_ratio),
            curve,
            working_section,
        };
        let DriveMotor { motor, mut runners_up, passed_over, .. } = motor;
        runners_up.retain(|one| starts(one, characteristic.kind, resistance / efficiency));
        Self { motor, work, runners_up, passed_over, warnings }
    }

    /// Keeps of all motors that were `refused` those nearest before this one, if it was chosen.
    pub(crate) fn passed_over(&mut self, refused: Vec<PassedOver<'static>>) {
        if let Some(row) = row(&self.motor) {
            self.passed_over = nearest(refused, row);
        }
    }
}

/// Whether a motor starts against a moment on the input, N m, as far as its torque at rest is known.
fn starts(one: &Candidate<'_>, kind: CharacteristicKind, resistance: f64) -> bool {
    let Ok(characteristic) = Characteristic::new(kind, &one.motor.rated_data()) else { return false };
    check_starting(&characteristic, one.motor.starting_torque_ratio, resistance / one.ratio).is_none()
}

/// Points (speed rad/s, torque N m) of a characteristic between two speeds of the motor.
fn curve(characteristic: &Characteristic, [low, high]: [f64; 2]) -> Vec<[f64; 2]> {
    let point = |speed: f64| [speed, characteristic.torque(speed)];
    (0..CURVE).map(|i| point(low + (high - low) * (i as f64) / (CURVE - 1) as f64)).collect()
}
