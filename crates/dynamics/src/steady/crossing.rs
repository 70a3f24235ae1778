//! Crossings of a speed at which the formulas change: synchronous speed, rows of a table over speed.

use super::arc::Arc;
use super::collocation::{RULE, S, dot};
use super::path::Datum;
use super::sweep::Sweep;
use crate::DynamicsError;

impl Sweep<'_, '_> {
    /// Where the speed first leaves its bounds, as part of the arc, and on which side.
    pub(super) fn first_crossing(&self, arc: &Arc) -> Option<(f64, f64)> {
        const SLACK: f64 = 1e-13;
        let [low, high] = self.bounds;
        if low <= 0.0 && high == f64::INFINITY {
            return None;
        }
        let middle = arc.start + arc.h * dot(&RULE.to_middle, &arc.moment);
        let mut inside = 0.0;
        let nodes = (0..S).map(|i| (RULE.c[i], arc.energy[i], &arc.data.nodes[i]));
        let (before, after): (Vec<_>, Vec<_>) = nodes.partition(|node| node.0 < RULE.middle);
        for (theta, energy, datum) in
            before.into_iter().chain([(RULE.middle, middle, &arc.data.middle)]).chain(after)
        {
            let v = self.speed(energy, datum);
            let side = if v > high * (1.0 + SLACK) {
                1.0
            } else if v < low * (1.0 - SLACK) {
                -1.0
            } else {
                inside = theta;
                continue;
            };
            let level = if side > 0.0 { high } else { low };
            return Some((arc.when(level, &self.setup.shaft, [inside, theta]), side));
        }
        None
    }

    /// Goes to the crossing by the old formulas, and on by the new ones.
    pub(super) fn cross(
        &mut self,
        arc: &Arc,
        theta: f64,
        side: f64,
        halvings: usize,
    ) -> Result<(), DynamicsError> {
        /// More in one cycle is no motion but chatter.
        const MOST: usize = 1000;
        /// A crossing so near to the start is at the start.
        const AT_START: f64 = 1e-9;
        let (x, h) = (arc.x + theta * arc.h, (1.0 - theta) * arc.h);
        let coordinate = self.road.way.coordinate(x);
        self.crossings += 1;
        if self.crossings > MOST {
            return Err(DynamicsError::NoPath { coordinate });
        }
        let (mut at, mut before) = (arc.data.start, arc.first_moment);
        if theta > AT_START {
            let data = self.data(arc.x, theta * arc.h, &arc.data.start)?;
            let part = self
                .solve(arc.x, theta * arc.h, &data, None)
                .map_err(|_| DynamicsError::NoPath { coordinate })?;
            (at, before) = (part.data.nodes[S - 1], part.moment[S - 1]);
            self.keep(&part);
        }
        self.side = side;
        if h <= 1e-12 * self.road.way.length {
            return Ok(());
        }
        let data = self.data(x, h, &at)?;
        let data = self.choose(x, h, &data)?;
        let after = self.force(&data.start, self.energy).value;
        self.jump(&at, [before, after], side).map_err(|()| DynamicsError::Held { coordinate })?;
        self.advance(x, h, &data, None, halvings)
    }

    /// What the moving place of a crossing does to the derivatives, if the moment jumps there.
    fn jump(&mut self, at: &Datum, moments: [f64; 2], side: f64) -> Result<(), ()> {
        let inertia = at.inertia + self.setup.shaft.inertia;
        let half_square = self.energy / inertia;
        // The level T = J v²/2 rises with J.
        let approach = moments[0] - at.slope * half_square;
        let leaving = moments[1] - at.slope * half_square;
        if leaving * side <= 0.0 {
            return Err(());
        }
        let [by_ratio, by_flywheel] = self.setup.inertia_by;
        let level = [0.0, by_ratio * half_square, by_flywheel * half_square];
        for (derivative, level) in self.derivatives.iter_mut().zip(level) {
            // dx = -(dT - dB)/(M before - B'), dT after = dT + (M before - M after) dx
            *derivative -= (moments[0] - moments[1]) * (*derivative - level) / approach;
        }
        Ok(())
    }
}
