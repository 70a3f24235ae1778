//! The contract of an integrator, the equation of motion as integrators see it, the driver that they share, and
//! the registry of plugins.
//!
//! The equation is that of a mechanism with one degree of freedom, J(q) w' + J'(q) w²/2 = Q(q, w, t), q' = w (D 3.11).
//! This crate knows no mechanism, no scene and no concrete method. SI units.
//!
//! A method that advances in time steps implements [`Stepper`]: one step, its error and its dense output. [`Steps`]
//! does everything else. A method that advances in panels of the coordinate or of the speed implements [`Integrator`]
//! and keeps a [`Run`] itself.
//!
//! What an equation depends on decides which methods suit it:
//!
//! ```
//! use assur_integrator::{AUTO, Dependence, choose};
//!
//! // J is constant, and the moment follows the speed.
//! let dependence = Dependence { inertia_constant: true, moment_on_speed: true, ..Dependence::default() };
//! assert_eq!(dependence.case(), 2);
//! // Of the methods that are linked:
//! if let Ok(choice) = choose(AUTO, &dependence, 1e-9) {
//!     println!("{}", choice.first.integrator.name);
//! }
//! ```
//!
//! # Existing crates, considered before this one was written (2026-11)
//!
//! | crate | version | license | dense output | events | two states without allocation | verdict |
//! | --- | --- | --- | --- | --- | --- | --- |
//! | `ode_solvers` | 0.6.2 | Apache-2.0 | dopri5, dop853: equidistant only | none but a stop condition | states yes, but `integrate` allocates its stages | no: no implicit method, the equation can't fail, plain control in dop853; its table holds c12 = 0 instead of 1, and when tried, y' = 5 cos t at 1e-9 ended with "stiffness detected" at t = 0.25: no M(t) |
//! | `diffsol` | 0.18.0 | MIT | yes | root functions, the solver stops there | no: heap vectors and matrices (nalgebra, faer) | no: made for large stiff systems (BDF, SDIRK), brings faer, petgraph and serde; a yardstick |
//! | `differential-equations` | 0.7.0 | Apache-2.0 | yes | yes, by sign change over accepted steps | explicit methods yes, radau5 allocates at start | the nearest; no: an event is found after a step whose stages have already crossed the jump, and the equation can't fail |
//!
//! Judged from the published sources and manifests; `ode_solvers` was also run.
//!
//! What decides is not the formulas but the steps: a mechanism's equation consists of smooth pieces (rows of tables,
//! stroke direction, dry friction), no step may contain a jump, at zero speed the side on which the motion continues
//! must be found, and a position may not exist. None of the three has a notion of a piece that a trial step may leave
//! smoothly. So the methods are implemented here, with the published coefficients, and the tests check the order
//! conditions.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod change;
mod choose;
mod control;
mod dense;
mod driver;
mod error;
mod event_location;
mod motion;
mod piece_ahead;
mod plugin;
mod request;
mod run;
mod stepper;

assur_words::resources!();

pub use assur_plugin::RegistryError;
pub use change::{Part, first_change};
pub use choose::{AUTO, Choice, RankedMethod, Solution, choose, solve};
pub use control::{Control, Scale};
pub use dense::{COEFFICIENTS, Dense};
pub use driver::Steps;
pub use error::IntegrationError;
pub use inventory;
pub use motion::{Dependence, EquationOfMotion, MotionError, Partials, Piece, Reduced, State, Stretch};
pub use piece_ahead::enter;
pub use plugin::{Cost, Integrator, IntegratorPlugin, Knob, Suitability, find, integrators};
pub use request::{Event, EventKind, FixedStep, Request, Sample, SolutionCost, Trajectory, Until};
pub use run::Curve;
pub use run::Run;
pub use stepper::CountedEquation;
pub use stepper::{Attempt, Node, Pace, Step, Stepper};
