//! Reduction to the input link (theory of the project, section 3; S eqs. 1-3; E eqs. 4-6), and energies.

use assur_group::plane::{dot, vector};
use assur_group::{Body, Wrench};
use assur_integrator::Reduced;
use assur_number::Real;

use crate::choice::{Choice, Live};
use crate::loads::{Applied, Cause, Loads, Mass};
use crate::visit::{self, Sink, Visit};
use crate::{LoadNumber, LoadState, Phase};

/// Adds up the virtual power of loads.
struct Power<T>(T);

impl<T: LoadNumber> Sink<T> for Power<T> {
    #[inline(always)]
    fn force(&mut self, _: Cause, _: usize, body: &Body<T>, arm: [T; 2], force: [T; 2]) {
        self.0 += dot(body.first(arm), force);
    }

    #[inline(always)]
    fn moment(&mut self, _: Cause, _: usize, body: &Body<T>, moment: T) {
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
        Visit { loads: self, choice: &Live, states, bodies }.reduced()
    }

    /// Reduced inertia, its derivative and the reduced moment by the formulas of one phase, continued smoothly beyond
    /// its bounds. `bodies` need PF2 only where J depends on the coordinate.
    #[inline]
    pub fn reduced_in_phase(&self, phase: &Phase, state: &LoadState, bodies: &[Body<f64>]) -> Reduced {
        Visit { loads: self, choice: phase, states: state, bodies }.reduced()
    }

    /// Potential energy of weights (zero at the origin of the ground) and springs, J. Other loads have none here.
    pub fn potential_energy<T: LoadNumber>(&self, bodies: &[Body<T>]) -> T {
        let mut energy = T::ZERO;
        for mass in &self.masses {
            let weight = mass.weight(self.gravity);
            energy -= dot(weight, bodies[mass.link].point(vector(mass.center)));
        }
        for spring in self.applied.iter().filter_map(Applied::spring) {
            energy += visit::energy(spring, bodies);
        }
        energy
    }

    /// Sum of the sizes of the terms of which the [potential energy](Self::potential_energy) consists, J: it has the rounding
    /// of these.
    pub fn terms_of_potential_energy(&self, bodies: &[Body<f64>]) -> f64 {
        let weights = self.masses.iter().map(|mass| {
            let [weight, place] = [mass.weight(self.gravity), bodies[mass.link].point(vector(mass.center))];
            dot(weight, weight).sqrt() * dot(place, place).sqrt()
        });
        let springs = self.applied.iter().filter_map(Applied::spring);
        weights.chain(springs.map(|spring| visit::terms_of_energy(spring, bodies))).sum()
    }
}

/// Reduction to the input link.
impl<T: LoadNumber, C: Choice> Visit<'_, T, C> {
    #[inline(always)]
    fn reduced(self) -> Reduced<T> {
        T::evaluate(
            #[inline(always)]
            move || {
                let Self { loads, states, bodies, .. } = self;
                let (mut inertia, mut half, mut power) = (T::ZERO, T::ZERO, Power(T::ZERO));
                for mass in &loads.masses {
                    let body = &bodies[mass.link];
                    let (own, slope) = mass.reduced(states, body, loads.inertia_constant);
                    inertia += own;
                    half += slope;
                    if loads.has_weights() {
                        power.force(
                            Cause::Weight(mass.link),
                            mass.link,
                            body,
                            mass.arm(body),
                            mass.weight(loads.gravity),
                        );
                    }
                }
                self.each(&mut power);
                Reduced { inertia, inertia_derivative: half.twice(), moment: power.0 }
            },
        )
    }
}

impl Mass {
    /// Reduced inertia of the link, and half of its derivative with respect to the coordinate, unless it is not wanted.
    #[inline(always)]
    fn reduced<T: LoadNumber>(&self, states: &T::States, body: &Body<T>, constant: bool) -> (T, T) {
        let (inertia, half) = self.rigid(body, constant);
        let Some([own, slope]) = self.varying_at::<T>(states) else { return (inertia, half) };
        let turning = own * body.w1;
        let changing = (slope * body.w1 * body.w1).half();
        (inertia + turning * body.w1, half + turning * body.w2 + changing)
    }

    /// The moment of inertia that varies, and its derivative with respect to the coordinate.
    #[inline(always)]
    pub(crate) fn varying_at<T: LoadNumber>(&self, states: &T::States) -> Option<[T; 2]> {
        let law = self.varying.as_ref()?;
        Some([0, 1].map(|order| T::of_lanes(|lane| law.at(T::state(states, lane).coordinate)[order])))
    }

    /// The part of the rigid link.
    #[inline(always)]
    fn rigid<T: LoadNumber>(&self, body: &Body<T>, constant: bool) -> (T, T) {
        let (w, e) = (body.w1, body.w2);
        if let Some(inertia) = self.about_pin {
            let turning = T::from_f64(inertia) * w;
            return (turning * w, if constant { T::ZERO } else { turning * e });
        }
        let (m, turning) = (T::from_f64(self.m), T::from_f64(self.inertia) * w);
        let arm = self.arm(body);
        let velocity = if self.at_origin { [body.x1, body.y1] } else { body.first(arm) };
        let inertia = m * dot(velocity, velocity) + turning * w;
        if constant {
            return (inertia, T::ZERO);
        }
        let acceleration = if self.at_origin { [body.x2, body.y2] } else { body.second(arm) };
        (inertia, m * dot(velocity, acceleration) + turning * e)
    }

    /// Arm of the center of mass from the origin of the link.
    #[inline(always)]
    fn arm<T: LoadNumber>(&self, body: &Body<T>) -> [T; 2] {
        if self.at_origin { [T::ZERO; 2] } else { body.arm(vector(self.center)) }
    }
}

/// Virtual power of a wrench about the origin of a body for dq = 1.
#[inline(always)]
pub fn power<T: Real>(wrench: &Wrench<T>, body: &Body<T>) -> T {
    wrench.fx * body.x1 + wrench.fy * body.y1 + wrench.m * body.w1
}
