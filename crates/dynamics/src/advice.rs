//! The motors that suit a scene, compared by the unevenness that each allows (S stage 5).

use assur_force::Loads;
use assur_kinematics::Linkage;
use assur_mechanism::{Drive, Mechanism, Motion, Motor as Asked, Solve, Torque};
use assur_motor::Motor;

use crate::scene::{chosen_motor, steady_of};
use crate::{DynamicsError, Steady};

/// A motor in the place of that of a scene.
#[derive(Debug)]
pub struct Advice {
    /// The row of its catalogue.
    pub motor: &'static Motor,
    /// The regime of the greatest unevenness that it allows, or why there is none.
    pub found: Result<Steady, DynamicsError>,
}

/// The motors that have the power which a scene needs and keep its limit of speed, the best first, at most `most` of them;
/// each with the greatest unevenness at which it stays on the stable section of its characteristic. Also returns how many
/// such motors there are.
///
/// # Errors
///
/// [`DynamicsError`]: no steady motion with a motor in the scene, or no motor that fits.
pub fn advise(linkage: &Linkage, loads: &Loads, most: usize) -> Result<(Vec<Advice>, usize), DynamicsError> {
    let mut mechanism = linkage.mechanism.clone();
    set_motor(&mut mechanism, Asked::Auto, None);
    let chosen = chosen_motor(linkage, loads, &mechanism)?;
    let others = chosen.runners_up.iter().map(|candidate| candidate.motor);
    let all: Vec<_> = chosen.row.into_iter().chain(others).collect();
    let advice = all.iter().take(most).map(|motor| {
        let (designation, catalogue) = (motor.designation.clone(), motor.catalogue.clone());
        set_motor(&mut mechanism, Asked::Designation(designation), Some(catalogue));
        Advice { motor, found: steady_of(linkage, loads, &mechanism, None) }
    });
    Ok((advice.collect(), all.len()))
}

/// Sets the motor of a scene, whose flywheel is to be found for the greatest unevenness that it allows.
fn set_motor(mechanism: &mut Mechanism, new: Asked, from: Option<String>) {
    if let Some(Motion::Steady { unevenness, .. }) = &mut mechanism.motion {
        *unevenness = Some(Solve::Wanted);
    }
    let Some(Drive { torque: Torque::Motor { motor, catalogue, .. }, flywheel, ratio, .. }) =
        &mut mechanism.drive
    else {
        return;
    };
    (*motor, *flywheel, *ratio) = (new, Some(Solve::Wanted), Solve::Wanted);
    if from.is_some() {
        *catalogue = from;
    }
}
