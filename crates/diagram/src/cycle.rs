//! A reaction over the cycle: its polar diagram, its greatest value and root mean square.

use serde::Serialize;

use crate::plan::length;

/// Size of one reaction over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Extreme {
    /// Pin or slide.
    pub joint: String,
    /// The link that it acts on.
    pub on: String,
    /// Greatest modulus, N.
    pub greatest: f64,
    /// Number of the position where it occurs; the first one of equals.
    pub index: usize,
    /// Coordinate there, rad or m.
    pub coordinate: f64,
    /// Root mean square of the modulus over the coordinate, N.
    pub rms: f64,
}

/// Polar diagram of a reaction: the ends of its vectors from one origin.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Hodograph {
    /// Pin or slide.
    pub joint: String,
    /// The link that it acts on.
    pub on: String,
    /// Coordinates of the positions, rad or m.
    pub coordinates: Vec<f64>,
    /// The force in each position, N.
    pub points: Vec<[f64; 2]>,
    /// Whether the last point joins the first: the positions make a whole cycle.
    pub closed: bool,
}

/// Relative difference below which moduli count as equal.
const TIE: f64 = 1e-9;

impl Hodograph {
    /// Greatest modulus, the first position that has it, and root mean square. `indices`: the numbers of the positions.
    ///
    /// Over a whole cycle of equal steps the mean of the squares is the arithmetic one; over a range it is by
    /// trapezoids.
    pub fn extreme(&self, indices: &[usize]) -> Extreme {
        let sizes: Vec<f64> = self.points.iter().map(|force| length(*force)).collect();
        let greatest = sizes.iter().copied().fold(0.0, f64::max);
        // A cycle often has two equal maxima; rounding must not decide between them.
        let at = sizes.iter().position(|size| *size >= greatest * (1.0 - TIE)).unwrap_or(0);
        let squares: Vec<[f64; 2]> = self
            .coordinates
            .iter()
            .zip(&sizes)
            .map(|(coordinate, size)| [*coordinate, size * size])
            .collect();
        Extreme {
            joint: self.joint.clone(),
            on: self.on.clone(),
            greatest,
            index: indices.get(at).copied().unwrap_or(at),
            coordinate: self.coordinates.get(at).copied().unwrap_or(f64::NAN),
            rms: mean(&squares, self.closed).sqrt(),
        }
    }
}

/// Mean of values over the coordinate, rows (coordinate, value).
fn mean(rows: &[[f64; 2]], closed: bool) -> f64 {
    let range = rows.last().map_or(0.0, |last| last[0] - rows[0][0]);
    if closed || range == 0.0 {
        return rows.iter().map(|row| row[1]).sum::<f64>() / (rows.len().max(1) as f64);
    }
    let areas = rows.windows(2).map(|two| 0.5 * (two[0][1] + two[1][1]) * (two[1][0] - two[0][0]));
    areas.sum::<f64>() / range
}
