//! Reactions over the cycle: greatest, root mean square, hodograph.

use assur_kinematics::Linkage;
use assur_mechanism::Range;
use serde::Serialize;

use crate::plan::length;
use crate::{JointForce, PlansError};

/// The reactions of one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sample {
    /// Number of the position.
    pub index: usize,
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Reactions of all joints.
    pub reactions: Vec<JointForce>,
    /// Balancing moment (N m) or force (N).
    pub balancing: f64,
}

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

/// Whether the positions of the scene make a whole cycle.
fn is_closed(linkage: &Linkage) -> bool {
    matches!(linkage.mechanism.input.range, Range::Cycle(_))
}

/// Moduli that differ by less, relative, count as equally great.
const TIE: f64 = 1e-9;

/// Greatest modulus, the first position that has it, and root mean square of every reaction over the positions.
///
/// Over a whole cycle of equal steps the mean of the squares is that of the positions; over a range it is by trapezoids.
pub fn extremes(linkage: &Linkage, samples: &[Sample]) -> Vec<Extreme> {
    let Some(first) = samples.first() else { return Vec::new() };
    let names = first.reactions.iter().enumerate();
    names
        .map(|(id, reaction)| {
            let size = |sample: &Sample| length(sample.reactions[id].force);
            let greatest = samples.iter().map(size).fold(0.0, f64::max);
            // A cycle often has two alike; which of them is greater by rounding says nothing.
            let at = samples.iter().find(|one| size(one) >= greatest * (1.0 - TIE)).unwrap_or(first);
            let squares: Vec<[f64; 2]> =
                samples.iter().map(|one| [one.coordinate, size(one) * size(one)]).collect();
            Extreme {
                joint: reaction.joint.clone(),
                on: reaction.on.clone(),
                greatest,
                index: at.index,
                coordinate: at.coordinate,
                rms: mean(&squares, is_closed(linkage)).sqrt(),
            }
        })
        .collect()
}

/// Mean of values over the coordinate, rows (coordinate, value).
fn mean(rows: &[[f64; 2]], closed: bool) -> f64 {
    let way = rows.last().map_or(0.0, |last| last[0] - rows[0][0]);
    if closed || way == 0.0 {
        return rows.iter().map(|row| row[1]).sum::<f64>() / (rows.len().max(1) as f64);
    }
    let areas = rows.windows(2).map(|two| 0.5 * (two[0][1] + two[1][1]) * (two[1][0] - two[0][0]));
    areas.sum::<f64>() / way
}

/// The polar diagram of one reaction.
///
/// # Errors
///
/// [`PlansError::NoReaction`] where no joint of this name acts on such a link.
pub fn hodograph(
    linkage: &Linkage,
    samples: &[Sample],
    joint: &str,
    on: &str,
) -> Result<Hodograph, PlansError> {
    let reactions = samples.first().map_or(&[][..], |sample| &sample.reactions);
    let id = reactions.iter().position(|one| one.joint == joint && one.on == on).ok_or_else(|| {
        let known = reactions.iter().map(|one| format!("{} on {}", one.joint, one.on)).collect();
        PlansError::NoReaction { joint: joint.to_owned(), on: on.to_owned(), known }
    })?;
    Ok(Hodograph {
        joint: joint.to_owned(),
        on: on.to_owned(),
        coordinates: samples.iter().map(|sample| sample.coordinate).collect(),
        points: samples.iter().map(|sample| sample.reactions[id].force).collect(),
        closed: is_closed(linkage),
    })
}
