//! Motion of a mechanism under its loads and its drive.
//!
//! * [`Machine`]: a compiled mechanism with its loads, and with motor, flywheel and rotor, as an equation of motion.
//! * [`transient`]: the motion from an initial state, by a registered integrator.
//! * [`steady`]: the periodic regime of a scene with ratio and flywheel; [`RegimeSolver`] finds a [`Regime`] of any equation.
//!
//! Knows no scene file and no terminal. SI units; angles, speeds and moments counter-clockwise positive.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod drive;
mod error;
mod friction;
mod instant;
mod machine;
mod motor;
mod regime;
mod scene;
mod steady;
#[cfg(test)]
mod tests;
mod transient;

assur_words::resources!();

pub use drive::{InputDrive, TorqueSource};
pub use error::DynamicsError;
pub use instant::{Holding, Instant};
pub use machine::{Machine, Watcher};
pub use motor::{MotorWork, SteadyMotor};
pub use regime::{Advice, AdvisedRegime, advise, steady};
pub use scene::{Steady, section_margin};
pub use steady::{
    CycleRequest, DriveRequest, Effort, Figures, FlywheelByMethod, Iteration, Regime, RegimeSolver,
    RegimeState, TorqueRequest, Trial,
};
pub use transient::{EnergyBalance, Method, Transient, equation, request, transient, unknown_rotor};
