//! The common work of all methods of transfer functions and forces: the scene's positions, and their reference.

use assur_group::{Body, Number, Order, derive_generally, place_by_newton};
use assur_kinematics::{Chain, ChainError, Linkage};
use assur_number::{Dd, Real, greater};
use assur_words::{Text, joined, number, text};

use super::race::{Entry, Verdict};
use super::{ChartError, Measurement, Reference};

/// Positions nearer to a change point than this, in rad or in parts of the scale, are left to the study of stability:
/// the equations of a group are undetermined there.
const NEAR_CHANGE: f64 = 0.02;

/// Most positions that are compared, ten for each degree of a turn; of more, this many are taken, equally spaced. Their
/// references are kept.
const MOST_POSITIONS: usize = 3600;

pub(crate) struct Work<'a> {
    pub(crate) linkage: &'a Linkage,
    /// Coordinates, rad or m.
    pub(crate) coordinates: Vec<f64>,
    pub(crate) truth: Vec<Vec<Body<Dd>>>,
    pub(crate) ruler: Ruler,
    pub(crate) reference: Reference,
    pub(crate) extended: Chain<Dd>,
}

impl<'a> Work<'a> {
    /// Solves the positions of the scene in extended precision by the closed forms, and again by Newton's method.
    pub(crate) fn new(linkage: &'a Linkage) -> Result<Self, ChartError> {
        let extended = Chain::<Dd>::compile(&linkage.mechanism, &linkage.structure)?;
        let input = &linkage.mechanism.input;
        let count = input.positions.min(MOST_POSITIONS);
        let spread = (0..count).map(|i| input.coordinate(i * input.positions / count));
        let mut position = linkage.position();
        let near = NEAR_CHANGE * linkage.coordinate_unit();
        let apart = spread.filter(|q| !linkage.is_near_change_point(*q, near));
        let solved = apart.filter(|q| linkage.solve(*q, Order::Second, &mut position).is_ok());
        let coordinates: Vec<f64> = solved.collect();
        if coordinates.is_empty() {
            linkage.solve_index(0, Order::Second, &mut linkage.position())?;
            return Err(ChartError::OnlyChangePoints);
        }
        let mut truth = Vec::with_capacity(coordinates.len());
        for q in &coordinates {
            truth.push(closed(linkage, &extended, *q).ok_or(ChartError::NoReference { coordinate: *q })?);
        }
        let ruler = Ruler::new(truth.iter().map(Vec::as_slice), linkage.structure.scale);
        let left = count - coordinates.len();
        let mut work = Self {
            linkage,
            coordinates,
            truth,
            ruler,
            reference: Reference { how: Text::default(), error: 0.0 },
            extended,
        };
        work.reference = work.described(left);
        Ok(work)
    }

    /// Greatest deviation between the closed forms and Newton's method, both in extended precision.
    fn described(&self, left: usize) -> Reference {
        let mut error = 0.0;
        let mut missing = 0;
        for (q, truth) in self.coordinates.iter().zip(&self.truth) {
            // From rounded positions, so that Newton's method has a correction to find.
            let starts: Vec<Body<Dd>> = truth.iter().map(rounded).collect();
            let mut bodies = starts.clone();
            match solve_generally(self.linkage, &self.extended, *q, Some(&starts), &mut bodies) {
                Ok(()) => error = greater(error, self.ruler.deviation(truth, &bodies)),
                Err(_) => missing += 1,
            }
        }
        let mut how = vec![text!("chart-reference-positions", count = number(self.coordinates.len()))];
        if left > 0 {
            how.push(text!("chart-reference-left-out", count = number(left)));
        }
        if missing > 0 {
            how.push(text!("chart-reference-unconfirmed", count = number(missing)));
        }
        // Rounding of the extended numbers themselves, if both agree in every digit.
        Reference { how: joined("; ", how), error: greater(error, Dd::EPSILON) }
    }

    /// A method over all positions, with the number of solutions of the whole mechanism in each. `solve` receives the
    /// index of a position and whether its error is needed.
    pub(crate) fn entry<'e>(
        &self,
        row: Measurement,
        times: usize,
        mut solve: impl FnMut(usize, bool) -> Result<f64, Text> + 'e,
    ) -> Entry<'e> {
        let (count, solutions) = (self.coordinates.len(), self.linkage.groups().len() * times);
        let run = move |judged: bool| {
            let errors = (0..count).map(|index| std::hint::black_box(solve(index, judged)));
            Verdict::of_positions(solutions as u64, errors)
        };
        Entry { units: count as f64, ..Entry::run(row, run) }
    }

    /// Largest relative deviation of bodies from those of position `index`.
    pub(crate) fn deviation<T: Real>(&self, index: usize, bodies: &[Body<T>]) -> f64 {
        self.ruler.deviation(&self.truth[index], bodies)
    }
}

/// One position by the closed forms in extended precision; `None` where they have no finite solution.
pub(crate) fn closed(linkage: &Linkage, chain: &Chain<Dd>, q: f64) -> Option<Vec<Body<Dd>>> {
    let mut bodies = linkage.starting_bodies(q);
    let mut health = vec![Dd::ZERO; chain.groups.len()];
    let ways = linkage.ways.at(q);
    chain.solve(Dd::from_f64(q), ways, Order::Second, &mut bodies, &mut health).ok()?;
    bodies.iter().all(|body| body.numbers().iter().all(|x| x.hi.is_finite())).then_some(bodies)
}

/// All bodies at a coordinate, placed by Newton's method from `starts`, if there are any, or by the closed forms; their
/// derivatives by the general linear system.
pub(crate) fn solve_generally<T: Number>(
    linkage: &Linkage,
    chain: &Chain<T>,
    q: f64,
    starts: Option<&[Body<T>]>,
    bodies: &mut [Body<T>],
) -> Result<(), ChainError> {
    let ways = linkage.ways.at(q);
    chain.set_input(T::from_f64(q), bodies);
    for (group, kernel) in chain.groups.iter().enumerate() {
        let frame = kernel.frame();
        let placed = if let Some(starts) = starts {
            for link in &frame.links {
                bodies[*link] = starts[*link];
            }
            place_by_newton(frame, bodies)
        } else {
            kernel.place(bodies, usize::from(ways[group]))
        };
        let solved = placed.and_then(|_| derive_generally(frame, bodies, Order::Second));
        solved.map_err(|source| ChainError { group, source })?;
    }
    Ok(())
}

/// Rounds the pose to single precision, without derivatives.
fn rounded(body: &Body<Dd>) -> Body<Dd> {
    let single = |x: Dd| Dd::from_f64(f32::from_f64(x.to_f64()).to_f64());
    Body { x: single(body.x), y: single(body.y), c: single(body.c), s: single(body.s), ..Body::ground() }
}

/// For each number of a body, the quantity to which it belongs: position, direction, PF1 and PF2 of the origin, PF1 and
/// PF2 of the angle.
const QUANTITY: [usize; 10] = [0, 0, 1, 1, 2, 2, 3, 4, 4, 5];

/// A quantity below this part of its natural size counts as zero.
const NOTHING: f64 = 1e-12;

/// Sizes of the quantities of all links over the work.
#[derive(Debug, Clone)]
pub(crate) struct Ruler {
    sizes: [f64; 6],
}

impl Ruler {
    /// From the reference: the largest value of each quantity, or its natural size (PF1 of a link, its square) where it is
    /// zero throughout, as PF2 of a parallelogram's rockers; lengths are measured by a length typical of the mechanism.
    pub(crate) fn new<'a>(positions: impl Iterator<Item = &'a [Body<Dd>]>, scale: f64) -> Self {
        let mut sizes: [f64; 6] = [scale, 1.0, 0.0, 0.0, 0.0, 0.0];
        for body in positions.flatten() {
            let all = body.numbers();
            for (value, quantity) in all.into_iter().zip(QUANTITY).skip(4) {
                sizes[quantity] = sizes[quantity].max(value.to_f64().abs());
            }
        }
        let [_, _, first, turn, _, _] = sizes;
        let natural = [scale, 1.0, scale * turn, 1.0, (first * turn).max(scale * turn * turn), turn * turn];
        for (size, natural) in sizes.iter_mut().zip(natural) {
            // A quantity that is zero everywhere has only the size of its rounding.
            if *size <= NOTHING * natural {
                *size = natural;
            }
            if *size == 0.0 {
                *size = 1.0;
            }
        }
        Self { sizes }
    }

    /// Largest relative deviation of one position; NaN if a number is NaN.
    pub(crate) fn deviation<T: Real>(&self, reference: &[Body<Dd>], found: &[Body<T>]) -> f64 {
        let mut worst = 0.0;
        for (right, found) in reference.iter().zip(found) {
            for ((a, b), quantity) in right.numbers().into_iter().zip(found.numbers()).zip(QUANTITY) {
                worst = greater(worst, difference(b, a).abs() / self.sizes[quantity]);
            }
        }
        worst
    }
}

/// A number less its reference, with all digits of both.
pub(crate) fn difference<T: Real>(found: T, reference: Dd) -> f64 {
    let high = found.to_f64();
    let low = (found - T::from_f64(high)).to_f64();
    (Dd::from_f64(high) - reference + Dd::from_f64(low)).to_f64()
}
