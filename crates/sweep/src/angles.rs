//! Angles of links without jumps from position to position.

use assur_kinematics::{Linkage, continuous_angle, first_angle};
use assur_mechanism::LinkId;
use assur_number::elementary;

/// An angle that differs by more than this (rad) from what the transfer functions at both ends of a step let expect is
/// not joined over the whole step.
const UNCLEAR: f64 = 0.5;

/// The angles of some links, followed along the coordinate.
#[derive(Debug, Default)]
pub(crate) struct Angles {
    /// Coordinate of the last position; `None` before the first.
    last: Option<f64>,
    /// Angle (rad) and its derivative in the last position, of each link.
    links: Vec<[f64; 2]>,
}

impl Angles {
    /// Forgets the positions.
    pub(crate) fn clear(&mut self) {
        self.last = None;
        self.links.clear();
    }

    /// Angle (rad) and derivative of each link in a solved position: in (-pi, pi] in the first one, then continuous.
    ///
    /// `poses`: each link with cosine and sine of its angle and the derivative.
    pub(crate) fn follow(
        &mut self,
        linkage: &Linkage,
        coordinate: f64,
        poses: impl Iterator<Item = (LinkId, [f64; 3])>,
    ) -> &[[f64; 2]] {
        let Some(from) = self.last.replace(coordinate) else {
            self.links.extend(poses.map(|(_, [c, s, w])| [first_angle(elementary::atan2(s, c)), w]));
            return &self.links;
        };
        let way = coordinate - from;
        for ([angle, rate], (link, [c, s, w])) in self.links.iter_mut().zip(poses) {
            let expected = *angle + 0.5 * (*rate + w) * way;
            let plain = elementary::atan2(s, c);
            let joined = continuous_angle(plain, expected);
            // Comparing this way round, an angle that is not a number is unclear too.
            let clear = (joined - expected).abs() <= UNCLEAR;
            *angle = if clear { joined } else { in_steps(linkage, link, [from, coordinate], *angle, plain) };
            *rate = w;
        }
        &self.links
    }
}

/// The angle of a link at the end of a step, joined in short steps to that at its start; where the mechanism can't be
/// assembled in between, the nearest angle is used.
fn in_steps(linkage: &Linkage, link: LinkId, ends: [f64; 2], start: f64, end: f64) -> f64 {
    let mut angle = start;
    linkage.each_between(ends, |position| {
        let body = &position.bodies[link];
        angle = continuous_angle(elementary::atan2(body.s, body.c), angle);
    });
    continuous_angle(end, angle)
}
