//! The checks.

mod forces;
mod motion;
mod numbers;
mod places;
mod refusals;

use assur_group::{GroupError, GroupPlugin};

use crate::{Case, Dice, Fault};

/// Samples nearer to a singular position than this are left to the check of singular positions.
const LEAST_HEALTH: f64 = 0.05;

/// How often the checks that depend on luck came to something.
#[derive(Debug, Default)]
pub(crate) struct Tried {
    regular: usize,
    open: usize,
    several_ways: bool,
}

impl Tried {
    /// A suite that tried too little proves nothing.
    pub(crate) fn enough(&self, plugin: &GroupPlugin) -> Result<(), Fault> {
        let few = self.regular < 20 || self.several_ways && !plugin.iterates && self.open < 20;
        if few {
            return Err(Fault {
                check: "samples",
                seed: 0,
                what: format!("too few came to a check: {self:?}"),
            });
        }
        Ok(())
    }
}

/// All checks of a group that can be assembled and is not near a singular position.
pub(crate) fn regular(case: &Case, dice: &mut Dice, tried: &mut Tried) -> Result<(), Fault> {
    let way = places::recovers(case)?;
    let mut bodies = case.sample.bodies(0.0);
    let health = case.called("place", case.kernel.place(&mut bodies, way))?;
    places::health_is_told_alike(case, &bodies, health)?;
    if health < LEAST_HEALTH {
        return Ok(());
    }
    tried.regular += 1;
    tried.several_ways |= case.kernel.ways() > 1;
    places::all_ways_close(case)?;
    motion::agrees_with_differences(case, way)?;
    motion::agrees_with_the_general_solution(case, way, health)?;
    motion::solve_is_place_and_derive(case, way, health)?;
    forces::all(case, way, health, dice)?;
    numbers::lanes(case, way)?;
    numbers::precisions(case, way, health)?;
    refusals::not_a_number(case, way)?;
    if case.kernel.ways() > 1 {
        tried.open += refusals::gap_closes(case, dice)?;
    }
    Ok(())
}

/// At a singular position the health is 0, up to the square root of rounding, and the pairs still close; or there is
/// no place.
pub(crate) fn singular(case: &Case) -> Result<(), Fault> {
    let fault = |what| Err(case.fault("singular", what));
    let mut bodies = case.sample.bodies(0.0);
    match case.kernel.place(&mut bodies, 0) {
        Ok(health) if health.abs() < 1e-6 && case.kernel.health(&bodies) < 1e-6 => {
            case.within("singular", "a pair", case.residual(&bodies), 1e-13)
        }
        Ok(health) => fault(format!("health {health:.3e}, {:.3e} when asked", case.kernel.health(&bodies))),
        Err(GroupError::Singular { health }) if health.abs() < 1e-14 => Ok(()),
        // Rounding may leave the group open by as much as rounding is.
        Err(GroupError::NoAssembly { gap_m }) if gap_m < 1e-13 => Ok(()),
        Err(error) => fault(error.to_string()),
    }
}
