//! The surroundings of a position in about 32 digits.
//!
//! The step of a difference must be far smaller than the distance to a singular position, and in 16 digits such a step leaves
//! none. In double-double, steps of a tenth of that distance and less keep more than 16 digits down to distances of 1e-14; so
//! the differences are known, with their error, wherever the calculated numbers have digits to compare. The chain is
//! solved by the same kernels in the other number; what they say of PF1 is compared with differences of their places.

use assur_group::{Body, Order};
use assur_kinematics::{Chain, Linkage};
use assur_number::{Dd, Real};

use crate::around::{Around, Numbers, Quotient};
use crate::differences::LEVELS;
use crate::elements::{Element, Motion};
use crate::kinetics;
use crate::stir::{Stir, TRIALS};
use crate::subject::{Solved, Subject};

/// First step, in parts of the length over which the motion bends.
const FIRST_STEP: f64 = 0.1;

/// Least part of the square of the determinant that is taken for that length: the ways of a group that meet in an end of
/// assembly meet at a distance in proportion to the square, and no motion bends much faster than it could end.
const LEAST_BEND: f64 = 1e-3;

/// Halvings of the step that are tried before a position is given up: beyond, even 32 digits leave none.
const HALVINGS: usize = 40;

/// Levels that an extrapolation needs.
const LEAST_LEVELS: usize = 4;

/// Roundings of the calculated numbers, in rounding units by their amplification: as in the closure some twenty operations
/// in each of two bodies, and the root and the division of the group. In parts of the safety that multiplies all estimates.
const ROUNDINGS: f64 = 64.0 / crate::test_pf::SAFETY;

/// The chain in double-double.
pub(crate) struct Wide<'a> {
    subject: &'a Subject<'a>,
    chain: Chain<Dd>,
    stir: Stir,
    /// The chain with stirred lengths, for each trial.
    stirred: Vec<Chain<Dd>>,
}

/// Numbers of all elements in one position.
struct Sample {
    motions: Vec<[[Dd; 2]; 3]>,
    inertia: [Dd; 2],
}

impl<'a> Wide<'a> {
    /// `None` where a kernel can't be built in this number.
    pub(crate) fn of(subject: &'a Subject<'a>) -> Option<Self> {
        let linkage = subject.linkage;
        let chain = Chain::compile(&linkage.mechanism, &linkage.structure).ok()?;
        let mut stir = Stir::new(linkage);
        let trial = |trial| {
            stir.begin(trial);
            Chain::compile(&linkage.mechanism, &stir.lengths(&linkage.structure)).ok()
        };
        let stirred = (0..TRIALS).map(trial).collect::<Option<Vec<_>>>()?;
        Some(Self { subject, chain, stir, stirred })
    }

    /// Differences around a position and the rounding there; `None` where too few steps can be solved on both sides.
    pub(crate) fn around(&mut self, all: &[Element], one: &Solved) -> Option<Around> {
        let linkage = self.subject.linkage;
        let q = one.position.coordinate;
        let start: Vec<_> = one.position.bodies.iter().map(lifted).collect();
        // The way does not change within the steps: they are far smaller than the distance to where it could.
        let ways = linkage.ways.at(q);
        let center = self.solve(Dd::from_f64(q), ways, &start)?;
        let middle = sample(linkage, all, &center, &center);
        let first = FIRST_STEP * self.bend(&center, one.health);
        let quotients = self.quotients(all, q, ways, &center, first)?;
        let mut own = rounded(&middle, |_| 0.0);
        for trial in 0..TRIALS {
            self.stir.begin(trial);
            let stirred = self.solve_stirred(trial, q, ways, &center)?;
            own.raise(&off(&sample(linkage, all, &stirred, &center), &middle));
        }
        own.scale(ROUNDINGS);
        let mut below = own.clone();
        let floor = Dd::EPSILON / f64::EPSILON;
        below.scale(floor);
        Some(Around { quotients, below, own, floor, values: rounded(&middle, Dd::to_f64) })
    }

    /// The length, in the coordinate, over which the motion bends: of all links the least ratio of PF1 to PF2. Near a pole of
    /// the motion and near an end of assembly this is the distance to it, but for a factor of about 2.
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

    fn quotients(
        &self,
        all: &[Element],
        q: f64,
        ways: &[u8],
        center: &[Body<Dd>],
        first: f64,
    ) -> Option<Vec<Quotient>> {
        let linkage = self.subject.linkage;
        let at = |shift: f64| {
            let bodies = self.solve(Dd::from_f64(q) + Dd::from_f64(shift), ways, center)?;
            Some(sample(linkage, all, &bodies, center))
        };
        let (mut step, mut quotients) = (first, Vec::with_capacity(LEVELS));
        for _ in 0..HALVINGS {
            match (at(-step), at(step)) {
                (Some(low), Some(high)) => quotients.push(quotient(step, &low, &high)),
                _ => quotients.clear(),
            }
            if quotients.len() == LEVELS {
                break;
            }
            step *= 0.5;
        }
        (quotients.len() >= LEAST_LEVELS).then_some(quotients)
    }

    /// All bodies at a coordinate; `start`: for kinds that iterate.
    fn solve(&self, q: Dd, ways: &[u8], start: &[Body<Dd>]) -> Option<Vec<Body<Dd>>> {
        let mut bodies = start.to_vec();
        let mut health = vec![Dd::ZERO; self.chain.groups.len()];
        self.chain.solve(q, ways, Order::Second, &mut bodies, &mut health).ok()?;
        Some(bodies)
    }

    /// The same with everything stirred: the lengths, and each body as soon as it is placed.
    fn solve_stirred(
        &mut self,
        trial: u64,
        q: f64,
        ways: &[u8],
        start: &[Body<Dd>],
    ) -> Option<Vec<Body<Dd>>> {
        let Self { stir, stirred, subject, .. } = self;
        let chain = &stirred[usize::try_from(trial).ok()?];
        let mut bodies = start.to_vec();
        chain.set_input(Dd::from_f64(q), &mut bodies);
        let input = subject.linkage.mechanism.input.link;
        stir.link(&mut bodies[input], input);
        for (kernel, way) in chain.groups.iter().zip(ways) {
            bodies[0] = Body::ground();
            stir.ground(&mut bodies[0]);
            kernel.solve(&mut bodies, usize::from(*way), Order::Second).ok()?;
            for &link in &kernel.frame().links {
                stir.link(&mut bodies[link], link);
            }
        }
        bodies[0] = Body::ground();
        Some(bodies)
    }
}

/// The same numbers in 32 digits.
fn lifted(body: &Body<f64>) -> Body<Dd> {
    let Body { x, y, c, s, x1, y1, w1, x2, y2, w2 } = *body;
    let [x, y, c, s, x1, y1, w1, x2, y2, w2] = [x, y, c, s, x1, y1, w1, x2, y2, w2].map(Dd::from_f64);
    Body { x, y, c, s, x1, y1, w1, x2, y2, w2 }
}

fn sample(linkage: &Linkage, all: &[Element], bodies: &[Body<Dd>], reference: &[Body<Dd>]) -> Sample {
    let motions =
        all.iter().map(|element| element.wide_motion(&linkage.mechanism, bodies, reference)).collect();
    Sample { motions, inertia: kinetics::reduced(&linkage.mechanism, bodies) }
}

fn quotient(step: f64, low: &Sample, high: &Sample) -> Quotient {
    let slope = |high: Dd, low: Dd| (high - low).to_f64() / (2.0 * step);
    let motion = |(low, high): (&[[Dd; 2]; 3], &[[Dd; 2]; 3])| {
        [0, 1].map(|order| [0, 1].map(|k| slope(high[order][k], low[order][k])))
    };
    let motions = low.motions.iter().zip(&high.motions).map(motion).collect();
    Quotient { step, motions, inertia: slope(high.inertia[0], low.inertia[0]) }
}

/// Each number of a sample by a function.
fn rounded(sample: &Sample, number: impl Fn(Dd) -> f64) -> Numbers {
    let motion = |motion: &[[Dd; 2]; 3]| -> Motion { motion.map(|order| order.map(&number)) };
    Numbers { motions: sample.motions.iter().map(motion).collect(), inertia: sample.inertia.map(&number) }
}

/// By how much each number of a sample is off.
fn off(sample: &Sample, exact: &Sample) -> Numbers {
    let off = |a: Dd, b: Dd| (a - b).to_f64().abs();
    let motion = |(a, b): (&[[Dd; 2]; 3], &[[Dd; 2]; 3])| -> Motion {
        [0, 1, 2].map(|order| [0, 1].map(|k| off(a[order][k], b[order][k])))
    };
    let motions = sample.motions.iter().zip(&exact.motions).map(motion).collect();
    Numbers { motions, inertia: [0, 1].map(|k| off(sample.inertia[k], exact.inertia[k])) }
}
