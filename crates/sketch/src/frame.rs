//! The frames of new links.

use assur_group::plane::{direction, minus, plus, scaled};

use crate::group::Plan;
use crate::layout::meet;
use crate::number::rounded;
use crate::pose::{Line, Pose, angle_of, distance};
use crate::shape::Joint;

/// How far from the pin of a link a further point is put, in sizes of the mechanism: beyond what slides there.
const BEYOND: f64 = 1.4;

/// A new link in the plane.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) pose: Pose,
    /// Its points with their coordinates in its frame, rounded, m.
    pub(crate) points: Vec<(String, [f64; 2])>,
}

impl Frame {
    /// The frames of all links: the origin is the first point, and the x axis points to the second one, or along the first slide.
    pub(crate) fn all(plan: &Plan<'_>, joints: &[Joint]) -> Vec<Self> {
        (0..plan.shape.links).map(|link| Self::of(plan, joints, link)).collect()
    }

    fn of(plan: &Plan<'_>, joints: &[Joint], link: usize) -> Self {
        let shape = &plan.shape;
        let pins = shape.pins(link).filter_map(|bond| match joints[bond] {
            Joint::Pin(place) => Some((plan.pins[bond].clone(), place)),
            Joint::Guide(_) => None,
        });
        let mut places: Vec<(String, [f64; 2])> = pins.collect();
        let lines: Vec<Line> = shape.slides(link).filter_map(|bond| line(joints[bond])).collect();
        let is_free = shape.bonds.is_empty();
        for (index, (_, name)) in plan.own.iter().filter(|(of, _)| *of == link).enumerate() {
            let place = if is_free { plan.ends[index] } else { own_place(&places, &lines, plan.size) };
            places.push((name.clone(), place));
        }
        let origin = places.first().map_or([0.0; 2], |first| first.1);
        let angle = match (places.get(1), lines.first()) {
            (Some(second), _) if distance(second.1, origin) > 0.0 => angle_of(minus(second.1, origin)),
            (_, Some(line)) => line.1,
            _ => 0.0,
        };
        let pose = Pose { at: origin, angle };
        let local = |(name, place): (String, [f64; 2])| {
            (name, pose.local(place).map(|part| rounded(part, plan.step)))
        };
        Self { pose, points: places.into_iter().map(local).collect() }
    }
}

/// The line of a slide.
pub(crate) fn line(joint: Joint) -> Option<Line> {
    match joint {
        Joint::Guide(line) => Some(line),
        Joint::Pin(_) => None,
    }
}

/// Where a point of a link is put that is no pin: where its guides meet; of a link with a pin, along the guide beyond what slides.
fn own_place(pins: &[(String, [f64; 2])], lines: &[Line], size: f64) -> [f64; 2] {
    match (pins, lines) {
        ([(_, pin), ..], [line, ..]) => {
            let along = direction(line.1);
            plus(*pin, scaled(BEYOND * size, along))
        }
        (_, [one, others @ ..]) => others.iter().find_map(|other| meet(*one, *other)).unwrap_or(one.0),
        _ => [0.0; 2],
    }
}
