//! Checks of a kernel in other number types.

use assur_group::Number;
use assur_number::{Dd, Lanes, Real};

use super::{motion, places};
use crate::case::{Case, Fault};

/// Coordinates of the lanes.
const LANES: [f64; Lanes::WIDTH] = [0.0, 0.004, -0.003, 0.007, -0.006, 0.002, -0.001, 0.005];

/// Positions in lanes give the results of each alone, bit for bit.
pub(crate) fn lanes(case: &Case, way: usize) -> Result<(), Fault> {
    let alone: Vec<_> = LANES.iter().filter_map(|&q| case.solved(&*case.kernel, q, way).ok()).collect();
    if alone.len() < LANES.len() {
        return Ok(());
    }
    let kernel = case.kernel_in::<Lanes>()?;
    let together = case.called("lanes", case.solved(&*kernel, Lanes(LANES), way))?;
    for (lane, bodies) in alone.iter().enumerate() {
        for &i in &case.sample.frame.links {
            for (one, all) in bodies[i].numbers().into_iter().zip(together[i].numbers()) {
                let off = if one.to_bits() == all.0[lane].to_bits() { 0.0 } else { one - all.0[lane] };
                case.within("lanes", "a number", off, 0.0)?;
            }
        }
    }
    Ok(())
}

/// Bounds of errors relative to 32 digits: of the place as 1/health, of PF1 as 1/health², of PF2 as 1/health⁴ at the
/// worst.
fn errors<T: Number>(case: &Case, way: usize, health: f64) -> Result<(), Fault> {
    let reference = case.called("precision", case.solved(&*case.kernel_in::<Dd>()?, Dd::ZERO, way))?;
    let tested = case.called("precision", case.solved(&*case.kernel_in::<T>()?, T::ZERO, way))?;
    let reference: Vec<_> = reference.iter().map(|body| body.map(Real::to_f64)).collect();
    let tested: Vec<_> = tested.iter().map(|body| body.map(Real::to_f64)).collect();
    let unit = 100.0 * T::EPSILON;
    case.within("precision", "PF0", places::apart(case, &tested, &reference), unit / health)?;
    let [first, second] = motion::apart(case, &tested, &reference);
    case.within("precision", "PF1", first, unit / health.powi(2))?;
    case.within("precision", "PF2", second, unit / health.powi(4))
}

/// f64 and f32 are compared with double-double; double-double is checked by the residuals of its pairs.
pub(crate) fn precisions(case: &Case, way: usize, health: f64) -> Result<(), Fault> {
    errors::<f64>(case, way, health)?;
    // Near a singular position f32 may not find an assembly at all.
    if health > 0.2 {
        errors::<f32>(case, way, health)?;
    }
    let extended = case.called("precision", case.solved(&*case.kernel_in::<Dd>()?, Dd::ZERO, way))?;
    case.within("precision", "a pair in double-double", case.residual(&extended), 1e-29)
}
