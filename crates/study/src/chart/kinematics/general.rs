//! The closed forms in several numbers, and the general solution: derivatives from the one linear system of a group, and places
//! by Newton's method.

use std::hint::black_box;

use assur_group::{Body, Number, Order};
use assur_kinematics::Chain;
use assur_number::Lanes;
use assur_words::{Describe, Text, number, text};

use crate::chart::race::{Entry, Verdict};
use crate::chart::work::{Work, solve_generally};
use crate::chart::{ChartError, Measurement};

/// Distance before a position at which Newton's method begins, rad or parts of the scale: as in following a mechanism
/// in some 300 steps per turn.
const BACK: f64 = 0.02;

/// How a position is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum How {
    /// Places and derivatives by the closed forms of the kinds.
    Closed,
    /// Places by the closed forms, derivatives by the linear system.
    General,
    /// Places by Newton's method on the constraints, derivatives by the linear system.
    Newton,
}

/// All positions in one number type.
pub(super) fn solved<'a, T: Number>(
    work: &'a Work<'a>,
    how: How,
) -> Result<impl FnMut(usize, bool) -> Result<f64, Text> + 'a, ChartError> {
    let linkage = work.linkage;
    let chain = Chain::<T>::compile(&linkage.mechanism, &linkage.structure)?;
    let (mut bodies, mut health) = (chain.bodies(), vec![T::ZERO; chain.groups.len()]);
    let by_newton = how == How::Newton;
    // Where groups that iterate begin.
    let iterates = linkage.structure.groups.iter().any(|group| group.plugin.iterates);
    let kept = (iterates && !by_newton)
        .then(|| work.coordinates.iter().map(|&q| linkage.starting_bodies(q)).collect::<Vec<_>>());
    let starts =
        by_newton.then(|| work.coordinates.iter().map(|q| start(work, &chain, *q)).collect::<Vec<_>>());
    Ok(move |index: usize, judged| {
        let q = work.coordinates[index];
        if let Some(kept) = &kept {
            bodies.clone_from_slice(&kept[index]);
        }
        let solved = if how == How::Closed {
            chain.solve(T::from_f64(q), linkage.ways.at(q), Order::Second, &mut bodies, &mut health)
        } else {
            let start = starts.as_ref().map(|starts| &starts[index][..]);
            solve_generally(linkage, &chain, q, start, &mut bodies)
        };
        solved.map_err(|error| {
            let group = linkage.structure.group_name(&linkage.mechanism, error.group);
            let coordinate = number(format_args!("{q:.9}"));
            text!("chart-group-at", group, coordinate, problem = error.source.describe())
        })?;
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
