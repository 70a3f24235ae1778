//! The working of one position: the equations of the input link and of every group with the numbers of this position,
//! in solving order, then the forces from the last group to the input link, in the form of a calculation by hand.
//!
//! The equations of a kind are in its plugin ([`assur_worksheet::WorkingPlugin`]), those of a force analyzer in its own
//! ([`AnalyzerWorking`]). For a kind without its own
//! equations, and in a position where they are singular (0/0), the general linear system is used. This crate is
//! independent of concrete kinds, of files and of the terminal.

mod area;
mod chain;
mod conventions;
mod energy;
mod equation;
mod forces;
mod friction;
mod general;
mod input;
mod loads;
mod method;
mod names;

pub use conventions::digits_told;
pub use energy::{Done, Ending, EnergyForm};

use assur_force::{LoadError, LoadState, Loads};
use assur_group::{Body, Order};
use assur_kinematics::{Linkage, PositionError};
use assur_mechanism::{Key, Mechanism};
use assur_words::{Describe, Language, Text, text};
use assur_worksheet::{Expr, Reaction, RegistryError, Section, Sheet, Symbol, Units};

pub use assur_group::inventory;
pub use method::{AnalyzerWorking, FoundForces, WriteForces};

assur_words::resources!();

/// The working of one position.
#[derive(Debug, Clone)]
pub struct Working {
    /// Its sections in order.
    pub sections: Vec<Section>,
    /// Groups (counted from 0) whose positions were calculated by the general linear system.
    pub general: Vec<usize>,
    /// The reactions, each on a link of its group.
    pub reactions: Vec<Reaction>,
    /// The balancing moment (N m) or force (N), if there are loads and it is determined.
    pub balancing: Option<f64>,
}

/// Why there is no working.
#[derive(Clone, PartialEq)]
pub enum WorkingError {
    /// There is no such position.
    Index {
        /// The number of the wanted position.
        index: usize,
        /// The number of the last position.
        last: usize,
    },
    /// The coordinate of the mechanism is the time.
    OverTime,
    /// The mechanism can't be assembled there.
    Position(PositionError),
    /// A load has no value there.
    Load {
        /// The position or the sample.
        place: PositionOrSample,
        /// Which load.
        error: LoadError,
    },
    /// Two plugins provide a working for one kind.
    Registry(RegistryError),
}

assur_words::errors!(WorkingError; Position(PositionError), Registry(RegistryError));

impl Describe for WorkingError {
    fn describe(&self) -> Text {
        match self {
            Self::Index { index, last } => text!("working-no-position", position = *index, last = *last),
            Self::OverTime => text!("working-over-time"),
            Self::Position(error) => error.describe(),
            Self::Load { place, error } => {
                text!("working-load", place = place.describe(), error = error.describe())
            }
            Self::Registry(error) => error.describe(),
        }
    }
}

/// What is worked.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// The compiled mechanism.
    pub linkage: &'a Linkage,
    /// Its loads; `None`: positions and transfer functions only.
    pub loads: Option<&'a Loads>,
    /// The state of the input.
    pub state: LoadState,
    /// Which position it is.
    pub place: PositionOrSample,
    /// What drives the input where its acceleration follows from the equation of motion, reduced to it and positive along the
    /// coordinate: moment, N m (force, N), and moment of inertia of flywheel and rotor, kg m² (mass, kg).
    pub drive: Option<[f64; 2]>,
    /// Name of the force analyzer whose working follows that of the groups, where it has one.
    pub analyzer: Option<&'a str>,
}

/// Which position is worked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PositionOrSample {
    /// A position of the scene, by its number.
    Position(usize),
    /// A sample of a motion, by its number.
    Sample(usize),
}

impl WorkingError {
    /// The key of the scene that the error concerns.
    pub fn key(&self, mechanism: &Mechanism) -> Option<Key> {
        if let Self::Load { error, .. } = self { error.key(mechanism) } else { None }
    }
}

impl Describe for PositionOrSample {
    fn describe(&self) -> Text {
        match self {
            Self::Position(index) => text!("working-position", position = *index),
            Self::Sample(index) => text!("working-sample", sample = *index),
        }
    }
}

/// Data that all parts of a working use.
pub(crate) struct Work<'a> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) bodies: &'a [Body<f64>],
    pub(crate) state: LoadState,
    pub(crate) drive: Option<[f64; 2]>,
    /// The load of the drive of a pair between two links of a group, as it was written with the reactions of the group.
    pub(crate) pair_drive: Option<Expr>,
    pub(crate) sheet: Sheet,
    pub(crate) general: Vec<usize>,
    /// Whether kinds may write their own equations; otherwise the general linear system is used for all.
    pub(crate) own: bool,
}

impl Working {
    /// Writes the working of a position; with loads also its equation of motion, where the input has a drive, and its forces.
    pub fn of(task: &Task<'_>) -> Result<Self, WorkingError> {
        Self::by(task, true)
    }

    pub(crate) fn by(task: &Task<'_>, own: bool) -> Result<Self, WorkingError> {
        let Task { linkage, loads, state, place, drive, analyzer } = *task;
        if linkage.kind().is_time() {
            return Err(WorkingError::OverTime);
        }
        let mut position = linkage.position();
        match place {
            PositionOrSample::Position(index) => {
                let count = linkage.mechanism.input.positions;
                if index >= count {
                    return Err(WorkingError::Index { index, last: count.saturating_sub(1) });
                }
                linkage.solve_index(index, Order::Second, &mut position)?;
            }
            PositionOrSample::Sample(_) => linkage.solve(state.coordinate, Order::Second, &mut position)?,
        }
        if let Some(loads) = loads {
            let finite = loads.finite(&linkage.mechanism, &state, &position.bodies);
            finite.map_err(|error| WorkingError::Load { place, error })?;
        }
        let units = if linkage.kind().is_angle() { Units::ANGULAR } else { Units::LINEAR };
        let sheet = Sheet::new(names::of(linkage), units);
        let mut work = Work {
            linkage,
            bodies: &position.bodies,
            state,
            drive,
            pair_drive: None,
            sheet,
            general: Vec::new(),
            own,
        };
        work.conventions(place, loads.is_some());
        work.input(place);
        for group in 0..linkage.structure.groups.len() {
            work.group(group)?;
        }
        let balancing = match loads {
            Some(loads) => work.forces(loads, analyzer, &position)?,
            None => None,
        };
        let reactions = work.sheet.reactions().to_vec();
        Ok(Self { sections: work.sheet.sections, general: work.general, reactions, balancing })
    }

    /// The working in a language, as plain text of at most [`assur_worksheet::WIDTH`] columns.
    pub fn text(&self, language: &Language) -> String {
        assur_worksheet::text(&self.sections, assur_worksheet::WIDTH, language)
    }
}

/// The symbol of the balancing moment or force.
pub(crate) fn balancing(letter: &'static str) -> Symbol {
    Symbol::from(letter).of(text!("working-balancing"))
}

#[cfg(test)]
mod tests;
