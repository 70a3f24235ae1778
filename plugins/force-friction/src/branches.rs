//! All solutions with friction of a mechanism: those of the last block, and for each of them those of the blocks before it; which of
//! several is taken, and up to which part of the coefficients there is any.

use assur_force::{Block, ForceError, FrictionIteration};
use assur_friction::{Moduli, PathPoint, SHORTEST, nearest, path};
use assur_group::Wrench;

use crate::chain::{Chain, Prepared, add};

/// A solution of all blocks.
#[derive(Debug, Clone)]
pub(crate) struct Branch {
    /// Loads on all links, with the reactions and the friction of the blocks that are solved.
    loads: Vec<Wrench<f64>>,
    /// Reactions without the forces and moments of friction.
    pub(crate) pairs: Vec<Wrench<f64>>,
    pub(crate) balancing: f64,
    /// The magnitudes, block by block.
    pub(crate) moduli: Vec<f64>,
}

#[derive(Debug)]
pub(crate) struct Solutions {
    pub(crate) branches: Vec<Branch>,
    /// Whether there are certainly no others.
    pub(crate) proved: bool,
    /// Whether some are ends of a continuum.
    pub(crate) continuum: bool,
    /// The block that has no solution in any branch.
    pub(crate) jammed: Option<usize>,
    /// Spectral radius by group, NaN without friction.
    pub(crate) certificates: Vec<f64>,
    /// The part of the coefficients at which the path of the first block from no friction ends, where this was found.
    followed: f64,
}

/// Most solutions that are followed from block to block: each of them may lead to several in the next block.
const MOST: usize = 64;

impl Chain<'_> {
    /// All solutions under these loads with all coefficients times `scale`.
    pub(crate) fn solutions(&self, loads: &[Wrench<f64>], scale: f64) -> Result<Solutions, ForceError> {
        let pairs = vec![Wrench::ZERO; self.linkage.structure.pairs.len()];
        let start = Branch { loads: loads.to_vec(), pairs, balancing: 0.0, moduli: Vec::new() };
        let mut found = Solutions {
            branches: vec![start],
            proved: true,
            continuum: false,
            jammed: None,
            certificates: vec![f64::NAN; self.linkage.groups().len()],
            followed: f64::INFINITY,
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
    fn go_on(
        &self,
        block: &Block,
        branch: Branch,
        scale: f64,
        found: &mut Solutions,
    ) -> Result<(), ForceError> {
        if self.is_undetermined(block, &branch, scale) {
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
        let only = if self.is_free() {
            // Nobody is told the certificate of an acceleration.
            prepared.moduli.only()
        } else {
            let radius = prepared.moduli.certificate();
            block.groups().for_each(|group| found.certificates[group] = radius);
            let start = vec![0.0; prepared.moduli.count()];
            if radius < 1.0 { prepared.moduli.follow(&start) } else { None }
        };
        if let Some(only) = only {
            found.branches.push(branch.with(block, &prepared, &only));
            return Ok(());
        }
        let mut all = prepared.moduli.solutions();
        found.continuum |= all.continuum;
        if !all.complete {
            found.proved = false;
            // The loads of the first block are the same whatever the coefficients: so is its path.
            let is_first = branch.moduli.is_empty();
            if !is_first || scale <= self.followed {
                match self.continued(block, &branch, &prepared, scale) {
                    Ok(continued) => _ = all.index_of(continued),
                    Err(end) if is_first => found.followed = scale * end.part,
                    Err(_) => {}
                }
            }
        }
        found.branches.extend(all.points.iter().map(|point| branch.clone().with(block, &prepared, point)));
        Ok(())
    }

    /// The solution near expected magnitudes, with all coefficients times `scale`.
    pub(crate) fn near(&self, loads: &[Wrench<f64>], scale: f64, expected: &[f64]) -> Option<Branch> {
        let pairs = vec![Wrench::ZERO; self.linkage.structure.pairs.len()];
        let mut branch = Branch { loads: loads.to_vec(), pairs, balancing: 0.0, moduli: Vec::new() };
        for block in self.blocks() {
            let prepared = self.prepare(block, (&branch.loads, &branch.pairs), scale).ok()??;
            let known = branch.moduli.len();
            let expected = expected.get(known..known + prepared.moduli.count())?;
            let found = prepared.moduli.near(expected)?;
            branch = branch.with(block, &prepared, &found);
        }
        Some(branch)
    }

    /// Whether friction of a block, or a load on one of its links, is not determined at rest.
    fn is_undetermined(&self, block: &Block, branch: &Branch, scale: f64) -> bool {
        let mut unknowns = block.unknowns.iter().map(|&index| &self.frictions.unknowns[index]);
        let mut links = block.groups().flat_map(|group| &self.linkage.structure.groups[group].frame.links);
        unknowns.any(|unknown| self.factor(unknown, scale).is_nan())
            || links.any(|&link| branch.loads[link].m.is_nan())
    }

    /// A block at rest whose friction or loads are not determined: neither are its reactions, nor what they do to other links.
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
            let drives = self.linkage.mechanism.input.drivers.len();
            branch.pairs[..drives].fill(unknown);
            branch.balancing = f64::NAN;
        }
        for bearing in block
            .unknowns
            .iter()
            .map(|&index| &self.frictions.bearings[self.frictions.unknowns[index].bearing])
        {
            for link in [bearing.link, bearing.on] {
                branch.loads[link] = unknown;
            }
        }
        branch.moduli.extend(block.unknowns.iter().map(|_| f64::NAN));
        branch
    }

    /// The solution of a block to which that without friction leads as the coefficients grow, or where it ends before.
    fn continued(
        &self,
        block: &Block,
        branch: &Branch,
        whole: &Prepared,
        scale: f64,
    ) -> Result<Vec<f64>, PathPoint> {
        let is_linear = whole.each.len() == block.unknowns.len();
        let moduli = |part: f64| -> Option<Moduli> {
            if is_linear {
                return Some(whole.moduli.scaled(part));
            }
            let prepared = self.prepare(block, (&branch.loads, &branch.pairs), scale * part);
            prepared.ok()?.map(|prepared| prepared.moduli)
        };
        let mut start = PathPoint { part: 0.0, moduli: Vec::new() };
        let Some(ideal) = moduli(0.0) else { return Err(start) };
        start.moduli = ideal.step(&vec![0.0; ideal.count()]);
        path(start, |part, expected| moduli(part)?.near(expected))
    }

    /// How the friction of each block is found, on the way to the solution that is taken.
    pub(crate) fn iterations(&self, loads: &[Wrench<f64>]) -> Result<Vec<FrictionIteration>, ForceError> {
        let found = self.solutions(loads, 1.0)?;
        let taken = taken(self, loads, &found).map(|index| found.branches[index].moduli.clone());
        let mut left = taken.as_deref();
        let pairs = vec![Wrench::ZERO; self.linkage.structure.pairs.len()];
        let mut branch = Branch { loads: loads.to_vec(), pairs, balancing: 0.0, moduli: Vec::new() };
        let mut all = Vec::new();
        for (index, block) in self.blocks().iter().enumerate() {
            let Some(prepared) = self.prepare(block, (&branch.loads, &branch.pairs), 1.0)? else { break };
            let moduli = &prepared.moduli;
            let solution = left.and_then(|left| left.get(..moduli.count())).map(<[f64]>::to_vec);
            left = left.and_then(|left| left.get(moduli.count()..));
            if moduli.count() > 0 {
                let unknowns = block.unknowns.iter().copied();
                all.push(FrictionIteration {
                    what: self.name(index),
                    unknowns: unknowns.filter(|one| self.frictions.unknowns[*one].is_modulus()).collect(),
                    steps: steps(moduli),
                    radius: moduli.certificate(),
                    solution: solution.clone(),
                });
            }
            let Some(solution) = solution else { break };
            branch = branch.with(block, &prepared, &solution);
        }
        Ok(all)
    }
}

/// Most steps of the iteration that are reported, and the relative change at which it stands still.
const TOLD: (usize, f64) = (12, 1e-10);

/// The magnitudes by the textbook iteration, until they stand still.
fn steps(moduli: &Moduli) -> Vec<Vec<f64>> {
    let mut all = vec![moduli.step(&vec![0.0; moduli.count()])];
    while let (Some(last), true) = (all.last(), all.len() < TOLD.0) {
        let next = moduli.step(last);
        let size = next.iter().fold(0.0_f64, |most, z| most.max(*z));
        let still = next.iter().zip(last).all(|(new, old)| (new - old).abs() <= TOLD.1 * size);
        all.push(next);
        if still {
            break;
        }
    }
    all
}

impl Branch {
    fn with(mut self, block: &Block, prepared: &Prepared, moduli: &[f64]) -> Self {
        let all = &prepared.all;
        let mut drive = all.drive(0);
        (self.loads, self.pairs) = (all.loads(0).to_vec(), all.pairs(0).to_vec());
        for (&response, &z) in prepared.each.iter().zip(moduli) {
            add(&mut self.loads, z, all.loads(response));
            add(&mut self.pairs, z, all.pairs(response));
            drive += z * all.drive(response);
        }
        if block.stages.contains(&0) {
            self.balancing = drive;
        }
        self.moduli.extend_from_slice(moduli);
        self
    }
}

/// The part of the coefficients at which a path begins, at most.
const START: f64 = 1e-3;

/// Ratio of two parts of the coefficients between which no interval without solutions is looked for.
const RATIO: f64 = 1.03;

/// The index of the solution that is taken: in a motion that a drive made, the one with its load; else the one that follows by
/// continuity from small coefficients, else that of the least balancing load; `None` where there is none.
pub(crate) fn taken(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Solutions) -> Option<usize> {
    if found.branches.len() < 2 {
        return (!found.branches.is_empty()).then_some(0);
    }
    if let Some(driven) = chain.driven(found.branches.iter().map(|branch| branch.balancing)) {
        return Some(driven);
    }
    let size = |branch: &Branch| branch.balancing.abs();
    let least = (0..found.branches.len())
        .min_by(|&a, &b| size(&found.branches[a]).total_cmp(&size(&found.branches[b])));
    followed(chain, loads, found).or(least)
}

/// A part of the coefficients with certainly one solution, as great as the spectral radii promise, and its magnitudes.
fn start(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Solutions) -> Option<PathPoint> {
    let radius = found.certificates.iter().copied().filter(|radius| radius.is_finite()).fold(0.0, f64::max);
    let parts = [0.9 / radius.max(1.0), START.min(0.01 / radius.max(1e-300))];
    parts.into_iter().find_map(|part| {
        let mut found = chain.solutions(loads, part).ok().filter(|found| found.proved)?;
        let only = found.branches.pop().filter(|_| found.branches.is_empty())?;
        Some(PathPoint { part, moduli: only.moduli })
    })
}

fn followed(chain: &Chain<'_>, loads: &[Wrench<f64>], found: &Solutions) -> Option<usize> {
    let near = |part: f64, z: &[f64]| Some(chain.near(loads, part, z)?.moduli);
    let moduli = path(start(chain, loads, found)?, near).ok()?;
    nearest(found.branches.iter().map(|branch| &branch.moduli), &moduli)
}

/// The upper end of the interval from 0 of the parts of the coefficients for which there is a solution.
pub(crate) fn limit(chain: &Chain<'_>, loads: &[Wrench<f64>]) -> f64 {
    let first = chain.first(loads);
    let mut chain = chain.knowing(first.as_ref());
    let whole = chain.solutions(loads, 1.0).ok();
    chain.followed = whole.as_ref().map_or(f64::INFINITY, |found| found.followed);
    let start = whole.and_then(|found| start(&chain, loads, &found));
    let none = PathPoint { part: 0.0, moduli: Vec::new() };
    let near = |part: f64, z: &[f64]| Some(chain.near(loads, part, z)?.moduli);
    let Err(mut last) = start.map_or(Err(none), |start| path(start, near)) else { return 1.0 };
    let (mut holding, mut failing) = (last.part, (last.part * RATIO).clamp(START, 1.0));
    let beyond = last.part + SHORTEST;
    // A solution is near the last one that was followed to; where that ends it is looked for.
    let mut exists = |part: f64| {
        if part <= beyond
            && let Some(moduli) = near(part, &last.moduli)
        {
            last = PathPoint { part, moduli };
            return true;
        }
        chain.solutions(loads, part).is_ok_and(|found| !found.branches.is_empty())
    };
    while failing < 1.0 && exists(failing) {
        (holding, failing) = (failing, (failing * RATIO).min(1.0));
    }
    assur_number::search::bisect(holding, failing, 0.0, exists)[0]
}
