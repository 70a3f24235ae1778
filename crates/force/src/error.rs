//! What is wrong with the loads of a mechanism, and why there are no reactions.

use assur_group::GroupError;
use assur_kinematics::PositionError;
use assur_mechanism::{Key, LoadKind, Mechanism, Value};
use assur_words::{Describe, Text, name, number, quantity, text};

/// A load that can't be compiled, or has no value.
#[derive(Clone, PartialEq)]
pub struct LoadError {
    /// Its name.
    pub load: Text,
    /// Why.
    pub fault: LoadFault,
}

/// Why a load can't be compiled, or has no value.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadFault {
    /// It has no size without a motion; the part of the load that needs one.
    NeedsMotion(Text),
    /// A moment acts at no point, so it has no stroke.
    StrokeOfMoment,
    /// Its point stands still along the axis: distance of the extremes, m.
    NoStroke(f64),
    /// Its point is at infinity at a coordinate, as on guides that become parallel; rad or m.
    InfiniteStroke(f64),
    /// Its formula has no value at a coordinate, or one beyond the range of loads; rad or m.
    NotFinite(f64),
    /// Where the sliding of a contact turns can't be found before an integrator steps over it.
    UnlocatedSliding,
    /// A formula changes too often for its changes to be followed.
    ChangesTooOften {
        /// The function that has a jump or kink.
        function: String,
        /// Where it stands in the formula, from 1.
        column: usize,
        /// Most changes in a cycle.
        most: usize,
    },
    /// The stroke can't be found because the mechanism can't take a position of the cycle, at a coordinate, rad or m.
    NoPosition(f64, Box<PositionError>),
}

assur_words::errors!(LoadError);

impl Describe for LoadError {
    fn describe(&self) -> Text {
        let load = &self.load;
        let at = |coordinate: &f64| number(format_args!("{coordinate:.9}"));
        match &self.fault {
            LoadFault::NeedsMotion(what) => text!("force-load-needs-motion", load, what),
            LoadFault::StrokeOfMoment => text!("force-stroke-of-moment", load),
            LoadFault::NoStroke(travel) => {
                text!("force-no-stroke", load, travel = quantity(format_args!("{travel:.3e}"), "m"))
            }
            LoadFault::InfiniteStroke(coordinate) => {
                text!("force-infinite-stroke", load, coordinate = at(coordinate))
            }
            LoadFault::NotFinite(coordinate) => {
                text!("force-not-finite", load, coordinate = at(coordinate))
            }
            LoadFault::UnlocatedSliding => text!("force-unlocated-sliding", load),
            LoadFault::ChangesTooOften { function, column, most } => text!(
                "force-changes-too-often",
                load,
                function = name(function.clone()),
                column = *column,
                most = *most
            ),
            // The cause names the coordinate.
            LoadFault::NoPosition(_, error) => text!("force-no-position", load, cause = error.describe()),
        }
    }
}

impl LoadError {
    /// The key of the scene that the error concerns.
    pub fn key(&self, mechanism: &Mechanism) -> Option<Key> {
        let loads = &mechanism.loads;
        let found = loads.iter().position(|load| Text::from(&load.name) == self.load)?;
        let key = mechanism.key_of_load(found);
        let varies = |value: &Value| !matches!(value, Value::Constant(_));
        // The key that gives its size.
        let size = match &loads[found].kind {
            LoadKind::Force(_) | LoadKind::Moment(_) => "value",
            LoadKind::Spring(_) => "damping",
            LoadKind::Contact(found) if varies(&found.angle) && !varies(&found.force) => "angle",
            LoadKind::Brake(_) | LoadKind::Contact(_) => "force",
        };
        Some(if matches!(self.fault, LoadFault::NeedsMotion(_)) { key } else { key.at(size) })
    }
}

/// Why there are no reactions. Names the coordinate; the caller adds the number of the position.
#[derive(Clone, PartialEq)]
pub enum ForceError {
    /// Two ways of a group meet there (the coordinate, rad or m).
    ChangePoint(f64),
    /// A group can't be solved.
    Group {
        /// The group in words.
        group: Text,
        /// The coordinate, rad or m.
        coordinate: f64,
        /// The reason, from the group.
        source: GroupError,
    },
    /// A load has no value there, whatever the method.
    Load(LoadError),
    /// The equations of equilibrium of the whole mechanism can't be solved.
    Singular {
        /// The coordinate, rad or m.
        coordinate: f64,
        /// Least over greatest pivot.
        health: f64,
    },
    /// The balancing load does no work in this position, so that it can't balance anything.
    IdleBalance {
        /// The balancing load in words.
        load: Text,
        /// The coordinate, rad or m.
        coordinate: f64,
        /// Its transfer function, dimensionless.
        share: f64,
    },
    /// Two lines that the method intersects are parallel.
    Parallel {
        /// The coordinate, rad or m.
        coordinate: f64,
        /// The two lines in words.
        lines: Text,
        /// Angle between them, rad.
        angle: f64,
        /// A method that has a solution there.
        instead: &'static str,
    },
    /// With friction there is no equilibrium: the mechanism jams, or can't be driven back.
    Jammed {
        /// What has none, in words: a group, the input link, or the balancing load.
        what: Text,
        /// The coordinate, rad or m.
        coordinate: f64,
        /// Whether there is certainly none; else none was found.
        proved: bool,
    },
    /// The method does not support this mechanism.
    Unsupported {
        /// Name of the method.
        analyzer: &'static str,
        /// Why not.
        reason: Text,
    },
}

assur_words::errors!(ForceError; Load(LoadError));

impl Describe for ForceError {
    fn describe(&self) -> Text {
        let at = |coordinate: f64| number(format_args!("{coordinate:.9}"));
        match self {
            Self::ChangePoint(coordinate) => text!("force-change-point", coordinate = at(*coordinate)),
            Self::Group { group, coordinate, source } => {
                text!("force-group-singular", group, coordinate = at(*coordinate), cause = source.describe())
            }
            Self::Load(error) => error.describe(),
            Self::Singular { coordinate, health } => text!(
                "force-singular",
                coordinate = at(*coordinate),
                health = number(format_args!("{health:.3e}"))
            ),
            Self::IdleBalance { load, coordinate, share } => text!(
                "force-idle-balance",
                coordinate = at(*coordinate),
                load,
                share = number(if *share == 0.0 { "0".to_owned() } else { format!("{share:.1e}") })
            ),
            Self::Parallel { coordinate, lines, angle, instead } => text!(
                "force-parallel",
                coordinate = at(*coordinate),
                lines,
                angle = quantity(format_args!("{angle:.3e}"), "rad"),
                instead = name(*instead)
            ),
            Self::Jammed { what, coordinate, proved } => {
                let jammed = if *proved { "force-jammed" } else { "force-jammed-unproved" };
                text!(jammed, what, coordinate = at(*coordinate))
            }
            Self::Unsupported { analyzer, reason } => {
                text!("force-unsupported", method = name(*analyzer), reason)
            }
        }
    }
}
