//! All solutions of the equations in magnitudes.

use assur_number::elementary;

use crate::matrix::solve;
use crate::moduli::{Moduli, Width, distance};
use crate::quadrics::{self, Quadric};
use crate::steps::Steps;

/// Two solutions this near, as part of their size, are one.
const SAME: f64 = 1e-9;

/// A sign that is violated by no more than this part of the greatest term counts as right: the vector is zero.
const SIGN: f64 = 1e-9;

/// Most vectors of one component whose signs are enumerated, by the number of those of two components: each adds much to the work
/// for a choice of signs, from microseconds to milliseconds. Groups of two links have no more.
const MOST: [usize; 4] = [8, 6, 4, 2];

/// Most solutions that are followed from part to part: each of them may lead to several in the next.
const MOST_POINTS: usize = 64;

/// Places from which Newton's method looks for solutions where algebra does not give all of them: as many for so many unknowns, fewer
/// for more, since a step takes the cube of their number.
const TRIALS: usize = 64;
const MANY: usize = 12;
const FEWEST: usize = 4;

/// Most steps of Newton's method from each of them: it converges in fewer or hardly ever.
const STEPS: usize = 24;

/// All solutions that were found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Solutions {
    /// The magnitudes of each.
    pub points: Vec<Vec<f64>>,
    /// Whether there are no others.
    pub complete: bool,
    /// Whether there is a continuum of solutions, of which the points contain the ends.
    pub continuum: bool,
}

/// Relative difference up to which solutions that were found in different ways are one: near a place where two meet, Newton's method
/// leaves the root of the rounding.
const FOUND: f64 = 1e-6;

/// Whether the magnitudes of two solutions that were found in different ways are those of one.
fn is_same(one: &[f64], other: &[f64]) -> bool {
    let size = one.iter().chain(other).fold(0.0_f64, |most, z| most.max(z.abs()));
    distance(one, other) <= FOUND * size
}

/// Which of some solutions is that of these magnitudes, which were found in another way; the nearest of those that may be.
pub fn nearest<'a>(all: impl IntoIterator<Item = &'a Vec<f64>>, z: &[f64]) -> Option<usize> {
    let same = all.into_iter().enumerate().filter(|(_, one)| is_same(one, z));
    same.min_by(|(_, a), (_, b)| distance(a, z).total_cmp(&distance(b, z))).map(|(index, _)| index)
}

impl Solutions {
    /// The index of a solution that was found in another way. One that is missing among these joins them: they were not all.
    pub fn index_of(&mut self, z: Vec<f64>) -> usize {
        if let Some(known) = nearest(&self.points, &z) {
            return known;
        }
        self.complete = false;
        self.points.push(z);
        self.points.len() - 1
    }
}

impl Moduli {
    /// All solutions: none, one, or several; where each of the [parts](Self::parts) has at most three vectors of two components and
    /// few of one.
    pub fn solutions(&self) -> Solutions {
        let parts = self.parts();
        if parts.len() < 2 {
            return self.together();
        }
        let mut found = Solutions { complete: true, ..Solutions::default() };
        let mut points = vec![vec![0.0; self.count()]];
        for part in &parts {
            for known in std::mem::take(&mut points) {
                let own = self.part(part, &known).together();
                found.complete &= own.complete;
                found.continuum |= own.continuum;
                points.extend(own.points.into_iter().map(|solved| {
                    let mut point = known.clone();
                    part.iter().zip(solved).for_each(|(at, z)| point[*at] = z);
                    point
                }));
            }
            if points.len() > MOST_POINTS {
                points.truncate(MOST_POINTS);
                found.complete = false;
            }
        }
        let steps = &mut Steps::new(self);
        for point in points {
            add(point, steps, &mut found);
        }
        found
    }

    /// All solutions of equations of one part.
    fn together(&self) -> Solutions {
        let of = |width: Width| (0..self.count()).filter(|j| self.widths[*j] == width).collect::<Vec<_>>();
        let (lines, planes) = (of(Width::One), of(Width::Two));
        let mut found = Solutions { complete: true, ..Solutions::default() };
        let steps = &mut Steps::new(self);
        if MOST.get(planes.len()).is_none_or(|most| lines.len() > *most) {
            found.complete = false;
            self.seek(steps, &mut found);
            return found;
        }
        for signs in 0..1_u32 << lines.len() {
            let signs: Vec<f64> =
                (0..lines.len()).map(|i| if signs >> i & 1 == 0 { 1.0 } else { -1.0 }).collect();
            self.with_signs([&lines, &planes], &signs, steps, &mut found);
        }
        if !found.complete {
            self.seek(steps, &mut found);
        }
        found
    }

    /// Adds the solutions to which Newton's method leads from magnitudes of many sizes.
    fn seek(&self, steps: &mut Steps<'_>, found: &mut Solutions) {
        let size = steps.size(&vec![0.0; self.count()]);
        let trials = (TRIALS * MANY.pow(3) / self.count().max(1).pow(3)).clamp(FEWEST, TRIALS);
        for trial in 0..trials {
            // Each magnitude has a sequence of its own: the fractions of the multiples of an irrational number.
            let part = |j: usize| (trial as f64 * elementary::sin(1.0 + j as f64)).rem_euclid(1.0);
            let start: Vec<f64> =
                (0..self.count()).map(|j| size * elementary::powf(10.0, 4.0 * part(j) - 2.0)).collect();
            let is_new = |z: &[f64]| !found.points.iter().any(|known| is_same(known, z));
            if let Some(z) = steps.newton_within(STEPS, &start, is_new) {
                add(z, steps, found);
            }
        }
    }

    /// Adds the solutions in which the vectors of one component have these signs.
    fn with_signs(
        &self,
        [lines, planes]: [&[usize]; 2],
        signs: &[f64],
        steps: &mut Steps<'_>,
        found: &mut Solutions,
    ) {
        // (1 - S W) z of the lines = S (a + W z of the planes).
        let signed = |i: usize, k: usize| signs[i] * self.slopes[lines[i]][k][0];
        let n = lines.len();
        let entry = |(i, j): (usize, usize)| f64::from(u8::from(i == j)) - signed(i, lines[j]);
        let matrix: Vec<f64> = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(entry).collect();
        let mut solved: Vec<f64> = (0..n).map(|i| signs[i] * self.constants[lines[i]][0]).collect();
        let constant = solved.clone();
        solved.extend(planes.iter().flat_map(|&p| (0..n).map(move |i| (i, p))).map(|(i, p)| signed(i, p)));
        if solve(&mut matrix.clone(), &mut solved, n).is_none() {
            self.singular([lines, planes], [&matrix, &constant], steps, found);
            return;
        }
        // By line: without planes; then what each of these adds.
        let solved: Vec<&[f64]> = (0..=planes.len()).map(|k| &solved[k * n..(k + 1) * n]).collect();
        let put = |lines_of: &[f64], planes_of: &[f64]| {
            let mut z = vec![0.0; self.count()];
            lines.iter().zip(lines_of).for_each(|(at, value)| z[*at] = *value);
            planes.iter().zip(planes_of).for_each(|(at, value)| z[*at] = *value);
            z
        };
        let with = |w: &dyn Fn(usize) -> [f64; 2], own: [f64; 2], factors: &[f64]| {
            lines.iter().zip(factors).fold(own, |[x, y], (&l, f)| [x + w(l)[0] * f, y + w(l)[1] * f])
        };
        let quadrics: Vec<Quadric> = planes
            .iter()
            .map(|&p| {
                let w = |l: usize| self.slopes[p][l];
                let slopes =
                    planes.iter().enumerate().map(|(k, &q)| with(&w, self.slopes[p][q], solved[1 + k]));
                Quadric { constant: with(&w, self.constants[p], solved[0]), slopes: slopes.collect() }
            })
            .collect();
        let (roots, complete) = quadrics::roots(&quadrics);
        found.complete &= complete;
        for root in roots {
            let of_lines: Vec<f64> = (0..n)
                .map(|i| root.iter().enumerate().fold(solved[0][i], |sum, (k, z)| sum + solved[1 + k][i] * z))
                .collect();
            let z = put(&of_lines, &root);
            let size = steps.size(&z);
            if z.iter().all(|z| *z >= -SIGN * size) {
                add(z, steps, found);
            }
        }
    }

    /// Signs with which the linear equations are singular: where they have solutions all the same, these are a continuum.
    fn singular(
        &self,
        [lines, planes]: [&[usize]; 2],
        [matrix, constant]: [&[f64]; 2],
        steps: &Steps<'_>,
        found: &mut Solutions,
    ) {
        if !planes.is_empty() {
            found.complete = false;
            return;
        }
        let n = lines.len();
        let all = nalgebra::DMatrix::from_row_slice(n, n, matrix);
        let right = nalgebra::DVector::from_column_slice(constant);
        let svd = all.clone().svd(true, true);
        let Some(directions) = &svd.v_t else { return };
        let greatest = svd.singular_values.max();
        let null: Vec<usize> = (0..n).filter(|i| svd.singular_values[*i] <= 1e-12 * greatest).collect();
        let Ok(point) = svd.solve(&right, 1e-12 * greatest) else { return };
        let size = right.amax().max(point.amax());
        if (&all * &point - &right).amax() > 1e-10 * size {
            return;
        }
        let [only] = null[..] else {
            found.complete = false;
            return;
        };
        let direction: Vec<f64> = directions.row(only).iter().copied().collect();
        let Some([low, high]) = nonnegative(point.as_slice(), &direction, SIGN * size) else { return };
        let ends: Vec<f64> = [low, high].into_iter().filter(|t| t.is_finite()).collect();
        found.continuum |= high - low > SIGN * size;
        for t in ends {
            let mut z = vec![0.0; self.count()];
            lines.iter().enumerate().for_each(|(i, at)| z[*at] = (point[i] + t * direction[i]).max(0.0));
            keep(z, steps, found);
        }
    }
}

/// Adds a solution that is near these magnitudes, if it is new.
fn add(near: Vec<f64>, steps: &mut Steps<'_>, found: &mut Solutions) {
    let near: Vec<f64> = near.into_iter().map(|z| z.max(0.0)).collect();
    let reach = 1e-3 * steps.size(&near);
    let polished = steps.newton(&near).filter(|z| distance(z, &near) <= reach);
    let z = match polished {
        Some(z) => z,
        None if steps.is_solved(&near) => near,
        None => return,
    };
    keep(z, steps, found);
}

/// Keeps a solution, if it is new.
fn keep(z: Vec<f64>, steps: &Steps<'_>, found: &mut Solutions) {
    let size = steps.size(&z);
    if found.points.iter().all(|known| distance(known, &z) > SAME * size) {
        found.points.push(z);
    }
}

/// The ends of the part of a line, from a point along a direction, on which no coordinate is negative beyond `slack`; `None` where there
/// is no such part.
fn nonnegative(point: &[f64], direction: &[f64], slack: f64) -> Option<[f64; 2]> {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for (z, d) in point.iter().zip(direction) {
        if d.abs() <= 1e-12 {
            if *z < -slack {
                return None;
            }
        } else if *d > 0.0 {
            low = low.max(-z / d);
        } else {
            high = high.min(-z / d);
        }
    }
    (low <= high + slack).then_some([low, high])
}
