//! What was found in one position.

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use std::sync::Arc;

use crate::results::{ByCause, Named};

/// PF0, PF1, PF2 of an angle (rad) or a displacement (m): the value and its derivatives by the coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Derivatives {
    /// The value.
    pub pf0: f64,
    /// First derivative by the coordinate.
    pub pf1: f64,
    /// Second derivative by the coordinate.
    pub pf2: f64,
}

/// PF0, PF1, PF2 of a point, m and its derivatives by the coordinate, in the ground's frame.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Transfer {
    /// Place, m.
    pub pf0: [f64; 2],
    /// First derivative by the coordinate.
    pub pf1: [f64; 2],
    /// Second derivative by the coordinate.
    pub pf2: [f64; 2],
}

/// Derivatives by time of one order (velocities or accelerations).
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Rates {
    /// Of the angles of links, rad/s or rad/s².
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub links: Named<f64>,
    /// Of points, m/s or m/s².
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub points: Named<[f64; 2]>,
    /// Of the displacements of slides, m/s or m/s².
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub slides: Named<f64>,
}

/// All moving links reduced to the input coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Reduced {
    /// J, kg m² (kg for a sliding input).
    pub inertia: f64,
    /// dJ/dq.
    pub inertia_derivative: f64,
    /// Q, N m (N): of all loads but the balancing one; no inertia.
    pub moment: f64,
}

/// The forces in one pin or slide.
///
/// Serializes to a map: link to force, and `moment` for a slide.
#[derive(Debug, Clone, PartialEq)]
pub struct PairReaction {
    /// The force that the pair exerts on each link that it joins, N, ground's frame; they sum to zero.
    pub forces: Vec<(Arc<str>, [f64; 2])>,
    /// Slides: the moment on the sliding link about its point, N m.
    pub moment: Option<f64>,
    /// Slides: where along the guide, from the point of the sliding link in the guide's direction, the force alone
    /// would do the same, m; `None` for a pin and where there is no force.
    pub offset: Option<f64>,
}

impl Serialize for PairReaction {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (link, force) in &self.forces {
            map.serialize_entry(&**link, force)?;
        }
        if let Some(moment) = self.moment {
            map.serialize_entry("moment", &moment)?;
        }
        map.end()
    }
}

/// One position of the input, numbered from 0.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PositionResult {
    /// Number of the position.
    pub index: usize,
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Its speed, with a motion, rad/s or m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Its acceleration, with a motion, rad/s² or m/s².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<f64>,
    /// Angles of the moving links, continuous over the positions.
    pub links: Named<Derivatives>,
    /// Named points.
    pub points: Named<Transfer>,
    /// Displacements of the slides.
    pub slides: Named<Derivatives>,
    /// First derivatives by time, with a motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocities: Option<Rates>,
    /// Second derivatives by time, with a motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accelerations: Option<Rates>,
    /// Reduction to the input link.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduced: Option<Reduced>,
    /// Reactions by pin or slide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reactions: Option<Named<PairReaction>>,
    /// The balancing moment (N m) or force (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balancing: Option<f64>,
    /// Reactions and balancing load by cause, where they were asked for.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub by_cause: Option<ByCause>,
    /// By index of the group: 1 / |dimensionless determinant|, how near it is to a singular position.
    pub condition: Named<f64>,
}
