//! The angle of a link without jumps from position to position.

use assur_kinematics::{LanePosition, Linkage, continuous_angle, first_angle};
use assur_mechanism::LinkId;
use assur_number::{Lanes, elementary};

/// An angle that differs by more than this (rad) from what the transfer functions at both ends of a step let expect is
/// not joined over the whole step.
const UNCLEAR: f64 = 0.5;

/// The angle of a link, followed along the coordinate.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Followed {
    /// Coordinate, angle (rad) and its derivative in the last position; `None` before the first.
    last: Option<[f64; 3]>,
}

impl Followed {
    /// The angle (rad) in those of eight solved positions that are marked: in (-pi, pi] in the first one of all, then continuous.
    pub(crate) fn follow(
        &mut self,
        (linkage, link): (&Linkage, LinkId),
        position: &LanePosition,
        valid: [bool; Lanes::WIDTH],
    ) -> Lanes {
        let body = &position.bodies[link];
        let mut angles = Lanes::default();
        for lane in (0..Lanes::WIDTH).filter(|&lane| valid[lane]) {
            let [c, s, rate, to] = [body.c, body.s, body.w1, position.coordinates].map(|of| of.0[lane]);
            let plain = elementary::atan2(s, c);
            let angle = self.last.map_or_else(
                || first_angle(plain),
                |[from, angle, before]| {
                    let expected = angle + 0.5 * (before + rate) * (to - from);
                    let joined = continuous_angle(plain, expected);
                    // Comparing this way round, an angle that is not a number is unclear too.
                    let is_clear = (joined - expected).abs() <= UNCLEAR;
                    if is_clear { joined } else { in_steps(linkage, link, [from, to], angle, plain) }
                },
            );
            self.last = Some([to, angle, rate]);
            angles.0[lane] = angle;
        }
        angles
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
