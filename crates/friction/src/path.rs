//! A solution along a path: how it changes as friction grows.

use crate::Moduli;

/// A solution goes on a path where its moduli are as expected but for this part of them.
const NEAR: f64 = 0.02;

/// Shortest step along a path, as part of all friction: where it does not suffice the path ends.
const SHORTEST: f64 = 1e-9;

/// First step, and most steps of a path.
const FIRST: f64 = 1.0 / 32.0;
const MOST: usize = 2000;

/// A point of a path: the part of all friction, and the moduli.
#[derive(Debug, Clone, PartialEq)]
pub struct PathPoint {
    /// From 0 to 1.
    pub part: f64,
    /// The moduli of the solution.
    pub moduli: Vec<f64>,
}

/// The moduli of a solution with all friction, to which a path leads from a point of it; `None` where it ends before. `solve` finds
/// the moduli at a part near expected ones, as [`Moduli::near`] does.
pub fn path(mut now: PathPoint, mut solve: impl FnMut(f64, &[f64]) -> Option<Vec<f64>>) -> Option<Vec<f64>> {
    let mut before: Option<PathPoint> = None;
    let mut step = FIRST;
    for _ in 0..MOST {
        if now.part >= 1.0 {
            return Some(now.moduli);
        }
        let part = (now.part + step).min(1.0);
        if let Some(moduli) = solve(part, &expected(before.as_ref(), &now, part)) {
            before = Some(std::mem::replace(&mut now, PathPoint { part, moduli }));
            step *= 1.5;
        } else {
            step *= 0.5;
            if step < SHORTEST {
                return None;
            }
        }
    }
    None
}

/// The moduli that a path will have, straight on.
fn expected(before: Option<&PathPoint>, now: &PathPoint, part: f64) -> Vec<f64> {
    let Some(before) = before else { return now.moduli.clone() };
    let share = (part - now.part) / (now.part - before.part);
    now.moduli.iter().zip(&before.moduli).map(|(now, before)| now + share * (now - before)).collect()
}

impl Moduli {
    /// The solution near expected moduli; `None` where there is none so near that a path goes on there.
    pub fn near(&self, expected: &[f64]) -> Option<Vec<f64>> {
        let found = self.newton(expected)?;
        let size = found.iter().fold(0.0_f64, |most, z| most.max(*z));
        let is_near = |(z, expected): (&f64, &f64)| (z - expected).abs() <= NEAR * size;
        found.iter().zip(expected).all(is_near).then_some(found)
    }
}
