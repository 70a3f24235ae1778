//! Differences around a position, by a chain that is compiled anew from the lengths of the scene.
//!
//! The step of a difference must be far smaller than the distance to a singular position. In 16 digits that leaves a
//! dozen digits of the derivative in ordinary positions, and none close to a singular one. In double-double, steps of a
//! tenth of that distance and less keep more than 16 digits down to distances of 1e-14, so the differences are known,
//! with their error, wherever the calculated numbers have digits to compare. Both number types go through the kernels of
//! the program; their PF1 and PF2 are compared with differences of their PF0 and PF1.

use assur_group::{Body, Number, Order};
use assur_kinematics::{Chain, Position};
use assur_number::Dd;

use crate::elements::Element;
use crate::kinetics::{self, ROUNDINGS};
use crate::numbers::{LEVELS, Numbers, Quotient, SAFETY, SAMPLES, SPACING, numbers, quotients, rounding_of};
use crate::perturbation::{Perturbation, TRIALS};
use crate::subject::{Solved, Subject};

/// First step, as part of the length over which the motion changes markedly.
const FIRST_STEP: f64 = 0.1;

/// Lower bound of that length, as part of the square of the determinant: the assembly modes that meet at the limit of
/// an assembly interval do so at a distance in proportion to the square, and no motion changes on a much shorter
/// length.
const LEAST_BEND: f64 = 1e-3;

/// Most halvings of the first step; beyond, even 32 digits leave none.
const LEAST_STEP: f64 = 1.0 / ((1_u64 << 40) as f64);

/// A number type in which differences are taken.
pub(crate) trait Precision: Number {
    /// Part of its size by which a datum is perturbed: large against the rounding of this type, small enough for the
    /// effect to be linear.
    const PERTURBED: f64;
    /// Number of steps of the differences, each half of the one before.
    const STEPS: usize;
}

impl Precision for f64 {
    const PERTURBED: f64 = 1.0 / ((1_u64 << 26) as f64);
    // Five steps from a tenth leave a truncation of 1e-15; smaller steps only magnify the rounding.
    const STEPS: usize = 5;
}

impl Precision for Dd {
    const PERTURBED: f64 = f64::EPSILON;
    const STEPS: usize = LEVELS;
}

/// Differences around one position.
#[derive(Debug, Clone)]
pub(crate) struct Surroundings {
    pub(crate) quotients: Vec<Quotient>,
    /// Rounding of the numbers that were differenced.
    pub(crate) below: Numbers<f64>,
    /// Rounding of the numbers that are checked.
    pub(crate) own: Numbers<f64>,
    /// Factor from the rounding unit of f64 to the least rounding of the differenced numbers.
    pub(crate) floor: f64,
    /// The numbers of the position as the differences see it; only their sizes are used.
    pub(crate) values: Numbers<f64>,
}

/// The chain in one number type, as it is and with perturbed lengths.
pub(crate) struct Differences<'a, T: Number> {
    subject: &'a Subject<'a>,
    chain: Chain<T>,
    perturbation: Perturbation,
    /// The chain with perturbed lengths, for each trial.
    perturbed: Vec<Chain<T>>,
}

impl<'a, T: Precision> Differences<'a, T> {
    /// `None` where a kernel can't be built in this number type.
    pub(crate) fn of(subject: &'a Subject<'a>) -> Option<Self> {
        let linkage = subject.linkage;
        let chain = Chain::compile(&linkage.mechanism, &linkage.structure).ok()?;
        let mut perturbation = Perturbation::new(linkage, T::PERTURBED);
        let trial = |trial| {
            perturbation.begin(trial);
            Chain::compile(&linkage.mechanism, &perturbation.lengths(&linkage.structure)).ok()
        };
        let perturbed = (0..TRIALS).map(trial).collect::<Option<Vec<_>>>()?;
        Some(Self { subject, chain, perturbation, perturbed })
    }

    /// Differences around a position and the rounding there; `None` where too few steps can be solved on both sides.
    pub(crate) fn around(&mut self, all: &[Element], one: &Solved) -> Option<Surroundings> {
        let coordinate = one.position.coordinate;
        for chain in self.perturbed.iter_mut().chain([&mut self.chain]) {
            chain.continue_laws(&self.subject.linkage.mechanism, coordinate);
        }
        let q = T::from_f64(coordinate);
        let start: Vec<_> = one.position.bodies.iter().map(|body| body.map(T::from_f64)).collect();
        // The steps are far smaller than the distance to a change point, where the assembly mode could change.
        let ways = self.subject.linkage.ways.at(coordinate);
        let center = self.solve((q, Order::Second), ways, &start)?;
        let middle = self.numbers(all, q, [&center, &center]);
        let first = FIRST_STEP * self.bend(&center, one.health);
        let at = |q: T| {
            let bodies = self.solve((q, Order::First), ways, &center)?;
            Some(self.numbers(all, q, [&bodies, &center]))
        };
        let quotients = quotients([first, LEAST_STEP * first], T::STEPS, |step| {
            let (low, high) = (q - T::from_f64(step), q + T::from_f64(step));
            // The step as it is after rounding.
            Some(at(low)?.quotient(&at(high)?, (high - low).half().to_f64()))
        })?;
        let mut own = middle.map(|_| 0.0);
        for trial in 0..TRIALS {
            self.perturbation.begin(trial);
            let perturbed = self.solve_perturbed(trial, q, ways, &center)?;
            own.raise(&self.numbers(all, q, [&perturbed, &center]).off(&middle));
        }
        let own = own.scaled(ROUNDINGS / SAFETY * f64::EPSILON / T::PERTURBED);
        let floor = T::EPSILON / f64::EPSILON;
        Some(Surroundings { quotients, below: own.scaled(floor), own, floor, values: middle.map(T::to_f64) })
    }

    /// The length, in the coordinate, over which the motion changes markedly: the least ratio of PF1 to PF2 over all
    /// links. Near a pole of the motion and near a limit of an assembly interval this is the distance to it, within a
    /// factor of about 2.
    fn bend(&self, bodies: &[Body<T>], health: f64) -> f64 {
        let scale = self.subject.linkage.structure.scale;
        let ratio = |body: &Body<T>| {
            let [x1, y1, w1, x2, y2, w2] =
                [body.x1, body.y1, body.w1, body.x2, body.y2, body.w2].map(|number| number.to_f64().abs());
            let second = (x2 + y2) / scale + w2 + w1 * w1;
            if second > 0.0 { ((x1 + y1) / scale + w1) / second } else { f64::INFINITY }
        };
        let unit = self.subject.linkage.coordinate_unit();
        let least = bodies.iter().skip(1).map(ratio).fold(health * unit, f64::min);
        least.max(LEAST_BEND * health * health * unit)
    }

    /// All bodies at a coordinate; `start`: starting values for kinds that iterate.
    fn solve(&self, (q, order): (T, Order), ways: &[u8], start: &[Body<T>]) -> Option<Vec<Body<T>>> {
        let mut bodies = start.to_vec();
        let mut health = vec![T::ZERO; self.chain.groups.len()];
        self.chain.solve(q, ways, order, &mut bodies, &mut health).ok()?;
        Some(bodies)
    }

    /// All bodies with perturbed data: the lengths, and each body as soon as it is solved.
    fn solve_perturbed(&mut self, trial: u64, q: T, ways: &[u8], start: &[Body<T>]) -> Option<Vec<Body<T>>> {
        let Self { perturbation, perturbed, subject, .. } = self;
        let chain = &perturbed[usize::try_from(trial).ok()?];
        let mut bodies = start.to_vec();
        let q = if subject.linkage.kind().is_time() { perturbation.time(q) } else { q };
        chain.set_input(q, &mut bodies);
        for input in subject.linkage.mechanism.input.placed() {
            perturbation.link(&mut bodies[input], input);
        }
        for (kernel, way) in chain.groups.iter().zip(ways) {
            bodies[0] = Body::ground();
            perturbation.ground(&mut bodies[0]);
            kernel.solve(&mut bodies, usize::from(*way), Order::Second).ok()?;
            for &link in &kernel.frame().links {
                perturbation.link(&mut bodies[link], link);
            }
        }
        bodies[0] = Body::ground();
        perturbation.ground(&mut bodies[0]);
        chain.hang(&mut bodies, Order::Second);
        for &link in subject.linkage.structure.passive.iter().flat_map(|passive| &passive.frame.links) {
            perturbation.link(&mut bodies[link], link);
        }
        bodies[0] = Body::ground();
        Some(bodies)
    }

    fn numbers(&self, all: &[Element], q: T, [bodies, reference]: [&[Body<T>]; 2]) -> Numbers<T> {
        let mechanism = &self.subject.linkage.mechanism;
        let motions = all.iter().map(|element| element.motion_of(mechanism, bodies, reference));
        Numbers::new(motions, kinetics::reduced(mechanism, q, bodies))
    }
}

/// First step of the differences in 16 digits, in units of the coordinate, at a position of determinant 1. The smaller
/// the determinant, the faster the functions change; the step shrinks with it, down to a hundredth.
const WIDE_STEP: f64 = 0.2;

/// Least initial step, as part of the first step.
const LEAST_PART: f64 = 0.01;

/// With steps below this, differences in 16 digits have no correct digits.
const LEAST_WIDE_STEP: f64 = 1e-7;

/// Where the rounding is measured around a position, in units of the coordinate: at the position itself, and on both
/// sides just outside the interpolation across a change point, whose innermost nodes have the greatest weight.
const PLACES: [f64; 3] = [0.0, 0.013, -0.013];

/// Differences by the calculated motion itself: across a change point it is smooth, and steps may be wide. `None` where too few of them can be solved on both sides.
pub(crate) fn interpolated(
    subject: &Subject<'_>,
    all: &[Element],
    one: &Solved,
    scratch: &mut Position,
) -> Option<Surroundings> {
    let linkage = subject.linkage;
    let (q, unit) = (one.position.coordinate, linkage.coordinate_unit());
    let mut at = |coordinate: f64| {
        linkage.solve(coordinate, Order::Second, scratch).ok()?;
        Some(numbers(linkage, all, scratch, &one.position))
    };
    let steps = [WIDE_STEP * one.health.max(LEAST_PART) * unit, LEAST_WIDE_STEP * unit];
    let quotients = quotients(steps, LEVELS, |step| {
        // The step is rounded so that q + h and q - h are exact.
        let (low, high) = (q - step, q + step);
        Some(at(low)?.quotient(&at(high)?, 0.5 * (high - low)))
    })?;
    let values = numbers(linkage, all, &one.position, &one.position);
    let change_point = linkage.nearest_change_point(q).filter(|_| subject.is_interpolated(one));
    let interpolation = change_point.and_then(|at| linkage.interpolation(at));
    let gain = interpolation.map_or(1.0, |interpolation| interpolation.gain);
    let below = measured(&values, q, unit, &mut at).scaled(gain);
    Some(Surroundings { quotients, own: below.clone(), below, floor: gain, values })
}

/// The greatest rounding measured at closely spaced coordinates around a position.
fn measured(
    like: &Numbers<f64>,
    q: f64,
    unit: f64,
    at: &mut impl FnMut(f64) -> Option<Numbers<f64>>,
) -> Numbers<f64> {
    let mut most = like.scaled(0.0);
    for shift in PLACES {
        let middle = 0.5 * (SAMPLES as f64 - 1.0);
        let places = (0..SAMPLES).map(|i| q + (shift + SPACING * (i as f64 - middle)) * unit);
        let Some(run) = places.map(&mut *at).collect::<Option<Vec<_>>>() else { continue };
        let number = |k: usize| rounding_of(&std::array::from_fn(|i| run[i].0[k]));
        most.raise(&Numbers((0..like.0.len()).map(number).collect()));
    }
    most
}
