//! Differences around a position in about 32 digits.
//!
//! The step of a difference must be far smaller than the distance to a singular position; in 16 digits no digits remain
//! with such a step. In double-double, steps of a tenth of that distance and less keep more than 16 digits down to
//! distances of 1e-14, so the differences are known, with their error, wherever the calculated numbers have digits to
//! compare. The chain is solved by the kernels of the program with the other number type; their PF1 and PF2 are
//! compared with differences of their PF0 and PF1.

use assur_group::{Body, Order};
use assur_kinematics::Chain;
use assur_number::{Dd, Real};

use crate::differences::SAFETY;
use crate::elements::Element;
use crate::kinetics;
use crate::perturbation::{Perturbation, TRIALS};
use crate::sample::{Sample, Surroundings, quotients};
use crate::subject::{Solved, Subject};

/// First step, as part of the length over which the motion changes markedly.
const FIRST_STEP: f64 = 0.1;

/// Lower bound of that length, as part of the square of the determinant: the assembly modes that meet at the limit of
/// an assembly interval do so at a distance in proportion to the square, and no motion changes on a much shorter
/// length.
const LEAST_BEND: f64 = 1e-3;

/// Most halvings of the first step; beyond, even 32 digits leave none.
const LEAST_STEP: f64 = 1.0 / ((1_u64 << 40) as f64);

/// Rounding of the calculated numbers, in rounding units times their amplification: as for the closure, some twenty
/// operations in each of two bodies, and the root and the division of the group. Divided by the safety factor of all
/// estimates.
const ROUNDINGS: f64 = 64.0 / SAFETY;

/// The chain in double-double.
pub(crate) struct DoubleDouble<'a> {
    subject: &'a Subject<'a>,
    chain: Chain<Dd>,
    perturbation: Perturbation,
    /// The chain with perturbed lengths, for each trial.
    perturbed: Vec<Chain<Dd>>,
}

impl<'a> DoubleDouble<'a> {
    /// `None` where a kernel can't be built in this number type.
    pub(crate) fn of(subject: &'a Subject<'a>) -> Option<Self> {
        let linkage = subject.linkage;
        let chain = Chain::compile(&linkage.mechanism, &linkage.structure).ok()?;
        let mut perturbation = Perturbation::new(linkage);
        let trial = |trial| {
            perturbation.begin(trial);
            Chain::compile(&linkage.mechanism, &perturbation.lengths(&linkage.structure)).ok()
        };
        let perturbed = (0..TRIALS).map(trial).collect::<Option<Vec<_>>>()?;
        Some(Self { subject, chain, perturbation, perturbed })
    }

    /// Differences around a position and the rounding there; `None` where too few steps can be solved on both sides.
    pub(crate) fn surroundings(&mut self, all: &[Element], one: &Solved) -> Option<Surroundings> {
        let q = one.position.coordinate;
        let start: Vec<_> = one.position.bodies.iter().map(|body| body.map(Dd::from_f64)).collect();
        // The steps are far smaller than the distance to a change point, where the assembly mode could change.
        let ways = self.subject.linkage.ways.at(q);
        let center = self.solve(Dd::from_f64(q), ways, &start)?;
        let middle = self.sample(all, &center, &center);
        let first = FIRST_STEP * self.bend(&center, one.health);
        let at = |shift: f64| {
            let bodies = self.solve(Dd::from_f64(q) + Dd::from_f64(shift), ways, &center)?;
            Some(self.sample(all, &bodies, &center))
        };
        let quotients =
            quotients(first, LEAST_STEP * first, |step| Some(at(-step)?.quotient(&at(step)?, step)))?;
        let mut own = middle.map(|_| 0.0);
        for trial in 0..TRIALS {
            self.perturbation.begin(trial);
            let perturbed = self.solve_perturbed(trial, q, ways, &center)?;
            own.raise(&self.sample(all, &perturbed, &center).off(&middle));
        }
        let own = own.scaled(ROUNDINGS);
        let floor = Dd::EPSILON / f64::EPSILON;
        Some(Surroundings { quotients, below: own.scaled(floor), own, floor, values: middle.map(Dd::to_f64) })
    }

    /// The length, in the coordinate, over which the motion changes markedly: the least ratio of PF1 to PF2 over all
    /// links. Near a pole of the motion and near a limit of an assembly interval this is the distance to it, within a
    /// factor of about 2.
    fn bend(&self, bodies: &[Body<Dd>], health: f64) -> f64 {
        let scale = self.subject.linkage.structure.scale;
        let ratio = |body: &Body<Dd>| {
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
    fn solve(&self, q: Dd, ways: &[u8], start: &[Body<Dd>]) -> Option<Vec<Body<Dd>>> {
        let mut bodies = start.to_vec();
        let mut health = vec![Dd::ZERO; self.chain.groups.len()];
        self.chain.solve(q, ways, Order::Second, &mut bodies, &mut health).ok()?;
        Some(bodies)
    }

    /// All bodies with perturbed data: the lengths, and each body as soon as it is solved.
    fn solve_perturbed(
        &mut self,
        trial: u64,
        q: f64,
        ways: &[u8],
        start: &[Body<Dd>],
    ) -> Option<Vec<Body<Dd>>> {
        let Self { perturbation, perturbed, subject, .. } = self;
        let chain = &perturbed[usize::try_from(trial).ok()?];
        let mut bodies = start.to_vec();
        chain.set_input(Dd::from_f64(q), &mut bodies);
        let input = subject.linkage.mechanism.input.link;
        perturbation.link(&mut bodies[input], input);
        for (kernel, way) in chain.groups.iter().zip(ways) {
            bodies[0] = Body::ground();
            perturbation.ground(&mut bodies[0]);
            kernel.solve(&mut bodies, usize::from(*way), Order::Second).ok()?;
            for &link in &kernel.frame().links {
                perturbation.link(&mut bodies[link], link);
            }
        }
        bodies[0] = Body::ground();
        Some(bodies)
    }

    fn sample(&self, all: &[Element], bodies: &[Body<Dd>], reference: &[Body<Dd>]) -> Sample<Dd> {
        let mechanism = &self.subject.linkage.mechanism;
        let motions = all.iter().map(|element| element.motion_of(mechanism, bodies, reference));
        Sample::new(motions, kinetics::reduced(mechanism, bodies))
    }
}
