//! Event location: where a step leaves the bounds of its smooth piece, or meets the requested end.

use assur_number::search::root;

use crate::{Dense, Node, Piece, Request, State, Until};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    CoordinateLow,
    CoordinateHigh,
    SpeedLow,
    SpeedHigh,
}

pub(crate) const SIDES: [Side; 4] =
    [Side::CoordinateLow, Side::CoordinateHigh, Side::SpeedLow, Side::SpeedHigh];

/// The bounds of the smooth piece, narrowed by the requested end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    value: [f64; 4],
    goal: [bool; 4],
}

impl Bounds {
    pub(crate) fn new(piece: &Piece, request: &Request, node: &Node) -> Self {
        let mut bounds = Self {
            value: [piece.coordinate[0], piece.coordinate[1], piece.speed[0], piece.speed[1]],
            goal: [false; 4],
        };
        match request.until {
            Until::Time(_) | Until::Rest => {}
            Until::Coordinate(target) if target < node.state.coordinate => bounds.aim(0, target),
            Until::Coordinate(target) => bounds.aim(1, target),
            Until::Turn => {
                // At rest the acceleration decides on which side the state is.
                let forward = node.state.speed > 0.0 || (node.state.speed == 0.0 && node.acceleration > 0.0);
                bounds.aim(if forward { 2 } else { 3 }, 0.0);
            }
        }
        bounds
    }

    fn aim(&mut self, side: usize, value: f64) {
        let nearer =
            if side.is_multiple_of(2) { value >= self.value[side] } else { value <= self.value[side] };
        if nearer {
            self.value[side] = value;
            self.goal[side] = true;
        }
    }

    pub(crate) fn value(&self, side: Side) -> f64 {
        self.value[side as usize]
    }

    pub(crate) fn is_goal(&self, side: Side) -> bool {
        self.goal[side as usize]
    }

    /// Distance to the bound, positive inside.
    #[inline]
    fn inside(&self, side: Side, state: &State) -> f64 {
        let bound = self.value(side);
        match side {
            Side::CoordinateLow => state.coordinate - bound,
            Side::CoordinateHigh => bound - state.coordinate,
            Side::SpeedLow => state.speed - bound,
            Side::SpeedHigh => bound - state.speed,
        }
    }

    /// Time in which uniformly accelerated motion meets the bound, if it does.
    pub(crate) fn time_to(&self, side: Side, node: &Node) -> Option<f64> {
        let bound = self.value(side);
        if !bound.is_finite() {
            return None;
        }
        let (w, a) = (node.state.speed, node.acceleration);
        match side {
            Side::CoordinateLow | Side::CoordinateHigh => first_root(bound - node.state.coordinate, w, a),
            Side::SpeedLow | Side::SpeedHigh => Some((bound - w) / a).filter(|time| *time > 0.0),
        }
        .filter(|time| time.is_finite())
    }

    /// The state put exactly onto the bound.
    pub(crate) fn snap(&self, side: Side, mut state: State) -> State {
        match side {
            Side::CoordinateLow | Side::CoordinateHigh => state.coordinate = self.value(side),
            Side::SpeedLow | Side::SpeedHigh => state.speed = self.value(side),
        }
        state
    }

    /// Whether the step from `from` to `to` may have left the bounds: a cheap test that may say yes without cause, but
    /// never no.
    #[inline]
    pub(crate) fn may_leave(&self, from: &Node, to: &Node) -> bool {
        let outside = |state: &State| SIDES.iter().any(|side| self.inside(*side, state) < 0.0);
        if outside(&to.state) {
            return true;
        }
        let turned = from.state.speed * to.state.speed < 0.0;
        let swung = from.acceleration * to.acceleration < 0.0;
        let near = |low: f64, high: f64, least: f64, most: f64, reach: f64| {
            least - reach < low || most + reach > high
        };
        let h = to.state.time - from.state.time;
        // An extremum inside the step is no further out than the tangents at its ends reach.
        let reach_w = h * from.acceleration.abs().max(to.acceleration.abs());
        let reach_q = h * from.state.speed.abs().max(to.state.speed.abs()) + h * reach_w;
        let span = |a: f64, b: f64| (a.min(b), a.max(b));
        let (q0, q1) = span(from.state.coordinate, to.state.coordinate);
        let (w0, w1) = span(from.state.speed, to.state.speed);
        (turned && near(self.value[0], self.value[1], q0, q1, reach_q))
            || (swung && near(self.value[2], self.value[3], w0, w1, reach_w))
    }

    /// The bound that a step aimed at it has passed only by rounding: its dense output then ends on the bound itself
    /// and shows no exit.
    pub(crate) fn passed_by_rounding(&self, from: &State, to: &State) -> Option<Side> {
        const ROUNDINGS: f64 = 8.0 * f64::EPSILON;
        SIDES.into_iter().find(|&side| {
            let (before, beyond) = (self.inside(side, from), -self.inside(side, to));
            let size = self.value(side).abs() + before.abs();
            before > 0.0 && beyond > 0.0 && beyond <= ROUNDINGS * size
        })
    }

    /// First instant at which the step leaves the bounds, as θ, and the bound that it crosses.
    pub(crate) fn first_exit(&self, dense: &Dense) -> Option<(f64, Side)> {
        let mut first: Option<(f64, Side)> = None;
        for side in SIDES {
            if !self.value(side).is_finite() {
                continue;
            }
            let before = first.map_or(1.0, |(theta, _)| theta);
            if let Some(theta) = first_negative(|theta| self.inside(side, &dense.at(theta)), before) {
                first = Some((theta, side));
            }
        }
        first
    }
}

/// Smallest positive root of a/2 x² + w x = d: without cancellation.
fn first_root(d: f64, w: f64, a: f64) -> Option<f64> {
    if d == 0.0 {
        return Some(-2.0 * w / a).filter(|x| *x > 0.0);
    }
    let discriminant = w * w + 2.0 * a * d;
    if discriminant < 0.0 {
        return None;
    }
    let k = -0.5 * (w + w.signum() * discriminant.sqrt());
    let roots = [2.0 * k / a, -d / k];
    roots.into_iter().filter(|x| x.is_finite() && *x > 0.0).min_by(f64::total_cmp)
}

/// Instant at which the speed passes through zero inside the step.
pub(crate) fn turning(dense: &Dense) -> f64 {
    let sign = dense.speed[0].signum();
    first_negative(|theta| sign * dense.at(theta).speed, 1.0).unwrap_or(1.0)
}

/// First θ up to `end` at which `g` turns negative. A zero of `g` at θ = 0 (the step starts on the bound) is no exit.
fn first_negative(g: impl Fn(f64) -> f64, end: f64) -> Option<f64> {
    const MESH: [f64; 10] = [1.0 / 64.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1.0];
    let mut inside = 0.0;
    for part in MESH {
        let theta = part * end;
        if g(theta) < 0.0 {
            if inside == 0.0 && g(0.0) <= 0.0 {
                // A θ close to 0 where `g` is positive, for a step that starts on the bound.
                inside =
                    (1..40).map(|halvings| theta * 0.5_f64.powi(halvings)).find(|theta| g(*theta) > 0.0)?;
            }
            return Some(root(inside, theta, f64::EPSILON, &g));
        }
        inside = theta;
    }
    None
}

#[cfg(test)]
mod tests;
