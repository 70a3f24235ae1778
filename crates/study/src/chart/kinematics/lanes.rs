//! The program's own positions, eight at once.

use std::hint::black_box;

use assur_group::Order;
use assur_kinematics::PositionError;
use assur_number::Lanes;

use crate::chart::Row;
use crate::chart::entry::{Entry, Verdict};
use crate::chart::work::Work;

/// The closed forms over all positions, block by block; the last block repeats the last position.
pub(super) fn entry<'a>(work: &'a Work<'a>, row: Row) -> Entry<'a> {
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
                    *error = Err(PositionError::to_string(&failure));
                }
            }
            black_box(&block);
        }
        Verdict::of_positions(groups, errors.into_iter())
    };
    Entry { units: coordinates.len() as f64, ..Entry::run(row, run) }
}
