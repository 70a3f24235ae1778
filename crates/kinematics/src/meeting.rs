//! Judges a minimum of the determinant of a group: whether two modes meet there, and at which coordinate.

use assur_group::GroupError;
use assur_number::{Dd, Real};

/// Meaning of a minimum of a determinant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Minimum {
    /// Two modes meet, within the accuracy of the lengths.
    Meeting(Meeting),
    /// The modes approach each other and separate again: the motion stays in its mode.
    Beside,
    /// The group can't be assembled at this coordinate (rad or m); the gap, m.
    Gap(f64, f64),
}

/// A coordinate at which two modes of a group meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Meeting {
    pub(crate) coordinate: f64,
    /// Remainder of the squared determinant there: 0, or rounding of the lengths.
    pub(crate) residue: f64,
}

/// Distances from a supposed minimum at which the determinant is evaluated, in samples: coarse first, because the
/// minimum may be inaccurate; then so fine that the higher orders neglected by the parabola are below 1e-30.
const DISTANCES: [f64; 4] = [3e-2, 3e-2, 1e-4, 1e-6];

/// How many of these distances are used for a group followed after one with a rounded meeting at the same coordinate.
const COARSE: usize = 2;

/// The places of evaluation are rounded to multiples of this fraction of a distance, so that groups that meet at one
/// coordinate share them. The parabola finds its minimum from any of them.
const LATTICE: f64 = 0.25;

/// Meetings nearer than this, in samples, are at one coordinate.
const NEAR: f64 = 1e-4;

/// The remainder of an earlier group at the same coordinate counts as rounding of 32 digits below this.
const CLEAN: f64 = 1e-26;

/// Smallest squared determinant that counts as nonzero for a group followed after one with a rounded meeting at the
/// same coordinate: the places of its links are then only known to about 1e-16 / distance.
const BLURRED: f64 = 1e-11;

/// A squared determinant above this is no meeting, whatever the rounding.
const FAR: f64 = 1e-6;

/// A parabola h² = least + slope² (q - center)² of the squared determinant.
struct Parabola {
    center: Dd,
    least: f64,
    /// slope².
    square: f64,
}

/// Data for the judgment of a minimum. It uses the squared determinant, which is smooth in the coordinate where the
/// determinant itself is a square root.
pub(crate) struct Judge<'a> {
    /// The determinant of the group at a coordinate, in its present mode.
    pub(crate) determinant: &'a mut dyn FnMut(Dd) -> Result<Dd, GroupError>,
    /// Distance between neighboring samples, positive.
    pub(crate) sample: f64,
    /// Smallest determinant that can't be a zero with rounded lengths.
    pub(crate) resolution: f64,
    /// Meetings of the groups followed before.
    pub(crate) earlier: &'a [Meeting],
}

impl Judge<'_> {
    /// Judges the minimum near `q`.
    pub(crate) fn judge(&mut self, q: f64) -> Minimum {
        let is_rounded = |meeting: &&Meeting| {
            (meeting.coordinate - q).abs() < NEAR * self.sample && meeting.residue.abs() > CLEAN
        };
        let blurred = self.earlier.iter().find(is_rounded).copied();
        let distances = if blurred.is_some() { &DISTANCES[..COARSE] } else { &DISTANCES[..] };
        let (mut center, mut least_distance, mut residue) = (Dd::from_f64(q), 0.0_f64, f64::NAN);
        for distance in distances {
            // At a distance at which the four places are not in a gap that is only rounding.
            let distance = (distance * self.sample).max(least_distance);
            let lattice = LATTICE * distance;
            let place = (center.to_f64() / lattice).round() * lattice;
            let fit = match self.fit(Dd::from_f64(place), distance) {
                Ok(fit) => fit,
                Err(GroupError::NoAssembly { gap_m }) => return Minimum::Gap(q, gap_m),
                Err(_) => return Minimum::Beside,
            };
            center = fit.center;
            residue = fit.least;
            least_distance = 4.0 * self.resolution / fit.square.sqrt();
            let is_misplaced = (center - Dd::from_f64(q)).to_f64().abs() > self.sample;
            if fit.square.is_nan() || fit.square <= 0.0 || residue > FAR || is_misplaced {
                return Minimum::Beside;
            }
        }
        let limit = self.resolution * self.resolution;
        match blurred {
            Some(meeting) if residue.abs() <= BLURRED.max(limit) => {
                Minimum::Meeting(Meeting { coordinate: meeting.coordinate, residue })
            }
            None if residue.abs() <= limit => {
                Minimum::Meeting(Meeting { coordinate: center.to_f64(), residue })
            }
            _ if residue < 0.0 => match (self.determinant)(center) {
                Err(GroupError::NoAssembly { gap_m }) => Minimum::Gap(center.to_f64(), gap_m),
                _ => Minimum::Gap(center.to_f64(), 0.0),
            },
            _ => Minimum::Beside,
        }
    }

    /// Parabola through four places, two on each side; the group may have no assembly at the minimum itself.
    fn fit(&mut self, center: Dd, distance: f64) -> Result<Parabola, GroupError> {
        let mut at = |steps: f64| {
            let determinant = (self.determinant)(center + Dd::from_f64(steps * distance))?;
            Ok(determinant * determinant)
        };
        let (near, far) = ([at(-1.0)?, at(1.0)?], [at(-2.0)?, at(2.0)?]);
        let (inner, outer) = ((near[0] + near[1]).half(), (far[0] + far[1]).half());
        let square = (outer - inner).to_f64() / (3.0 * distance * distance);
        let shift = -((near[1] - near[0]).to_f64() / (4.0 * distance * square));
        // inner and outer hold slope² (shift² + distance²), with 4 distance² for the outer.
        let least = (inner + inner.twice() + inner - outer) / Dd::from_f64(3.0);
        Ok(Parabola {
            center: center + Dd::from_f64(shift),
            least: least.to_f64() - square * shift * shift,
            square,
        })
    }
}

#[cfg(test)]
mod tests;
