//! One stretch of the path: Newton's method for the collocation equations, and the variational equation.

use nalgebra::{SMatrix, SVector};

use super::collocation::{RULE, S, Values};
use super::path::{Coefficients, NodalCoefficients};
use super::segment::{BY_DRIVE, BY_ENERGY, BY_FLYWHEEL, PARAMETERS, Segment, Setup};

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

/// The equations of the nodes, factorized at the solution.
type Factors = nalgebra::LU<f64, nalgebra::Const<S>, nalgebra::Const<S>>;

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
) -> Result<([Moment; S + 1], Factors), Failure> {
    let start = energy[0];
    let mut moments: [Moment; S + 1] = std::array::from_fn(|j| moment(j, energy));
    for _ in 0..MOST_STEPS {
        let integrals = RULE.integrals(&moments.map(|moment| moment.value));
        let miss = SVector::<f64, S>::from_fn(|i, _| start + h * integrals[i + 1] - energy[i + 1]);
        let unit = |i, j| f64::from(u8::from(i == j));
        let slope = |i: usize, j: usize| unit(i, j) - h * RULE.a[i][j] * moments[j + 1].by_energy;
        let lu = SMatrix::<f64, S, S>::from_fn(slope).lu();
        let Some(step) = lu.solve(&miss).filter(|step| step.iter().all(|d| d.is_finite())) else { break };
        for (t, d) in energy[1..].iter_mut().zip(&step) {
            *t = (*t + d).max(LEAST_LEFT * *t).max(FLOOR * start);
        }
        let most = energy.iter().copied().fold(0.0, f64::max);
        if step.amax() <= CONVERGED * most {
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
fn derivatives(moments: &[Moment; S + 1], lu: &Factors, start: &Start, h: f64) -> [Values; PARAMETERS] {
    let vary = |right: SVector<f64, S>, first: f64| -> Values {
        let found = lu.solve(&right).unwrap_or_else(|| SVector::repeat(f64::NAN));
        std::array::from_fn(|i| if i == 0 { first } else { found[i - 1] })
    };
    let mut derivatives = [[0.0; S + 1]; PARAMETERS];
    let by_energy = start.derivatives[BY_ENERGY];
    derivatives[BY_ENERGY] = vary(SVector::repeat(1.0), 1.0).map(|d| d * by_energy);
    for p in [BY_DRIVE, BY_FLYWHEEL] {
        let sources = RULE.integrals(&moments.map(|moment| moment.by_parameter[p - 1]));
        let first = start.derivatives[p];
        derivatives[p] = vary(SVector::from_fn(|i, _| first + h * sources[i + 1]), first);
    }
    derivatives
}
