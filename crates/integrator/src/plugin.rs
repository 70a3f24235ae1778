//! The registry of integrators: what each method declares about itself.

use assur_plugin::RegistryError;
use assur_words::{Text, text};

use crate::{Dependence, EquationOfMotion, IntegrationError, Request, Trajectory};

/// A method for the equation of motion.
///
/// A method that advances in steps of time implements [`Stepper`](crate::Stepper) instead, and [`Steps`](crate::Steps)
/// makes it an integrator.
pub trait Integrator: Sync {
    /// Solves the equation from the initial state to the end. Called through [`IntegratorPlugin::solve`], which makes sure
    /// that the method suits the equation.
    fn solve(
        &self,
        motion: &mut dyn EquationOfMotion,
        request: &Request,
    ) -> Result<Trajectory, IntegrationError>;
}

/// Entry of a method in the registry: `inventory::submit! { IntegratorPlugin { ... } }`.
#[derive(Clone)]
pub struct IntegratorPlugin {
    /// Stable name, as users write it.
    pub name: &'static str,
    /// The crate it comes from: `env!("CARGO_PKG_NAME")`.
    pub crate_name: &'static str,
    /// One line for lists.
    pub summary: Text,
    /// Where the method is described.
    pub source: Text,
    /// Order of accuracy; 0 for a method without discretization error in time.
    pub order: u8,
    /// Which field of a [`Request`] sets the accuracy.
    pub knob: Knob,
    /// The method stays efficient on stiff equations: `auto` continues with it where an explicit method finds
    /// stiffness.
    pub stiff: bool,
    /// How well the method suits an equation at a tolerance; the error says, as a sentence, why it does not support it.
    pub suitability: fn(&Dependence, tolerance: f64) -> Result<Suitability, Text>,
    /// The method itself.
    pub method: &'static dyn Integrator,
}

impl std::fmt::Debug for IntegratorPlugin {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "IntegratorPlugin({})", self.name)
    }
}

/// Which field of a request sets the accuracy of a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Knob {
    /// Nothing: the method is exact.
    None,
    /// [`Request::tolerance`].
    Tolerance,
    /// [`Request::fixed_step`].
    Step,
}

/// The rank of a method among those that suit an equation, and the reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Suitability {
    /// What the method costs here.
    pub cost: Cost,
    /// Why, for a person; continues "case 3 of D (J(q), M(q)): ".
    pub reason: Text,
}

/// Classes of cost, the cheapest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cost {
    /// The motion has a closed form.
    ClosedForm,
    /// One quadrature gives the motion.
    Quadrature,
    /// Steps in time, of an order that fits the tolerance.
    Steps,
    /// Steps in time, of an order meant for other tolerances.
    OtherSteps,
    /// Chosen only if no other method is linked.
    LastResort,
}

assur_plugin::registry!(IntegratorPlugin, text!("integrator-sort"), name);

impl IntegratorPlugin {
    /// Whether the method suits such an equation at all.
    pub fn supports(&self, dependence: &Dependence) -> Result<(), IntegrationError> {
        // Whether a method suits an equation does not depend on the tolerance, only how well it does.
        match (self.suitability)(dependence, f64::EPSILON) {
            Ok(_) => Ok(()),
            Err(reason) => Err(IntegrationError::Unsupported { integrator: self.name, reason }),
        }
    }

    /// Solves the equation from the initial state to the end.
    pub fn solve(
        &self,
        motion: &mut dyn EquationOfMotion,
        request: &Request,
    ) -> Result<Trajectory, IntegrationError> {
        self.supports(&motion.dependence())?;
        request.check()?;
        self.method.solve(motion, request)
    }
}

/// All linked integrators, sorted by name.
pub fn integrators() -> Result<Vec<&'static IntegratorPlugin>, RegistryError> {
    assur_plugin::all()
}

/// The integrator of that name.
pub fn find(name: &str) -> Result<&'static IntegratorPlugin, RegistryError> {
    assur_plugin::find(name)
}
