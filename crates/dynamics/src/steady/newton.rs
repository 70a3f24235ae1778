//! One stretch of the path: Newton's method for the collocation equations, and the variational equation.

use super::arc::Arc;
use super::collocation::{Lu, Nodal, RULE, S, product};
use super::path::{Data, Datum};
use super::sweep::{BY_DRIVE, BY_ENERGY, BY_FLYWHEEL, PARAMETERS, Sweep};

/// Newton steps for a panel.
const MOST_STEPS: usize = 30;

/// Newton's method did not converge on a stretch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Failure {
    /// The speed went to zero.
    pub(super) stalled: bool,
}

/// Moment at a place, and its derivatives.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Force {
    pub(super) value: f64,
    by_energy: f64,
    by_parameter: [f64; 2],
}

impl Sweep<'_, '_> {
    #[inline]
    pub(super) fn force(&self, datum: &Datum, energy: f64) -> Force {
        let inertia = datum.inertia + self.setup.shaft.inertia;
        let v = (2.0 * energy / inertia).sqrt();
        let drive = self.setup.shaft.moment(self.factor, v);
        let by_speed = drive.by_speed + datum.by_speed;
        let by_inertia = -by_speed * v / (2.0 * inertia);
        let [by_ratio, by_flywheel] = self.setup.inertia_by;
        Force {
            value: datum.moment_at(v) + drive.value,
            by_energy: by_speed / (inertia * v),
            by_parameter: [drive.by_parameter + by_inertia * by_ratio, by_inertia * by_flywheel],
        }
    }

    /// Newton's method for `T(i) = T(0) + h sum over j of a(i, j) M(x(j), T(j))`.
    pub(super) fn solve(
        &mut self,
        x: f64,
        h: f64,
        data: &Data,
        guess: Option<Nodal>,
    ) -> Result<Arc, Failure> {
        let start = self.energy;
        let floor = 1e-9 * start;
        let mut energy = guess.unwrap_or([start; S]);
        let mut forces = [Force::default(); S];
        let mut factors;
        let mut steps = 0;
        loop {
            for (j, force) in forces.iter_mut().enumerate() {
                *force = self.force(&data.nodes[j], energy[j]);
            }
            let integral = product(&RULE.a, &forces.map(|force| force.value));
            let miss: Nodal = std::array::from_fn(|i| start + h * integral[i] - energy[i]);
            factors = Lu::new(std::array::from_fn(|i| {
                std::array::from_fn(|j| f64::from(u8::from(i == j)) - h * RULE.a[i][j] * forces[j].by_energy)
            }));
            let step = factors.solve(&miss);
            let largest = step.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
            for (t, d) in energy.iter_mut().zip(&step) {
                *t = (*t + d).max(0.05 * *t).max(floor);
            }
            steps += 1;
            let most = energy.iter().fold(start, |most, t| most.max(*t));
            // The step is made already: what is left is its square.
            if largest <= 1e-11 * most {
                break;
            }
            if steps == MOST_STEPS || !largest.is_finite() {
                return Err(Failure { stalled: energy.iter().any(|t| *t < 1e-2 * start) });
            }
        }
        if energy.iter().any(|t| *t <= 2.0 * floor) {
            return Err(Failure { stalled: true });
        }
        Ok(self.arc(x, h, data, energy, &forces, &factors))
    }

    /// The arc with its derivatives: the same linear system with other right-hand sides.
    fn arc(&self, x: f64, h: f64, data: &Data, energy: Nodal, forces: &[Force; S], factors: &Lu) -> Arc {
        let first = self.force(&data.start, self.energy).value;
        let mut derivatives = [[0.0; S]; PARAMETERS];
        derivatives[BY_ENERGY] = factors.solve(&[1.0; S]).map(|d| d * self.derivatives[BY_ENERGY]);
        for p in [BY_DRIVE, BY_FLYWHEEL] {
            let sources = product(&RULE.a, &forces.map(|force| force.by_parameter[p - 1]));
            let b = sources.map(|source| self.derivatives[p] + h * source);
            derivatives[p] = factors.solve(&b);
        }
        Arc {
            x,
            h,
            data: *data,
            start: self.energy,
            energy,
            first_moment: first,
            moment: forces.map(|force| force.value),
            start_derivatives: self.derivatives,
            derivatives,
            factor: self.factor,
        }
    }
}
