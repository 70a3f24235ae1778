//! What is wrong with the loads of a mechanism.

use assur_mechanism::{Mechanism, Name, Value};
use assur_words::{Describe, Text, name, number, quantity, text};

/// Why loads can't be compiled.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LoadError {
    /// The load has no size without a motion.
    NeedsMotion {
        /// The load.
        name: Text,
        /// The part of the load that needs a motion.
        what: Text,
    },
    /// A moment acts at no point, so it has no stroke (the load).
    StrokeOfMoment(Text),
    /// The point of the load stands still along the axis.
    NoStroke {
        /// The load.
        name: Text,
        /// Distance of the extremes, m.
        travel: f64,
    },
    /// The point of the load runs through infinity, as behind guides that turn parallel.
    InfiniteStroke {
        /// The load.
        name: Text,
        /// Where the point is at infinity, rad or m.
        coordinate: f64,
    },
    /// The formula of the load has no value in a state, or one beyond the range of loads.
    NotFinite {
        /// The load.
        name: Text,
        /// Coordinate of the state, rad or m.
        coordinate: f64,
    },
    /// A jump or bend of a formula can't be found before an integrator steps over it.
    Unlocated {
        /// The load.
        name: Text,
        /// The function that jumps or bends.
        function: String,
        /// Where it stands in the formula, from 1.
        column: usize,
    },
    /// Where the sliding of a contact turns can't be found before an integrator steps over it (the contact).
    UnlocatedSliding(Text),
    /// A formula changes too often for its changes to be followed.
    ChangesTooOften {
        /// The load.
        name: Text,
        /// The function that jumps or bends.
        function: String,
        /// Where it stands in the formula, from 1.
        column: usize,
        /// Most changes in a cycle.
        most: usize,
    },
    /// The stroke can't be found because the mechanism can't take a position of the cycle.
    NoPosition {
        /// The load.
        name: Text,
        /// The reason, from the position solver.
        coordinate: f64,
        /// What the position solver says.
        reason: Text,
    },
}

assur_words::errors!(LoadError);

impl Describe for LoadError {
    fn describe(&self) -> Text {
        let at = |coordinate: f64| number(format_args!("{coordinate:.9}"));
        match self {
            Self::NeedsMotion { name, what } => {
                text!("force-load-needs-motion", load = name, what = what)
            }
            Self::StrokeOfMoment(name) => text!("force-stroke-of-moment", load = name),
            Self::NoStroke { name, travel } => {
                text!("force-no-stroke", load = name, travel = quantity(format_args!("{travel:.3e}"), "m"))
            }
            Self::InfiniteStroke { name, coordinate } => {
                text!("force-infinite-stroke", load = name, coordinate = at(*coordinate))
            }
            Self::NotFinite { name, coordinate } => {
                text!("force-not-finite", load = name, coordinate = at(*coordinate))
            }
            Self::Unlocated { name: load, function, column } => {
                text!("force-unlocated", load = load, function = name(function.clone()), column = *column)
            }
            Self::UnlocatedSliding(load) => text!("force-unlocated-sliding", load = load),
            Self::ChangesTooOften { name: load, function, column, most } => text!(
                "force-changes-too-often",
                load = load,
                function = name(function.clone()),
                column = *column,
                most = *most
            ),
            Self::NoPosition { name, coordinate, reason } => {
                text!("force-no-position", load = name, coordinate = at(*coordinate), cause = reason)
            }
        }
    }
}

impl LoadError {
    /// The key of the scene that the error concerns, step by step; an element of a list is given by its number.
    pub fn key(&self, mechanism: &Mechanism) -> Option<Vec<String>> {
        let (name, of_size) = match self {
            Self::NeedsMotion { name, .. } => (name, false),
            Self::StrokeOfMoment(name)
            | Self::NoStroke { name, .. }
            | Self::InfiniteStroke { name, .. }
            | Self::NotFinite { name, .. }
            | Self::Unlocated { name, .. }
            | Self::UnlocatedSliding(name)
            | Self::ChangesTooOften { name, .. }
            | Self::NoPosition { name, .. } => (name, true),
        };
        let (list, index, size) = place(name, mechanism)?;
        let size = of_size.then(|| size.to_owned());
        Some([list.to_owned(), index.to_string()].into_iter().chain(size).collect())
    }
}

/// Where the scene has a load: its list, its number there, and the key that gives its size.
fn place(name: &Text, mechanism: &Mechanism) -> Option<(&'static str, usize, &'static str)> {
    let Mechanism { forces, moments, springs, contacts, .. } = mechanism;
    let named = |other: &Name| Text::from(other) == *name;
    // A brake is a moment of the mechanism, and has a list of its own in the scene.
    let brakes = || moments.iter().filter(|moment| moment.brake.is_some());
    let others = || moments.iter().filter(|moment| moment.brake.is_none());
    let contact = |index: usize| {
        let found = &contacts[index];
        let varies = |value: &Value| !matches!(value, Value::Constant(_));
        let part = if varies(&found.angle) && !varies(&found.force) { "angle" } else { "force" };
        ("contact", index, part)
    };
    let force = forces.iter().position(|one| named(&one.name)).map(|index| ("force", index, "value"));
    force
        .or_else(|| others().position(|one| named(&one.name)).map(|index| ("moment", index, "value")))
        .or_else(|| brakes().position(|one| named(&one.name)).map(|index| ("brake", index, "force")))
        .or_else(|| springs.iter().position(|one| named(&one.name)).map(|index| ("spring", index, "damping")))
        .or_else(|| contacts.iter().position(|one| named(&one.name)).map(contact))
}
