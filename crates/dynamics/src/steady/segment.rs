//! A solved stretch of the path: the kinetic energy on it as a polynomial, with its derivatives with respect to the
//! unknowns; found by Newton's method for the collocation equations, and the variational equation.

use assur_number::elimination::Lu;
use assur_number::search::bisect;

use super::path::{Coefficients, NodalCoefficients, RULE, S, Values};
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
    pub(crate) fn energy_at(&self, theta: f64) -> f64 {
        RULE.interpolate(&self.energy, theta)
    }

    /// Reduced inertia of the machine without its drive.
    pub(crate) fn inertia_at(&self, theta: f64) -> f64 {
        RULE.interpolate(&self.coefficients.values(|node| node.inertia), theta)
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

/// Newton steps for a panel.
const MOST_STEPS: usize = 30;

/// Newton's method did not converge on a stretch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Failure {
    /// The speed went to zero.
    pub(crate) stalled: bool,
}

/// The state at the start of a stretch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Start {
    /// T, J.
    pub(crate) energy: f64,
    /// Derivatives of T with respect to each parameter.
    pub(crate) derivatives: [f64; PARAMETERS],
    /// η or 1/η.
    pub(crate) factor: f64,
}

/// Moment of loads and drive along the path, and its derivatives.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Moment {
    pub(crate) value: f64,
    by_energy: f64,
    /// With respect to the drive's parameter, to the flywheel.
    by_parameter: [f64; 2],
}

impl Moment {
    /// The moment at a place, at the kinetic energy there.
    #[inline]
    pub(crate) fn at(setup: &Setup, factor: f64, place: &Coefficients, energy: f64) -> Self {
        let inertia = place.inertia + setup.drive.inertia;
        let v = (2.0 * energy / inertia).sqrt();
        let drive = setup.drive.moment(factor, v);
        let by_speed = drive.by_speed + place.by_speed;
        let by_inertia = -by_speed * v / (2.0 * inertia);
        let [by_ratio, by_flywheel] = setup.inertia_by;
        Self {
            value: place.moment_at(v) + drive.value,
            by_energy: by_speed / (inertia * v),
            by_parameter: [drive.by_parameter + by_inertia * by_ratio, by_inertia * by_flywheel],
        }
    }
}

/// The energies of a stretch are solved down to this part of that at its start; below, the machine counts as stalled.
const FLOOR: f64 = 1e-9;

/// Where Newton's method fails, the machine counts as stalled if an energy is below this part of that at the start.
const NEARLY_AT_REST: f64 = 1e-2;

/// A Newton step reduces an energy to this part of itself at most, so that it stays positive.
const LEAST_LEFT: f64 = 0.05;

/// The last Newton step, as part of the greatest energy. It is taken: the remaining error is of the size of its square.
const CONVERGED: f64 = 1e-11;

/// Solves `T(i) = T(0) + h sum over j of a(i, j) M(x(j), T(j))`; `guess`: energies of a solution nearby.
pub(crate) fn solve(
    setup: &Setup,
    start: &Start,
    [x, h]: [f64; 2],
    coefficients: &NodalCoefficients,
    guess: Option<&Values>,
) -> Result<Segment, Failure> {
    let moment =
        |j: usize, energy: &Values| Moment::at(setup, start.factor, &coefficients.nodes[j], energy[j]);
    let mut energy = guess.copied().unwrap_or([start.energy; S + 1]);
    energy[0] = start.energy;
    let (moments, lu) = converge(&mut energy, h, moment)?;
    Ok(Segment {
        x,
        h,
        coefficients: *coefficients,
        energy,
        moment: moments.map(|moment| moment.value),
        derivatives: derivatives(&moments, &lu, start, h),
        factor: start.factor,
    })
}

/// Newton's method from the energies given, of which the first stays. Returns the moments of the last step, with that at the
/// start, and the factors of its equations.
fn converge(
    energy: &mut Values,
    h: f64,
    moment: impl Fn(usize, &Values) -> Moment,
) -> Result<([Moment; S + 1], Lu<f64, S>), Failure> {
    let start = energy[0];
    let mut moments: [Moment; S + 1] = std::array::from_fn(|j| moment(j, energy));
    for _ in 0..MOST_STEPS {
        let integrals = RULE.integrals(&moments.map(|moment| moment.value));
        let miss: [f64; S] = std::array::from_fn(|i| start + h * integrals[i + 1] - energy[i + 1]);
        let unit = |i, j| f64::from(u8::from(i == j));
        let slope = |i: usize, j: usize| unit(i, j) - h * RULE.a[i][j] * moments[j + 1].by_energy;
        let lu = Lu::new(std::array::from_fn(|i| std::array::from_fn(|j| slope(i, j))));
        let step = lu.solve(&miss);
        if !step.iter().all(|d| d.is_finite()) {
            break;
        }
        for (t, d) in energy[1..].iter_mut().zip(&step) {
            *t = (*t + d).max(LEAST_LEFT * *t).max(FLOOR * start);
        }
        let most = energy.iter().copied().fold(0.0, f64::max);
        if step.iter().all(|d| d.abs() <= CONVERGED * most) {
            let stalled = energy.iter().any(|t| *t <= 2.0 * FLOOR * start);
            return if stalled { Err(Failure { stalled }) } else { Ok((moments, lu)) };
        }
        for (j, found) in moments.iter_mut().enumerate().skip(1) {
            *found = moment(j, energy);
        }
    }
    Err(Failure { stalled: energy.iter().any(|t| *t < NEARLY_AT_REST * start) })
}

/// Derivatives of the energies with respect to each parameter: they solve the linear system of the last Newton step with
/// other right-hand sides.
fn derivatives(moments: &[Moment; S + 1], lu: &Lu<f64, S>, start: &Start, h: f64) -> [Values; PARAMETERS] {
    let vary = |right: [f64; S], first: f64| -> Values {
        let found = lu.solve(&right);
        std::array::from_fn(|i| if i == 0 { first } else { found[i - 1] })
    };
    let mut derivatives = [[0.0; S + 1]; PARAMETERS];
    let by_energy = start.derivatives[BY_ENERGY];
    derivatives[BY_ENERGY] = vary([1.0; S], 1.0).map(|d| d * by_energy);
    for p in [BY_DRIVE, BY_FLYWHEEL] {
        let sources = RULE.integrals(&moments.map(|moment| moment.by_parameter[p - 1]));
        let first = start.derivatives[p];
        derivatives[p] = vary(std::array::from_fn(|i| first + h * sources[i + 1]), first);
    }
    derivatives
}
