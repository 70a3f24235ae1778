//! A group that can't be assembled, with its gap: of two links each in its outer pair, turned towards the other; of any other
//! kind the group as it is in another position, with what is open then.

use assur_group::{Body, GroupFrame, Pair, PairGeometry};
use assur_kinematics::Position;
use assur_mechanism::LinkId;
use assur_words::text;

use super::Drawing;
use crate::model::{Ink, Item, Point, Stroke};

/// A gap below this part of the size of the mechanism is none.
const CLOSED: f64 = 1e-9;

/// A link in its outer pair alone.
#[derive(Debug, Clone, Copy)]
enum Hanging {
    /// It may turn about a pin: the place of the pin, and the same point in the frame of the link.
    Pin { at: Point, own: Point },
    /// It may slide along a line in this direction (a unit vector), from this pose.
    Slide { pose: Body<f64>, along: Point },
}

impl Drawing<'_> {
    /// The links of a group that can't be assembled, and the gaps between them as dashed lines. The links that the group is
    /// joined to must have their places in `pose`.
    ///
    /// Two links with a pin between them are as near to each other as their outer pairs allow. A group of another kind has
    /// the poses of the position `near`, in which it exists; nothing is drawn where there is none.
    pub fn gap(&self, pose: &Position, near: Option<&Position>, group: usize) -> Vec<Item> {
        let Some(group) = self.linkage.structure.groups.get(group) else { return Vec::new() };
        let mut bodies = pose.bodies.clone();
        if let Some(poses) = two_links(pose, &group.frame) {
            for (link, body) in poses {
                bodies[link] = body;
            }
        } else if let Some(near) = near {
            for &link in &group.frame.links {
                bodies[link] = near.bodies[link];
            }
        } else {
            return Vec::new();
        }
        let mut items = Vec::new();
        for &link in &group.frame.links {
            items.extend(self.body(self.outline(link, &bodies[link]), link));
        }
        for ends in group.frame.pairs().map(|pair| open(pair, &bodies)) {
            if (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1])
                > CLOSED * self.linkage.structure.scale
            {
                items.push(Item::line(ends, Stroke::Dashed, Ink::Marked));
                let middle = [0, 1].map(|axis| 0.5 * (ends[0][axis] + ends[1][axis]));
                items.push(Item::name(middle, text!("figure-gap"), Ink::Marked));
            }
        }
        items
    }
}

/// The places of a pair on both of its bodies; of a slide the point, and its foot on the guide.
fn open(pair: &Pair, bodies: &[Body<f64>]) -> [Point; 2] {
    let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
    match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => [a.point(at_a), b.point(at_b)],
        PairGeometry::Slide { point, through, angle, .. } => {
            let (point, through) = (a.point(point), b.point(through));
            let along = b.turned([angle.cos(), angle.sin()]);
            let ahead = (point[0] - through[0]) * along[0] + (point[1] - through[1]) * along[1];
            [point, [through[0] + ahead * along[0], through[1] + ahead * along[1]]]
        }
    }
}

/// Two links with a pin between them, each in its outer pair, as near to each other as they come; `None` for another kind.
fn two_links(pose: &Position, frame: &GroupFrame) -> Option<[(LinkId, Body<f64>); 2]> {
    let ([one, two], [inner]) = (&frame.links[..], &frame.inner[..]) else { return None };
    let PairGeometry::Pin { at_a, at_b } = inner.geometry else { return None };
    let links = [*one, *two];
    let ends = links.map(|link| if link == inner.a { at_a } else { at_b });
    let [first, second] = links.map(|link| hanging(pose, &frame.outer, link));
    let [one, two] = nearest([first?, second?], ends)?;
    Some([(links[0], one), (links[1], two)])
}

/// How a link is attached by its outer pair; `None` if it has none.
fn hanging(pose: &Position, outer: &[Pair], link: LinkId) -> Option<Hanging> {
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

/// A body that is attached by a pin, with another point of its own in a direction from the pin.
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
