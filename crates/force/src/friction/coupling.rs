//! Which groups have to be solved together.
//!
//! Stage 0 is the input links with the drives of all driven pairs; stage g + 1 is the group g. A stage depends on those whose reactions load its links, and on those
//! whose reactions give the friction on its links. What depends on each other is one block.

use std::cmp::Reverse;

use assur_mechanism::Input;
use assur_number::components;
use assur_structure::Structure;

use super::{Bearing, Unknown};

/// Stages that are solved together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// The stages, the last first: 0 is that of the drive, others are groups plus 1.
    pub stages: Vec<usize>,
    /// Indices of the unknowns of friction that are found with it.
    pub unknowns: Vec<usize>,
    /// Of these, the first of each bearing.
    pub firsts: Vec<usize>,
}

impl Block {
    /// The groups of the block, in solving order of the forces.
    pub fn groups(&self) -> impl Iterator<Item = usize> {
        self.stages.iter().filter_map(|stage| stage.checked_sub(1))
    }

    fn of(stages: impl Iterator<Item = usize>) -> Self {
        Self { stages: stages.collect(), unknowns: Vec::new(), firsts: Vec::new() }
    }

    /// The blocks of a mechanism in solving order, and the whole of it as one.
    pub(crate) fn all(
        structure: &Structure,
        input: &Input,
        bearings: &[Bearing],
        unknowns: &[Unknown],
    ) -> (Vec<Self>, Self) {
        let stages = Stages::of(structure, input);
        let count = structure.groups.len() + 1;
        let mut needs = vec![Vec::new(); count];
        for pair in &structure.pairs {
            let own = stages.of_pair[pair.pair.id];
            for loaded in [pair.pair.a, pair.pair.b].into_iter().filter_map(|link| stages.of_link[link]) {
                needs[loaded].push(own);
            }
        }
        for (driver, driven) in input.drivers.iter().zip(&structure.pairs) {
            if driver.is_relative() {
                // The load of the drive follows from the reaction of its pair.
                needs[0].push(stages.of_pair[driven.pair.id]);
            }
        }
        for unknown in unknowns {
            let bearing = &bearings[unknown.bearing];
            for acted in [bearing.link, bearing.on].into_iter().filter_map(|link| stages.of_link[link]) {
                needs[acted].extend(unknown.pairs.iter().map(|(pair, _)| stages.of_pair[*pair]));
            }
        }
        // The last stages first: their loads are those of no other stage.
        let blocks = components(&needs, |stages| Reverse(stages.last().copied()));
        let mut blocks: Vec<Self> =
            blocks.into_iter().map(|stages| Self::of(stages.into_iter().rev())).collect();
        let place =
            |stage: usize, blocks: &[Self]| blocks.iter().position(|block| block.stages.contains(&stage));
        for (index, unknown) in unknowns.iter().enumerate() {
            let last =
                unknown.pairs.iter().filter_map(|(pair, _)| place(stages.of_pair[*pair], &blocks)).max();
            if let Some(block) = last.and_then(|last| blocks.get_mut(last)) {
                block.unknowns.push(index);
            }
        }
        let mut whole = Self { unknowns: (0..unknowns.len()).collect(), ..Self::of((0..count).rev()) };
        for block in blocks.iter_mut().chain([&mut whole]) {
            block.firsts.clone_from(&block.unknowns);
            block.firsts.dedup_by_key(|unknown| unknowns[*unknown].bearing);
        }
        (blocks, whole)
    }
}

struct Stages {
    of_link: Vec<Option<usize>>,
    of_pair: Vec<usize>,
}

impl Stages {
    fn of(structure: &Structure, input: &Input) -> Self {
        let mut found =
            Self { of_link: vec![None; structure.links], of_pair: vec![0; structure.pairs.len()] };
        input.placed().for_each(|link| found.of_link[link] = Some(0));
        for (group, one) in structure.groups.iter().enumerate() {
            one.frame.links.iter().for_each(|link| found.of_link[*link] = Some(group + 1));
            one.frame.pairs().for_each(|pair| found.of_pair[pair.id] = group + 1);
        }
        found
    }
}
