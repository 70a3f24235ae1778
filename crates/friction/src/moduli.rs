//! The equations in moduli, and what is found of them by iteration, and along a path: how a solution changes as friction grows.

use crate::matrix::{solve, spectral_radius};

/// How many components a vector has whose modulus is an unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// A number: the pressing force of a slide.
    One,
    /// A vector in the plane: the force of a pin.
    Two,
}

/// Equations `z_j = |a_j + sum of W_jk z_k|`; of a vector of one component the second is zero.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Moduli {
    /// Number of components of each vector.
    pub widths: Vec<Width>,
    /// The vectors a: those without friction.
    pub constants: Vec<[f64; 2]>,
    /// By equation j and unknown k: the vectors W, what a modulus of 1 adds by its friction.
    pub slopes: Vec<Vec<[f64; 2]>>,
}

/// Most steps of the iteration before Newton's method.
const MOST_STEPS: usize = 400;

/// Most steps of Newton's method.
const MOST_NEWTON: usize = 60;

/// Relative residual at which equations count as solved; rounding leaves some 1e-16 times the condition.
pub(crate) const SOLVED: f64 = 1e-11;

/// Greatest part of moduli by which Newton's method would change those of a solution.
const STILL: f64 = 1e-3;

impl Moduli {
    /// Number of unknowns.
    pub fn count(&self) -> usize {
        self.widths.len()
    }

    /// The vector of an equation at some moduli.
    pub fn vector(&self, j: usize, z: &[f64]) -> [f64; 2] {
        let start = self.constants[j];
        self.slopes[j].iter().zip(z).fold(start, |[x, y], (w, z)| [x + w[0] * z, y + w[1] * z])
    }

    /// One step of the textbook iteration: the moduli of the vectors that other moduli give.
    #[must_use]
    pub fn step(&self, z: &[f64]) -> Vec<f64> {
        (0..self.count()).map(|j| length(self.vector(j, z))).collect()
    }

    /// The matrix L of the lengths of W.
    pub fn lengths(&self) -> Vec<Vec<f64>> {
        self.slopes.iter().map(|row| row.iter().map(|w| length(*w)).collect()).collect()
    }

    /// The spectral radius of L: below 1 there is exactly one solution.
    pub fn certificate(&self) -> f64 {
        spectral_radius(&self.lengths())
    }

    /// Greatest residual |z - |a + W z|| as part of the greatest term.
    pub fn residual(&self, z: &[f64]) -> f64 {
        let size = self.size(z);
        let off = self.step(z).iter().zip(z).fold(0.0_f64, |most, (new, z)| most.max((new - z).abs()));
        if off == 0.0 { 0.0 } else { off / size }
    }

    /// The greatest term of the equations at some moduli.
    pub(crate) fn size(&self, z: &[f64]) -> f64 {
        let constants = self.constants.iter().map(|a| length(*a));
        let terms = self.slopes.iter().flat_map(|row| row.iter().zip(z).map(|(w, z)| length(*w) * z.abs()));
        constants.chain(terms).chain(z.iter().map(|z| z.abs())).fold(0.0, f64::max)
    }

    /// The solution to which the textbook iteration and then Newton's method lead, from some moduli; `None` where they lead
    /// to none. Where the [certificate](Self::certificate) is below 1 this is the only one.
    pub fn follow(&self, start: &[f64]) -> Option<Vec<f64>> {
        let mut z = start.to_vec();
        for round in 1..=MOST_STEPS {
            let next = self.step(&z);
            let off = next.iter().zip(&z).fold(0.0_f64, |most, (new, z)| most.max((new - z).abs()));
            z = next;
            let size = self.size(&z);
            if !size.is_finite() {
                return None;
            }
            // Newton's method finishes from wherever it converges, but is tried only now and then.
            if (off <= f64::EPSILON * size || off <= 1e-3 * size && round % 8 == 0)
                && let Some(found) = self.newton(&z)
            {
                return Some(found);
            }
        }
        self.newton(&z)
    }

    /// Newton's method from some moduli; `None` where it leads to no solution. Moduli of a solution are not negative.
    pub fn newton(&self, start: &[f64]) -> Option<Vec<f64>> {
        let mut z = start.to_vec();
        let mut best: Option<(f64, Vec<f64>)> = None;
        for _ in 0..MOST_NEWTON {
            let residual = self.residual(&z);
            if !residual.is_finite() {
                break;
            }
            if best.as_ref().is_none_or(|(least, _)| residual < *least) {
                best = Some((residual, z.clone()));
            } else if best.as_ref().is_some_and(|(least, _)| *least <= SOLVED) {
                break;
            }
            if residual == 0.0 {
                break;
            }
            let Some(change) = self.change(&z) else { break };
            z.iter_mut().zip(change).for_each(|(z, change)| *z -= change);
        }
        let (_, z) = best?;
        let size = self.size(&z);
        let solved = self.is_solved(&z) && z.iter().all(|z| *z >= -SOLVED * size);
        solved.then(|| z.into_iter().map(|z| z.max(0.0)).collect())
    }

    /// Whether moduli solve the equations. Towards a solution at infinity the residual vanishes beside them, but Newton's method
    /// would change them as much as ever.
    pub(crate) fn is_solved(&self, z: &[f64]) -> bool {
        let still = |change: Vec<f64>| change.iter().all(|change| change.abs() <= STILL * self.size(z));
        self.residual(z) <= SOLVED && self.change(z).is_none_or(still)
    }

    /// The correction of Newton's method; `None` where the derivative is singular.
    fn change(&self, z: &[f64]) -> Option<Vec<f64>> {
        let vectors: Vec<[f64; 2]> = (0..self.count()).map(|j| self.vector(j, z)).collect();
        let off = vectors.iter().zip(z).map(|(vector, z)| z - length(*vector)).collect();
        solve(self.derivative(&vectors), vec![off])?.pop()
    }

    /// Whether the determinant of the derivative is positive, as it is without friction.
    fn is_ahead(&self, z: &[f64]) -> bool {
        let vectors: Vec<[f64; 2]> = (0..self.count()).map(|j| self.vector(j, z)).collect();
        let rows = self.derivative(&vectors);
        nalgebra::DMatrix::from_fn(rows.len(), rows.len(), |i, k| rows[i][k]).determinant() > 0.0
    }

    /// Derivative of z - |a + W z| by z, where the vectors are these.
    fn derivative(&self, vectors: &[[f64; 2]]) -> Vec<Vec<f64>> {
        let row = |(j, vector): (usize, &[f64; 2])| {
            let size = length(*vector);
            let unit = if size > 0.0 { [vector[0] / size, vector[1] / size] } else { [0.0; 2] };
            let entry =
                |(k, w): (usize, &[f64; 2])| f64::from(u8::from(j == k)) - unit[0] * w[0] - unit[1] * w[1];
            self.slopes[j].iter().enumerate().map(entry).collect()
        };
        vectors.iter().enumerate().map(row).collect()
    }

    /// The solution near expected moduli; `None` where there is none so near that a path goes on there.
    ///
    /// A path from no friction, where the derivative is the unit matrix, keeps the sign of its determinant: it changes where two
    /// solutions meet and the path ends. So of two solutions side by side only one is on the path, however near they are.
    pub fn near(&self, expected: &[f64]) -> Option<Vec<f64>> {
        let found = self.newton(expected).filter(|found| self.is_ahead(found))?;
        let size = found.iter().fold(0.0_f64, |most, z| most.max(*z));
        let is_near = |(z, expected): (&f64, &f64)| (z - expected).abs() <= NEAR * size;
        found.iter().zip(expected).all(is_near).then_some(found)
    }
}

pub(crate) fn length([x, y]: [f64; 2]) -> f64 {
    if y == 0.0 { x.abs() } else { x.hypot(y) }
}

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
