//! Where a motor works under a mean load: first guesses for its speed and for the ratio of the reducer.

use assur_motor::Characteristic;
use assur_number::search::bisect;

use crate::DynamicsError;

/// Motor speed on the stable branch that gives a torque, or where the branch ends.
pub(crate) fn working_speed(characteristic: &Characteristic, torque: f64) -> f64 {
    let (slow, fast) = stable_branch(characteristic);
    let [slow, fast] = bisect(slow, fast, 0.0, |speed| characteristic.torque(speed) > torque);
    0.5 * (slow + fast)
}

/// Ends of the stable branch: breakdown as motor (of a straight line: a hundredth of the synchronous speed), and as brake.
fn stable_branch(characteristic: &Characteristic) -> (f64, f64) {
    let synchronous = characteristic.synchronous_speed;
    let slow = characteristic.breakdown_speed().unwrap_or(0.0).max(0.01 * synchronous);
    (slow, 2.0 * synchronous - slow)
}

/// Ratio at which the motor carries the mean moment `needed` at the input speed `speed`.
pub(crate) fn working_ratio(
    characteristic: &Characteristic,
    efficiency: f64,
    needed: f64,
    speed: f64,
) -> Result<f64, DynamicsError> {
    let power = |motor: f64| motor * characteristic.torque(motor);
    let wanted = if needed > 0.0 { needed * speed / efficiency } else { needed * speed * efficiency };
    let (mut slow, fast) = stable_branch(characteristic);
    // The greatest power is above the breakdown speed.
    let synchronous = characteristic.synchronous_speed;
    for k in 0..200 {
        let trial = slow + (synchronous - slow) * f64::from(k) / 200.0;
        if power(trial) > power(slow) {
            slow = trial;
        }
    }
    if power(slow) < wanted {
        return Err(DynamicsError::TooWeak { needed: wanted, most: power(slow) });
    }
    let [slow, fast] = bisect(slow, fast, 0.0, |motor| power(motor) > wanted);
    Ok(0.5 * (slow + fast) / speed)
}
