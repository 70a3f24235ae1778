//! Motion of a mechanism under its loads and its drive.
//!
//! * [`Machine`]: a compiled mechanism with its loads as an equation of motion; [`Driven`]: with motor, flywheel and rotor.
//! * [`transient`]: the motion from an initial state, by a registered integrator.
//! * [`Survey`], [`Regime`]: the steady regime, ratio and flywheel.
//!
//! Knows no scene file and no terminal. SI units; angles, speeds and moments counter-clockwise positive.

mod driven;
mod error;
mod machine;
mod motor;
mod point;
mod scene;
mod shaft;
mod steady;
#[cfg(test)]
mod tests;
mod told;
mod transient;

pub use driven::Driven;
pub use error::DynamicsError;
pub use machine::Machine;
pub use motor::DriveMotor;
pub use point::ReductionPoint;
pub use scene::{Steady, SteadyMotor, steady, steady_told};
pub use shaft::{Shaft, Source};
pub use steady::{
    CycleRequest, DriveRequest, Effort, FlywheelByMethod, Regime, RegimeState, Survey, TorqueRequest, Trial,
    Turn,
};
pub use told::Tell;
pub use transient::{EnergyBalance, Transient, equation, request, transient, transient_by, transient_told};
