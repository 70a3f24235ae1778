//! The checks.

mod forces;
mod motion;
mod places;
mod refusals;

use assur_group::GroupError;

use crate::Rng;
use crate::case::{Case, Fault};

/// Samples nearer to a singular position than this are only checked by the check of singular positions.
const LEAST_HEALTH: f64 = 0.05;

/// How many samples were suitable for the checks that not every sample allows.
#[derive(Debug, Default)]
pub(crate) struct Tried {
    regular: usize,
    singular: usize,
    /// Number of gaps in the check of gaps; `None` for a kind to which it does not apply.
    open: Option<usize>,
}

impl Tried {
    /// Fails if too few samples were suitable: such a suite proves nothing.
    pub(crate) fn enough(&self) -> Result<(), Fault> {
        let few = self.regular < 20 || self.singular < 20 || self.open.is_some_and(|open| open < 10);
        if few {
            let what = format!("too few samples were suitable for a check: {self:?}");
            return Err(Fault { check: "samples", seed: None, what });
        }
        Ok(())
    }
}

/// All checks of a group that can be assembled and is not near a singular position.
pub(crate) fn regular(case: &Case, rng: &mut Rng, tried: &mut Tried) -> Result<(), Fault> {
    let way = places::recovers(case)?;
    let mut bodies = case.sample.bodies(0.0);
    let health = case.called("place", case.kernel.place(&mut bodies, way))?;
    places::health_is_consistent(case, &bodies, health)?;
    if health < LEAST_HEALTH {
        return Ok(());
    }
    tried.regular += 1;
    places::all_ways_close(case)?;
    motion::agrees_with_differences(case, way)?;
    motion::agrees_with_the_general_solution(case, way, health)?;
    motion::solve_is_place_and_derive(case, way, health)?;
    forces::all(case, way, health, rng)?;
    motion::lanes(case, way)?;
    motion::precisions(case, way, health)?;
    refusals::not_a_number(case, way)?;
    // With two links the least change of a length equals a displacement of one outer body; with more links it need
    // not.
    if case.sample.frame.links.len() == 2 && case.plugin.ways.most > 1 {
        *tried.open.get_or_insert(0) += refusals::gap_closes(case, rng)?;
    }
    Ok(())
}

/// At a singular position one of the ways is refused as singular, or has a health of 0 (up to the square root of
/// rounding) while its pairs still close; or the group can't be assembled because of rounding.
pub(crate) fn singular(case: &Case, tried: &mut Tried) -> Result<(), Fault> {
    tried.singular += 1;
    if case.plugin.iterates {
        return singular_start(case);
    }
    let mut last = Ok(());
    for way in 0..case.kernel.ways() {
        last = singular_way(case, way);
        if last.is_ok() {
            break;
        }
    }
    last
}

/// A kind that iterates finds a health of 0 at the singular position itself; from there it may reach any assembly or
/// give up.
fn singular_start(case: &Case) -> Result<(), Fault> {
    let mut bodies = case.sample.built();
    let health = case.kernel.health(&bodies);
    case.within("singular", "the health from 0", health, 1e-6)?;
    match case.kernel.place(&mut bodies, 0) {
        Ok(_) => case.within("singular", "a pair", case.residual(&bodies), 1e-13),
        Err(_) => Ok(()),
    }
}

fn singular_way(case: &Case, way: usize) -> Result<(), Fault> {
    let fault = |what| Err(case.fault("singular", what));
    let mut bodies = case.sample.bodies(0.0);
    match case.kernel.place(&mut bodies, way) {
        Ok(health) if health.abs() < 1e-6 && case.kernel.health(&bodies) < 1e-6 => {
            case.within("singular", "a pair", case.residual(&bodies), 1e-13)
        }
        Ok(health) => fault(format!("health {health:.3e}, {:.3e} when asked", case.kernel.health(&bodies))),
        Err(GroupError::Singular { health }) if health.abs() < 1e-14 => Ok(()),
        // Rounding may leave a gap of its own size.
        Err(GroupError::NoAssembly { gap_m }) if gap_m < 1e-13 => Ok(()),
        Err(error) => fault(error.to_string()),
    }
}
