//! The linear part: the reactions of the groups of a block to loads and to the friction of each modulus of size 1.

use assur_force::{
    Block, ForceError, FreeMotion, Frictions, Reactions, UnitBalance, Unknown, UnknownKind, Unsolved,
    input_link,
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
    senses: &'a [f64],
    solved: &'a [bool],
    unit: Option<UnitBalance>,
    /// What acts in a motion whose acceleration takes the place of the balancing load.
    free: Option<&'a FreeMotion<'a>>,
}

/// The response of some stages to loads on their links.
#[derive(Debug, Clone)]
pub(crate) struct Response {
    /// The loads, with those that the stages hand on.
    pub(crate) loads: Vec<Wrench<f64>>,
    /// Reactions in the pairs of the stages; in the others those that are known before, or none.
    pub(crate) pairs: Vec<Wrench<f64>>,
    /// Load of the drive, where the input link is one of the stages.
    pub(crate) drive: f64,
}

/// A block with its loads: everything linear in the moduli.
#[derive(Debug)]
pub(crate) struct Prepared {
    /// The response to the loads, without friction.
    pub(crate) base: Response,
    /// The response to the friction of each modulus of size 1.
    pub(crate) each: Vec<Response>,
    pub(crate) moduli: Moduli,
}

/// A determinant of the linear part below this is zero.
const SINGULAR: f64 = 1e-14;

impl<'a> Chain<'a> {
    /// `None` where all pairs are ideal.
    pub(crate) fn of(linkage: &'a Linkage, position: &'a Position, out: &'a Reactions) -> Option<Self> {
        let friction = out.friction.as_ref()?;
        let (frictions, senses) = (friction.frictions.as_ref(), &friction.senses[..]);
        Some(Self { linkage, position, frictions, senses, solved: &out.solved, unit: out.unit, free: None })
    }

    /// The chain in a motion whose acceleration is looked for: the drive balances it.
    pub(crate) fn moved_by<'b>(&'b self, motion: &'b FreeMotion<'b>) -> Chain<'b> {
        Chain { unit: None, free: Some(motion), ..*self }
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
        scale * self.senses[unknown.bearing] * self.frictions.bearings[unknown.bearing].coefficient
    }

    /// The vector of an unknown from reactions.
    fn vector(&self, unknown: usize, response: &Response) -> [f64; 2] {
        let unknown = &self.frictions.unknowns[unknown];
        unknown.vector(&self.frictions.bearings[unknown.bearing], &self.position.bodies, &response.pairs)
    }

    /// The response of a block to loads; `pairs`: the reactions in the other blocks.
    fn respond(
        &self,
        block: &Block,
        mut loads: Vec<Wrench<f64>>,
        mut pairs: Vec<Wrench<f64>>,
    ) -> Result<Response, ForceError> {
        let (linkage, bodies) = (self.linkage, &self.position.bodies);
        let mut drive = 0.0;
        for &stage in &block.stages {
            match stage.checked_sub(1) {
                None => {
                    let pair = &linkage.structure.pairs[0].pair;
                    (pairs[0], drive) = input_link(pair, linkage.mechanism.input.link, bodies, &loads);
                }
                Some(group) if self.solved[group] => {
                    let found = linkage.groups()[group].reactions(bodies, &mut loads, &mut pairs);
                    found.map_err(|reason| {
                        Unsolved::Group(group, reason).explain(linkage, self.position.coordinate)
                    })?;
                }
                Some(_) => {}
            }
        }
        Ok(Response { loads, pairs, drive })
    }

    /// A block under its loads, with all coefficients times `scale`; `None` where the part of friction that is linear has no
    /// solution.
    pub(crate) fn prepare(
        &self,
        block: &Block,
        (loads, pairs): (&[Wrench<f64>], &[Wrench<f64>]),
        scale: f64,
    ) -> Result<Option<Prepared>, ForceError> {
        let [nothing, no_pairs] = [loads.len(), pairs.len()].map(|count| vec![Wrench::ZERO; count]);
        let mut all = vec![self.respond(block, loads.to_vec(), pairs.to_vec())?];
        for &unknown in &block.unknowns {
            let (mut own, found) = (nothing.clone(), &self.frictions.unknowns[unknown]);
            let factor = self.factor(found, scale);
            found.kind.load(&self.frictions.bearings[found.bearing], &self.position.bodies, factor, &mut own);
            all.push(self.respond(block, own, no_pairs.clone())?);
        }
        if let Some(unit) = self.unit {
            let mut own = nothing;
            own[unit.link] = unit.wrench(&self.position.bodies);
            self.balance(&unit, &self.respond(block, own, no_pairs)?, &mut all)?;
        }
        if let Some(motion) = self.free {
            self.accelerate(block, motion, pairs.len(), &mut all)?;
        }
        let shift = |unknown: usize| self.frictions.unknowns[unknown].kind == UnknownKind::Shift;
        for (index, &unknown) in block.unknowns.iter().enumerate().filter(|(_, unknown)| shift(**unknown)) {
            let own = all[index + 1].clone();
            let left = 1.0 - self.vector(unknown, &own)[0];
            if left.abs() < SINGULAR {
                return Ok(None);
            }
            for response in &mut all {
                response.add(self.vector(unknown, response)[0] / left, &own);
            }
        }
        let base = all.remove(0);
        let moduli: Vec<(usize, Response)> =
            block.unknowns.iter().copied().zip(all).filter(|(unknown, _)| !shift(*unknown)).collect();
        let widths = moduli.iter().map(|(unknown, _)| match self.frictions.unknowns[*unknown].kind {
            UnknownKind::Force => Width::Two,
            _ => Width::One,
        });
        let system = Moduli {
            widths: widths.collect(),
            constants: moduli.iter().map(|(unknown, _)| self.vector(*unknown, &base)).collect(),
            slopes: moduli
                .iter()
                .map(|(unknown, _)| moduli.iter().map(|(_, of)| self.vector(*unknown, of)).collect())
                .collect(),
        };
        Ok(Some(Prepared { base, each: moduli.into_iter().map(|(_, of)| of).collect(), moduli: system }))
    }

    /// Adds to each response that of the inertia loads of the acceleration with which the drive gives what is known of it; the
    /// acceleration replaces the load of the drive.
    fn accelerate(
        &self,
        block: &Block,
        motion: &FreeMotion<'_>,
        pairs: usize,
        all: &mut [Response],
    ) -> Result<(), ForceError> {
        let mut own = self.respond(block, motion.inertia.to_vec(), vec![Wrench::ZERO; pairs])?;
        own.drive += motion.drive_inertia;
        // The base moves under the drive, what friction adds without it.
        for (index, response) in all.iter_mut().enumerate() {
            let given = if index == 0 { motion.drive } else { 0.0 };
            let acceleration = (given - response.drive) / own.drive;
            response.add(acceleration, &own);
            response.drive = acceleration;
        }
        Ok(())
    }

    /// Adds to each response that of the balancing load with which the drive is idle; its size replaces that of the drive.
    fn balance(&self, unit: &UnitBalance, own: &Response, all: &mut [Response]) -> Result<(), ForceError> {
        for response in all {
            let size = unit.size(response.drive, own.drive, self.linkage);
            let size = size.map_err(|idle| idle.explain(self.linkage, self.position.coordinate))?;
            response.add(size, own);
            response.drive = size;
        }
        Ok(())
    }
}

impl Response {
    /// Adds a multiple of another response.
    pub(crate) fn add(&mut self, factor: f64, other: &Self) {
        let add = |all: &mut [Wrench<f64>], other: &[Wrench<f64>]| {
            for (sum, one) in all.iter_mut().zip(other) {
                sum.fx += factor * one.fx;
                sum.fy += factor * one.fy;
                sum.m += factor * one.m;
            }
        };
        add(&mut self.loads, &other.loads);
        add(&mut self.pairs, &other.pairs);
        self.drive += factor * other.drive;
    }
}
