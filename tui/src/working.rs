//! The working of a position or of a sample of a motion.

use assur_analysis::Calculation;
use assur_mechanism::Motion;
use assur_working::{Drive, Place, Task, Working, WorkingError};

/// The working of a position: with its forces, unless the motion is found from an initial state.
pub(crate) fn of_position(calculation: &Calculation, index: usize) -> Result<Working, WorkingError> {
    let mechanism = &calculation.linkage.mechanism;
    let is_transient = matches!(mechanism.motion, Some(Motion::Transient { .. }));
    let has_forces = !is_transient && (mechanism.motion.is_some() || mechanism.has_loads());
    let state = calculation.state(mechanism.input.coordinate(index));
    work(calculation, Place::Position(index), state, has_forces)
}

/// The working of a sample of a transient motion, in which the motion has this state.
pub(crate) fn of_sample(
    calculation: &Calculation,
    number: usize,
    state: assur_force::State,
) -> Result<Working, WorkingError> {
    work(calculation, Place::Sample(number), state, true)
}

fn work(
    calculation: &Calculation,
    place: Place,
    state: assur_force::State,
    has_forces: bool,
) -> Result<Working, WorkingError> {
    // Where the motion is not found, neither are its forces.
    let loads = calculation.loads.as_ref().filter(|_| has_forces && calculation.no_motion.is_none());
    let drive = calculation.drive_in(&state).filter(|_| has_forces);
    let drive = drive.map(|[moment, inertia]| Drive { moment, inertia });
    Working::of(&Task { linkage: &calculation.linkage, loads, state, place, drive })
}
