//! The result of a force analyzer.

use assur_group::Wrench;
use assur_kinematics::Linkage;
use assur_number::Real;

use crate::UnitBalance;

/// Reactions in all pairs, and the balancing load: the result of an analyzer, with its scratch memory.
#[derive(Debug, Clone, PartialEq)]
pub struct Reactions<T = f64> {
    /// For each pair of the structure: force (N) and moment (N m) on its body `a`, about the pin or about the point of the sliding
    /// link. NaN where the method gives no reactions.
    pub pairs: Vec<Wrench<T>>,
    /// Moment (N m, counter-clockwise) or force (N, along the slide or along the direction of `[balance]`) that keeps the
    /// mechanism in its motion.
    pub balancing: T,
    /// The balancing load of size 1; `None` where the drive balances.
    pub unit: Option<UnitBalance>,
    /// For each group, whether its equations are solved. The reactions of the others stay exactly zero: those of a
    /// group that carries no load, or is not placed. Respected by methods that solve [by
    /// groups](crate::AnalyzerPlugin::by_groups).
    pub solved: Vec<bool>,
    /// Scratch of a method: one wrench for each pair.
    pub scratch_pairs: Vec<Wrench<T>>,
    /// Scratch of a method: one wrench for each body.
    pub scratch_bodies: Vec<Wrench<T>>,
}

impl<T: Real> Reactions<T> {
    /// Memory for the reactions of a mechanism, of all groups that are placed.
    pub fn new(linkage: &Linkage) -> Self {
        let groups = 0..linkage.groups().len();
        let pairs = vec![Wrench::ZERO; linkage.structure.pairs.len()];
        Self {
            balancing: T::from_f64(f64::NAN),
            unit: UnitBalance::of(&linkage.mechanism),
            solved: groups.map(|group| linkage.chain.is_needed(group)).collect(),
            scratch_pairs: pairs.clone(),
            pairs,
            scratch_bodies: vec![Wrench::ZERO; linkage.structure.links],
        }
    }

    /// Memory for the reactions, without the groups of these indices, which carry no load: their reactions stay zero.
    #[must_use]
    pub fn without_idle(mut self, carrying: &[bool]) -> Self {
        for (solved, carrying) in self.solved.iter_mut().zip(carrying) {
            *solved &= *carrying;
        }
        self
    }
}
