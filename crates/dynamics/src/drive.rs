//! The drive of the input link, reduced to it: torque, flywheel and rotor.

use assur_force::{LoadState, Side, beside};
use assur_motor::Characteristic;

/// Source of the driving torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TorqueSource {
    /// Nothing but the loads of the scene.
    None,
    /// A constant moment, N m, positive along the motion (not along the coordinate).
    Constant(f64),
    /// An asynchronous motor with a reducer, connected so that it drives along the motion.
    Motor {
        /// Its characteristic.
        characteristic: Characteristic,
        /// Motor speed / input speed, u.
        ratio: f64,
        /// Efficiency η of the reducer, (0, 1].
        efficiency: f64,
    },
}

/// Torque and inertia of a drive, reduced to the input link. Speeds v and moments of a drive are positive along the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InputDrive {
    /// The torque.
    pub source: TorqueSource,
    /// Direction of the motion: 1 along growing coordinates, -1 along falling ones.
    pub sense: f64,
    /// Moment of inertia of flywheel and rotor, kg m².
    pub inertia: f64,
}

/// The driving moment, N m, and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Moment {
    pub(crate) value: f64,
    pub(crate) by_speed: f64,
    /// With respect to the ratio u, or to the constant moment.
    pub(crate) by_parameter: f64,
}

/// Interval of the speed in which the power of the motor keeps its sign, so that the losses of the reducer do, too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Branch {
    /// η while the motor drives, 1/η while it brakes.
    pub(crate) factor: f64,
    /// Bounds of v.
    pub(crate) speed: [f64; 2],
}

impl InputDrive {
    /// No drive and no flywheel.
    pub const NONE: Self = Self { source: TorqueSource::None, sense: 1.0, inertia: 0.0 };

    /// The branch of the torque just above the speed `v`.
    pub(crate) fn branch(&self, v: f64) -> Branch {
        let everywhere = Branch { factor: 1.0, speed: [f64::NEG_INFINITY, f64::INFINITY] };
        let TorqueSource::Motor { characteristic, ratio, efficiency } = &self.source else {
            return everywhere;
        };
        if *efficiency >= 1.0 {
            return everywhere;
        }
        let synchronous = characteristic.synchronous_speed / ratio;
        // Motor torque times motor speed is negative above synchronous speed and where the input turns against the motor.
        if v < 0.0 {
            Branch { factor: 1.0 / efficiency, speed: [f64::NEG_INFINITY, 0.0] }
        } else if v < synchronous {
            Branch { factor: *efficiency, speed: [0.0, synchronous] }
        } else {
            Branch { factor: 1.0 / efficiency, speed: [synchronous, f64::INFINITY] }
        }
    }

    /// Moment of the drive on the input link, N m, along the coordinate, by the formulas on the side of a state.
    pub fn torque(&self, state: &LoadState) -> f64 {
        let above_or_below = |side: f64| {
            let v = self.sense * state.speed;
            let factor = self.branch(self.sense * beside(state.speed, side)).factor;
            self.sense * self.moment(factor, v).value
        };
        let leads = if state.acceleration < 0.0 { -1.0 } else { 1.0 };
        match state.side {
            Side::Held { upper } => (1.0 - upper) * above_or_below(-1.0) + upper * above_or_below(1.0),
            Side::Before => above_or_below(-leads),
            Side::After | Side::Prescribed => above_or_below(leads),
        }
    }

    /// A state with the load of this drive on the input: its moment less that of its inertia.
    pub(crate) fn driving(&self, state: LoadState) -> LoadState {
        let load = self.torque(&state) - self.inertia * state.acceleration;
        LoadState { drive: Some(load), ..state }
    }

    /// Moment on the input link at the speed `v` by the formula of the branch with this factor, continued beyond the branch.
    #[inline]
    pub(crate) fn moment(&self, factor: f64, v: f64) -> Moment {
        match &self.source {
            TorqueSource::None => Moment::default(),
            TorqueSource::Constant(value) => Moment { value: *value, by_speed: 0.0, by_parameter: 1.0 },
            TorqueSource::Motor { characteristic, ratio, .. } => {
                let (torque, slope) = (characteristic.torque(ratio * v), characteristic.slope(ratio * v));
                Moment {
                    value: ratio * factor * torque,
                    by_speed: ratio * ratio * factor * slope,
                    by_parameter: factor * (torque + ratio * v * slope),
                }
            }
        }
    }
}
