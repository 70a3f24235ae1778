//! Crossings of a speed at which the formulas change: synchronous speed, rows of a table over speed.

use super::collocation::{RULE, S};
use super::newton::Start;
use super::path::Coefficients;
use super::segment::{Segment, Setup};

/// Where the speed first leaves the `bounds` of its formulas on a segment: the part of the segment, and 1 for a
/// crossing upward or -1 downward.
pub(crate) fn first_crossing(segment: &Segment, setup: &Setup, [low, high]: [f64; 2]) -> Option<(f64, f64)> {
    const SLACK: f64 = 1e-13;
    if low <= 0.0 && high == f64::INFINITY {
        return None;
    }
    let nodes = &segment.coefficients.nodes;
    let mut places: [(f64, f64, &Coefficients); S + 1] =
        std::array::from_fn(|i| (RULE.c[i], segment.energy[i], &nodes[i]));
    // The start is on the bound that was crossed last; the middle is examined instead.
    places[0] = (RULE.middle, segment.middle_energy(), &segment.coefficients.middle);
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut inside = 0.0;
    for (theta, energy, place) in places {
        let v = (2.0 * energy / (place.inertia + setup.drive.inertia)).sqrt();
        let (level, side) = if v > high * (1.0 + SLACK) {
            (high, 1.0)
        } else if v < low * (1.0 - SLACK) {
            (low, -1.0)
        } else {
            inside = theta;
            continue;
        };
        return Some((segment.crossing(level, &setup.drive, [inside, theta]), side));
    }
    None
}

impl Start {
    /// Carries the derivatives over a crossing at the place `at`, where the moment jumps: the crossing itself moves
    /// with the parameters. `moments`: before and after; `side`: 1 upward, -1 downward. `false` if the moment after
    /// drives the speed back.
    pub(crate) fn carry_over(
        &mut self,
        setup: &Setup,
        at: &Coefficients,
        moments: [f64; 2],
        side: f64,
    ) -> bool {
        let half_square = self.energy / (at.inertia + setup.drive.inertia);
        // The level T = J v²/2 rises with J.
        let approach = moments[0] - at.slope * half_square;
        let leaving = moments[1] - at.slope * half_square;
        if leaving * side <= 0.0 {
            return false;
        }
        let [by_ratio, by_flywheel] = setup.inertia_by;
        let level = [0.0, by_ratio * half_square, by_flywheel * half_square];
        for (derivative, level) in self.derivatives.iter_mut().zip(level) {
            // dx = -(dT - dB)/(M before - B'), dT after = dT + (M before - M after) dx
            *derivative -= (moments[0] - moments[1]) * (*derivative - level) / approach;
        }
        true
    }
}
