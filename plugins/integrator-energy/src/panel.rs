//! A panel of the coordinate with the polynomials of J and of the kinetic energy.

use assur_integrator::{Equation, MotionError, State};
use assur_number::panel::chebyshev::{
    NODES, Series, WITH_ENDS, divided, first_zero, integral, swing, tail, value,
};

/// J and Q at a node.
pub(crate) type Values = (f64, f64);

/// A panel over x in [-1, 1].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Panel {
    /// Coordinate at x = -1, rad (m).
    pub(crate) start: f64,
    /// Length with the sign of the direction, rad (m).
    pub(crate) length: f64,
    inertia: Series,
    /// Kinetic energy T, N m.
    energy: Series,
    /// J and Q at x = 1.
    pub(crate) last: Values,
    /// Largest error of the fits, relative.
    pub(crate) error: f64,
}

impl Panel {
    /// Fits a panel. `first` are the values at its start where they are known, `energy` is T there, and `largest`
    /// the largest T so far: the energy is right compared to that.
    pub(crate) fn fit(
        equation: &mut Equation<'_>,
        from: &State,
        length: f64,
        first: Option<Values>,
        (energy, largest): (f64, f64),
    ) -> Result<Self, MotionError> {
        let (mut inertias, mut moments) = ([0.0; NODES], [0.0; NODES]);
        for (j, x) in WITH_ENDS.nodes.iter().enumerate() {
            let known = if j == 0 { first } else { None };
            let state = State { coordinate: from.coordinate + 0.5 * length * (1.0 + x), ..*from };
            (inertias[j], moments[j]) = match known {
                Some(values) => values,
                None => equation.work(&state)?,
            };
        }
        let (inertia, moment) = (WITH_ENDS.fit(&inertias), WITH_ENDS.fit(&moments));
        let mut work = integral(&moment, 0.5 * length);
        work[0] += energy;
        let scale = largest.max(work[0].abs()).max(swing(&work));
        // The integral of T_k is smaller than T_k by about k.
        let of_work = 0.5 * length.abs() * tail(&moment) / (NODES as f64 * scale);
        let error = of_work.max(0.5 * tail(&inertia) / inertia[0].abs());
        let last = (inertias[NODES - 1], moments[NODES - 1]);
        Ok(Self { start: from.coordinate, length, inertia, energy: work, last, error })
    }

    pub(crate) fn coordinate(&self, x: f64) -> f64 {
        self.start + 0.5 * self.length * (1.0 + x)
    }

    /// T at x.
    pub(crate) fn energy(&self, x: f64) -> f64 {
        value(&self.energy, x)
    }

    /// The energy without its zeros: divided by (x + 1) if the motion starts from rest, and by (until - x) if it ends
    /// at rest there.
    pub(crate) fn energy_without_zeros(&self, starts: bool, ends: Option<f64>) -> Series {
        let mut series = self.energy;
        if starts {
            series = divided(&series, -1.0);
        }
        if let Some(until) = ends {
            series = divided(&series, until).map(|c| -c);
        }
        series
    }

    /// Seconds for a unit of x at the energy 1 N m: (L/2) √(J/2).
    pub(crate) fn slowness(&self, x: f64) -> f64 {
        0.5 * self.length.abs() * (0.5 * value(&self.inertia, x)).sqrt()
    }

    /// Speed at `x` for an energy there, rad/s (m/s): w = √(2 T/J), E eq. 1.
    pub(crate) fn speed(&self, x: f64, energy: f64) -> f64 {
        (2.0 * energy.max(0.0) / value(&self.inertia, x)).sqrt().copysign(self.length)
    }

    /// An upper bound of T in the panel.
    pub(crate) fn most_energy(&self) -> f64 {
        self.energy[0] + swing(&self.energy)
    }

    /// First x at which T falls to zero, if it does, after a start from rest or in motion.
    pub(crate) fn turning(&self, from_rest: bool) -> Option<f64> {
        if self.energy[0] - swing(&self.energy) > 0.0 {
            return None;
        }
        first_zero(&self.energy_without_zeros(from_rest, None))
    }
}

/// Factor of the length that brings the error of a fit to the tolerance.
pub(crate) fn factor(tolerance: f64, error: f64) -> f64 {
    0.85 * (tolerance / error.max(1e-30)).powf(1.0 / (NODES - 1) as f64)
}
