//! An instant of a motion with everything that acts at it: on one side of a jump, or with the load that holds the
//! speed.

use assur_force::{Side, beside};
use assur_integrator::{Motion, MotionError, Reduced, Sample, State};
use serde::Serialize;

use crate::machine::load_state;
use crate::{Driven, Machine};

/// Speeds whose relative difference is below this are equal.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// An instant of a motion: acceleration and loads belong to one side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// The state, with its side.
    pub state: assur_force::State,
    /// What holds the motion at its speed, if anything does.
    pub holding: Option<Holding>,
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

impl Driven<Machine<'_>> {
    /// Completes a sample of a motion with accelerations and loads. At a jump, the values just after it in the
    /// direction of motion are taken; for the last sample (`is_end`), those just before.
    ///
    /// # Errors
    ///
    /// [`MotionError`] if the mechanism has no such position, or the equation no value.
    pub fn instant(&mut self, sample: &Sample, is_end: bool) -> Result<Instant, MotionError> {
        let (at, speed) = (sample.state(), sample.speed);
        let bounds = self.enter(&at)?.speed;
        let side = if is_end { Side::Before } else { Side::After };
        let on_bound = bounds.iter().any(|bound| (bound - speed).abs() <= ROUNDING * speed.abs());
        if speed != 0.0 && !on_bound {
            let acceleration = self.on_side(&at, side, 0.0)?.acceleration(speed)?;
            return Ok(Instant::free(&at, acceleration, side));
        }
        let above = self.on_side(&at, side, 1.0)?;
        let below = self.on_side(&at, side, -1.0)?;
        let [up, down] = [above.acceleration(speed)?, below.acceleration(speed)?];
        if is_end && sample.acceleration != 0.0 {
            // The motion reached this speed from the other side than the one to which its acceleration leads.
            let acceleration = if sample.acceleration > 0.0 { down } else { up };
            return Ok(Instant::free(&at, acceleration, side));
        }
        if up > 0.0 || down < 0.0 {
            return Ok(Instant::free(&at, if up > 0.0 { up } else { down }, Side::After));
        }
        let jump = down - up;
        let upper = if jump > 0.0 { down / jump } else { 0.5 };
        let [net_up, net_down] = [up, down].map(|acceleration| above.inertia * acceleration);
        let holding = Holding { moment: -0.5 * (net_up + net_down), bound: 0.5 * (net_down - net_up) };
        let state = assur_force::State { side: Side::Held { upper }, ..load_state(&at) };
        Ok(Instant { state, holding: (jump > 0.0).then_some(holding) })
    }

    /// Coefficients of the equation by the formulas on a side of a state, above (1), below (-1) or at (0) its speed.
    fn on_side(&mut self, at: &State, side: Side, of_speed: f64) -> Result<Reduced, MotionError> {
        let speed = if of_speed == 0.0 { at.speed } else { beside(at.speed, of_speed) };
        self.enter_side(&assur_force::State { side, ..load_state(&State { speed, ..*at }) });
        self.reduced(at)
    }
}

impl Instant {
    fn free(at: &State, acceleration: f64, side: Side) -> Self {
        Self { state: assur_force::State { acceleration, side, ..load_state(at) }, holding: None }
    }
}
