//! Group by group for any number type: reactions and the balancing load, by the closed forms of the groups or by their
//! linear system.

use assur_force::{Reactions, Unsolved, group_by_group};
use assur_group::{AssurGroup, Body, Number, Wrench, reactions_generally};
use assur_kinematics::Linkage;

/// The source of the reactions of a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Forms {
    /// The closed forms of its kind.
    Closed,
    /// The transposed linear system of its constraints.
    General,
}

/// Solves one position. `loads`: about the origins of the bodies; `own`: scratch memory, one wrench for each body.
pub(crate) fn solve<T: Number>(
    linkage: &Linkage,
    groups: &[Box<dyn AssurGroup<T>>],
    bodies: &[Body<T>],
    loads: &[Wrench<f64>],
    forms: Forms,
    own: &mut [Wrench<T>],
    out: &mut Reactions<T>,
) -> Result<(), Unsolved> {
    for (own, load) in own.iter_mut().zip(loads) {
        *own = load.map(T::from_f64);
    }
    group_by_group(linkage, groups, bodies, own, out, |group, bodies, loads, pairs| match forms {
        Forms::Closed => group.reactions(bodies, loads, pairs),
        Forms::General => reactions_generally(group.frame(), bodies, loads, pairs),
    })
}
