//! Group by group for any number type: reactions and the balancing load, by the closed forms of the groups or by their
//! linear system.

use assur_force::{UnitBalance, group_by_group};
use assur_group::{AssurGroup, Body, GroupError, Number, Wrench, reactions_generally};
use assur_kinematics::Linkage;
use assur_number::Real;

/// The source of the reactions of a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Forms {
    /// The closed forms of its kind.
    Closed,
    /// The transposed linear system of its constraints.
    General,
}

/// Reactions in one number type, with scratch memory.
pub(crate) struct Answer<T> {
    pub(crate) pairs: Vec<Wrench<T>>,
    pub(crate) balancing: T,
    loads: Vec<Wrench<T>>,
    unit_pairs: Vec<Wrench<T>>,
}

impl<T: Number> Answer<T> {
    pub(crate) fn new(linkage: &Linkage) -> Self {
        let pairs = vec![Wrench::ZERO; linkage.structure.pairs.len()];
        let loads = vec![Wrench::ZERO; linkage.structure.links];
        Self { unit_pairs: pairs.clone(), pairs, balancing: T::ZERO, loads }
    }

    /// Solves one position. `loads`: about the origins of the bodies; `unit`: the balancing load of size 1, if it does
    /// not act on the input link.
    pub(crate) fn solve(
        &mut self,
        linkage: &Linkage,
        groups: &[Box<dyn AssurGroup<T>>],
        bodies: &[Body<T>],
        loads: &[Wrench<f64>],
        unit: Option<UnitBalance>,
        forms: Forms,
    ) -> Result<(), GroupError> {
        for (own, load) in self.loads.iter_mut().zip(loads) {
            *own = wrench(load);
        }
        self.balancing = pass(linkage, groups, bodies, &mut self.loads, &mut self.pairs, forms)?;
        let Some(unit) = unit else { return Ok(()) };
        self.loads.fill(Wrench::ZERO);
        self.loads[unit.link] = wrench(&unit.wrench);
        let idle = pass(linkage, groups, bodies, &mut self.loads, &mut self.unit_pairs, forms)?;
        let size = -self.balancing / idle;
        for (sum, unit) in self.pairs.iter_mut().zip(&self.unit_pairs) {
            sum.fx += size * unit.fx;
            sum.fy += size * unit.fy;
            sum.m += size * unit.m;
        }
        self.balancing = size;
        Ok(())
    }
}

fn wrench<T: Real>(of: &Wrench<f64>) -> Wrench<T> {
    Wrench { fx: T::from_f64(of.fx), fy: T::from_f64(of.fy), m: T::from_f64(of.m) }
}

fn pass<T: Number>(
    linkage: &Linkage,
    groups: &[Box<dyn AssurGroup<T>>],
    bodies: &[Body<T>],
    loads: &mut [Wrench<T>],
    pairs: &mut [Wrench<T>],
    forms: Forms,
) -> Result<T, GroupError> {
    group_by_group(linkage, groups, bodies, loads, pairs, |_, group, loads, pairs| match forms {
        Forms::Closed => group.reactions(bodies, loads, pairs),
        Forms::General => reactions_generally(group.frame(), bodies, loads, pairs),
    })
}
