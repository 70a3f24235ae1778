//! Which smooth piece comes next, and whether the motion continues at all.

use assur_words::{number, text};

use crate::{CountedEquation, IntegrationError, MotionError, Piece, State};

/// Enters the piece after `state`, and returns the acceleration in it; `at_speed_bound` if the speed is on a bound of
/// the previous piece.
///
/// At rest and at a bound of the speed both sides are tried: a side is right if its own acceleration leads into it. The
/// speed may lie on a bound of the piece that begins, too: that of a motion that starts on a row of a table.
/// `None`: each side drives the motion back, so that the speed is held (dry friction at rest, a governor).
pub fn enter(
    equation: &mut CountedEquation<'_>,
    state: &State,
    at_speed_bound: bool,
) -> Result<Option<(Piece, f64)>, IntegrationError> {
    if state.speed != 0.0 && !at_speed_bound {
        let piece = piece_ahead(equation, state, 0.0)?;
        let [low, high] = piece.speed;
        if low < state.speed && state.speed < high {
            return Ok(Some((piece, acceleration(equation, state)?)));
        }
    }
    let Some(upward) = leading(equation, state, 1.0)? else { return leading(equation, state, -1.0) };
    // Other loads never drive away from rest to both sides.
    if state.speed == 0.0 && equation.dependence().moment_on_acceleration {
        if let Some((_, downward)) = leading(equation, state, -1.0)? {
            let shown = |value: f64| number(format_args!("{value:.6e}"));
            let both = text!("integrator-both-directions", up = shown(upward.1), down = shown(downward));
            return Err(IntegrationError::equation(state, MotionError::Undetermined(both)));
        }
        return leading(equation, state, 1.0);
    }
    Ok(Some(upward))
}

/// The piece on a side of the speed with its acceleration, if that leads into it.
fn leading(
    equation: &mut CountedEquation<'_>,
    state: &State,
    side: f64,
) -> Result<Option<(Piece, f64)>, IntegrationError> {
    let piece = piece_ahead(equation, state, side)?;
    let acceleration = acceleration(equation, state)?;
    Ok((acceleration * side > 0.0).then_some((piece, acceleration)))
}

/// Acceleration at a state of the motion.
pub(crate) fn acceleration(
    equation: &mut CountedEquation<'_>,
    state: &State,
) -> Result<f64, IntegrationError> {
    equation.acceleration(state).map_err(|source| IntegrationError::equation(state, source))
}

/// Enters the piece, each time a little further ahead, until it contains states ahead of `state`: a table that repeats
/// with the cycle may place a row a rounding before or after the bound that it reported.
pub(crate) fn piece_ahead(
    equation: &mut CountedEquation<'_>,
    state: &State,
    side: f64,
) -> Result<Piece, IntegrationError> {
    /// Up to 2^24 roundings, 4e-9: more is not a rounding.
    const TRIALS: i32 = 12;
    for trial in -1..TRIALS {
        let roundings = if trial < 0 { 0.0 } else { f64::EPSILON * 4.0_f64.powi(trial) };
        let asked = ahead(state, side, roundings);
        let piece = equation.enter(&asked).map_err(|source| IntegrationError::equation(state, source))?;
        if has_states_ahead(&piece, state, asked.speed, side) {
            return Ok(including(piece, state));
        }
    }
    Err(IntegrationError::EmptyPiece { at: *state })
}

/// A state `roundings` ahead, on one side of its speed.
fn ahead(state: &State, side: f64, roundings: f64) -> State {
    let nudge = 2.0 * f64::EPSILON * state.speed.abs();
    let speed = state.speed + side * nudge.max(f64::MIN_POSITIVE);
    let size = state.coordinate.abs().max(1e-3);
    State {
        time: state.time + roundings * state.time.abs().max(1e-9),
        coordinate: state.coordinate + speed.signum() * roundings * size,
        speed,
    }
}

fn has_states_ahead(piece: &Piece, state: &State, speed: f64, side: f64) -> bool {
    let coordinate = if speed > 0.0 {
        piece.coordinate[1] > state.coordinate
    } else {
        piece.coordinate[0] < state.coordinate
    };
    let on_side =
        side == 0.0 || if side > 0.0 { piece.speed[1] > state.speed } else { piece.speed[0] < state.speed };
    coordinate && on_side && piece.time[1] > state.time
}

/// The piece, widened by the roundings that separate it from the state itself.
fn including(mut piece: Piece, state: &State) -> Piece {
    let widen = |bounds: &mut [f64; 2], value: f64| {
        bounds[0] = bounds[0].min(value);
        bounds[1] = bounds[1].max(value);
    };
    widen(&mut piece.coordinate, state.coordinate);
    widen(&mut piece.speed, state.speed);
    piece
}
