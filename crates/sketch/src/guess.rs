//! Places links that are not solved, by what is known of their points.

use assur_group::plane::minus;
use assur_mechanism::{LinkId, Mechanism};

use crate::pose::{Line, Pose, angle_of, distance, foot};
use crate::sketch::place_of;

/// Places one link after another, that of which most is known first, until nothing tells of the others.
pub(crate) fn guess(mechanism: &Mechanism, bodies: &mut [Option<Pose>]) {
    loop {
        let open = (0..bodies.len()).rev().filter(|link| bodies[*link].is_none());
        let known = open.filter_map(|link| Some((link, pose(mechanism, bodies, link)?)));
        let Some((link, (_, pose))) = known.max_by_key(|(_, (certainty, _))| *certainty) else { return };
        bodies[link] = Some(pose);
    }
}

/// Where a link may be, and how certain that is: by two points, by a point and a slide, by a slide, by a point.
fn pose(mechanism: &Mechanism, bodies: &[Option<Pose>], link: LinkId) -> Option<(u8, Pose)> {
    let points = (0..mechanism.points.len())
        .filter_map(|point| Some((mechanism.place_in(point, link)?, place_of(mechanism, bodies, point)?)));
    let points: Vec<_> = points.collect();
    let guide = guided(mechanism, bodies, link);
    let Some(&(own, place)) = points.first() else {
        let (angle, own, line) = guide?;
        return Some((2, Pose::putting(own, line.0, angle)));
    };
    let apart = |other: &([f64; 2], [f64; 2])| distance(other.0, own);
    let far = points.iter().max_by(|a, b| apart(a).total_cmp(&apart(b)));
    match (far.filter(|far| apart(far) > 0.0), guide) {
        (Some(far), _) => {
            let angle = angle_of(minus(far.1, place)) - angle_of(minus(far.0, own));
            Some((4, Pose::putting(own, place, angle)))
        }
        (None, Some((angle, on_line, line))) => {
            // The point of the slide lies on the line, wherever the other point was wanted.
            let there = Pose::putting(own, place, angle).point(on_line);
            Some((3, Pose::putting(on_line, foot(line, there), angle)))
        }
        (None, None) => Some((1, Pose::putting(own, place, 0.0))),
    }
}

/// What a slide on a placed link tells of a link: its angle, a point of it, and the line on which that lies.
fn guided(mechanism: &Mechanism, bodies: &[Option<Pose>], link: LinkId) -> Option<(f64, [f64; 2], Line)> {
    mechanism.slides.iter().find_map(|slide| {
        let turn = slide.angle + slide.tilt;
        if slide.link == link {
            let on = bodies[slide.on]?;
            Some((on.angle + turn, slide.point, (on.point(slide.through), on.angle + slide.angle)))
        } else if slide.on == link {
            let on = bodies[slide.link]?;
            Some((on.angle - turn, slide.through, (on.point(slide.point), on.angle - slide.tilt)))
        } else {
            None
        }
    })
}
