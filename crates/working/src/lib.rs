//! The working of one position: the equations of the input link and of every group with this position's numbers put in,
//! in solving order, then the forces from the last group to the input link, so that a reader follows by hand.
//!
//! The equations of a kind stand with its plugin ([`assur_worksheet::WorkingPlugin`]); a kind without its own, and a
//! position in which they say nothing (0/0), are worked by the general linear system. Knows no kind by name, no file and
//! no terminal.

mod chain;
mod conventions;
mod forces;
mod general;
mod input;
mod loads;
mod names;
mod statics;

use assur_force::{Loads, State};
use assur_group::{Body, Order};
use assur_kinematics::{Linkage, PositionError};
use assur_worksheet::{Reaction, Section, Sheet, Units, WorkingRegistryError};

/// The working of one position.
#[derive(Debug, Clone)]
pub struct Working {
    /// Its parts in order.
    pub sections: Vec<Section>,
    /// Groups (counted from 0) whose positions were not worked by equations of their kind.
    pub general: Vec<usize>,
    /// The reactions found, each on a link of its group.
    pub reactions: Vec<Reaction>,
    /// The balancing moment (N m) or force (N), where there are loads and it is determined.
    pub balancing: Option<f64>,
}

/// Why there is no working.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WorkingError {
    /// There is no such position.
    #[error("there is no position {index}: the scene has positions 0 to {last}")]
    Index {
        /// The position asked for.
        index: usize,
        /// The last one.
        last: usize,
    },
    /// The mechanism can't be assembled there.
    #[error(transparent)]
    Position(#[from] PositionError),
    /// The plugins are at odds.
    #[error(transparent)]
    Registry(#[from] WorkingRegistryError),
}

/// What the parts of a working share.
pub(crate) struct Work<'a> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) bodies: &'a [Body<f64>],
    pub(crate) state: State,
    pub(crate) sheet: Sheet,
    pub(crate) general: Vec<usize>,
    /// Whether kinds may write their own equations; otherwise all are worked by the linear system.
    pub(crate) own: bool,
}

impl Working {
    /// Works position `index` of a scene; with `loads` its forces as well, at the speed and acceleration of `state`.
    ///
    /// # Errors
    ///
    /// [`WorkingError`] where the position does not exist or can't be assembled.
    pub fn of(
        linkage: &Linkage,
        loads: Option<&Loads>,
        state: State,
        index: usize,
    ) -> Result<Self, WorkingError> {
        Self::by(linkage, loads, state, index, true)
    }

    pub(crate) fn by(
        linkage: &Linkage,
        loads: Option<&Loads>,
        state: State,
        index: usize,
        own: bool,
    ) -> Result<Self, WorkingError> {
        let count = linkage.mechanism.input.positions;
        if index >= count {
            return Err(WorkingError::Index { index, last: count.saturating_sub(1) });
        }
        let mut position = linkage.position();
        linkage.solve_index(index, Order::Second, &mut position)?;
        let units = if linkage.angular() { Units::ANGULAR } else { Units::LINEAR };
        let sheet = Sheet::new(names::of(linkage), units);
        let mut work = Work { linkage, bodies: &position.bodies, state, sheet, general: Vec::new(), own };
        work.conventions(index, loads.is_some());
        work.input(index);
        for group in 0..linkage.structure.groups.len() {
            work.group(group)?;
        }
        let balancing = match loads {
            Some(loads) => work.forces(loads)?,
            None => None,
        };
        let reactions = work.sheet.reactions().to_vec();
        Ok(Self { sections: work.sheet.sections, general: work.general, reactions, balancing })
    }

    /// As plain text of at most [`assur_worksheet::WIDTH`] columns.
    pub fn text(&self) -> String {
        assur_worksheet::text(&self.sections)
    }
}

#[cfg(test)]
mod tests;
