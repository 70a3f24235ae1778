//! The equations in magnitudes, and what is found of them by iteration, and along a path: how a solution changes as friction grows.

use assur_number::{ROUNDING, components, elementary};

use crate::matrix::spectral_radius;

/// How many components a vector has whose magnitude is an unknown.
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
    /// By equation j and unknown k: the vectors W, what a magnitude of 1 adds by its friction.
    pub slopes: Vec<Vec<[f64; 2]>>,
}

impl Moduli {
    /// Number of unknowns.
    pub fn count(&self) -> usize {
        self.widths.len()
    }

    /// The vector of an equation at some magnitudes.
    pub fn vector(&self, j: usize, z: &[f64]) -> [f64; 2] {
        let start = self.constants[j];
        self.slopes[j].iter().zip(z).fold(start, |[x, y], (w, z)| [x + w[0] * z, y + w[1] * z])
    }

    /// One step of the textbook iteration: the magnitudes of the vectors that other magnitudes give.
    #[must_use]
    pub fn step(&self, z: &[f64]) -> Vec<f64> {
        (0..self.count()).map(|j| length(self.vector(j, z))).collect()
    }

    /// The equations with a part of the friction.
    #[must_use]
    pub fn scaled(&self, part: f64) -> Self {
        let slopes = self.slopes.iter().map(|row| row.iter().map(|[x, y]| [part * x, part * y]).collect());
        Self { slopes: slopes.collect(), ..self.clone() }
    }

    /// The matrix L of the lengths of W.
    pub fn lengths(&self) -> Vec<Vec<f64>> {
        self.slopes.iter().map(|row| row.iter().map(|w| length(*w)).collect()).collect()
    }

    /// The spectral radius of L: below 1 there is exactly one solution.
    pub fn certificate(&self) -> f64 {
        spectral_radius(&self.lengths())
    }

    /// The unknowns in parts that depend on themselves and on parts before them alone; in each, any depends on any other.
    pub fn parts(&self) -> Vec<Vec<usize>> {
        let n = self.count();
        let lengths = self.lengths();
        let most = |k: usize| lengths.iter().fold(1.0, |most: f64, row| most.max(row[k]));
        let limits: Vec<f64> = (0..n).map(|k| ROUNDING * most(k)).collect();
        let needs: Vec<Vec<usize>> =
            lengths.iter().map(|row| (0..n).filter(|k| row[*k] > limits[*k]).collect()).collect();
        components(&needs, |_| 0)
    }

    /// The equations of some unknowns, where the others are known; those that depend on these are of no account.
    pub(crate) fn part(&self, unknowns: &[usize], known: &[f64]) -> Self {
        let others: Vec<f64> =
            (0..self.count()).map(|k| if unknowns.contains(&k) { 0.0 } else { known[k] }).collect();
        let slopes = |j: &usize| unknowns.iter().map(|k| self.slopes[*j][*k]).collect();
        Self {
            widths: unknowns.iter().map(|j| self.widths[*j]).collect(),
            constants: unknowns.iter().map(|j| self.vector(*j, &others)).collect(),
            slopes: unknowns.iter().map(slopes).collect(),
        }
    }
}

pub(crate) fn length([x, y]: [f64; 2]) -> f64 {
    if y == 0.0 { x.abs() } else { elementary::hypot(x, y) }
}

/// Greatest difference of two solutions.
pub(crate) fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (a, b)| most.max(length([a - b, 0.0])))
}

/// Shortest step along a path, as part of all friction: where it does not suffice the path ends.
pub const SHORTEST: f64 = 1e-9;

/// First step, and most steps of a path.
const FIRST: f64 = 1.0 / 32.0;
const MOST: usize = 2000;

/// A point of a path: the part of all friction, and the magnitudes.
#[derive(Debug, Clone, PartialEq)]
pub struct PathPoint {
    /// From 0 to 1.
    pub part: f64,
    /// The magnitudes of the solution.
    pub moduli: Vec<f64>,
}

/// The magnitudes of a solution with all friction, to which a path leads from a point of it. `solve` finds the magnitudes at a part near
/// expected ones, as [`Moduli::near`] does.
///
/// # Errors
///
/// The last point of a path that ends before.
pub fn path(
    mut now: PathPoint,
    mut solve: impl FnMut(f64, &[f64]) -> Option<Vec<f64>>,
) -> Result<Vec<f64>, PathPoint> {
    let mut before: Option<PathPoint> = None;
    let mut step = FIRST;
    for _ in 0..MOST {
        if now.part >= 1.0 {
            return Ok(now.moduli);
        }
        let part = (now.part + step).min(1.0);
        if let Some(moduli) = solve(part, &expected(before.as_ref(), &now, part)) {
            before = Some(std::mem::replace(&mut now, PathPoint { part, moduli }));
            step *= 1.5;
        } else {
            step *= 0.5;
            if step < SHORTEST {
                break;
            }
        }
    }
    Err(now)
}

/// The magnitudes that a path will have, straight on.
fn expected(before: Option<&PathPoint>, now: &PathPoint, part: f64) -> Vec<f64> {
    let Some(before) = before else { return now.moduli.clone() };
    let share = (part - now.part) / (now.part - before.part);
    now.moduli.iter().zip(&before.moduli).map(|(now, before)| now + share * (now - before)).collect()
}
