//! The geometry of the motion as data that serializes itself.

use assur_mechanism::{CoordinateKind, LinkId, Name, Named};
use assur_words::Text;
use indexmap::IndexMap;
use serde::Serialize;

use crate::{Centers, Curvature, Extremes, Stroke};

/// Values of links, points or slides, in the order of the scene.
pub(crate) type Each<T> = IndexMap<Named<usize>, T>;

/// The geometry of the motion of a mechanism over its cycle. Coordinates in rad (sliding input: m).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Geometry {
    /// Version of the format.
    pub format: u32,
    /// Title of the scene.
    pub title: Name,
    /// Whether coordinates are angles, rad; otherwise m, or s over time.
    #[serde(rename = "angular")]
    pub kind: CoordinateKind,
    /// The link from which the centers are seen; `ground` for absolute ones.
    pub against: Named<LinkId>,
    /// Links that form a rigid part with that one over the whole cycle, by their dimensions or by the structure: they have no
    /// centers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub rigid: Vec<Named<LinkId>>,
    /// Moving links.
    pub links: Each<PartCourse>,
    /// Points that move.
    pub points: Each<PartCourse>,
    /// Slides.
    pub slides: Each<PartCourse>,
    /// The angle of each group that shows how well it transmits forces, by the name of the group.
    pub groups: IndexMap<Text, ForceAngles>,
    /// What belongs to one position of the scene.
    pub positions: Vec<AtPosition>,
}

/// A link, slide or point over the cycle.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct PartCourse {
    /// Of a link: whole turns over the cycle, counter-clockwise positive; `None` for one that does not return to its angle with
    /// a whole turn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turns: Option<f64>,
    /// Of a point: extremes of its x, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x: Option<Extremes>,
    /// Of a point: extremes of its y, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<Extremes>,
    /// Extremes of the angle of a link, rad, or of the displacement of a slide, m; `None` for a link that turns, and for a point.
    #[serde(flatten)]
    pub pf0: Option<Extremes>,
    /// Its stroke or swing; `None` if it does not go to and fro. That of a point is between dead points, at which it rests and
    /// returns along its path.
    #[serde(flatten)]
    pub stroke: Option<Stroke>,
    /// Extremes of the first derivative of its angle or displacement, or of the magnitude of PF1 of a point.
    pub pf1: Extremes,
    /// Extremes of the second derivative, or of the magnitude of PF2.
    pub pf2: Extremes,
    /// Coordinates at which it rests, a link as a whole, rad or m.
    pub rests: Vec<f64>,
    /// Of a link: whether it rests over the whole cycle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rests_always: Option<bool>,
}

/// The angle that shows how well a group transmits forces, over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ForceAngles {
    /// What the angle is: `transmission angle between the links`.
    pub what: Text,
    /// Its extremes, rad.
    #[serde(flatten)]
    pub extremes: Extremes,
}

/// What belongs to one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AtPosition {
    /// Number of the position.
    pub index: usize,
    /// Its coordinate, rad or m.
    pub coordinate: f64,
    /// Centers of the links, in the frame of [`Geometry::against`].
    pub links: Each<Centers>,
    /// Curvature of the paths of points; a point that rests is left out.
    pub points: Each<Curvature>,
    /// Force angles of the groups, rad, in the order of [`Geometry::groups`].
    pub angles: Vec<f64>,
}
