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

/// Solves `T(i) = T(0) + h sum over j of a(i, j) M(x(j), T(j))`; `guess`: energies of a solution nearby.
pub(crate) fn solve(
    setup: &Setup,
    start: &Start,
    [x, h]: [f64; 2],
    coefficients: &NodalCoefficients,
    guess: Option<&Values>,
) -> Result<Segment, Failure> {
    let floor = 1e-9 * start.energy;
    let mut energy = guess.copied().unwrap_or([start.energy; S + 1]);
    energy[0] = start.energy;
    let failure = |energy: &Values| Failure { stalled: energy.iter().any(|t| *t < 1e-2 * start.energy) };
    let mut moments = [Moment::default(); S + 1];
    let mut steps = 0;
    let lu = loop {
        for j in 1..=S {
            moments[j] = Moment::at(setup, start.factor, &coefficients.nodes[j], energy[j]);
        }
        let integrals = RULE.integrals(&moments.map(|moment| moment.value));
        let miss = SVector::<f64, S>::from_fn(|i, _| start.energy + h * integrals[i + 1] - energy[i + 1]);
        let lu = SMatrix::<f64, S, S>::from_fn(|i, j| {
            f64::from(u8::from(i == j)) - h * RULE.a[i][j] * moments[j + 1].by_energy
        })
        .lu();
        let step = lu.solve(&miss).unwrap_or_else(|| SVector::repeat(f64::NAN));
        if !step.iter().all(|d| d.is_finite()) {
            return Err(failure(&energy));
        }
        let largest = step.amax();
        for (t, d) in energy[1..].iter_mut().zip(&step) {
            *t = (*t + d).max(0.05 * *t).max(floor);
        }
        steps += 1;
        let most = energy.iter().copied().fold(0.0, f64::max);
        // The step has already been taken: the remaining error is its square.
        if largest <= 1e-11 * most {
            break lu;
        }
        if steps == MOST_STEPS {
            return Err(failure(&energy));
        }
    };
    if energy.iter().any(|t| *t <= 2.0 * floor) {
        return Err(Failure { stalled: true });
    }
    moments[0] = Moment::at(setup, start.factor, &coefficients.nodes[0], start.energy);
    // The derivatives solve the same linear system with other right-hand sides.
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
    Ok(Segment {
        x,
        h,
        coefficients: *coefficients,
        energy,
        moment: moments.map(|moment| moment.value),
        derivatives,
        factor: start.factor,
    })
}
