//! What is wrong with the loads of a mechanism.

use assur_mechanism::{Mechanism, Value};

/// Why loads can't be compiled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// The load has no size without a motion.
    #[error("load `{name}`: {what} needs a motion; add `[motion]` with a speed")]
    NeedsMotion {
        /// The load.
        name: String,
        /// The part of the load that needs a motion.
        what: &'static str,
    },
    /// A moment acts at no point, so it has no stroke (the load).
    #[error(
        "moment `{0}` follows a stroke, but a moment has no point that could move; use a table over the angle"
    )]
    StrokeOfMoment(String),
    /// The point of the load stands still along the axis.
    #[error(
        "load `{name}` follows a stroke, but its point moves only {travel:.3e} m along the axis; turn the axis"
    )]
    NoStroke {
        /// The load.
        name: String,
        /// Distance of the extremes, m.
        travel: f64,
    },
    /// The point of the load runs through infinity, as behind guides that turn parallel.
    #[error(
        "load `{name}` follows a stroke, but near coordinate {coordinate:.9} its point is at infinity, since guides turn parallel there; calculate a range without that, or turn the axis"
    )]
    InfiniteStroke {
        /// The load.
        name: String,
        /// Where the point is at infinity, rad or m.
        coordinate: f64,
    },
    /// The formula of the load has no finite value in a state.
    #[error(
        "load `{name}` has no finite value at coordinate {coordinate:.9}: its formula divides by zero or outgrows all numbers there"
    )]
    NotFinite {
        /// The load.
        name: String,
        /// Coordinate of the state, rad or m.
        coordinate: f64,
    },
    /// A jump or bend of a formula can't be found before an integrator steps over it.
    #[error(
        "load `{name}`: the argument of `{function}` (character {column} of the formula) mixes coordinate, speed, time and place, \
         so its changes can't be found in advance in a motion that is calculated; let it depend on one of q, w, t (or on x and \
         what repeats with the cycle)"
    )]
    Unlocated {
        /// The load.
        name: String,
        /// The function that jumps or bends.
        function: String,
        /// Where it stands in the formula, from 1.
        column: usize,
    },
    /// Where the sliding of a contact turns can't be found before an integrator steps over it (the contact).
    #[error(
        "contact `{0}`: its friction is against the sliding, but its angle does not repeat with the cycle of the input, so where the \
         sliding turns can't be found in advance in a motion that is calculated; let the angle repeat with the cycle"
    )]
    UnlocatedSliding(String),
    /// A formula changes too often for its changes to be followed.
    #[error(
        "load `{name}`: the argument of `{function}` (character {column} of the formula) passes zero too often: a formula may have \
         {most} jumps and bends in a cycle"
    )]
    ChangesTooOften {
        /// The load.
        name: String,
        /// The function that jumps or bends.
        function: String,
        /// Where it stands in the formula, from 1.
        column: usize,
        /// Most changes in a cycle.
        most: usize,
    },
    /// The stroke can't be found because the mechanism can't take a position of the cycle.
    #[error(
        "load `{name}` follows a stroke, but the cycle has no position at coordinate {coordinate:.9}: {reason}"
    )]
    NoPosition {
        /// The load.
        name: String,
        /// The reason, from the position solver.
        coordinate: f64,
        /// What the position solver says.
        reason: String,
    },
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
fn place(name: &str, mechanism: &Mechanism) -> Option<(&'static str, usize, &'static str)> {
    let Mechanism { forces, moments, springs, contacts, .. } = mechanism;
    let named = |other: &str| other == name;
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
