//! The check of the work with an error of twice its limit in the kinetic energy at the end.

use assur_check::Check;
use assur_dynamics::Transient;
use assur_words::Text;

use super::super::{Balance, INTERVALS};
use crate::Calculation;

/// An error that no limit allows for, of the largest energy, which it must not change.
const GROSS: f64 = 0.5;

/// The check as it is, and with the error; `None` where it judges nothing.
pub(crate) fn twice_the_limit(calculation: &Calculation, found: &Transient) -> Option<[Check; 2]> {
    let (mut motion, trajectory) =
        calculation.solved_again(calculation.loads.as_ref()?, found, INTERVALS[0], true)?;
    let mut balance = Balance::of(&mut motion, &trajectory, false)?;
    let own = 2.0 * calculation.tolerance() * (trajectory.statistics.steps + 1) as f64;
    let check = |balance: &Balance| Check::of(Text::default(), Text::default(), balance.worst(own));
    let sound = check(&balance);
    let size = balance.kinetic.iter().copied().fold(0.0, f64::max);
    let end = *balance.kinetic.last()?;
    let mut with = |error: f64| {
        *balance.kinetic.last_mut()? = end - error * size;
        Some(check(&balance))
    };
    // What is missed at the end shows the limit there: errors of the quadrature add up.
    let gross = with(GROSS)?;
    let wrong = with(GROSS * 2.0 * gross.finding.bound / gross.finding.error)?;
    sound.finding.holds.is_some().then_some([sound, wrong])
}
