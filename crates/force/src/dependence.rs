//! What the reduced inertia and the reduced moment depend on, by the structure of the scene (D 3.21).

use assur_integrator::Dependence;
use assur_mechanism::{GROUND, LinkId};

use crate::loads::{Along, Loads, PointForce};

impl Loads {
    /// What the coefficients of the equation of motion depend on: `false` is certain, `true` means that nothing in the structure
    /// excludes it.
    pub fn dependence(&self) -> Dependence {
        Dependence {
            inertia_constant: self.inertia_constant,
            moment_on_coordinate: self.moment_on_coordinate(),
            moment_on_speed: self.laws.iter().any(|law| law.used().speed) || self.damped(),
            moment_on_time: self.laws.iter().any(|law| law.used().time),
        }
    }

    fn damped(&self) -> bool {
        self.springs.iter().any(|spring| spring.damping != 0.0)
    }

    fn moment_on_coordinate(&self) -> bool {
        let heavy = self.gravity != [0.0, 0.0]
            && self.masses.iter().any(|mass| mass.m > 0.0 && !self.steady_point(mass.link, mass.center));
        let laws = self.laws.iter().any(|law| law.used().coordinate || law.used().place);
        let springs = self.springs.iter().any(|spring| spring.stiffness != 0.0 || spring.damping != 0.0);
        heavy
            || laws
            || springs
            || !self.contacts.is_empty()
            || self.forces.iter().any(|force| !self.steady_force(force))
            || self.moments.iter().any(|moment| moment.link != self.input.0)
    }

    /// Whether PF1 of a point is the same vector at every coordinate.
    fn steady_point(&self, link: LinkId, at: [f64; 2]) -> bool {
        match self.input {
            _ if link == GROUND => true,
            (input, Some(pin)) => link == input && at.map(f64::to_bits) == pin.map(f64::to_bits),
            (input, None) => link == input,
        }
    }

    fn steady_force(&self, force: &PointForce) -> bool {
        // On a pinned input link the arm of a force that turns with it is constant.
        let turns = matches!(force.along, Along::Link(_) | Along::AgainstMotion);
        self.steady_point(force.at.link, force.at.at) || force.at.link == self.input.0 && turns
    }
}
