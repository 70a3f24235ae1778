//! Reduction to a point of the input link instead of to the link (E eqs. 4-6).

use assur_number::elementary;
use serde::Serialize;

use crate::{InputPair, Mechanism, Named, PointId};

/// A point of the input link to which all loads are reduced as one force and all links as one mass.
///
/// With PF1 of the point of the size r, vA = r w: F = sum(P v cos α)/vA = Q/r and m = sum(m (vS/vA)² + IS (w/vA)²) = J/r².
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReductionPoint {
    /// The point; results have its name.
    #[serde(rename = "name")]
    pub point: Named<PointId>,
    /// r: its distance from the pin of the input link, m; 1 for a sliding one.
    pub radius: f64,
}

impl ReductionPoint {
    /// The named point of the input link farthest from its pin; of equal ones, the first of the scene. `None` where every point
    /// lies at the pin, and where two moving links are driven.
    pub fn farthest(mechanism: &Mechanism) -> Option<Self> {
        let link = mechanism.input.crank()?;
        let pin = match mechanism.input.first().pair {
            InputPair::Pin(pin) => Some(mechanism.place_in(pin, link)?),
            InputPair::Slide(_) => None,
        };
        let radius = |[x, y]: [f64; 2]| pin.map_or(1.0, |pin| elementary::hypot(x - pin[0], y - pin[1]));
        let points = 0..mechanism.points.len();
        let all = points.filter_map(|point| Some((point, radius(mechanism.place_in(point, link)?))));
        let apart = all.filter(|(_, radius)| *radius > 0.0);
        let farthest = apart.reduce(|best, next| if next.1 > best.1 { next } else { best });
        farthest.map(|(point, radius)| Self { point: mechanism.named_point(point), radius })
    }
}
