//! Reduction to the input link (theory of the project, section 3; S eqs. 1-3; E eqs. 4-6), and energies.

use assur_group::plane::{dot, vector};
use assur_group::{Body, Wrench};
use assur_integrator::Reduced;
use assur_number::Real;

use crate::choice::{Choice, Live};
use crate::loads::Loads;
use crate::visit::{Sink, Visit};
use crate::{LoadNumber, Phase, State};

/// Adds up the virtual power of loads.
struct Power<T>(T);

impl<T: LoadNumber> Sink<T> for Power<T> {
    #[inline]
    fn force(&mut self, _link: usize, body: &Body<T>, arm: [T; 2], force: [T; 2]) {
        self.0 += dot(body.first(arm), force);
    }

    #[inline]
    fn moment(&mut self, _link: usize, body: &Body<T>, moment: T) {
        self.0 += body.w1 * moment;
    }
}

impl Loads {
    /// Coefficients of the equation of motion J e + J' w²/2 = Q for all moving links and loads, without motor, flywheel
    /// and balancing load. The state decides which formulas of the loads apply.
    ///
    /// `bodies` need PF2 where J depends on the coordinate or a force is always against the motion, else PF1. Where J is constant
    /// by structure ([`Mechanism::has_constant_reduced_inertia`](assur_mechanism::Mechanism::has_constant_reduced_inertia)),
    /// its derivative is exactly zero and is not computed.
    #[inline]
    pub fn reduced<T: LoadNumber>(&self, states: &T::States, bodies: &[Body<T>]) -> Reduced<T> {
        self.reduce(&Live, states, bodies)
    }

    /// Reduced inertia, its derivative and the reduced moment by the formulas of one phase, continued smoothly beyond
    /// its bounds. `bodies` need PF2 only where J depends on the coordinate.
    #[inline]
    pub fn reduced_in_phase(&self, phase: &Phase, state: &State, bodies: &[Body<f64>]) -> Reduced {
        self.reduce(phase, state, bodies)
    }

    #[inline]
    fn reduce<T: LoadNumber, C: Choice>(
        &self,
        choice: &C,
        states: &T::States,
        bodies: &[Body<T>],
    ) -> Reduced<T> {
        let (mut inertia, mut half, mut power) = (T::ZERO, T::ZERO, T::ZERO);
        let gravity = vector(self.gravity);
        for mass in &self.masses {
            let body = &bodies[mass.link];
            let arm = body.arm(vector(mass.center));
            let velocity = body.first(arm);
            let (m, own) = (T::from_f64(mass.m), T::from_f64(mass.inertia));
            inertia += m * dot(velocity, velocity) + own * (body.w1 * body.w1);
            if !self.inertia_constant {
                half += m * dot(velocity, body.second(arm)) + own * (body.w1 * body.w2);
            }
            power += m * dot(gravity, velocity);
        }
        let mut sum = Power(power);
        Visit { loads: self, choice, states, bodies }.each(&mut sum);
        Reduced { inertia, inertia_derivative: half.twice(), moment: sum.0 }
    }

    /// Potential energy of weights (zero at the origin of the ground) and springs, J. Other loads have none here.
    pub fn potential_energy<T: LoadNumber>(&self, bodies: &[Body<T>]) -> T {
        let mut energy = T::ZERO;
        for mass in &self.masses {
            let weight = mass.weight(self.gravity);
            energy -= dot(weight, bodies[mass.link].point(vector(mass.center)));
        }
        for spring in &self.springs {
            energy += spring.energy(bodies);
        }
        energy
    }
}

/// Virtual power of a wrench about the origin of a body for dq = 1.
#[inline]
pub fn power<T: Real>(wrench: &Wrench<T>, body: &Body<T>) -> T {
    wrench.fx * body.x1 + wrench.fy * body.y1 + wrench.m * body.w1
}
