//! The general solution: derivatives from the one linear system of a group, and places by Newton's method.

use std::hint::black_box;

use assur_group::{Body, Number, Order};
use assur_kinematics::Chain;
use assur_number::Lanes;
use assur_words::{Describe, Text};

use super::{failure, kept};
use crate::chart::race::{Entry, Verdict};
use crate::chart::work::{Work, solve_generally};
use crate::chart::{ChartError, Measurement};

/// Distance before a position at which Newton's method begins, rad or parts of the scale: as in following a mechanism
/// in some 300 steps per turn.
const BACK: f64 = 0.02;

/// The general solution in one number type, as a method over all positions; `by_newton`: the places by Newton's method on the
/// constraints, otherwise by the closed forms.
pub(super) fn general<'a, T: Number>(
    work: &'a Work<'a>,
    by_newton: bool,
) -> Result<impl FnMut(usize, bool) -> Result<f64, Text> + 'a, ChartError> {
    let chain = Chain::<T>::compile(&work.linkage.mechanism, &work.linkage.structure)?;
    let starts: Vec<_> = work.coordinates.iter().map(|q| start(work, &chain, *q)).collect();
    let mut bodies = chain.bodies();
    let kept = if by_newton { None } else { kept(work) };
    Ok(move |index: usize, judged| {
        let q = work.coordinates[index];
        if let Some(kept) = &kept {
            bodies.clone_from_slice(&kept[index]);
        }
        let starts = by_newton.then(|| &starts[index][..]);
        let solved = solve_generally(work.linkage, &chain, q, starts, &mut bodies);
        solved.map_err(|error| failure(work.linkage, q, &error))?;
        Ok(if judged { work.deviation(index, &bodies) } else { 0.0 })
    })
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

/// The closed forms over all positions, block by block; the last block repeats the last position.
pub(super) fn entry<'a>(work: &'a Work<'a>, row: Measurement) -> Entry<'a> {
    let (linkage, coordinates) = (work.linkage, &work.coordinates);
    let (mut block, mut position) = (linkage.lane_position(), linkage.position());
    let groups = linkage.groups().len() as u64;
    let run = move |judged: bool| {
        let mut errors = vec![Ok(0.0); if judged { coordinates.len() } else { 0 }];
        for (index, eight) in coordinates.chunks(Lanes::WIDTH).enumerate() {
            let lanes = Lanes::of(|lane| eight[lane.min(eight.len() - 1)]);
            let solved = linkage.solve_lanes(lanes, Order::Second, &mut block);
            for (lane, error) in errors.iter_mut().skip(index * Lanes::WIDTH).take(Lanes::WIDTH).enumerate() {
                block.copy_lane(lane, &mut position);
                *error = Ok(work.deviation(index * Lanes::WIDTH + lane, &position.bodies));
            }
            for (lane, failure) in solved.err().unwrap_or_default() {
                if let Some(error) = errors.get_mut(index * Lanes::WIDTH + lane) {
                    *error = Err(failure.describe());
                }
            }
            black_box(&block);
        }
        Verdict::of_positions(groups, errors.into_iter())
    };
    Entry { units: coordinates.len() as f64, ..Entry::run(row, run) }
}
