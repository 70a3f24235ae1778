//! Reduction to a point of the input link instead of to the link (E eqs. 4-6).

use assur_mechanism::{InputPair, Mechanism, PointId};

/// A point of the input link at which a force and a mass stand for all loads and all links.
///
/// With PF1 of the point of the size r, vA = r w: F = sum(P v cos α)/vA = Q/r and m = sum(m (vS/vA)² + IS (w/vA)²) = J/r².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReductionPoint {
    /// The point.
    pub point: PointId,
    /// r: its distance from the pin of the input link, m; 1 for a sliding one.
    pub radius: f64,
}

impl ReductionPoint {
    /// A named point of the input link; `None` if it is none, or lies at the pin.
    pub fn at(mechanism: &Mechanism, point: PointId) -> Option<Self> {
        let input = &mechanism.input;
        let place = mechanism.place_in(point, input.link)?;
        let radius = match input.pair {
            InputPair::Pin(pin) => {
                let pin = mechanism.place_in(pin, input.link)?;
                (place[0] - pin[0]).hypot(place[1] - pin[1])
            }
            InputPair::Slide(_) => 1.0,
        };
        (radius > 0.0).then_some(Self { point, radius })
    }

    /// The named point of the input link farthest from its pin; of equal ones, the first of the scene.
    pub fn farthest(mechanism: &Mechanism) -> Option<Self> {
        let all = (0..mechanism.points.len()).filter_map(|point| Self::at(mechanism, point));
        all.reduce(|best, next| if next.radius > best.radius { next } else { best })
    }

    /// The force F, N, at the point, positive along its motion when the coordinate grows, that has the power of the
    /// reduced moment Q (N m).
    pub fn force(&self, moment: f64) -> f64 {
        moment / self.radius
    }

    /// The mass m, kg, at the point that has the kinetic energy of the reduced inertia J (kg m²).
    pub fn mass(&self, inertia: f64) -> f64 {
        inertia / (self.radius * self.radius)
    }
}
