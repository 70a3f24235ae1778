//! The greatest unevenness that a motor allows (S stage 5).

use std::cell::RefCell;

use assur_motor::Characteristic;
use assur_number::search;

use crate::DynamicsError;
use crate::steady::{DriveRequest, Regime, RegimeSolver};

/// Least unevenness that is tried: no machine is built for less.
const LEAST: f64 = 1e-3;
/// Greatest unevenness that is tried: at 2 the input would stand still once in a cycle.
const MOST: f64 = 1.9;
/// Width of the natural logarithm of the unevenness to which the greatest one is found.
const WIDTH: f64 = 1e-11;

/// How far the speeds of the motor stay inside the stable section of its characteristic, as a part of the section; negative
/// where they leave it.
pub fn section_margin(regime: &Regime, characteristic: &Characteristic) -> f64 {
    let [low, high] = characteristic.stable_section();
    let ratio = regime.ratio.unwrap_or(1.0);
    let [slow, fast] = [regime.speed_min, regime.speed_max].map(|speed| ratio * speed.abs());
    (slow - low).min(high - fast) / (high - low)
}

/// The regime of the greatest unevenness at which the motor stays on the stable section of its characteristic; a flywheel is
/// found for it.
pub(crate) fn greatest(
    solver: &mut RegimeSolver<'_>,
    request: &DriveRequest,
    characteristic: &Characteristic,
) -> Result<Regime, DynamicsError> {
    let mut solve = |unevenness| solver.solve(&DriveRequest { unevenness: Some(unevenness), ..*request });
    let least = solve(LEAST)?;
    let inside = section_margin(&least, characteristic);
    if inside < 0.0 {
        let [low, high] = characteristic.stable_section();
        let speed = least.ratio.unwrap_or(1.0) * least.mean_speed.abs();
        return Err(DynamicsError::OffSection { speed, low, high });
    }
    let kept = RefCell::new((least, solve));
    let margin_at = |logarithm: f64| {
        let (best, solve) = &mut *kept.borrow_mut();
        // Where the machine stalls, it has left the section long before.
        let Ok(regime) = solve(logarithm.exp()) else { return -1.0 };
        let inside = section_margin(&regime, characteristic);
        if inside >= 0.0 && regime.unevenness > best.unevenness {
            *best = regime;
        }
        inside
    };
    if margin_at(MOST.ln()) < 0.0 {
        search::root(LEAST.ln(), MOST.ln(), WIDTH, margin_at);
    }
    Ok(kept.into_inner().0)
}
