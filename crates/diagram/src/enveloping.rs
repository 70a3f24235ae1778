//! The straight line that an arc of a link envelopes (L, the press).

use assur_group::Order;
use assur_kinematics::Linkage;
use assur_mechanism::{Contact, Name};
use serde::Serialize;

use crate::DiagramError;

/// The arc in one position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EnvelopingPoint {
    /// Coordinate, rad or m.
    pub coordinate: f64,
    /// Lowest point of the arc, m.
    pub lowest: [f64; 2],
    /// Its height above the line, m.
    pub deviation: f64,
    /// Speed of sliding along the line at the lowest point, per unit speed of the coordinate, m/rad; 0 where the arc rolls.
    pub sliding: f64,
}

/// How well an arc envelopes a horizontal straight line.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Enveloping {
    /// Name of the contact.
    pub contact: Name,
    /// The interval of the coordinate, rad or m.
    pub interval: [f64; 2],
    /// Height of the line from which the path deviates least: the middle between its highest and lowest place, m.
    pub level: f64,
    /// Greatest deviation from the line, m.
    pub greatest: f64,
    /// Coordinate where it occurs first.
    pub greatest_at: f64,
    /// Displacement of the lowest point along the line between both ends of the interval, m, with its sign.
    pub way: f64,
    /// The path.
    pub path: Vec<EnvelopingPoint>,
}

/// Path of the lowest point of an arc over the interval of its contact (without one: over the positions of the scene),
/// at `count` equally spaced places, at least 2, both ends included. `name`: that of the contact.
pub fn enveloping(
    linkage: &Linkage,
    name: &Name,
    contact: &Contact,
    count: usize,
) -> Result<Enveloping, DiagramError> {
    let count = count.max(2);
    let interval = contact.during.unwrap_or_else(|| linkage.mechanism.input.ends());
    let path = path(linkage, contact, interval, count)?;
    let heights = || path.iter().map(|point| point.lowest[1]);
    let level =
        f64::midpoint(heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max));
    let leveled = path.iter().map(|point| EnvelopingPoint { deviation: point.lowest[1] - level, ..*point });
    let path: Vec<EnvelopingPoint> = leveled.collect();
    let farther = |worst: EnvelopingPoint, point: &EnvelopingPoint| {
        if point.deviation.abs() > worst.deviation.abs() { *point } else { worst }
    };
    let worst = path.iter().fold(path[0], farther);
    Ok(Enveloping {
        contact: name.clone(),
        interval,
        level,
        greatest: worst.deviation.abs(),
        greatest_at: worst.coordinate,
        way: path[count - 1].lowest[0] - path[0].lowest[0],
        path,
    })
}

fn path(
    linkage: &Linkage,
    contact: &Contact,
    [from, to]: [f64; 2],
    count: usize,
) -> Result<Vec<EnvelopingPoint>, DiagramError> {
    let mut position = linkage.position();
    let mut list = Vec::with_capacity(count);
    for index in 0..count {
        let coordinate = from + (to - from) * (index as f64) / ((count - 1) as f64);
        linkage.solve(coordinate, Order::First, &mut position)?;
        let body = &position.bodies[contact.center.link];
        let center = body.arm(contact.center.at);
        // The line is horizontal, so the lowest point is below the center, however the link is turned.
        let arm = [center[0], center[1] - contact.radius];
        let lowest = [body.x + arm[0], body.y + arm[1]];
        list.push(EnvelopingPoint { coordinate, lowest, deviation: 0.0, sliding: body.first(arm)[0] });
    }
    Ok(list)
}
