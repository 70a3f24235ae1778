//! Errors in compiling a mechanism and in calculating a position.

use assur_group::{BuildError, GroupError};
use assur_mechanism::{Key, Name};
use assur_structure::StructureError;
use assur_words::{CoordinateKind, Describe, Text, joined, list, name, text};

/// Why a mechanism can't be compiled.
#[derive(Clone, PartialEq)]
pub enum CompileError {
    /// The mechanism can't be decomposed into groups.
    Structure(StructureError),
    /// A group whose kind can't list its assemblies has no places to begin with.
    NoStart {
        /// The group.
        group: Box<Text>,
        /// Its points that `[assembly]` should place.
        points: Vec<String>,
    },
    /// The lengths don't form a group of the kind.
    Build {
        /// The group.
        group: Box<Text>,
        /// What is wrong.
        source: BuildError,
        /// The link that is at fault, where it is one.
        link: Option<String>,
    },
}

impl CompileError {
    /// The key of the scene that the error concerns, if it is about a link.
    pub fn key(&self) -> Option<Key> {
        match self {
            Self::Structure(error) => Some(Key::of("link").at(error.link()?)),
            Self::NoStart { .. } => Some(Key::of("assembly")),
            Self::Build { link, .. } => Some(Key::of("link").at(link.as_deref()?).at("points")),
        }
    }
}

/// Why there is no position at a coordinate.
#[derive(Clone, PartialEq)]
pub struct PositionError {
    /// Index of the group.
    pub group: usize,
    /// The group in words: `group 1 (RRR rod, rocker)`.
    pub group_name: Box<Text>,
    /// Number of the position, if the coordinate is that of a position of the scene.
    pub index: Option<usize>,
    /// The coordinate, rad or m.
    pub coordinate: f64,
    /// What the coordinate is.
    pub kind: CoordinateKind,
    /// Why the group has no solution.
    pub source: GroupError,
    /// The range around the first position in which the mechanism can be assembled, rad or m, in increasing order;
    /// `None` if it can't be assembled in the first position.
    pub range: Option<[f64; 2]>,
    /// The values of the coordinate nearest to that of the first position with which the mechanism could be assembled, where it can't be
    /// there and they were found.
    pub elsewhere: Option<Box<[f64; 2]>>,
    /// A slide of the group whose guide goes through the origin of its link, which is so where a scene does not say through what:
    /// the slide and that link.
    pub by_default: Option<Box<[Name; 2]>>,
    /// Two slides of one link of a singular group whose guides are always parallel.
    pub parallel: Option<Box<[Name; 2]>>,
}

/// Gaps above this suggest a length written without its unit, m.
const VAST: f64 = 10.0;

impl PositionError {
    /// A coordinate in the units of messages: degrees or millimeters.
    fn show(&self, coordinate: f64) -> Text {
        assur_words::coordinate(coordinate, self.kind, 4)
    }
}

assur_words::errors!(PositionError);
assur_words::errors!(CompileError; Structure(StructureError));

impl Describe for CompileError {
    fn describe(&self) -> Text {
        match self {
            Self::Structure(error) => error.describe(),
            Self::NoStart { group, points } => text!(
                "kinematics-no-start",
                group = Text::clone(group),
                points = list(points.iter().map(|point| name(point.clone())))
            ),
            Self::Build { group, source, .. } => joined(": ", [Text::clone(group), source.describe()]),
        }
    }
}

impl Describe for PositionError {
    fn describe(&self) -> Text {
        if let Some([one, other]) = self.parallel.as_deref() {
            let group = Text::clone(&self.group_name);
            return text!("kinematics-parallel-guides", group, one, other);
        }
        let number = self.index.map(|index| text!("kinematics-position", number = index));
        let at = text!(
            if self.kind.is_time() { "kinematics-time" } else { "kinematics-coordinate" },
            coordinate = self.show(self.coordinate),
            cause = self.source.describe()
        );
        let place = list([Text::clone(&self.group_name)].into_iter().chain(number).chain([at]));
        let range = if let Some([low, high]) = self.range {
            text!("kinematics-range", low = self.show(low), high = self.show(high))
        } else {
            let is_vast = matches!(self.source, GroupError::NoAssembly { gap_m } if gap_m >= VAST);
            let units = if is_vast { text!("kinematics-units") } else { Text::default() };
            text!(
                if self.kind.is_time() { "kinematics-no-range-over-time" } else { "kinematics-no-range" },
                units
            )
        };
        let guide = self.by_default.as_ref().filter(|_| self.range.is_none());
        let guide = guide.map(|guide| text!("kinematics-through-origin", slide = &guide[0], on = &guide[1]));
        let elsewhere = self
            .elsewhere
            .as_deref()
            .map(|&[low, high]| text!("kinematics-elsewhere", low = self.show(low), high = self.show(high)));
        joined("; ", [place, range].into_iter().chain(elsewhere).chain(guide))
    }
}
