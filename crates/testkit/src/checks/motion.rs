//! Checks of derivatives.

use assur_group::{Body, Number, Order, derive_generally};
use assur_number::{Dd, Lanes, Real};

use super::{motion, places};
use crate::case::{Case, Fault};

/// Step of the differences in 32 digits: truncation error 1e-20, rounding error 1e-22.
const STEP: f64 = 1e-10;

/// PF1 and PF2 of a body.
fn derivatives(body: &Body<f64>) -> [[f64; 3]; 2] {
    [[body.x1, body.y1, body.w1], [body.x2, body.y2, body.w2]]
}

/// Greatest difference of PF1 and of PF2 of the group's links, each relative to its greatest absolute value (at least
/// 1).
pub(crate) fn apart(case: &Case, one: &[Body<f64>], two: &[Body<f64>]) -> [f64; 2] {
    [0, 1].map(|order| {
        let (mut worst, mut size) = (0.0_f64, 1.0_f64);
        for &i in &case.sample.frame.links {
            let (a, b) = (derivatives(&one[i])[order], derivatives(&two[i])[order]);
            for (a, b) in a.into_iter().zip(b) {
                worst = if (a - b).is_nan() { f64::INFINITY } else { worst.max((a - b).abs()) };
                size = size.max(b.abs());
            }
        }
        worst / size
    })
}

pub(crate) fn agrees_with_the_general_solution(case: &Case, way: usize, health: f64) -> Result<(), Fault> {
    let closed = case.called("derive", case.solved(&*case.kernel, 0.0, way))?;
    let mut general = closed.clone();
    case.called("derive", derive_generally(&case.sample.frame, &mut general, Order::Second))?;
    let [first, second] = apart(case, &closed, &general);
    case.within("general", "PF1", first, 1e-14 / health)?;
    case.within("general", "PF2", second, 1e-14 / (health * health))
}

pub(crate) fn solve_is_place_and_derive(case: &Case, way: usize, health: f64) -> Result<(), Fault> {
    let apart_calls = case.called("derive", case.solved(&*case.kernel, 0.0, way))?;
    let mut bodies = case.sample.bodies(0.0);
    let given = case.called("solve", case.kernel.solve(&mut bodies, way, Order::Second))?;
    case.within("solve", "health", given - health, 0.0)?;
    case.within("solve", "a place", super::places::apart(case, &bodies, &apart_calls), 0.0)?;
    let [first, second] = apart(case, &bodies, &apart_calls);
    case.within("solve", "PF1", first, 1e-14 / (health * health))?;
    case.within("solve", "PF2", second, 1e-14 / health.powi(4))?;
    let mut once = case.sample.bodies(0.0);
    case.called("solve", case.kernel.solve(&mut once, way, Order::First))?;
    case.within("solve", "PF1 alone", apart(case, &once, &bodies)[0], 0.0)
}

/// Derivative of a link's pose (or of its first derivative) from the values on both sides.
fn rates(before: &Body<Dd>, after: &Body<Dd>) -> [[f64; 3]; 2] {
    let rate = |a: Dd, b: Dd| ((b - a) * Dd::ratio(0.5, STEP)).to_f64();
    // The sine of the small angle between the directions equals the angle up to STEP³.
    let turn = before.c * after.s - before.s * after.c;
    [
        [rate(before.x, after.x), rate(before.y, after.y), rate(Dd::ZERO, turn)],
        [rate(before.x1, after.x1), rate(before.y1, after.y1), rate(before.w1, after.w1)],
    ]
}

/// Compares with central differences in double-double along the motion of the outer bodies.
pub(crate) fn agrees_with_differences(case: &Case, way: usize) -> Result<(), Fault> {
    let kernel = case.kernel_in::<Dd>()?;
    let at = |q: f64| case.called("differences", case.solved(&*kernel, Dd::from_f64(q), way));
    let (before, now, after) = (at(-STEP)?, at(0.0)?, at(STEP)?);
    for &i in &case.sample.frame.links {
        let body = &now[i];
        let given = [[body.x1, body.y1, body.w1], [body.x2, body.y2, body.w2]];
        for (given, seen) in given.into_iter().zip(rates(&before[i], &after[i])) {
            for (given, seen) in given.into_iter().zip(seen) {
                let size = seen.abs().max(1.0);
                case.within("differences", "a derivative", (given.to_f64() - seen) / size, 1e-13)?;
            }
        }
    }
    Ok(())
}

/// Coordinates of the lanes.
const LANES: [f64; Lanes::WIDTH] = [0.0, 0.004, -0.003, 0.007, -0.006, 0.002, -0.001, 0.005];

/// How far from the place a kind that iterates begins, in lanes as in one position, m: as far as kept poses are.
const BESIDE: f64 = 1e-6;

/// Positions in lanes give the results of each alone, bit for bit.
pub(crate) fn lanes(case: &Case, way: usize) -> Result<(), Fault> {
    let found: Vec<_> = LANES.iter().filter_map(|&q| case.solved(&*case.kernel, q, way).ok()).collect();
    if found.len() < LANES.len() {
        return Ok(());
    }
    let links = &case.sample.frame.links;
    let begin = |(q, found): (&f64, &Vec<Body<f64>>)| {
        let mut bodies = case.sample.bodies(*q);
        for &link in links {
            let Body { x, y, c, s, .. } = found[link];
            bodies[link] = Body { x: x + BESIDE, y, c, s, ..bodies[link] };
        }
        bodies
    };
    let starts: Vec<_> = LANES.iter().zip(&found).map(begin).collect();
    let mut together = case.sample.bodies(Lanes(LANES));
    for &link in links {
        starts.iter().enumerate().for_each(|(lane, start)| together[link].set_lane(lane, &start[link]));
    }
    let kernel = case.kernel_in::<Lanes>()?;
    let together = case.called("lanes", Case::solved_from(&*kernel, together, way))?;
    for (lane, start) in starts.into_iter().enumerate() {
        let bodies = case.called("lanes", Case::solved_from(&*case.kernel, start, way))?;
        for &i in links {
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
