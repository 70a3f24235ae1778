//! Mobility by the rank of the constraints in one position.

use assur_group::{Pair, constraints};
use assur_mechanism::GROUND;
use nalgebra::DMatrix;

use crate::{Linkage, Position};

/// A singular value whose ratio to the greatest one is below this is rounding.
const RANK_LIMIT: f64 = 1e-9;

/// Velocities of a body in each independent motion found: of its origin, in units of the scale, and of its rotation.
type Velocities = Vec<[f64; 3]>;

/// Number of independent motions that the constraints of all pairs leave in a solved position.
///
/// The motions are found group by group, each as the null space of the constraints of its pairs, so that the work
/// grows in proportion to the number of groups. A group whose own constraints are dependent (at a change point) adds
/// motions; a locked group removes them.
pub fn mobility_in(linkage: &Linkage, position: &Position) -> usize {
    let structure = &linkage.structure;
    let mut bodies: Vec<Velocities> = vec![Vec::new(); structure.links];
    let mut motions = Motions { linkage, position, bodies: &mut bodies, count: 0 };
    // A driven pair between two moving links is among those of its group, which moves then.
    for (index, driver) in linkage.mechanism.input.drivers.iter().enumerate() {
        if !driver.is_relative() {
            motions.extend(&[driver.link], &[structure.pairs[index].pair]);
        }
    }
    for group in &structure.groups {
        let pairs: Vec<_> = group.frame.pairs().copied().collect();
        motions.extend(&group.frame.links, &pairs);
    }
    for passive in &structure.passive {
        motions.extend(&passive.frame.links, &passive.frame.outer);
    }
    motions.count
}

/// The independent motions of the links that were added.
struct Motions<'a> {
    linkage: &'a Linkage,
    position: &'a Position,
    bodies: &'a mut [Velocities],
    count: usize,
}

impl Motions<'_> {
    /// Adds links with the pairs that join them to each other and to links added before.
    fn extend(&mut self, links: &[usize], pairs: &[Pair]) {
        let columns = self.count + 3 * links.len();
        // Rows of zeros make the matrix square; its decomposition then yields the whole null space.
        let mut matrix = DMatrix::zeros(columns.max(2 * pairs.len()), columns);
        for (k, pair) in pairs.iter().enumerate() {
            let rows = constraints(pair, &self.position.bodies, self.linkage.structure.scale);
            for (i, [a, b]) in rows.into_iter().enumerate() {
                self.add(&mut matrix, 2 * k + i, (pair.a, a), links);
                self.add(&mut matrix, 2 * k + i, (pair.b, b), links);
            }
        }
        // Normalized, so that a motion with large velocities in these links has no greater weight than the links
        // themselves.
        let scales: Vec<_> = (0..self.count).map(|k| 1.0 / matrix.column(k).norm().max(1.0)).collect();
        for (k, scale) in scales.iter().enumerate() {
            matrix.column_mut(k).scale_mut(*scale);
        }
        let decomposed = matrix.svd(false, true);
        // New links have columns of 1; without any, what is left of the motions may be rounding alone.
        let limit = RANK_LIMIT * decomposed.singular_values.max().max(1.0);
        let Some(vectors) = decomposed.v_t else { return };
        let null = decomposed.singular_values.iter().enumerate().filter(|(_, value)| **value <= limit);
        let null: Vec<Vec<f64>> = null.map(|(i, _)| vectors.row(i).iter().copied().collect()).collect();
        self.replace(links, &scales, null);
    }

    /// Replaces the motions by the combinations of themselves and of the new links' velocities that the pairs allow.
    fn replace(&mut self, links: &[usize], scales: &[f64], mut null: Vec<Vec<f64>>) {
        for vector in &mut null {
            vector.iter_mut().zip(scales).for_each(|(part, scale)| *part *= scale);
        }
        // The usual case: one motion continues unchanged, and links added before keep their values.
        if let ([vector], 1) = (&mut null[..], self.count) {
            let part = vector[0];
            if part.abs() > RANK_LIMIT {
                *vector = vector.iter().map(|number| number / part).collect();
            }
        }
        let goes_on = null.len() == 1 && self.count == 1 && (null[0][0] - 1.0).abs() <= f64::EPSILON;
        if !goes_on {
            for velocities in self.bodies.iter_mut().filter(|velocities| !velocities.is_empty()) {
                let combined = |vector: &Vec<f64>| {
                    let sum = |i: usize| velocities.iter().zip(vector).map(|(one, part)| one[i] * part).sum();
                    [sum(0), sum(1), sum(2)]
                };
                *velocities = null.iter().map(combined).collect();
            }
        }
        for (k, &link) in links.iter().enumerate() {
            let own = |vector: &Vec<f64>| [0, 1, 2].map(|i| vector[self.count + 3 * k + i]);
            self.bodies[link] = null.iter().map(own).collect();
        }
        self.count = null.len();
    }

    /// Adds the coefficients of a body to a constraint: in its own columns if it is new, otherwise in those of the
    /// motions.
    fn add(
        &self,
        matrix: &mut DMatrix<f64>,
        row: usize,
        (body, factors): (usize, [f64; 3]),
        links: &[usize],
    ) {
        if let Some(k) = links.iter().position(|link| *link == body) {
            for (i, factor) in factors.into_iter().enumerate() {
                matrix[(row, self.count + 3 * k + i)] += factor;
            }
        } else if body != GROUND {
            for (k, velocity) in self.bodies[body].iter().enumerate() {
                let rate: f64 = factors.iter().zip(velocity).map(|(factor, part)| factor * part).sum();
                matrix[(row, k)] += rate;
            }
        }
    }
}
