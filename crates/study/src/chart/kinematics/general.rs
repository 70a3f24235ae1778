//! The general solution: derivatives from the one linear system of a group, and places by Newton's method.

use assur_group::{Body, Number, Order, derive_generally, place_by_newton};
use assur_kinematics::{Chain, ChainError};

use super::failure;
use crate::chart::ChartError;
use crate::chart::work::Work;

/// Distance before a position at which Newton's method begins, rad or parts of the scale: as in following a mechanism
/// in some 300 steps per turn.
const BACK: f64 = 0.02;

/// The source of the positions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Places {
    /// Closed forms.
    Closed,
    /// Newton's method on the constraints.
    Newton,
}

/// The general solution in one number type, as a method over all positions.
pub(super) fn general<'a, T: Number>(
    work: &'a Work<'a>,
    places: Places,
) -> Result<impl FnMut(usize, bool) -> Result<f64, String> + 'a, ChartError> {
    let chain = Chain::<T>::compile(&work.linkage.mechanism, &work.linkage.structure)?;
    let starts: Vec<_> = work.coordinates.iter().map(|q| start(work, &chain, *q)).collect();
    let mut bodies = chain.bodies();
    Ok(move |index: usize, judged| {
        let q = work.coordinates[index];
        let starts = (places == Places::Newton).then(|| &starts[index][..]);
        let solved = solve(work, &chain, q, starts, &mut bodies);
        solved.map_err(|error| failure(work.linkage, q, &error))?;
        Ok(if judged { work.deviation(index, &bodies) } else { 0.0 })
    })
}

/// All bodies at a coordinate, placed by Newton's method from `starts`, if there are any, or by the closed forms.
fn solve<T: Number>(
    work: &Work<'_>,
    chain: &Chain<T>,
    q: f64,
    starts: Option<&[Body<T>]>,
    bodies: &mut [Body<T>],
) -> Result<(), ChainError> {
    let ways = work.linkage.ways.at(q);
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

/// The bodies a little before a position, in the number type of the chain.
fn start<T: Number>(work: &Work<'_>, chain: &Chain<T>, q: f64) -> Vec<Body<T>> {
    let linkage = work.linkage;
    let unit = linkage.coordinate_unit();
    let mut position = linkage.position();
    // At the end of the range there is no position before; the one beyond is used instead.
    let solved = [-BACK, BACK, 0.0]
        .iter()
        .any(|back| linkage.solve(q + back * unit, Order::Place, &mut position).is_ok());
    let mut bodies = chain.bodies();
    if solved {
        for (to, from) in bodies.iter_mut().zip(&position.bodies) {
            (to.x, to.y) = (T::from_f64(from.x), T::from_f64(from.y));
            (to.c, to.s) = (T::from_f64(from.c), T::from_f64(from.s));
        }
    }
    bodies
}
