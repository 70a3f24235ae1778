//! The closed forms on four positions at once.

use std::hint::black_box;

use assur_group::{Body, Order};
use assur_kinematics::Chain;
use assur_number::{F64x4, Lanes, Real};

use super::failure;
use crate::chart::entry::{Entry, Verdict};
use crate::chart::work::Work;
use crate::chart::{ChartError, Row};

const WIDTH: usize = 4;

/// Positions of one assembly that are solved together.
struct Batch<'a> {
    /// Their indices; the last batch of an assembly repeats its last position.
    indices: [usize; WIDTH],
    coordinates: F64x4,
    ways: &'a [u8],
}

/// The closed forms over all positions, four by four.
pub(super) fn entry<'a>(work: &'a Work<'a>, row: Row) -> Result<Entry<'a>, ChartError> {
    let linkage = work.linkage;
    let chain = Chain::<F64x4>::compile(&linkage.mechanism, &linkage.structure)?;
    let (mut bodies, mut health) = (chain.bodies(), vec![F64x4::ZERO; chain.groups.len()]);
    let (batches, count) = (batches(work), work.coordinates.len());
    let groups = linkage.groups().len() as u64;
    let run = move |judged: bool| {
        let mut errors = vec![Ok(0.0); if judged { count } else { 0 }];
        for batch in &batches {
            let solved = chain
                .solve(batch.coordinates, batch.ways, Order::Second, &mut bodies, &mut health)
                .map_err(|error| failure(linkage, batch.coordinates.0[0], &error));
            for (lane, index) in batch.indices.into_iter().enumerate().take(if judged { WIDTH } else { 0 }) {
                errors[index] = solved.clone().map(|()| work.deviation(index, &lane_of(&bodies, lane)));
            }
            black_box(&bodies);
        }
        Verdict::of_positions(groups, errors.into_iter())
    };
    Ok(Entry { units: count as f64, ..Entry::run(row, run) })
}

/// Positions with the same assembly modes of all groups, four by four.
fn batches<'a>(work: &'a Work<'a>) -> Vec<Batch<'a>> {
    let ways = |index: usize| work.linkage.ways.at(work.coordinates[index]);
    let mut kinds: Vec<&[u8]> = (0..work.coordinates.len()).map(ways).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let mut batches = Vec::new();
    for kind in kinds {
        let alike: Vec<usize> = (0..work.coordinates.len()).filter(|index| ways(*index) == kind).collect();
        for four in alike.chunks(WIDTH) {
            let indices = std::array::from_fn(|lane| four[lane.min(four.len() - 1)]);
            let coordinates = Lanes(indices.map(|index| work.coordinates[index]));
            batches.push(Batch { indices, coordinates, ways: kind });
        }
    }
    batches
}

fn lane_of(bodies: &[Body<F64x4>], lane: usize) -> Vec<Body<f64>> {
    bodies.iter().map(|body| body.map(|x| x.0[lane])).collect()
}
