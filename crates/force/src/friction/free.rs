//! Friction in a motion whose acceleration is looked for.

use assur_group::Wrench;

use super::FrictionSolution;

/// What acts on a mechanism whose acceleration is looked for.
#[derive(Debug, Clone, Copy)]
pub struct FreeMotion<'a> {
    /// All loads on the links at acceleration 0, the inertia loads of the speed among them, about the origins of their frames.
    pub loads: &'a [Wrench<f64>],
    /// The inertia loads of acceleration 1 at speed 0.
    pub inertia: &'a [Wrench<f64>],
    /// Moment (force) of the drive on the input link, along the coordinate, N m (N).
    pub drive: f64,
    /// Moment of inertia (mass) that the drive adds to the input link, kg m² (kg).
    pub drive_inertia: f64,
}

/// The accelerations that dry friction leaves possible.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Accelerations {
    /// Each with its reactions and friction; in place of the balancing load stands the acceleration, rad/s² (m/s²).
    pub solutions: Vec<FrictionSolution>,
    /// Whether there are certainly no others.
    pub proved: bool,
}
