//! Angles of links without jumps from position to position.

use std::f64::consts::PI;

use assur_group::Order;
use assur_kinematics::{Linkage, Position, continuous_angle};
use assur_mechanism::LinkId;

/// Longest step of the coordinate, rad (or parts of the scale for a sliding input), between two angles that are joined:
/// a link turns less than half a turn in it unless it turns sixty times as fast as the input.
const LONGEST_STEP: f64 = 0.05;

/// Follows the angles of all links along the coordinate.
#[derive(Debug)]
pub(crate) struct Angles {
    /// Coordinate and angles of the last position; none before the first.
    last: Option<(f64, Vec<f64>)>,
    scratch: Position,
}

impl Angles {
    pub(crate) fn new(linkage: &Linkage) -> Self {
        Self { last: None, scratch: linkage.position() }
    }

    /// The angles in a solved position, rad: in (-pi, pi] at first, then continuous.
    ///
    /// Between distant positions the mechanism is solved at intermediate coordinates; where one can't be assembled, the
    /// nearest angle is used. `None` where no link is requested.
    pub(crate) fn follow(&mut self, linkage: &Linkage, position: &Position, wanted: &[LinkId]) -> &[f64] {
        if wanted.is_empty() {
            return &[];
        }
        let unit = linkage.coordinate_unit();
        let mut angles = match self.last.take() {
            None => position.bodies.iter().map(|body| first(body.s.atan2(body.c))).collect(),
            Some((from, mut angles)) => {
                let way = position.coordinate - from;
                let steps = steps(way / unit);
                for step in 1..steps {
                    let between = from + way * (f64::from(step) / f64::from(steps));
                    if linkage.solve(between, Order::Place, &mut self.scratch).is_ok() {
                        join(&mut angles, &self.scratch);
                    }
                }
                angles
            }
        };
        join(&mut angles, position);
        &self.last.insert((position.coordinate, angles)).1
    }
}

/// Number of steps for a change of the coordinate, limited for very large changes.
fn steps(way: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and 10000")]
    let steps = (way.abs() / LONGEST_STEP).ceil().clamp(1.0, 1e4) as u32;
    steps
}

/// -pi becomes pi.
fn first(angle: f64) -> f64 {
    if angle <= -PI { PI } else { angle }
}

/// Replaces each angle by the equivalent one that is nearest to the one before.
fn join(angles: &mut [f64], position: &Position) {
    for (angle, body) in angles.iter_mut().zip(&position.bodies) {
        *angle = continuous_angle(body.s.atan2(body.c), *angle);
    }
}
