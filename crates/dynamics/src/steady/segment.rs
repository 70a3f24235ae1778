//! A solved stretch of the path: the kinetic energy on it as a polynomial, with its derivatives with respect to the
//! unknowns.

use assur_number::search::bisect;

use super::collocation::{RULE, Values};
use super::path::{Coefficients, NodalCoefficients};
use crate::InputDrive;

/// Number of quantities with respect to which the energy is differentiated.
pub(crate) const PARAMETERS: usize = 3;

/// Initial energy.
pub(crate) const BY_ENERGY: usize = 0;
/// Ratio u, or the constant moment.
pub(crate) const BY_DRIVE: usize = 1;
/// Flywheel on its own shaft.
pub(crate) const BY_FLYWHEEL: usize = 2;

/// The drive, and how its inertia follows from the unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Setup {
    pub(crate) drive: InputDrive,
    /// Derivatives of the drive's inertia with respect to ratio and flywheel.
    pub(crate) inertia_by: [f64; 2],
}

/// How far what is read of a stretch is off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Misses {
    /// Of the energy, as part of it.
    pub(crate) residual: f64,
    /// Of the square of the speed, or of the time, as part of them.
    pub(crate) speed: f64,
    /// Of the moments in the equation with the acceleration that is read, N m.
    pub(crate) moment: f64,
}

impl Misses {
    /// The greater ones of both.
    pub(crate) fn or(&self, other: &Self) -> Self {
        Self {
            residual: self.residual.max(other.residual),
            speed: self.speed.max(other.speed),
            moment: self.moment.max(other.moment),
        }
    }
}

/// A solved stretch of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Segment {
    pub(crate) x: f64,
    pub(crate) h: f64,
    pub(crate) coefficients: NodalCoefficients,
    /// T at the start and at the nodes, J.
    pub(crate) energy: Values,
    /// dT/dx at the start and at the nodes, N m.
    pub(crate) moment: Values,
    /// Derivatives of T with respect to each parameter.
    pub(crate) derivatives: [Values; PARAMETERS],
    /// η or 1/η, see [`Branch`](crate::drive::Branch).
    pub(crate) factor: f64,
}

impl Segment {
    pub(crate) fn is_at(&self, x: f64, h: f64) -> bool {
        self.x.to_bits() == x.to_bits() && self.h.to_bits() == h.to_bits()
    }

    pub(crate) fn energy_at(&self, theta: f64) -> f64 {
        RULE.interpolate(&self.energy, theta)
    }

    /// Reduced inertia of the machine without its drive.
    pub(crate) fn inertia_at(&self, theta: f64) -> f64 {
        RULE.interpolate(&self.coefficients.values(|node| node.inertia), theta)
    }

    pub(crate) fn derivatives_at(&self, theta: f64) -> [f64; PARAMETERS] {
        self.derivatives.map(|values| RULE.interpolate(&values, theta))
    }

    /// T/J = v²/2 at the start and at the nodes.
    pub(crate) fn half_squares(&self, drive: &InputDrive) -> Values {
        std::array::from_fn(|i| self.energy[i] / (self.coefficients.nodes[i].inertia + drive.inertia))
    }

    /// d(v²/2)/dx, the acceleration along the path, at the start and at the nodes.
    pub(crate) fn accelerations(&self, drive: &InputDrive) -> Values {
        let half_squares = self.half_squares(drive);
        std::array::from_fn(|i| {
            let node = &self.coefficients.nodes[i];
            (self.moment[i] - half_squares[i] * node.slope) / (node.inertia + drive.inertia)
        })
    }

    /// Where the speed passes `level`, between a part where it has not yet (`inside`) and one where it has.
    pub(crate) fn crossing(&self, level: f64, drive: &InputDrive, [inside, outside]: [f64; 2]) -> f64 {
        let excess = |theta: f64| {
            2.0 * self.energy_at(theta) - (self.inertia_at(theta) + drive.inertia) * level * level
        };
        let sign = excess(outside).signum();
        bisect(outside, inside, 0.0, |theta| excess(theta) * sign > 0.0)[0]
    }

    /// How far the polynomials from which speed, time and acceleration are read are off. Between the nodes that shows in the
    /// middle, where a polynomial through them is hardly nearer than anywhere else.
    pub(crate) fn misses(&self, drive: &InputDrive) -> Misses {
        let middle = &self.coefficients.middle;
        let inertia = middle.inertia + drive.inertia;
        let moment_at = |place: &Coefficients, half: f64| {
            let v = (2.0 * half).sqrt();
            place.moment_at(v) + drive.moment(self.factor, v).value
        };
        let (halves, accelerations) = (self.half_squares(drive), self.accelerations(drive));
        let half = self.middle_energy() / inertia;
        let acceleration = (moment_at(middle, half) - half * middle.slope) / inertia;
        let read = RULE.interpolate(&halves, RULE.middle);
        let slowness = RULE.at_middle(&halves.map(|half| 1.0 / (2.0 * half).sqrt()));
        let off = read - half;
        let between = (inertia * (RULE.interpolate(&accelerations, RULE.middle) - acceleration)).abs()
            + (middle.slope * off).abs()
            + (moment_at(middle, read) - moment_at(middle, half)).abs();
        // Newton's method ends with the moments of the energies before its last step.
        let nodes = self.coefficients.nodes.iter().zip(&halves).zip(&self.moment);
        let at_nodes = nodes.map(|((node, half), moment)| (moment_at(node, *half) - moment).abs());
        Misses {
            residual: self.residual(drive),
            speed: (off / half).abs().max((slowness * (2.0 * half).sqrt() - 1.0).abs()),
            moment: at_nodes.fold(between, f64::max),
        }
    }

    /// Size of the terms of the equation, N m.
    pub(crate) fn terms(&self, drive: &InputDrive) -> f64 {
        let accelerated = self.accelerations(drive).into_iter().zip(self.half_squares(drive));
        let nodes = accelerated.zip(&self.coefficients.nodes).zip(&self.moment);
        let each = nodes.map(|(((acceleration, half), node), moment)| {
            moment.abs() + ((node.inertia + drive.inertia) * acceleration).abs() + (node.slope * half).abs()
        });
        each.fold(0.0, f64::max)
    }

    /// The residual of the equation between the nodes, as part of the energy.
    pub(crate) fn residual(&self, drive: &InputDrive) -> f64 {
        let middle = &self.coefficients.middle;
        let v = (2.0 * self.middle_energy() / (middle.inertia + drive.inertia)).sqrt();
        let moment = middle.moment_at(v) + drive.moment(self.factor, v).value;
        (RULE.at_middle(&self.moment) - moment).abs() * self.h / self.energy[0]
    }

    pub(crate) fn middle_energy(&self) -> f64 {
        self.energy[0] + self.h * RULE.integral_to_middle(&self.moment)
    }
}
