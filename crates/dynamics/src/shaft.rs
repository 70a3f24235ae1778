//! What drives the input link, seen from its shaft.

use assur_motor::Characteristic;

/// Source of the driving torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// Nothing but the loads of the scene.
    None,
    /// A constant moment, N m, positive along the motion (along the path, not along the coordinate).
    Constant(f64),
    /// An asynchronous motor behind a reducer, connected so that it drives along the path.
    Motor {
        /// Its characteristic.
        characteristic: Characteristic,
        /// Motor speed / input speed, u.
        ratio: f64,
        /// Efficiency η of the reducer, (0, 1].
        efficiency: f64,
    },
}

/// Drive and inertia on the input shaft. The path leads along growing coordinates for a sense of 1, along falling ones
/// for -1; speeds v and moments here are positive along the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// The torque.
    pub source: Source,
    /// 1 or -1.
    pub sense: f64,
    /// Flywheel and rotor, reduced to the input shaft, kg m².
    pub inertia: f64,
}

/// A moment and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Moment {
    pub(crate) value: f64,
    pub(crate) by_speed: f64,
    /// By the ratio u, or by the constant moment.
    pub(crate) by_parameter: f64,
}

/// Interval of the speed in which the losses of the reducer have one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Branch {
    /// η or 1/η.
    pub(crate) factor: f64,
    /// Bounds of v.
    pub(crate) speed: [f64; 2],
}

impl Shaft {
    /// A shaft without drive and flywheel.
    pub const FREE: Self = Self { source: Source::None, sense: 1.0, inertia: 0.0 };

    /// The branch of the torque just after the speed `v`, which holds until the reducer's losses turn.
    pub(crate) fn branch(&self, v: f64) -> Branch {
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
        let Source::Motor { characteristic, ratio, efficiency } = &self.source else {
            return Branch { factor: 1.0, speed: everywhere };
        };
        if *efficiency >= 1.0 {
            return Branch { factor: 1.0, speed: everywhere };
        }
        let synchronous = characteristic.synchronous_speed() / ratio;
        // Motor torque times motor speed is negative above synchronous speed and where the shaft turns against it.
        if v < 0.0 {
            Branch { factor: 1.0 / efficiency, speed: [f64::NEG_INFINITY, 0.0] }
        } else if v < synchronous {
            Branch { factor: *efficiency, speed: [0.0, synchronous] }
        } else {
            Branch { factor: 1.0 / efficiency, speed: [synchronous, f64::INFINITY] }
        }
    }

    /// Moment on the input shaft at speed `v` by the formula of a branch, continued beyond it.
    #[inline]
    pub(crate) fn moment(&self, factor: f64, v: f64) -> Moment {
        match &self.source {
            Source::None => Moment::default(),
            Source::Constant(value) => Moment { value: *value, by_speed: 0.0, by_parameter: 1.0 },
            Source::Motor { characteristic, ratio, .. } => {
                let (torque, slope) = (characteristic.torque(ratio * v), characteristic.slope(ratio * v));
                Moment {
                    value: ratio * factor * torque,
                    by_speed: ratio * ratio * factor * slope,
                    by_parameter: factor * (torque + ratio * v * slope),
                }
            }
        }
    }

    /// Whether the moment depends on the speed.
    pub(crate) fn depends_on_speed(&self) -> bool {
        matches!(self.source, Source::Motor { .. })
    }
}
