//! The same kernel in other numbers.

use assur_group::{Body, Number};
use assur_number::{Dd, F64x4, Lanes, Real};

use super::{motion, places};
use crate::{Case, Fault};

/// Positions of the four lanes.
const LANES: [f64; 4] = [0.0, 0.004, -0.003, 0.007];

fn numbers<T: Copy>(b: &Body<T>) -> [T; 10] {
    [b.x, b.y, b.c, b.s, b.x1, b.y1, b.w1, b.x2, b.y2, b.w2]
}

fn rounded<T: Real>(b: &Body<T>) -> Body<f64> {
    let [x, y, c, s, x1, y1, w1, x2, y2, w2] = numbers(b).map(Real::to_f64);
    Body { x, y, c, s, x1, y1, w1, x2, y2, w2 }
}

/// Four positions side by side give bit for bit what each gives alone.
pub(crate) fn lanes(case: &Case, way: usize) -> Result<(), Fault> {
    let alone: Vec<_> = LANES.iter().filter_map(|&q| case.solved(&*case.kernel, q, way).ok()).collect();
    if alone.len() < LANES.len() {
        return Ok(());
    }
    let kernel = case.kernel_in::<F64x4>()?;
    let together = case.called("lanes", case.solved(&*kernel, Lanes(LANES), way))?;
    for (lane, bodies) in alone.iter().enumerate() {
        for &i in &case.sample.frame.links {
            for (one, all) in numbers(&bodies[i]).into_iter().zip(numbers(&together[i])) {
                let off = if one.to_bits() == all.0[lane].to_bits() { 0.0 } else { one - all.0[lane] };
                // Only a kind that pivots or iterates decides for all lanes at once.
                let limit = if case.plugin.class == 2 { 0.0 } else { 1e-11 };
                case.within("lanes", "a number", off, limit)?;
            }
        }
    }
    Ok(())
}

/// Errors against 32 digits: of the place as 1/health, of PF1 as 1/health², of PF2 as 1/health⁴ at the worst.
fn errors<T: Number>(case: &Case, way: usize, health: f64) -> Result<(), Fault> {
    let reference = case.called("precision", case.solved(&*case.kernel_in::<Dd>()?, Dd::ZERO, way))?;
    let tested = case.called("precision", case.solved(&*case.kernel_in::<T>()?, T::ZERO, way))?;
    let reference: Vec<_> = reference.iter().map(rounded).collect();
    let tested: Vec<_> = tested.iter().map(rounded).collect();
    let unit = 100.0 * T::EPSILON;
    case.within("precision", "PF0", places::apart(case, &tested, &reference), unit / health)?;
    let [first, second] = motion::apart(case, &tested, &reference);
    case.within("precision", "PF1", first, unit / health.powi(2))?;
    case.within("precision", "PF2", second, unit / health.powi(4))
}

/// f64 and f32 against double-double; double-double by its own closure.
pub(crate) fn precisions(case: &Case, way: usize, health: f64) -> Result<(), Fault> {
    errors::<f64>(case, way, health)?;
    // Near a singular position f32 need not even find an assembly.
    if health > 0.2 {
        errors::<f32>(case, way, health)?;
    }
    let extended = case.called("precision", case.solved(&*case.kernel_in::<Dd>()?, Dd::ZERO, way))?;
    case.within("precision", "a pair in double-double", case.residual(&extended), 1e-29)
}
