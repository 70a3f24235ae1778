//! A group of two links that can't be assembled: each link in its outer pair, turned towards the other, and the gap between
//! them.

use assur_group::{Body, PairGeometry};
use assur_kinematics::Position;
use assur_mechanism::LinkId;

use super::{Drawing, hull};
use crate::model::{Ink, Item, Point, Stroke};

/// A link in its outer pair alone.
#[derive(Debug, Clone, Copy)]
enum Hanging {
    /// It may turn about a pin: the place of the pin, and the same point in the frame of the link.
    Pin { at: Point, own: Point },
    /// It may slide along a line in this direction (a unit vector), from this pose.
    Slide { pose: Body<f64>, along: Point },
}

impl Drawing<'_> {
    /// The links of a group that can't be assembled, as near to each other as their outer pairs allow, and the gap between
    /// them as a dashed line. The links that the group is joined to must have their places in `pose`. Nothing for a group
    /// that is not two links with a pin between them, or two sliders.
    pub fn gap(&self, pose: &Position, group: usize) -> Vec<Item> {
        let Some(group) = self.linkage.structure.groups.get(group) else { return Vec::new() };
        let ([one, two], [inner]) = (&group.frame.links[..], &group.frame.inner[..]) else {
            return Vec::new();
        };
        let PairGeometry::Pin { at_a, at_b } = inner.geometry else { return Vec::new() };
        let links = [*one, *two];
        let ends = links.map(|link| if link == inner.a { at_a } else { at_b });
        let hanging = links.map(|link| hanging(pose, &group.frame.outer, link));
        let [Some(first), Some(second)] = hanging else { return Vec::new() };
        let Some(bodies) = nearest([first, second], ends) else { return Vec::new() };
        let mut items = Vec::new();
        for (link, body) in links.into_iter().zip(&bodies) {
            let outline: Vec<Point> =
                hull(&self.features(link)).into_iter().map(|at| body.point(at)).collect();
            items.extend(self.body(outline, link));
        }
        let ends = [0, 1].map(|number| bodies[number].point(ends[number]));
        items.push(Item::line(ends, Stroke::Dashed, Ink::Marked));
        items.push(Item::name([0, 1].map(|axis| 0.5 * (ends[0][axis] + ends[1][axis])), "gap", Ink::Marked));
        items
    }
}

/// How a link hangs in its outer pair; `None` if it has none.
fn hanging(pose: &Position, outer: &[assur_group::Pair], link: LinkId) -> Option<Hanging> {
    let pair = outer.iter().find(|pair| [pair.a, pair.b].contains(&link))?;
    let (is_a, other) = (pair.a == link, &pose.bodies[if pair.a == link { pair.b } else { pair.a }]);
    Some(match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => {
            let (own, outer) = if is_a { (at_a, at_b) } else { (at_b, at_a) };
            Hanging::Pin { at: other.point(outer), own }
        }
        PairGeometry::Slide { point, through, angle, tilt } => {
            let turn = if is_a { angle + tilt } else { -angle - tilt };
            let axis = other.turned([turn.cos(), turn.sin()]);
            let along = if is_a { angle } else { -tilt };
            let along = other.turned([along.cos(), along.sin()]);
            let (own, at) = if is_a { (point, other.point(through)) } else { (through, other.point(point)) };
            Hanging::Slide { pose: placed(axis, own, at), along }
        }
    })
}

/// A body whose x axis has a direction, with a point of its own at a place.
fn placed([c, s]: Point, own: Point, at: Point) -> Body<f64> {
    let turned = Body { c, s, ..Body::ground() };
    let arm = turned.point(own);
    Body { x: at[0] - arm[0], y: at[1] - arm[1], ..turned }
}

/// A body that hangs in a pin, with another point of its own in a direction from the pin.
fn turned(at: Point, own: Point, end: Point, [x, y]: Point) -> Body<f64> {
    let arm = [end[0] - own[0], end[1] - own[1]];
    let length = arm[0].hypot(arm[1]);
    let axis = if length > 0.0 {
        [(arm[0] * x + arm[1] * y) / length, (arm[0] * y - arm[1] * x) / length]
    } else {
        [1.0, 0.0]
    };
    placed(axis, own, at)
}

/// The poses in which the ends of two links are nearest to each other, where they can't meet.
fn nearest(hanging: [Hanging; 2], ends: [Point; 2]) -> Option<[Body<f64>; 2]> {
    let unit = |from: Point, to: Point| {
        let (x, y) = (to[0] - from[0], to[1] - from[1]);
        let length = x.hypot(y);
        if length > 0.0 { ([x / length, y / length], length) } else { ([1.0, 0.0], 0.0) }
    };
    match hanging {
        [Hanging::Pin { at: one, own: first }, Hanging::Pin { at: two, own: second }] => {
            let ([x, y], distance) = unit(one, two);
            let [(_, a), (_, b)] = [unit(first, ends[0]), unit(second, ends[1])];
            // Too far apart they point at each other; too near, the longer one reaches beyond the shorter one.
            let sense = if a > distance + b {
                [1.0, 1.0]
            } else if b > distance + a {
                [-1.0, -1.0]
            } else {
                [1.0, -1.0]
            };
            let [to, from] = sense.map(|sense| [sense * x, sense * y]);
            Some([turned(one, first, ends[0], to), turned(two, second, ends[1], from)])
        }
        [Hanging::Pin { at, own }, Hanging::Slide { pose, along }] => {
            let end = pose.point(ends[1]);
            let ahead = (at[0] - end[0]) * along[0] + (at[1] - end[1]) * along[1];
            let slid = Body { x: pose.x + ahead * along[0], y: pose.y + ahead * along[1], ..pose };
            let (direction, _) = unit(at, slid.point(ends[1]));
            Some([turned(at, own, ends[0], direction), slid])
        }
        [slide @ Hanging::Slide { .. }, pin @ Hanging::Pin { .. }] => {
            let [pin, slide] = nearest([pin, slide], [ends[1], ends[0]])?;
            Some([slide, pin])
        }
        [Hanging::Slide { .. }, Hanging::Slide { .. }] => None,
    }
}
