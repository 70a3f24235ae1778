//! The motor of a scene: given by its data, looked up, or chosen (S stage 5).

use assur_mechanism::Motor as Asked;
use assur_motor::{
    Candidate, CharacteristicKind, Motor, MotorFilter, RatedData, SelectionRequest, catalogues, find_motor,
    list_motors, select,
};

use crate::DynamicsError;

/// The motor that drives.
#[derive(Debug, Clone, PartialEq)]
pub struct DriveMotor {
    /// Designation as the catalogue prints it; `None` for a motor given by its data.
    pub designation: Option<String>,
    /// What the characteristic is made of.
    pub rated: RatedData,
    /// Which characteristic.
    pub kind: CharacteristicKind,
    /// Row of the catalogue, with mass and size.
    pub row: Option<&'static Motor>,
    /// Other motors that would do, with the ratio that each would need, the best first; only where it was chosen.
    pub runners_up: Vec<Candidate<'static>>,
}

impl DriveMotor {
    /// Rotor, kg m²; 0 where it is not known.
    pub fn rotor(&self) -> f64 {
        self.rated.inertia.unwrap_or(0.0)
    }
}

/// What a scene asks of its motor.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MotorWish<'a> {
    pub(crate) motor: &'a Asked,
    pub(crate) catalogue: Option<&'a str>,
    pub(crate) max_speed: Option<f64>,
    pub(crate) kind: CharacteristicKind,
}

impl MotorWish<'_> {
    /// Finds the motor; power (W, at the motor shaft) and speed of the input are for choosing, `None` where that is impossible.
    pub(crate) fn find(&self, need: Option<[f64; 2]>) -> Result<DriveMotor, DynamicsError> {
        let kind = self.kind;
        let row = |motor: &'static Motor, runners_up| DriveMotor {
            designation: Some(motor.designation.clone()),
            rated: motor.rated_data(),
            kind,
            row: Some(motor),
            runners_up,
        };
        match self.motor {
            Asked::Rated(rated) => {
                let inertia = rated.inertia.filter(|inertia| *inertia > 0.0);
                let rated = RatedData { inertia, ..*rated };
                Ok(DriveMotor { designation: None, rated, kind, row: None, runners_up: Vec::new() })
            }
            Asked::Designation(designation) => Ok(row(find_motor(self.catalogue, designation)?, Vec::new())),
            Asked::Auto => {
                let [required_power, input_speed] =
                    need.ok_or(DynamicsError::SteadyOnly { what: "`motor = \"auto\"`" })?;
                let filter =
                    MotorFilter { catalogue: self.catalogue.map(str::to_owned), ..MotorFilter::default() };
                let motors = list_motors(&catalogues()?, &filter)?;
                let request = SelectionRequest {
                    required_power,
                    input_speed,
                    max_motor_speed: self.max_speed,
                    characteristic: kind,
                };
                let found = select(motors, &request)?;
                Ok(row(found.chosen.motor, found.runners_up))
            }
        }
    }
}
