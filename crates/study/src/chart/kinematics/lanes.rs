//! The closed forms on four positions at once.

use std::hint::black_box;

use assur_group::{Body, Order};
use assur_kinematics::Chain;
use assur_number::{Dd, F64x4, Lanes, Real};

use super::{failure, groups_of};
use crate::chart::entry::{Contestant, Verdict};
use crate::chart::work::Work;

const WIDTH: usize = 4;

/// Positions of one assembly that are solved together.
struct Batch {
    /// Their indices; the last batch of an assembly repeats its last position.
    indices: [usize; WIDTH],
    coordinates: F64x4,
    ways: Vec<u8>,
}

pub(super) struct InLanes<'a> {
    work: &'a Work<'a>,
    chain: Chain<F64x4>,
    batches: Vec<Batch>,
    bodies: Vec<Body<F64x4>>,
    health: Vec<F64x4>,
}

impl<'a> InLanes<'a> {
    pub(super) fn new(work: &'a Work<'a>, chain: Chain<F64x4>) -> Self {
        let (bodies, health) = (chain.bodies(), vec![F64x4::ZERO; chain.groups.len()]);
        Self { work, chain, batches: batches(work), bodies, health }
    }

    fn solve(&mut self, batch: usize) -> Result<(), String> {
        let Batch { coordinates, ways, .. } = &self.batches[batch];
        self.chain
            .solve(*coordinates, ways, Order::Second, &mut self.bodies, &mut self.health)
            .map_err(|error| failure(self.work.linkage, coordinates.0[0], &error))
    }
}

/// Positions with the same ways of all groups, four by four.
fn batches(work: &Work<'_>) -> Vec<Batch> {
    let ways = |index: usize| work.linkage.ways.at(work.coordinates[index]);
    let mut kinds: Vec<&[u8]> = Vec::new();
    for index in 0..work.len() {
        if !kinds.contains(&ways(index)) {
            kinds.push(ways(index));
        }
    }
    let mut batches = Vec::new();
    for kind in kinds {
        let alike: Vec<usize> = (0..work.len()).filter(|index| ways(*index) == kind).collect();
        for four in alike.chunks(WIDTH) {
            let indices = std::array::from_fn(|lane| four[lane.min(four.len() - 1)]);
            let coordinates = Lanes(indices.map(|index| work.coordinates[index]));
            batches.push(Batch { indices, coordinates, ways: kind.to_vec() });
        }
    }
    batches
}

impl Contestant for InLanes<'_> {
    fn run(&mut self) {
        for batch in 0..self.batches.len() {
            let _ = black_box(self.solve(batch));
        }
    }

    fn judge(&mut self) -> Verdict {
        let work = self.work;
        let mut found: Vec<Result<Vec<[Dd; 10]>, String>> = vec![Ok(Vec::new()); work.len()];
        for batch in 0..self.batches.len() {
            let solved = self.solve(batch);
            for (lane, index) in self.batches[batch].indices.into_iter().enumerate() {
                found[index] = solved.clone().map(|()| lane_of(&self.bodies, lane));
            }
        }
        work.verdict(groups_of(work.linkage), |index, _| found[index].clone())
    }
}

fn lane_of(bodies: &[Body<F64x4>], lane: usize) -> Vec<[Dd; 10]> {
    bodies.iter().map(|body| body.numbers().map(|x| Dd::from_f64(x.0[lane]))).collect()
}
