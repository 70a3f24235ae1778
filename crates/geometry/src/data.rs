//! The geometry of the motion as data that serializes itself.

use assur_mechanism::{LinkId, Named};
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
    pub title: String,
    /// Whether coordinates are angles, rad; otherwise m.
    pub angular: bool,
    /// The link from which the centers are seen; `ground` for absolute ones.
    pub against: Named<LinkId>,
    /// Links that form a rigid part with that one over the whole cycle, by their dimensions or by the structure: they have no
    /// centers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub rigid: Vec<Named<LinkId>>,
    /// Moving links.
    pub links: Each<LinkCourse>,
    /// Points that move.
    pub points: Each<PointCourse>,
    /// Slides.
    pub slides: Each<SlideCourse>,
    /// The angle of each group that shows how well it transmits forces, by the name of the group.
    pub groups: IndexMap<Text, ForceAngles>,
    /// What belongs to one position of the scene.
    pub positions: Vec<AtPosition>,
}

/// Some links, slides and points over the cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct PartCourses {
    /// The links.
    pub links: Vec<LinkCourse>,
    /// The slides.
    pub slides: Vec<SlideCourse>,
    /// The points.
    pub points: Vec<PointCourse>,
}

/// A link over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LinkCourse {
    /// Whole turns over the cycle, counter-clockwise positive; `None` for a link that does not return to its angle with a
    /// whole turn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turns: Option<f64>,
    /// Extremes of its angle, rad; `None` for a link that turns.
    #[serde(flatten)]
    pub pf0: Option<Extremes>,
    /// Its swing; `None` for a link that does not rock.
    #[serde(flatten)]
    pub stroke: Option<Stroke>,
    /// Extremes of the first derivative of its angle.
    pub pf1: Extremes,
    /// Extremes of the second derivative of its angle.
    pub pf2: Extremes,
    /// Coordinates at which the whole link rests, rad or m.
    pub rests: Vec<f64>,
    /// Whether it rests over the whole cycle.
    pub rests_always: bool,
}

/// A slide over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SlideCourse {
    /// Extremes of its displacement, m.
    #[serde(flatten)]
    pub pf0: Extremes,
    /// Its stroke; `None` if it does not go to and fro.
    #[serde(flatten)]
    pub stroke: Option<Stroke>,
    /// Extremes of the first derivative of its displacement.
    pub pf1: Extremes,
    /// Extremes of the second derivative of its displacement.
    pub pf2: Extremes,
    /// Coordinates at which it rests, rad or m.
    pub rests: Vec<f64>,
}

/// A point over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PointCourse {
    /// Extremes of its x, m.
    pub x: Extremes,
    /// Extremes of its y, m.
    pub y: Extremes,
    /// Its stroke, if it has dead points, at which it rests and returns along its path.
    #[serde(flatten)]
    pub stroke: Option<Stroke>,
    /// Extremes of the magnitude of PF1.
    pub pf1: Extremes,
    /// Extremes of the magnitude of PF2.
    pub pf2: Extremes,
    /// Coordinates at which it rests, rad or m.
    pub rests: Vec<f64>,
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
