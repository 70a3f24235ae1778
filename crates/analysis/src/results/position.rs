//! The results of one position.

use std::sync::Arc;

use assur_integrator::Reduced;
use assur_kinematics::{PointMotion, ScalarMotion};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use crate::results::{ByCause, Named};

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

/// The forces in one pin or slide.
///
/// Serializes to a map: link to force, and `moment` for a slide.
#[derive(Debug, Clone, PartialEq)]
pub struct PairReaction {
    /// The force that the pair exerts on each link that it joins, N, ground's frame; they sum to zero.
    pub forces: Vec<(Arc<str>, [f64; 2])>,
    /// Slides: the moment on the sliding link about its point, N m.
    pub moment: Option<f64>,
    /// Slides: where along the guide, from the point of the sliding link in the guide's direction, the force alone is
    /// equivalent, m; `None` for a pin and where there is no force.
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
    pub links: Named<ScalarMotion>,
    /// Named points.
    pub points: Named<PointMotion>,
    /// Displacements of the slides.
    pub slides: Named<ScalarMotion>,
    /// First derivatives by time, with a motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocities: Option<Rates>,
    /// Second derivatives by time, with a motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accelerations: Option<Rates>,
    /// The inertia of all moving links and their loads, reduced to the input coordinate; no motor, no flywheel, no
    /// balancing load.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduced: Option<Reduced>,
    /// Reactions by pin or slide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reactions: Option<Named<PairReaction>>,
    /// The balancing moment (N m) or force (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balancing: Option<f64>,
    /// Reactions and balancing load by cause, if requested.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub by_cause: Option<ByCause>,
    /// By index of the group: 1 / |dimensionless determinant|, how near it is to a singular position.
    pub condition: Named<f64>,
}
