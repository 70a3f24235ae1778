//! The textbook iteration and Newton's method on equations in magnitudes, in memory that their steps share.

use assur_number::Real;
use assur_number::elimination::factor;

use crate::Moduli;
use crate::matrix::{is_contraction, solve};
use crate::moduli::{distance, length};

/// Most steps of the iteration before Newton's method.
const MOST_STEPS: usize = 400;

/// Most steps of Newton's method.
const MOST_NEWTON: usize = 60;

/// Most steps of Newton's method to the next point of a path: where it takes more there is hardly any.
const MOST_NEAR: usize = 16;

/// Relative residual at which equations count as solved; rounding leaves some 1e-16 times the condition.
const SOLVED: f64 = 1e-11;

/// Greatest part of magnitudes by which Newton's method would change those of a solution.
const STILL: f64 = 1e-3;

/// A solution goes on a path where its magnitudes are as expected but for this part of them.
const NEAR: f64 = 0.02;

/// On a path Newton's method is given up where it leaves what is expected by this part of the greatest term.
const ASTRAY: f64 = 0.2;

impl Moduli {
    /// The solution where the [certificate](Self::certificate) is below 1, which is often known before it is.
    pub fn only(&self) -> Option<Vec<f64>> {
        let mut steps = Steps::new(self);
        if steps.is_contraction() { steps.follow(&vec![0.0; self.count()]) } else { None }
    }

    /// The solution to which the textbook iteration and then Newton's method lead, from some magnitudes; `None` where they lead
    /// to none. Where the [certificate](Self::certificate) is below 1 this is the only one.
    pub fn follow(&self, start: &[f64]) -> Option<Vec<f64>> {
        Steps::new(self).follow(start)
    }

    /// The solution near expected magnitudes; `None` where there is none so near that a path goes on there.
    ///
    /// A path from no friction, where the derivative is the unit matrix, keeps the sign of its determinant: it changes where two
    /// solutions meet and the path ends. So of two solutions side by side only one is on the path, however near they are. Each of
    /// the [parts](Self::parts) is judged by itself: a method that solves a whole mechanism at once has the path of one that solves
    /// group by group.
    pub fn near(&self, expected: &[f64]) -> Option<Vec<f64>> {
        let mut steps = Steps::new(self);
        let reach = ASTRAY * steps.size(expected);
        // Away from what is expected it may wander for long.
        let found = steps.newton_within(MOST_NEAR, expected, |z| distance(z, expected) <= reach)?;
        let goes_on = |part: &Vec<usize>| {
            let size = part.iter().fold(0.0_f64, |most, j| most.max(found[*j]));
            let is_near = |j: &usize| (found[*j] - expected[*j]).abs() <= NEAR * size;
            part.iter().all(is_near) && steps.is_ahead(&found, part)
        };
        self.parts().iter().all(goes_on).then_some(found)
    }
}

/// Equations in magnitudes, with memory for a step.
pub(crate) struct Steps<'a> {
    system: &'a Moduli,
    /// The greatest length of a constant.
    constant: f64,
    /// The lengths of the slopes, by equation.
    slopes: Vec<f64>,
    /// By unknown, the greatest length of a slope, and at least 1.
    columns: Vec<f64>,
    /// The vectors of all equations at the magnitudes that were looked at last, and their lengths.
    vectors: Vec<[f64; 2]>,
    lengths: Vec<f64>,
    matrix: Vec<f64>,
    change: Vec<f64>,
}

impl<'a> Steps<'a> {
    pub(crate) fn new(system: &'a Moduli) -> Self {
        let n = system.count();
        let slopes: Vec<f64> = system.slopes.iter().flatten().map(|slope| length(*slope)).collect();
        let mut columns = vec![1.0_f64; n];
        for row in slopes.chunks_exact(n.max(1)) {
            columns.iter_mut().zip(row).for_each(|(most, slope)| *most = most.max(*slope));
        }
        let constant = system.constants.iter().map(|constant| length(*constant)).fold(0.0, f64::max);
        let [lengths, change] = [vec![0.0; n], vec![0.0; n]];
        let (vectors, matrix) = (vec![[0.0; 2]; n], vec![0.0; n * n]);
        Self { system, constant, slopes, columns, vectors, lengths, matrix, change }
    }

    /// Whether the [certificate](Moduli::certificate) is below 1.
    pub(crate) fn is_contraction(&self) -> bool {
        let told = is_contraction(&self.slopes, self.lengths.len());
        told.unwrap_or_else(|| self.system.certificate() < 1.0)
    }

    /// The greatest term of the equations at some magnitudes.
    pub(crate) fn size(&self, z: &[f64]) -> f64 {
        self.columns.iter().zip(z).map(|(most, z)| most * z.abs()).fold(self.constant, f64::max)
    }

    /// Looks at some magnitudes; the greatest difference of a magnitude and the length of its vector.
    #[inline(always)]
    fn look(&mut self, z: &[f64]) -> f64 {
        let mut off = 0.0_f64;
        for (j, z_j) in z.iter().enumerate() {
            let vector = self.system.vector(j, z);
            (self.vectors[j], self.lengths[j]) = (vector, length(vector));
            off = off.max((self.lengths[j] - z_j).abs());
        }
        off
    }

    /// Greatest residual |z - |a + W z|| as part of the greatest term.
    #[inline(always)]
    pub(crate) fn residual(&mut self, z: &[f64]) -> f64 {
        let off = self.look(z);
        if off == 0.0 { 0.0 } else { off / self.size(z) }
    }

    /// As [`Moduli::follow`].
    pub(crate) fn follow(&mut self, start: &[f64]) -> Option<Vec<f64>> {
        let mut z = start.to_vec();
        for round in 1..=MOST_STEPS {
            let off = self.look(&z);
            z.copy_from_slice(&self.lengths);
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

    /// Newton's method from some magnitudes; `None` where it leads to no solution. Magnitudes of a solution are not negative.
    pub(crate) fn newton(&mut self, start: &[f64]) -> Option<Vec<f64>> {
        self.newton_within(MOST_NEWTON, start, |_| true)
    }

    /// Newton's method with at most so many steps, as long as it leads on: not where it comes to what is known.
    pub(crate) fn newton_within(
        &mut self,
        most: usize,
        start: &[f64],
        leads_on: impl Fn(&[f64]) -> bool,
    ) -> Option<Vec<f64>> {
        f64::evaluate(
            #[inline(always)]
            move || self.newton_steps(most, start, leads_on),
        )
    }

    #[inline(always)]
    fn newton_steps(
        &mut self,
        most: usize,
        start: &[f64],
        leads_on: impl Fn(&[f64]) -> bool,
    ) -> Option<Vec<f64>> {
        let mut z = start.to_vec();
        let (mut least, mut best) = (f64::INFINITY, z.clone());
        // Whether a step would hardly change the best.
        let mut is_still = true;
        for _ in 0..most {
            let residual = self.residual(&z);
            if !residual.is_finite() {
                break;
            }
            let is_best = residual < least;
            if is_best {
                (least, is_still) = (residual, true);
                best.copy_from_slice(&z);
            } else if least <= SOLVED {
                break;
            }
            if residual == 0.0 || self.change(&z).is_none() {
                break;
            }
            if is_best {
                is_still = self.is_still(&z);
            }
            z.iter_mut().zip(&self.change).for_each(|(z, change)| *z -= change);
            if !leads_on(&z) {
                return None;
            }
        }
        let size = self.size(&best);
        let solved = least <= SOLVED && is_still && best.iter().all(|z| *z >= -SOLVED * size);
        solved.then(|| best.into_iter().map(|z| z.max(0.0)).collect())
    }

    /// Whether magnitudes solve the equations. Towards a solution at infinity the residual vanishes beside them, but Newton's method
    /// would change them as much as ever.
    pub(crate) fn is_solved(&mut self, z: &[f64]) -> bool {
        self.residual(z) <= SOLVED && (self.change(z).is_none() || self.is_still(z))
    }

    /// Whether the correction that was found last hardly changes moduli.
    fn is_still(&self, z: &[f64]) -> bool {
        let most = STILL * self.size(z);
        self.change.iter().all(|change| change.abs() <= most)
    }

    /// Whether the determinant of the derivative of some equations by their unknowns is positive, as it is without friction.
    pub(crate) fn is_ahead(&mut self, z: &[f64], part: &[usize]) -> bool {
        self.look(z);
        self.derive();
        let row = |i: usize| part.iter().map(move |j| i * z.len() + j);
        let mut matrix: Vec<f64> =
            part.iter().copied().flat_map(row).map(|entry| self.matrix[entry]).collect();
        let found = factor(&mut matrix, &mut vec![0; part.len()]);
        part.is_empty() || found.is_positive && found.health > 0.0
    }

    /// Writes the correction of Newton's method at the magnitudes that were looked at last; `None` where the derivative is singular.
    #[inline(always)]
    fn change(&mut self, z: &[f64]) -> Option<()> {
        self.derive();
        let off = z.iter().zip(&self.lengths).map(|(z, length)| z - length);
        self.change.iter_mut().zip(off).for_each(|(change, off)| *change = off);
        solve(&mut self.matrix, &mut self.change, z.len())
    }

    /// Writes the derivative of z - |a + W z| by z at the magnitudes that were looked at last.
    #[inline(always)]
    fn derive(&mut self) {
        let n = self.lengths.len();
        for (j, row) in self.matrix.chunks_exact_mut(n.max(1)).enumerate() {
            let (vector, size) = (self.vectors[j], self.lengths[j]);
            let unit = if size > 0.0 { [vector[0] / size, vector[1] / size] } else { [0.0; 2] };
            for (k, (entry, w)) in row.iter_mut().zip(&self.system.slopes[j]).enumerate() {
                *entry = f64::from(u8::from(j == k)) - unit[0] * w[0] - unit[1] * w[1];
            }
        }
    }
}
