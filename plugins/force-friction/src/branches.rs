//! All solutions of a mechanism: those of the last block, and from each of them on those of the blocks before it.

use assur_force::{Block, ForceError};
use assur_group::Wrench;

use crate::chain::{Chain, Prepared};

/// A solution of all blocks.
#[derive(Debug, Clone)]
pub(crate) struct Branch {
    /// Loads with all that was handed on.
    loads: Vec<Wrench<f64>>,
    /// Reactions without the forces and moments of friction.
    pub(crate) pairs: Vec<Wrench<f64>>,
    /// The balancing load.
    pub(crate) balancing: f64,
    /// The moduli, block by block.
    pub(crate) moduli: Vec<f64>,
}

/// All solutions.
#[derive(Debug)]
pub(crate) struct Found {
    pub(crate) branches: Vec<Branch>,
    /// Whether there are certainly no others.
    pub(crate) proved: bool,
    /// Whether some are ends of a continuum.
    pub(crate) continuum: bool,
    /// The block that has no solution in any branch.
    pub(crate) jammed: Option<usize>,
    /// Spectral radius by group, NaN without friction.
    pub(crate) certificates: Vec<f64>,
}

/// Steps from no friction to all of it where a block is too large for all of its solutions to be found.
const STEPS: u32 = 64;

/// Most solutions that are followed from block to block, each of which may have several for each of them.
const MOST: usize = 64;

impl Chain<'_> {
    /// All solutions under these loads with all coefficients times `scale`.
    pub(crate) fn solutions(&self, loads: &[Wrench<f64>], scale: f64) -> Result<Found, ForceError> {
        let pairs = vec![Wrench::ZERO; self.linkage.structure.pairs.len()];
        let start = Branch { loads: loads.to_vec(), pairs, balancing: 0.0, moduli: Vec::new() };
        let mut found = Found {
            branches: vec![start],
            proved: true,
            continuum: false,
            jammed: None,
            certificates: vec![f64::NAN; self.linkage.groups().len()],
        };
        for (index, block) in self.blocks().iter().enumerate() {
            let before = std::mem::take(&mut found.branches);
            for branch in before {
                self.go_on(block, branch, scale, &mut found)?;
            }
            if found.branches.len() > MOST {
                found.branches.truncate(MOST);
                found.proved = false;
            }
            if found.branches.is_empty() {
                found.jammed = Some(index);
                return Ok(found);
            }
        }
        Ok(found)
    }

    /// Adds the solutions of a block that follow from a solution of those after it.
    fn go_on(&self, block: &Block, branch: Branch, scale: f64, found: &mut Found) -> Result<(), ForceError> {
        if block
            .unknowns
            .iter()
            .any(|&unknown| self.factor(&self.frictions.unknowns[unknown], scale).is_nan())
        {
            found.branches.push(self.undetermined(block, branch));
            return Ok(());
        }
        let Some(prepared) = self.prepare(block, (&branch.loads, &branch.pairs), scale)? else {
            return Ok(());
        };
        if prepared.moduli.count() == 0 {
            found.branches.push(branch.with(block, &prepared, &[]));
            return Ok(());
        }
        let radius = prepared.moduli.certificate();
        block.groups().for_each(|group| found.certificates[group] = radius);
        if radius < 1.0
            && let Some(only) = prepared.moduli.follow(&vec![0.0; prepared.moduli.count()])
        {
            found.branches.push(branch.with(block, &prepared, &only));
            return Ok(());
        }
        let mut all = prepared.moduli.solutions();
        found.continuum |= all.continuum;
        if !all.complete {
            found.proved = false;
            all.points.extend(self.continued(block, &branch, scale)?);
        }
        found.branches.extend(all.points.iter().map(|point| branch.clone().with(block, &prepared, point)));
        Ok(())
    }

    /// A block at rest whose friction is not determined: neither are its reactions, nor what they do to other links.
    fn undetermined(&self, block: &Block, mut branch: Branch) -> Branch {
        let unknown = Wrench { fx: f64::NAN, fy: f64::NAN, m: f64::NAN };
        let stages = block.groups().flat_map(|group| self.linkage.structure.groups[group].frame.pairs());
        for pair in stages {
            branch.pairs[pair.id] = unknown;
            for link in [pair.a, pair.b] {
                branch.loads[link] = unknown;
            }
        }
        if block.stages.contains(&0) {
            (branch.pairs[0], branch.balancing) = (unknown, f64::NAN);
        }
        for rub in
            block.unknowns.iter().map(|&index| &self.frictions.rubs[self.frictions.unknowns[index].rub])
        {
            for link in [rub.link, rub.on] {
                branch.loads[link] = unknown;
            }
        }
        branch.moduli.extend(block.unknowns.iter().map(|_| f64::NAN));
        branch
    }

    /// The solution of a block to which that without friction leads as the coefficients grow; `None` where it ends before.
    fn continued(&self, block: &Block, branch: &Branch, scale: f64) -> Result<Option<Vec<f64>>, ForceError> {
        let mut z: Option<Vec<f64>> = None;
        for step in 1..=STEPS {
            let part = scale * f64::from(step) / f64::from(STEPS);
            let Some(prepared) = self.prepare(block, (&branch.loads, &branch.pairs), part)? else {
                return Ok(None);
            };
            let start = z.unwrap_or_else(|| vec![0.0; prepared.moduli.count()]);
            let next = prepared.moduli.newton(&start).or_else(|| prepared.moduli.follow(&start));
            let Some(next) = next else { return Ok(None) };
            z = Some(next);
        }
        Ok(z)
    }
}

impl Branch {
    fn with(mut self, block: &Block, prepared: &Prepared, moduli: &[f64]) -> Self {
        let mut sum = prepared.base.clone();
        for (response, z) in prepared.each.iter().zip(moduli) {
            sum.add(*z, response);
        }
        (self.loads, self.pairs) = (sum.loads, sum.pairs);
        if block.stages.contains(&0) {
            self.balancing = sum.drive;
        }
        self.moduli.extend_from_slice(moduli);
        self
    }
}
