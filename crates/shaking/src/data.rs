//! Shaking force and counterweights as data that serializes itself.

use assur_force::{LoadError, LoadFault};
use assur_kinematics::PositionError;
use assur_mechanism::{CoordinateKind, Key, LinkId, Mechanism, Name, Named};
use assur_words::{Describe, Text, text};
use serde::Serialize;

/// Shaking force and moment of a mechanism over its cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Shaking {
    /// Version of the format.
    pub format: u32,
    /// Title of the scene.
    pub title: Name,
    /// Whether coordinates are angles, rad; otherwise m, or s over time.
    #[serde(rename = "angular")]
    pub kind: CoordinateKind,
    /// Sizes without counterweights.
    pub before: Size,
    /// Harmonics without counterweights, from order 0.
    pub harmonics: Vec<Harmonic>,
    /// Counterweights, by the links that carry them and by criterion; empty where no link turns about the ground.
    pub balances: Vec<Balanced>,
    /// The positions of the scene.
    pub positions: Vec<AtPosition>,
}

/// How large shaking force and moment are over the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Size {
    /// Greatest magnitude of the force, N, found between positions.
    pub greatest_force: f64,
    /// Root of the mean square of the force over the coordinate, N.
    pub rms_force: f64,
    /// Greatest moment about the origin by absolute value, N m, found between positions.
    pub greatest_moment: f64,
    /// Root of the mean square of the moment over the coordinate, N m.
    pub rms_moment: f64,
}

/// One harmonic: the factors of cos(k q) and sin(k q), where k q makes `order` whole turns in a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Harmonic {
    /// Number of periods in a cycle; 0: the mean, without factor of the sine.
    pub order: usize,
    /// Of the force along x, N.
    pub x: [f64; 2],
    /// Of the force along y, N.
    pub y: [f64; 2],
    /// Of the moment about the origin, N m.
    pub moment: [f64; 2],
    /// Of the torque (sliding input: force) that the input needs for the motion under all loads, N m (N).
    pub torque: [f64; 2],
}

/// What a counterweight is to make least.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// The mean square of the shaking force.
    LeastSquares,
    /// The greatest magnitude of the shaking force.
    LeastMaximum,
}

/// The mechanism with counterweights on some links.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Balanced {
    /// What is least.
    pub criterion: Criterion,
    /// The counterweights.
    pub counterweights: Vec<Counterweight>,
    /// Sizes with them.
    pub after: Size,
    /// Where the greatest magnitude is made least: the proof that no counterweights on these links make it less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<Proof>,
}

/// How far a greatest force is from the least possible one.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Proof {
    /// No counterweights on these links make the greatest force less, N: the value of the dual problem.
    pub bound: f64,
    /// Duality gap: the excess of the greatest force over the bound, relative to the bound. A force that a complete balance has left, less
    /// than 1/1000 of the sum of the inertia loads, is compared with that instead, since its rounding is no gap.
    pub gap: f64,
}

/// A point mass fixed to a link that turns about the ground.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Counterweight {
    /// The link.
    pub link: Named<LinkId>,
    /// Mass times radius, kg m.
    pub product: f64,
    /// Its direction from the pin on the ground, in the frame of the link, rad.
    pub angle: f64,
    /// Radius at which it is put: the greatest distance of a point of the link from its pin, m.
    pub radius: f64,
    /// Mass at this radius, kg.
    pub mass: f64,
}

/// One position of the scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AtPosition {
    /// Number of the position.
    pub index: usize,
    /// Its coordinate, rad or m.
    pub coordinate: f64,
    /// Shaking force without counterweights, N.
    pub force: [f64; 2],
    /// Shaking moment about the origin without counterweights, N m.
    pub moment: f64,
    /// Torque (sliding input: force) that the input needs for the motion under all loads, N m (N).
    pub torque: f64,
    /// Shaking force with the counterweights of each of [`Shaking::balances`], N.
    pub balanced: Vec<[f64; 2]>,
}

/// Why the shaking force of a scene is not found.
pub enum ShakingError {
    /// The positions are no closed cycle.
    NoCycle,
    /// The motion goes by laws over time.
    OverTime,
    /// Nothing moves.
    NoMotion,
    /// No link has a mass.
    NoMass,
    /// A load can't be compiled.
    Load(LoadError),
    /// A position of the cycle has no solution.
    Position(PositionError),
}

assur_words::errors!(ShakingError; Load(LoadError), Position(PositionError));

impl Describe for ShakingError {
    fn describe(&self) -> Text {
        match self {
            Self::NoCycle => text!("shaking-no-cycle"),
            Self::OverTime => text!("shaking-over-time"),
            Self::NoMotion => text!("shaking-no-motion"),
            Self::NoMass => text!("shaking-no-mass"),
            Self::Load(error) => error.describe(),
            Self::Position(error) => error.describe(),
        }
    }
}

impl ShakingError {
    /// The key of the scene that the error concerns; `None` where it concerns a position.
    pub fn key(&self, mechanism: &Mechanism) -> Option<Key> {
        match self {
            Self::NoCycle => Some(Key::of("input").at("to")),
            Self::NoMotion if mechanism.motion.is_some() => Some(Key::of("motion").at("kind")),
            Self::NoMotion | Self::OverTime => Some(Key::of("input")),
            Self::NoMass => Some(Key::of("link")),
            Self::Load(error) => error.key(mechanism),
            Self::Position(_) => None,
        }
    }

    /// Whether the machine has no solution, though the scene is sound.
    pub fn is_no_solution(&self) -> bool {
        matches!(self, Self::Position(_) | Self::Load(LoadError { fault: LoadFault::NotFinite(_), .. }))
    }
}
