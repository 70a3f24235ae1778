//! Inputs for which a kind must return an error.

use assur_group::{Body, GroupError, Order};
use assur_mechanism::GROUND;

use crate::Rng;
use crate::case::{Case, Fault};

/// Number of directions in which closing a gap is tried: the nearest of them loses less than 1e-6 of it.
const DIRECTIONS: u32 = 3600;

/// A NaN in any number of a moving outer body leads to an error, never to a result. The ground, which never moves, need not
/// be read.
pub(crate) fn not_a_number(case: &Case, way: usize) -> Result<(), Fault> {
    for outer in case.sample.outer().into_iter().filter(|outer| *outer != GROUND) {
        for k in 0..10 {
            let mut bodies = case.sample.bodies(0.0);
            let mut numbers = bodies[outer].numbers();
            numbers[k] = f64::NAN;
            bodies[outer] = Body::of_numbers(numbers);
            if case.kernel.solve(&mut bodies, way, Order::Second).is_ok() {
                return Err(
                    case.fault("NaN", format!("number {k} of body {outer} is NaN, and no error came"))
                );
            }
        }
    }
    Ok(())
}

/// The gap of a group after one outer body is displaced by a vector; `None` if it can be assembled.
fn gap(case: &Case, outer: usize, by: [f64; 2]) -> Result<Option<f64>, Fault> {
    let mut bodies = case.sample.bodies(0.0);
    bodies[outer].x += by[0];
    bodies[outer].y += by[1];
    match case.kernel.place(&mut bodies, 0) {
        Ok(_) => Ok(None),
        Err(GroupError::NoAssembly { gap_m }) if gap_m > 0.0 && gap_m.is_finite() => Ok(Some(gap_m)),
        Err(error) => Err(case.fault("gap", error.to_string())),
    }
}

/// Displaces an outer body until the group can't be assembled; then a displacement by the reported gap, in the best
/// direction, must close it, and a smaller one must not. Returns the number of gaps found.
pub(crate) fn gap_closes(case: &Case, rng: &mut Rng) -> Result<usize, Fault> {
    let mut open = 0;
    let outer = case.sample.outer();
    let [.., moved] = outer[..] else { return Ok(0) };
    if outer.len() < 2 {
        return Ok(0);
    }
    for size in [0.3, 1.0, 2.0, 6.0] {
        let [x, y] = [rng.range(-1.0, 1.0), rng.range(-1.0, 1.0)];
        let by = [size * x, size * y];
        let Some(miss) = gap(case, moved, by)? else { continue };
        open += 1;
        let (mut closed, mut too_early) = (false, false);
        for step in 0..DIRECTIONS {
            let (s, c) = (f64::from(step) * std::f64::consts::TAU / f64::from(DIRECTIONS)).sin_cos();
            let after = |part: f64| gap(case, moved, [by[0] + part * miss * c, by[1] + part * miss * s]);
            closed |= after(1.0 + 1e-5)?.is_none();
            too_early |= after(1.0 - 1e-5)?.is_none();
        }
        if !closed || too_early {
            return Err(case.fault("gap", format!("{miss:.6} m: closed {closed}, by less {too_early}")));
        }
    }
    Ok(open)
}
