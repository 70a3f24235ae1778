//! A solved cycle: kinetic energy over the path as polynomials, arc by arc.

use super::collocation::{Nodal, RULE, S, dot};
use super::path::{Data, Datum, Way};
use super::sweep::{PARAMETERS, Setup};
use crate::Shaft;

/// A stretch of the path with the energy on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Arc {
    pub(crate) x: f64,
    pub(crate) h: f64,
    pub(crate) data: Data,
    /// T at the start and at the nodes, J.
    pub(crate) start: f64,
    pub(crate) energy: Nodal,
    /// dT/dx at the start and at the nodes, N m.
    pub(crate) first_moment: f64,
    pub(crate) moment: Nodal,
    pub(crate) start_derivatives: [f64; PARAMETERS],
    pub(crate) derivatives: [Nodal; PARAMETERS],
    /// η or 1/η.
    pub(crate) factor: f64,
}

/// One cycle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Solution {
    pub(crate) setup: Setup,
    pub(crate) way: Way,
    /// T at the start and at the end.
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// Derivatives of the energy at the end.
    pub(crate) derivatives: [f64; PARAMETERS],
    pub(crate) arcs: Vec<Arc>,
}

/// Speed and acceleration along the path at one place, with what they come from.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Place {
    pub(crate) x: f64,
    pub(crate) energy: f64,
    /// T/J, v²/2.
    pub(crate) half_square: f64,
    /// d(v²/2)/dx, the acceleration.
    pub(crate) acceleration: f64,
}

impl Arc {
    pub(crate) fn same_place(&self, x: f64, h: f64) -> bool {
        self.x.to_bits() == x.to_bits() && self.h.to_bits() == h.to_bits()
    }

    pub(crate) fn energy_at(&self, theta: f64) -> f64 {
        RULE.interpolate(self.start, &self.energy, theta)
    }

    pub(crate) fn inertia_at(&self, theta: f64) -> f64 {
        RULE.interpolate(self.data.start.inertia, &self.data.nodes.map(|node| node.inertia), theta)
    }

    pub(crate) fn derivatives_at(&self, theta: f64) -> [f64; PARAMETERS] {
        std::array::from_fn(|p| RULE.interpolate(self.start_derivatives[p], &self.derivatives[p], theta))
    }

    /// Where the speed passes `level` between two parts of the arc.
    pub(crate) fn when(&self, level: f64, shaft: &Shaft, [mut inside, mut outside]: [f64; 2]) -> f64 {
        let excess = |theta: f64| {
            2.0 * self.energy_at(theta) - (self.inertia_at(theta) + shaft.inertia) * level * level
        };
        let sign = excess(outside).signum();
        for _ in 0..54 {
            let middle = 0.5 * (inside + outside);
            if excess(middle) * sign > 0.0 {
                outside = middle;
            } else {
                inside = middle;
            }
        }
        outside
    }

    /// Place at the start (0) or at a node (from 1).
    pub(crate) fn place(&self, index: usize, shaft: &Shaft) -> Place {
        let at = |c: f64, energy: f64, moment: f64, datum: &Datum| {
            let inertia = datum.inertia + shaft.inertia;
            let half_square = energy / inertia;
            let acceleration = (moment - half_square * datum.slope) / inertia;
            Place { x: self.x + c * self.h, energy, half_square, acceleration }
        };
        match index.checked_sub(1) {
            None => at(0.0, self.start, self.first_moment, &self.data.start),
            Some(i) => at(RULE.c[i], self.energy[i], self.moment[i], &self.data.nodes[i]),
        }
    }

    /// How much the polynomial misses the equation between the nodes, as energy over the arc, J: `moments` are the
    /// true ones at the start and in the middle.
    pub(crate) fn residual(&self, middle_moment: f64) -> f64 {
        // At 0 the derivative of the polynomial is that of the moments' polynomial, continued.
        let middle = dot(&RULE.at_middle, &self.moment) - middle_moment;
        middle.abs() * self.h
    }

    pub(crate) fn middle_energy(&self) -> f64 {
        self.start + self.h * dot(&RULE.to_middle, &self.moment)
    }
}

impl Solution {
    /// The arc that holds a place of the path.
    pub(crate) fn arc(&self, x: f64) -> Option<&Arc> {
        let after = self.arcs.partition_point(|arc| arc.x <= x);
        self.arcs.get(after.saturating_sub(1))
    }

    /// Number of places at which the solution is known without interpolation.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = (&Arc, usize)> {
        self.arcs.iter().flat_map(|arc| (0..=S).map(move |index| (arc, index)))
    }
}
