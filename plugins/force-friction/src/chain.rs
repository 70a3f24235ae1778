//! The linear part: the reactions of the groups of a block to loads and to the friction of each magnitude of size 1.

use std::ops::Range;

use assur_force::{
    Block, ForceError, FreeMotion, FrictionForces, Frictions, Reactions, UnitBalance, Unknown, UnknownKind,
    Unsolved, drive,
};
use assur_friction::{Moduli, Width};
use assur_group::Wrench;
use assur_kinematics::{Linkage, Position};
use assur_words::{Text, text};

/// A mechanism at a position, with friction in given senses.
#[derive(Clone, Copy)]
pub(crate) struct Chain<'a> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) position: &'a Position,
    pub(crate) frictions: &'a Frictions,
    given: &'a FrictionForces,
    solved: &'a [bool],
    unit: Option<UnitBalance>,
    /// What acts in a motion whose acceleration takes the place of the balancing load.
    free: Option<&'a FreeMotion<'a>>,
    /// The first block with all of its friction, where this is known and the other parts of it follow.
    first: Option<&'a Prepared>,
    /// The part of the coefficients up to which the solution of the first block can be followed, where it is known.
    pub(crate) followed: f64,
}

/// The responses of some stages to several sets of loads on their links, set after set.
#[derive(Debug, Clone)]
pub(crate) struct Responses {
    /// The loads, with those that the stages hand on: one wrench for each body in a set.
    loads: Vec<Wrench<f64>>,
    /// Reactions in the pairs of the stages; in the others those that are known before, or none.
    pairs: Vec<Wrench<f64>>,
    /// Loads of the drive, where the input link is one of the stages; one for each set.
    drives: Vec<f64>,
}

/// A block with its loads: everything linear in the magnitudes.
#[derive(Debug)]
pub(crate) struct Prepared {
    /// The first is that to the loads, without friction.
    pub(crate) all: Responses,
    /// By magnitude, the response to its friction where it has size 1.
    pub(crate) each: Vec<usize>,
    pub(crate) moduli: Moduli,
}

/// A determinant of the linear part below this is zero.
const SINGULAR: f64 = 1e-14;

impl<'a> Chain<'a> {
    /// `None` where all pairs are ideal.
    pub(crate) fn of(linkage: &'a Linkage, position: &'a Position, out: &'a Reactions) -> Option<Self> {
        let friction = out.friction.as_ref()?;
        let (frictions, given) = (friction.frictions.as_ref(), friction);
        let (first, followed) = (None, f64::INFINITY);
        let (solved, unit, free) = (&out.solved[..], out.unit, None);
        Some(Self { linkage, position, frictions, given, solved, unit, free, first, followed })
    }

    /// The chain in a motion whose acceleration is looked for: the drive balances it.
    pub(crate) fn moved_by(self, motion: &'a FreeMotion<'a>) -> Self {
        Self { unit: None, free: Some(motion), ..self }
    }

    /// The chain with its first block known.
    pub(crate) fn knowing(self, first: Option<&'a Prepared>) -> Self {
        Self { first, ..self }
    }

    /// Which of several solutions belongs to the motion, by their balancing loads; `None` where no drive on the input made it.
    pub(crate) fn driven(&self, balancing: impl Iterator<Item = f64>) -> Option<usize> {
        if self.unit.is_none() { self.given.driven(balancing) } else { None }
    }

    /// Whether the acceleration is looked for.
    pub(crate) fn is_free(&self) -> bool {
        self.free.is_some()
    }

    /// What has to be solved together, in solving order.
    pub(crate) fn blocks(&self) -> &[Block] {
        if self.unit.is_none() && self.free.is_none() {
            &self.frictions.blocks
        } else {
            std::slice::from_ref(&self.frictions.whole)
        }
    }

    /// A block in words.
    pub(crate) fn name(&self, block: usize) -> Text {
        let group = self.blocks()[block].groups().next();
        match (self.unit, group) {
            (Some(_), _) => text!("force-friction-balance"),
            (None, None) => text!("force-friction-input"),
            (None, Some(group)) => self.linkage.structure.group_name(&self.linkage.mechanism, group),
        }
    }

    /// Coefficient and sense of an unknown, where all coefficients are taken times `scale`.
    pub(crate) fn factor(&self, unknown: &Unknown, scale: f64) -> f64 {
        scale * self.given.senses[unknown.bearing] * self.frictions.bearings[unknown.bearing].coefficient
    }

    /// The vector of an unknown from the reactions of a response.
    fn vector(&self, unknown: usize, response: usize, all: &Responses) -> [f64; 2] {
        let unknown = &self.frictions.unknowns[unknown];
        let bearing = &self.frictions.bearings[unknown.bearing];
        unknown.vector(bearing, &self.position.bodies, all.pairs(response))
    }

    /// Adds the responses of a block to loads; in place of the reactions stand those in the other blocks.
    fn respond(&self, block: &Block, all: &mut Responses) -> Result<(), ForceError> {
        let (linkage, bodies) = (self.linkage, &self.position.bodies);
        for &stage in &block.stages {
            match stage.checked_sub(1) {
                None => {
                    let Responses { loads, pairs, drives } = &mut *all;
                    let (links, count) = (loads.len() / drives.len(), pairs.len() / drives.len());
                    let sets = loads.chunks(links).zip(pairs.chunks_mut(count));
                    for ((loads, pairs), found) in sets.zip(drives) {
                        *found = drive(linkage, bodies, loads, pairs);
                    }
                }
                Some(group) if self.solved[group] => {
                    let Responses { loads, pairs, drives } = &mut *all;
                    let found = linkage.groups()[group].reactions_under(bodies, loads, pairs, drives.len());
                    found.map_err(|reason| {
                        Unsolved::Group(group, reason).explain(linkage, self.position.coordinate)
                    })?;
                }
                Some(_) => {}
            }
        }
        Ok(())
    }

    /// A block under its loads, with all coefficients times `scale`; `None` where the part of friction that is linear has no
    /// solution.
    pub(crate) fn prepare(
        &self,
        block: &Block,
        (loads, pairs): (&[Wrench<f64>], &[Wrench<f64>]),
        scale: f64,
    ) -> Result<Option<Prepared>, ForceError> {
        let is_first = || self.blocks().first().is_some_and(|first| std::ptr::eq(block, first));
        if let Some(first) = self.first.filter(|_| is_first()) {
            return Ok(Some(first.scaled(scale)));
        }
        let unknowns = &block.unknowns;
        // The last is that to the balancing load, or to the inertia loads of the acceleration.
        let sets = 1 + unknowns.len() + usize::from(self.unit.is_some() || self.free.is_some());
        let mut all = Responses::to(loads, pairs, sets);
        for (index, &unknown) in unknowns.iter().enumerate() {
            let found = &self.frictions.unknowns[unknown];
            let bearing = &self.frictions.bearings[found.bearing];
            let own = all.loads_mut(1 + index);
            found.kind.load(bearing, &self.position.bodies, self.factor(found, scale), own);
        }
        if let Some(unit) = self.unit {
            all.loads_mut(sets - 1)[unit.link] = unit.wrench(&self.position.bodies);
        } else if let Some(motion) = self.free {
            all.loads_mut(sets - 1).copy_from_slice(motion.inertia);
        }
        self.respond(block, &mut all)?;
        if let Some(unit) = self.unit {
            self.balance(&unit, &mut all)?;
        } else if let Some(motion) = self.free {
            accelerate(motion, &mut all);
        }
        let shift = |unknown: usize| self.frictions.unknowns[unknown].kind == UnknownKind::Shift;
        for (index, &unknown) in unknowns.iter().enumerate().filter(|(_, unknown)| shift(**unknown)) {
            let own = all.one(index + 1);
            let left = 1.0 - self.vector(unknown, 0, &own)[0];
            if left.abs() < SINGULAR {
                return Ok(None);
            }
            for response in 0..=unknowns.len() {
                let part = self.vector(unknown, response, &all)[0] / left;
                all.add(response, part, &own);
            }
        }
        let moduli: Vec<(usize, usize)> =
            unknowns.iter().copied().zip(1..).filter(|(unknown, _)| !shift(*unknown)).collect();
        let widths = moduli.iter().map(|(unknown, _)| match self.frictions.unknowns[*unknown].kind {
            UnknownKind::Force => Width::Two,
            _ => Width::One,
        });
        let system = Moduli {
            widths: widths.collect(),
            constants: moduli.iter().map(|(unknown, _)| self.vector(*unknown, 0, &all)).collect(),
            slopes: moduli
                .iter()
                .map(|(unknown, _)| moduli.iter().map(|(_, of)| self.vector(*unknown, *of, &all)).collect())
                .collect(),
        };
        Ok(Some(Prepared { all, each: moduli.into_iter().map(|(_, of)| of).collect(), moduli: system }))
    }

    /// The first block under its loads, where all of its friction is linear in the coefficients.
    pub(crate) fn first(&self, loads: &[Wrench<f64>]) -> Option<Prepared> {
        let (block, pairs) = (self.blocks().first()?, vec![Wrench::ZERO; self.linkage.structure.pairs.len()]);
        let prepared = self.prepare(block, (loads, &pairs), 1.0).ok()??;
        (prepared.each.len() == block.unknowns.len()).then_some(prepared)
    }

    /// Adds to each response that of the balancing load with which the drive is idle, the last; its size replaces that of the drive.
    fn balance(&self, unit: &UnitBalance, all: &mut Responses) -> Result<(), ForceError> {
        let last = all.drives.len() - 1;
        let own = all.one(last);
        for response in 0..last {
            let size = unit.size(all.drives[response], own.drives[0], self.linkage);
            let size = size.map_err(|idle| idle.explain(self.linkage, self.position.coordinate))?;
            all.add(response, size, &own);
            all.drives[response] = size;
        }
        Ok(())
    }
}

/// Adds to each response that of the inertia loads of the acceleration with which the drive gives what is known of it, the last; the
/// acceleration replaces the load of the drive.
fn accelerate(motion: &FreeMotion<'_>, all: &mut Responses) {
    let last = all.drives.len() - 1;
    all.drives[last] += motion.drive_inertia;
    let own = all.one(last);
    // The base moves under the drive, what friction adds without it.
    for response in 0..last {
        let given = if response == 0 { motion.drive } else { 0.0 };
        let acceleration = (given - all.drives[response]) / own.drives[0];
        all.add(response, acceleration, &own);
        all.drives[response] = acceleration;
    }
}

impl Prepared {
    /// With this part of all coefficients.
    fn scaled(&self, part: f64) -> Self {
        let mut all = self.all.clone();
        for &set in &self.each {
            let own = all.one(set);
            all.add(set, part - 1.0, &own);
        }
        Self { all, each: self.each.clone(), moduli: self.moduli.scaled(part) }
    }
}

impl Responses {
    /// To these loads beside these reactions, and to no loads in the other sets.
    fn to(loads: &[Wrench<f64>], pairs: &[Wrench<f64>], sets: usize) -> Self {
        let first = |all: &[Wrench<f64>]| {
            let mut every = vec![Wrench::ZERO; all.len() * sets];
            every[..all.len()].copy_from_slice(all);
            every
        };
        Self { loads: first(loads), pairs: first(pairs), drives: vec![0.0; sets] }
    }

    fn range(all: &[Wrench<f64>], sets: usize, set: usize) -> Range<usize> {
        let count = all.len() / sets;
        set * count..(set + 1) * count
    }

    pub(crate) fn loads(&self, set: usize) -> &[Wrench<f64>] {
        &self.loads[Self::range(&self.loads, self.drives.len(), set)]
    }

    fn loads_mut(&mut self, set: usize) -> &mut [Wrench<f64>] {
        let range = Self::range(&self.loads, self.drives.len(), set);
        &mut self.loads[range]
    }

    pub(crate) fn pairs(&self, set: usize) -> &[Wrench<f64>] {
        &self.pairs[Self::range(&self.pairs, self.drives.len(), set)]
    }

    pub(crate) fn drive(&self, set: usize) -> f64 {
        self.drives[set]
    }

    /// One of the responses.
    pub(crate) fn one(&self, set: usize) -> Self {
        let [loads, pairs] = [self.loads(set), self.pairs(set)].map(<[_]>::to_vec);
        Self { loads, pairs, drives: vec![self.drives[set]] }
    }

    /// Adds a multiple of the only one of other responses to one.
    fn add(&mut self, set: usize, factor: f64, other: &Self) {
        let sets = self.drives.len();
        let [loads, pairs] = [&self.loads, &self.pairs].map(|all| Self::range(all, sets, set));
        add(&mut self.loads[loads], factor, &other.loads);
        add(&mut self.pairs[pairs], factor, &other.pairs);
        self.drives[set] += factor * other.drives[0];
    }
}

/// Adds a multiple of wrenches to others.
pub(crate) fn add(all: &mut [Wrench<f64>], factor: f64, other: &[Wrench<f64>]) {
    for (sum, one) in all.iter_mut().zip(other) {
        sum.fx += factor * one.fx;
        sum.fy += factor * one.fy;
        sum.m += factor * one.m;
    }
}
