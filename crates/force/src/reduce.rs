//! Reduction to the input link (theory of the project, section 3; S eqs. 1-3; E eqs. 4-6), and energies.

use assur_group::Body;
use assur_integrator::Reduced;

use crate::loads::Loads;
use crate::visit::{Choice, Selections, Sink};
use crate::{Phase, State};

/// Adds up the virtual power of loads.
struct Power(f64);

impl Sink for Power {
    #[inline]
    fn force(&mut self, _link: usize, body: &Body<f64>, arm: [f64; 2], force: [f64; 2]) {
        let pf1 = body.first(arm);
        self.0 += pf1[0] * force[0] + pf1[1] * force[1];
    }

    #[inline]
    fn moment(&mut self, _link: usize, body: &Body<f64>, moment: f64) {
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
    pub fn reduced(&self, state: &State, bodies: &[Body<f64>]) -> Reduced {
        match self.selections(state) {
            Selections::One(selection) => self.reduce(&selection, state, bodies),
            Selections::Held([(below, lower), (above, upper)]) => {
                let [low, high] = [lower, upper].map(|selection| self.reduce(&selection, state, bodies));
                Reduced { moment: below * low.moment + above * high.moment, ..low }
            }
        }
    }

    /// Reduced inertia, its derivative and the reduced moment by the formulas of one phase, continued smoothly beyond
    /// its bounds. `bodies` need PF2 only where J depends on the coordinate.
    pub fn reduced_in_phase(&self, phase: &Phase, state: &State, bodies: &[Body<f64>]) -> Reduced {
        self.reduce(phase, state, bodies)
    }

    #[inline]
    fn reduce<C: Choice>(&self, choice: &C, state: &State, bodies: &[Body<f64>]) -> Reduced {
        let (mut inertia, mut half, mut power) = (0.0, 0.0, 0.0);
        let [gx, gy] = self.gravity;
        for mass in &self.masses {
            let body = &bodies[mass.link];
            let arm = body.arm(mass.center);
            let [vx, vy] = body.first(arm);
            inertia += mass.m * (vx * vx + vy * vy) + mass.inertia * (body.w1 * body.w1);
            if !self.inertia_constant {
                let [ax, ay] = body.second(arm);
                half += mass.m * (vx * ax + vy * ay) + mass.inertia * (body.w1 * body.w2);
            }
            power += mass.m * (gx * vx + gy * vy);
        }
        let mut sum = Power(power);
        self.visit(choice, state, bodies, &mut sum);
        Reduced { inertia, inertia_derivative: 2.0 * half, moment: sum.0 }
    }

    /// Potential energy of weights (zero at the origin of the ground) and springs, J. Other loads have none here.
    pub fn potential_energy(&self, bodies: &[Body<f64>]) -> f64 {
        let weights = self.masses.iter().map(|mass| {
            let [x, y] = bodies[mass.link].point(mass.center);
            -mass.m * (self.gravity[0] * x + self.gravity[1] * y)
        });
        weights.sum::<f64>() + self.springs.iter().map(|spring| spring.energy(bodies)).sum::<f64>()
    }
}
