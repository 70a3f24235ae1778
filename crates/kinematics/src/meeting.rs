//! What happens where the determinant of a group has a minimum: do two ways meet there, and exactly where.

use assur_group::{Body, GroupError};
use assur_number::{Dd, Real};

use crate::wide::Wide;

/// What a minimum of a determinant is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Minimum {
    /// Two ways meet at this coordinate, as exactly as the lengths are given: the motion goes through into the other.
    ///
    /// With it what is left of the squared determinant: rounding of the lengths, or 0.
    Meeting(f64, f64),
    /// The ways come near each other and part again: the motion stays in its way.
    Beside,
    /// The group can't be assembled there (at this coordinate), by so much (m).
    Gap(f64, f64),
}

/// Distance from a supposed minimum at which the determinant is looked at, in samples of the walk: coarse first, so that
/// the minimum may be misplaced, then so fine that higher orders of the parabola are below 1e-30.
const REACH: [f64; 3] = [3e-2, 1e-4, 1e-6];

/// What a group before leaves of its squared determinant at the same place is rounding of 32 digits below this.
const CLEAN: f64 = 1e-26;

/// The least squared determinant that counts, behind a group whose own meeting there is rounded: its places are known to
/// some 1e-16 / reach only.
const BLURRED: f64 = 1e-11;

/// A minimum above this is no meeting, whatever the rounding.
const FAR: f64 = 1e-3;

/// Golden-section search for the least value of a determinant: where, and how much.
pub(crate) fn least_between(low: f64, high: f64, mut health: impl FnMut(f64) -> f64) -> (f64, f64) {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (low, high);
    let (mut x, mut y) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut fx, mut fy) = (health(x), health(y));
    for _ in 0..90 {
        if fx <= fy {
            (b, y, fy) = (y, x, fx);
            x = b - ratio * (b - a);
            fx = health(x);
        } else {
            (a, x, fx) = (x, y, fy);
            y = a + ratio * (b - a);
            fy = health(y);
        }
    }
    if fx <= fy { (x, fx) } else { (y, fy) }
}

/// A parabola h² = least + slope² (q - center)² of the squared determinant.
struct Parabola {
    center: Dd,
    least: f64,
    /// slope².
    square: f64,
}

/// Decides by the squared determinant, which is smooth in the coordinate where the determinant itself is a root.
pub(crate) struct Judge<'a> {
    pub(crate) wide: &'a Wide,
    pub(crate) bodies: &'a [Body<f64>],
    /// Ways of the groups up to this one at a coordinate.
    pub(crate) ways: &'a dyn Fn(f64) -> Vec<Option<usize>>,
    /// Distance of two samples of the walk.
    pub(crate) sample: f64,
    /// Least determinant that rounding of the lengths can't make of zero.
    pub(crate) resolution: f64,
    /// Meetings of the groups before: coordinate, and what is left of the squared determinant.
    pub(crate) before: &'a [(f64, f64)],
}

impl Judge<'_> {
    /// Judges the minimum near `q`, where the determinant is about `least`.
    pub(crate) fn judge(&self, q: f64, least: f64) -> Minimum {
        if least > FAR {
            return Minimum::Beside;
        }
        let beside =
            |&&(place, left): &&(f64, f64)| (place - q).abs() < REACH[1] * self.sample && left.abs() > CLEAN;
        let blurred = self.before.iter().find(beside);
        let reaches = if blurred.is_some() { &REACH[..1] } else { &REACH[..] };
        let (mut center, mut wanted, mut left) = (Dd::from_f64(q), 0.0_f64, f64::NAN);
        for reach in reaches {
            // Not so near that the four places fall into a gap that is rounding only.
            let reach = (reach * self.sample).max(wanted);
            let fit = match self.fit(center, reach) {
                Ok(fit) => fit,
                Err(GroupError::NoAssembly { gap_m }) => return Minimum::Gap(q, gap_m),
                Err(_) => return Minimum::Beside,
            };
            if fit.square.is_nan() || fit.square <= 0.0 {
                return Minimum::Beside;
            }
            center = fit.center;
            wanted = 4.0 * self.resolution / fit.square.sqrt();
            left = fit.least;
            if (center - Dd::from_f64(q)).to_f64().abs() > self.sample {
                return Minimum::Beside;
            }
        }
        let limit = self.resolution * self.resolution;
        match blurred {
            Some(&(place, _)) if left.abs() <= BLURRED.max(limit) => Minimum::Meeting(place, left),
            None if left.abs() <= limit => Minimum::Meeting(center.to_f64(), left),
            _ if left < 0.0 => Minimum::Gap(center.to_f64(), self.gap(center)),
            _ => Minimum::Beside,
        }
    }

    /// By how much the group misses, m.
    fn gap(&self, center: Dd) -> f64 {
        match self.square_at(center) {
            Err(GroupError::NoAssembly { gap_m }) => gap_m,
            _ => 0.0,
        }
    }

    fn square_at(&self, q: Dd) -> Result<Dd, GroupError> {
        self.wide.square(q, self.bodies, &(self.ways)(q.to_f64()))
    }

    /// Parabola through four places, two on each side; the minimum itself may have no assembly.
    fn fit(&self, center: Dd, reach: f64) -> Result<Parabola, GroupError> {
        let at = |steps: f64| self.square_at(center + Dd::from_f64(steps * reach));
        let (near, far) = ([at(-1.0)?, at(1.0)?], [at(-2.0)?, at(2.0)?]);
        let (inner, outer) = ((near[0] + near[1]).half(), (far[0] + far[1]).half());
        let square = (outer - inner).to_f64() / (3.0 * reach * reach);
        let shift = -((near[1] - near[0]).to_f64() / (4.0 * reach * square));
        // inner and outer hold slope² (shift² + reach²), with 4 reach² for the outer.
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
