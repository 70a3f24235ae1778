//! An instant of a motion with everything that acts at it: on one side of a jump, or with the load that holds the
//! speed.

use assur_force::{LoadState, Side, beside};
use assur_integrator::{EquationOfMotion, MotionError, Reduced, Sample, State};
use assur_number::search::try_bisect;
use serde::Serialize;

use crate::{Machine, friction::FrictionMoment, machine::load_state};

/// Speeds whose relative difference is below this are equal.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// An instant of a motion: acceleration and loads belong to one side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// The state, with its side.
    pub state: LoadState,
    /// What holds the motion at its speed, if anything does.
    pub holding: Option<Holding>,
    /// Moment of the dry friction of all pairs reduced to the input, N m (N); 0 at rest, where it is not determined.
    pub friction: f64,
}

/// The load that holds a motion at rest or at a speed, reduced to the input: what dry resistance (or a jump of a table
/// over the speed) adds to the mean of its values above and below the speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Holding {
    /// Holding moment on the input, N m (force, N), positive along the coordinate.
    pub moment: f64,
    /// The greatest possible size: half of the jump.
    pub bound: f64,
}

impl Machine<'_> {
    /// Completes a sample of a motion with accelerations and loads. At a jump, the values just after it in the
    /// direction of motion are taken; for the last sample (`is_end`), those just before.
    pub fn instant(&mut self, sample: &Sample, is_end: bool) -> Result<Instant, MotionError> {
        let (at, speed) = (sample.state(), sample.speed);
        let bounds = self.enter(&at)?.speed;
        let side = if is_end { Side::Before } else { Side::After };
        let on_bound = bounds.iter().any(|bound| (bound - speed).abs() <= ROUNDING * speed.abs());
        if speed != 0.0 && !on_bound {
            let (free, found) = self.on_side(&at, side, 0.0)?;
            return Ok(self.free(&at, free.acceleration(speed)?, side, found.moment));
        }
        let (above, over) = self.on_side(&at, side, 1.0)?;
        let (below, under) = self.on_side(&at, side, -1.0)?;
        let [up, down] = [above.acceleration(speed)?, below.acceleration(speed)?];
        if is_end && sample.acceleration != 0.0 {
            // The motion reached this speed from the other side than the one to which its acceleration leads.
            let (acceleration, found) = if sample.acceleration > 0.0 { (down, under) } else { (up, over) };
            return Ok(self.free(&at, acceleration, side, found.moment));
        }
        if up > 0.0 || down < 0.0 {
            let (acceleration, found) = if up > 0.0 { (up, over) } else { (down, under) };
            return Ok(self.free(&at, acceleration, Side::After, found.moment));
        }
        let jump = down - up;
        let mut upper = if jump > 0.0 { down / jump } else { 0.5 };
        let mut friction = 0.0;
        if self.has_friction() && speed != 0.0 {
            (upper, friction) = self.held_with_friction(&at)?;
        }
        let [net_up, net_down] = [up, down].map(|acceleration| above.inertia * acceleration);
        let holding = Holding { moment: -0.5 * (net_up + net_down), bound: 0.5 * (net_down - net_up) };
        let state = LoadState { side: Side::Held { upper }, ..load_state(&at) };
        let known = jump > 0.0 && !(over.jams || under.jams);
        Ok(Instant { state: self.drive.driving(state), holding: known.then_some(holding), friction })
    }

    /// Coefficients of the equation by the formulas on a side of a state, above (1), below (-1) or at (0) its speed.
    fn on_side(
        &mut self,
        at: &State,
        side: Side,
        of_speed: f64,
    ) -> Result<(Reduced, FrictionMoment), MotionError> {
        let speed = if of_speed == 0.0 { at.speed } else { beside(at.speed, of_speed) };
        self.enter_side(&LoadState { side, ..load_state(&State { speed, ..*at }) })?;
        Ok((self.reduced(at)?, self.friction()))
    }

    /// The share of the formulas above a speed that holds it with dry friction, which is not linear in the loads, and the moment of
    /// friction.
    fn held_with_friction(&mut self, at: &State) -> Result<(f64, f64), MotionError> {
        let state = |upper: f64| LoadState { side: Side::Held { upper }, ..load_state(at) };
        let mut above = |upper: f64| -> Result<bool, MotionError> {
            Ok(self.acceleration_at(&state(upper))?.is_some_and(|found| found < 0.0))
        };
        // More of the formulas above the speed slows down.
        let [lower, _] = try_bisect(0.0, 1.0, 0.0, |upper| above(upper).map(|slows| !slows))?;
        let ideal = self.ideal(at)?;
        let others = self.load_moment(&state(lower))? + self.drive.torque(&state(lower));
        Ok((lower, 0.5 * ideal.inertia_derivative * at.speed * at.speed - others))
    }

    fn free(&self, at: &State, acceleration: f64, side: Side, friction: f64) -> Instant {
        let state = LoadState { acceleration, side, ..load_state(at) };
        Instant { state: self.drive.driving(state), holding: None, friction }
    }
}
