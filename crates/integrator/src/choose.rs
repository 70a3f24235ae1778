//! `auto`: the cheapest method that is exact or meets the tolerance, by D's classification.

use crate::{Dependence, Integrator, IntegratorPlugin};

/// The method that `auto` takes, and why.
#[derive(Debug, Clone)]
pub struct Choice {
    /// The method.
    pub integrator: &'static IntegratorPlugin,
    /// Why, as a sentence for a person.
    pub reason: String,
    /// D's case, 1 to 5.
    pub case: u8,
}

impl Choice {
    /// Name of the method.
    pub fn name(&self) -> &'static str {
        self.integrator.name
    }

    /// The method itself.
    pub fn instance(&self) -> &'static dyn Integrator {
        (self.integrator.instance)()
    }
}

/// Tolerance from which on the cheap steps of order 5 need fewer evaluations than steps of order 8.
const COARSE: f64 = 1e-4;

/// Chooses a method for such an equation from `registry`, or none if nothing in it can treat the equation.
///
/// Case 1 has a closed form; cases 2 with M(q) and 3 one quadrature in the coordinate (E eq. 1), without any error from
/// time; case 2 with M(t) one over time, with M(w) one over the speed; the rest goes to the explicit method whose order fits the tolerance. Stiffness can't be seen from the
/// classification: an explicit method reports it when it meets it, and `radau5` is for that.
pub fn choose(
    dependence: &Dependence,
    tolerance: f64,
    registry: &[&'static IntegratorPlugin],
) -> Option<Choice> {
    let by_name = |name: &str| registry.iter().find(|plugin| plugin.name == name).copied();
    let suits = |plugin: &IntegratorPlugin| (plugin.instance)().supports(dependence).is_ok();
    let (case, words) = (dependence.case(), dependence.words());
    let preferences = preferences(*dependence, tolerance);
    let preferred = preferences
        .iter()
        .find_map(|(name, why)| by_name(name).filter(|plugin| suits(plugin)).map(|plugin| (plugin, *why)));
    let (integrator, why) = preferred.or_else(|| {
        let best =
            registry.iter().copied().filter(|plugin| suits(plugin)).max_by_key(|plugin| plugin.order)?;
        Some((best, "the method of the highest order that is linked and can treat it"))
    })?;
    let reason = format!("case {case} of D ({words}): {why}");
    Some(Choice { integrator, reason, case })
}

/// Names in the order of preference, each with its reason.
fn preferences(dependence: Dependence, tolerance: f64) -> Vec<(&'static str, &'static str)> {
    let mut names = Vec::with_capacity(4);
    if dependence.case() == 1 {
        names.push(("closed-form", "uniformly accelerated motion has a closed form, exact"));
    }
    if dependence.case() == 2 && dependence.moment_on_time {
        names.push(("quadrature", "the impulse of the moment gives the speed by one quadrature over time"));
    }
    if dependence.case() == 2 && dependence.moment_on_speed {
        names.push((
            "quadrature",
            "t = J * integral of dw / M(w) gives the motion by one quadrature over the speed",
        ));
    }
    if dependence.is_work_of_coordinate() {
        names.push((
            "energy",
            "the work along the coordinate gives the speed by one quadrature, without steps in time",
        ));
    }
    let five = ("dopri5", "a loose tolerance: cheap explicit steps of order 5 meet it");
    let eight =
        ("dop853", "a tight tolerance: explicit steps of order 8 meet it with the fewest evaluations");
    if tolerance > COARSE {
        names.extend([five, eight]);
    } else {
        names.extend([eight, five]);
    }
    names
}

#[cfg(test)]
mod tests;
