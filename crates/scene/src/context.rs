//! Facts about the rest of the scene that the readers of loads, motion and drive need.

use std::collections::BTreeSet;

use assur_mechanism::{GROUND, Input, InputPair, Load, LoadId, LoadKind, Name};
use assur_words::{Text, text};

use crate::over_time::Timing;
use crate::walk::{Entry, Section};
use crate::{linkage::SceneLinks, units::Dimension};

/// The dimension and meaning of an input's coordinate.
pub(crate) fn coordinate_of(pair: InputPair) -> Dimension {
    match pair {
        InputPair::Pin(_) => Dimension::Angle,
        InputPair::Slide(_) => Dimension::Length,
    }
}

/// What is known after links, slides and input have been read.
#[derive(Debug)]
pub(crate) struct Context<'s> {
    pub(crate) linkage: &'s SceneLinks,
    /// `None` if the input is faulty.
    pub(crate) input: Option<&'s Input>,
    pub(crate) timing: Timing,
    pub(crate) loads: usize,
    /// Whether there is a `[motion]`.
    pub(crate) moves: bool,
}

impl Context<'_> {
    /// Dimension of the input coordinate; `None` if the input is faulty, which must not cause further faults, or over time.
    pub(crate) fn coordinate(&self) -> Option<Dimension> {
        self.input.filter(|input| !input.is_list).map(|input| coordinate_of(input.first().pair))
    }

    /// Dimension of the input speed.
    pub(crate) fn speed(&self) -> Option<Dimension> {
        let turns = |coordinate| coordinate == Dimension::Angle;
        self.coordinate().map(|own| if turns(own) { Dimension::AngularSpeed } else { Dimension::Speed })
    }

    /// Whether the input is known to have no cycle.
    pub(crate) fn has_no_cycle(&self) -> bool {
        self.input.is_some_and(|input| input.period().is_none())
    }

    /// Sign of the input's motion.
    pub(crate) fn sign(&self) -> f64 {
        self.input.map_or(1.0, Input::sign)
    }

    /// Notes that a part of a load needs a motion, if the scene has none.
    pub(crate) fn need_motion(&self, entry: &Entry<'_>, what: Text) {
        if !self.moves {
            let add = if self.timing.is_time() { "scene-add-motion-until" } else { "scene-add-motion" };
            entry.fault(text!("scene-needs-motion", what), text!(add));
        }
    }
}

/// A sort of loads: a list of tables in the scene.
pub(crate) struct Sort {
    /// Its key in the scene.
    pub(crate) list: &'static str,
    /// The identity of the name of one that has none of its own: with its number from 1 and the first link on which it acts.
    pub(crate) unnamed: &'static str,
    /// Reads one from its section.
    pub(crate) one: fn(&Section<'_>, &Context<'_>, LoadId) -> Option<LoadKind>,
}

impl Sort {
    /// Reads all loads of this sort, after those before them with their names.
    pub(crate) fn read(
        &self,
        root: &Section<'_>,
        context: &Context<'_>,
        (loads, names): (&mut Vec<Load>, &mut BTreeSet<String>),
    ) {
        for (index, section) in root.inners(self.list).iter().enumerate() {
            let (id, moves) = (loads.len(), context.moves);
            let kind = (self.one)(section, context, id);
            let is_scaled = section.get("scale").is_some_and(|scale| scale.written().to_string() != "1");
            section.sets(1.0, move |scene, key| match key {
                // A scale is multiplied into what it scales, and without a motion there is no damping.
                "value" | "force" if is_scaled => None,
                "damping" if !moves => None,
                _ => scene.loads[id].kind.number(key),
            });
            let on = kind.as_ref().and_then(|kind| kind.links().next()).unwrap_or(GROUND);
            let unnamed = || text!(self.unnamed, number = index + 1, link = &context.linkage.links[on].name);
            let taken = |name: &Name| (!names.insert(name.to_string())).then_some("scene-two-loads");
            let name = section.name(unnamed, taken);
            loads.extend(kind.map(|kind| Load { name, kind }));
        }
    }
}
