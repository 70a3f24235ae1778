//! Mobility by the rank actually found in one position.

use assur_group::PairGeometry;
use nalgebra::DMatrix;

use crate::{Linkage, Position};

/// Rank of the constraints of all pairs in one position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rank {
    /// Number of independent constraints.
    pub rank: usize,
    /// Freedoms that are left: 3 n - rank.
    pub mobility: usize,
    /// Smallest singular value that counts as one, over the greatest.
    pub least: f64,
}

/// Below this ratio to the greatest, a singular value is rounding.
const RANK_LIMIT: f64 = 1e-9;

/// Rank of the constraints of all pairs of a linkage in a solved position.
pub fn rank_of(linkage: &Linkage, position: &Position) -> Rank {
    let matrix = constraints(linkage, position);
    let freedoms = matrix.ncols();
    let values = matrix.singular_values();
    let greatest = values.iter().copied().fold(0.0, f64::max);
    let counted = values.iter().copied().filter(|value| *value > RANK_LIMIT * greatest);
    let (rank, least) = counted.fold((0, f64::INFINITY), |(n, least), value| (n + 1, least.min(value)));
    Rank { rank, mobility: freedoms - rank, least: least / greatest }
}

/// Two rows a pair, three columns a moving link; lengths in units of the scale.
fn constraints(linkage: &Linkage, position: &Position) -> DMatrix<f64> {
    let structure = &linkage.structure;
    let mut matrix = DMatrix::zeros(2 * structure.pairs.len(), 3 * (structure.links - 1));
    for (k, named) in structure.pairs.iter().enumerate() {
        let pair = &named.pair;
        let bodies = &position.bodies;
        let (place, rows) = match pair.geometry {
            PairGeometry::Pin { at_a, .. } => {
                (bodies[pair.a].point(at_a), [Some([1.0, 0.0]), Some([0.0, 1.0])])
            }
            PairGeometry::Slide { point, angle, .. } => {
                let (s, c) = angle.sin_cos();
                let [c, s] = bodies[pair.b].turned([c, s]);
                (bodies[pair.a].point(point), [Some([-s, c]), None])
            }
        };
        for (i, row) in rows.into_iter().enumerate() {
            for (body, sign) in [(pair.a, 1.0), (pair.b, -1.0)] {
                if body == 0 {
                    continue;
                }
                let column = 3 * (body - 1);
                let arm = [place[0] - bodies[body].x, place[1] - bodies[body].y];
                match row {
                    Some([nx, ny]) => {
                        matrix[(2 * k + i, column)] = sign * nx;
                        matrix[(2 * k + i, column + 1)] = sign * ny;
                        matrix[(2 * k + i, column + 2)] =
                            sign * (ny * arm[0] - nx * arm[1]) / structure.scale;
                    }
                    None => matrix[(2 * k + i, column + 2)] = sign,
                }
            }
        }
    }
    matrix
}
