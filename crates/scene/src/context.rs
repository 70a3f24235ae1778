//! What the readers of loads, motion and drive know of the rest of the scene.

use assur_mechanism::Input;

use crate::input::coordinate_of;
use crate::linkage::Linkage;
use crate::units::Dimension;
use crate::walk::Entry;

/// What is known when links, slides and input are read.
#[derive(Debug)]
pub(crate) struct Context<'s> {
    pub(crate) linkage: &'s Linkage,
    /// `None`: the input is faulty.
    pub(crate) input: Option<&'s Input>,
    /// Whether there is a `[motion]`.
    pub(crate) moves: bool,
}

impl Context<'_> {
    /// Dimension of the input coordinate; `None` where the input is faulty, so that one fault doesn't cause others.
    pub(crate) fn coordinate(&self) -> Option<Dimension> {
        self.input.map(|input| coordinate_of(input.pair))
    }

    /// The dimension that belongs to an input that turns, or to one that slides.
    pub(crate) fn by_input(&self, turns: Dimension, slides: Dimension) -> Option<Dimension> {
        self.coordinate().map(|coordinate| if coordinate == Dimension::Angle { turns } else { slides })
    }

    /// Dimension of the input speed.
    pub(crate) fn speed(&self) -> Option<Dimension> {
        self.by_input(Dimension::AngularSpeed, Dimension::Speed)
    }

    /// Whether the input is known to have no cycle.
    pub(crate) fn has_no_cycle(&self) -> bool {
        self.input.is_some_and(|input| input.period().is_none())
    }

    /// Sign of the input's motion.
    pub(crate) fn sign(&self) -> f64 {
        self.input.map_or(1.0, Input::sign)
    }

    /// Notes that something of a load needs a motion, where there is none.
    pub(crate) fn need_motion(&self, entry: &Entry<'_>, what: &str) {
        if !self.moves {
            entry.fault(
                format!("{what} needs a motion, and the scene has no [motion]"),
                "add [motion] with `speed`",
            );
        }
    }
}
