//! The common work of all methods of transfer functions and forces: the scene's positions, and their reference.

use std::fmt::Write;

use assur_group::{Body, Order, derive_generally, place_by_newton};
use assur_kinematics::{Chain, Linkage};
use assur_number::{Dd, Real};

use super::ruler::{Ruler, greater};
use super::{ChartError, Reference};

/// Positions nearer to a change point than this, in rad or in parts of the scale, are left to the study of stability:
/// the equations of a group are undetermined there.
const NEAR_CHANGE: f64 = 0.02;

/// Of more positions so many are taken, equally spaced: ten for each degree of a turn. Their references are kept.
const MOST_POSITIONS: usize = 3600;

/// The positions with their reference.
pub(crate) struct Work<'a> {
    pub(crate) linkage: &'a Linkage,
    /// Coordinates, rad or m.
    pub(crate) coordinates: Vec<f64>,
    /// The bodies in extended precision, by position.
    pub(crate) truth: Vec<Vec<Body<Dd>>>,
    pub(crate) ruler: Ruler,
    pub(crate) reference: Reference,
    /// The chain in extended precision.
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
            reference: Reference { how: String::new(), error: 0.0 },
            extended,
        };
        work.reference = work.described(left);
        Ok(work)
    }

    /// Greatest deviation between the closed forms and Newton's method, both in extended precision.
    fn described(&self, left: usize) -> Reference {
        let mut error = 0.0;
        let mut missing = 0;
        for truth in &self.truth {
            match newton_from(&self.extended, self.linkage.mechanism.input.link, truth) {
                Some(bodies) => {
                    error = greater(error, self.ruler.deviation(truth, &bodies));
                }
                None => missing += 1,
            }
        }
        let mut how = format!(
            "closed forms in double-double arithmetic (about 32 digits) at {} positions; own error by Newton's method and the \
             general derivatives in the same arithmetic",
            self.coordinates.len()
        );
        if left > 0 {
            let _ =
                write!(how, "; {left} positions are left out, next to change points or without an assembly");
        }
        if missing > 0 {
            let _ = write!(how, "; at {missing} positions Newton's method could not confirm it");
        }
        // Rounding of the extended numbers themselves, if both agree in every digit.
        Reference { how, error: greater(error, Dd::EPSILON) }
    }

    /// Largest relative deviation of bodies from those of position `index`.
    pub(crate) fn deviation<T: Real>(&self, index: usize, bodies: &[Body<T>]) -> f64 {
        self.ruler.deviation(&self.truth[index], bodies)
    }
}

/// One position by the closed forms in extended precision.
fn closed(linkage: &Linkage, chain: &Chain<Dd>, q: f64) -> Option<Vec<Body<Dd>>> {
    let mut bodies = linkage.starting_bodies(q);
    let mut health = vec![Dd::ZERO; chain.groups.len()];
    let ways = linkage.ways.at(q);
    chain.solve(Dd::from_f64(q), ways, Order::Second, &mut bodies, &mut health).ok()?;
    bodies.iter().all(|body| body.numbers().iter().all(|x| x.hi.is_finite())).then_some(bodies)
}

/// One position by Newton's method in extended precision, from rounded positions, so that it has a correction to find.
fn newton_from(chain: &Chain<Dd>, input: usize, truth: &[Body<Dd>]) -> Option<Vec<Body<Dd>>> {
    let mut bodies: Vec<Body<Dd>> = truth.iter().map(rounded).collect();
    bodies[input] = truth[input];
    for group in &chain.groups {
        place_by_newton(group.frame(), &mut bodies).ok()?;
        derive_generally(group.frame(), &mut bodies, Order::Second).ok()?;
    }
    Some(bodies)
}

/// Rounds the pose to single precision, without derivatives.
fn rounded(body: &Body<Dd>) -> Body<Dd> {
    let single = |x: Dd| Dd::from_f64(f32::from_f64(x.to_f64()).to_f64());
    Body { x: single(body.x), y: single(body.y), c: single(body.c), s: single(body.s), ..Body::ground() }
}
