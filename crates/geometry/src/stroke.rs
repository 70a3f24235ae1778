//! The stroke of a quantity that goes to and fro.

use assur_mechanism::{Mechanism, Motion};
use serde::Serialize;

use crate::course::Rest;

/// The stroke of a slide, of a rocking link, or of a point that goes to and fro on its path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stroke {
    /// Displacement between the dead points, m; of a link its angle of swing, rad; of a point the distance between its
    /// farthest dead points, m.
    pub stroke: f64,
    /// Coordinates of the dead points, where the motion reverses, rad or m, in the order of the motion.
    pub dead_points: Vec<f64>,
    /// For two dead points in a closed cycle: the intervals of the coordinate from the first to the second and from the
    /// second to the first, rad or m, positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub intervals: Option<[f64; 2]>,
    /// The longer interval over the shorter one: the ratio of the times of the two strokes at constant input speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_ratio: Option<f64>,
    /// Angle of overlap: half the difference of the intervals, rad or m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub overlap: Option<f64>,
    /// Mean speeds over the two intervals for a prescribed constant input speed, m/s or rad/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_speeds: Option<[f64; 2]>,
}

impl Stroke {
    /// From the positions of rest of a quantity; `None` where it does not go to and fro. `size` gives the stroke.
    pub(crate) fn of(
        rests: &[Rest],
        period: Option<f64>,
        mechanism: &Mechanism,
        size: impl FnOnce(&[f64]) -> f64,
    ) -> Option<Self> {
        let dead = rests.iter().filter(|rest| rest.reverses).map(|rest| rest.coordinate);
        let dead_points: Vec<f64> = dead.collect();
        if dead_points.len() < 2 {
            return None;
        }
        let stroke = size(&dead_points);
        let intervals = match (period, dead_points.as_slice()) {
            (Some(period), [first, second]) => {
                let out = (second - first).abs();
                Some([out, period - out])
            }
            _ => None,
        };
        let ordered = intervals.map(|[out, back]| [out.max(back), out.min(back)]);
        let speed = match mechanism.motion {
            Some(Motion::Prescribed { speed, acceleration: 0.0 }) if speed != 0.0 => Some(speed.abs()),
            _ => None,
        };
        Some(Self {
            stroke,
            dead_points,
            intervals,
            time_ratio: ordered.map(|[long, short]| long / short),
            overlap: ordered.map(|[long, short]| 0.5 * (long - short)),
            mean_speeds: intervals.zip(speed).map(|(ways, speed)| ways.map(|way| stroke * speed / way)),
        })
    }
}
