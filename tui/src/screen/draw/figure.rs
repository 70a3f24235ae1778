//! The drawing of a mechanism as shapes: segments of links, blocks on guides, pins, hatched ground.

#[cfg(test)]
mod tests;

use assur_group::Body;
use assur_kinematics::Linkage;
use assur_mechanism::{GROUND, LinkId};

/// One thing to draw, in the plane, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// A straight piece of a link.
    Bar([f64; 2], [f64; 2]),
    /// A slider: a block in a given direction.
    Block([f64; 2], [f64; 2]),
    /// The guide line of a slide on the ground, hatched on its right side.
    GroundGuide([f64; 2], [f64; 2]),
    /// A pin between moving links.
    Pin([f64; 2]),
    /// A pin on the ground: a bearing on a hatched base.
    GroundPin([f64; 2]),
}

/// A shape and the link that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Part {
    pub(crate) link: LinkId,
    pub(crate) shape: Shape,
}

/// The figure of a mechanism in one position; `strokes` are the least and greatest displacement of each slide, m.
pub(crate) fn figure(linkage: &Linkage, bodies: &[Body<f64>], strokes: &[[f64; 2]]) -> Vec<Part> {
    let mut parts = guides(linkage, bodies, strokes);
    for (link, body) in bodies.iter().enumerate().skip(1) {
        let outline = hull(&features(linkage, link));
        let at = |local: [f64; 2]| body.point(local);
        let edges = outline.len();
        // Three points and more form a closed outline, two points a bar.
        let closed = usize::from(edges > 2);
        for i in 0..(edges + closed).saturating_sub(1) {
            let shape = Shape::Bar(at(outline[i]), at(outline[(i + 1) % edges]));
            parts.push(Part { link, shape });
        }
    }
    parts.extend(blocks(linkage, bodies));
    parts.extend(pins(linkage, bodies));
    parts
}

/// The guides: on the ground hatched, on a link a bar over the stroke of the slider.
fn guides(linkage: &Linkage, bodies: &[Body<f64>], strokes: &[[f64; 2]]) -> Vec<Part> {
    let mut parts = Vec::new();
    for (slide, &[low, high]) in linkage.mechanism.slides.iter().zip(strokes) {
        if !(low.is_finite() && high.is_finite()) {
            continue;
        }
        let body = &bodies[slide.on];
        let (s, c) = slide.angle.sin_cos();
        let [through, along] = [body.point(slide.through), body.turned([c, s])];
        let at = |d: f64| [through[0] + d * along[0], through[1] + d * along[1]];
        let beyond = (0.08 * (high - low)).max(0.02 * linkage.structure.scale);
        let (from, to) = (at(low - beyond), at(high + beyond));
        let shape = if slide.on == GROUND { Shape::GroundGuide(from, to) } else { Shape::Bar(from, to) };
        parts.push(Part { link: slide.on, shape });
    }
    parts
}

fn blocks<'a>(linkage: &'a Linkage, bodies: &'a [Body<f64>]) -> impl Iterator<Item = Part> + 'a {
    linkage.mechanism.slides.iter().map(|slide| {
        let (s, c) = slide.angle.sin_cos();
        let (center, along) = (bodies[slide.link].point(slide.point), bodies[slide.on].turned([c, s]));
        Part { link: slide.link, shape: Shape::Block(center, along) }
    })
}

fn pins<'a>(linkage: &'a Linkage, bodies: &'a [Body<f64>]) -> impl Iterator<Item = Part> + 'a {
    linkage.mechanism.points.iter().filter(|point| point.is_pin()).map(|point| {
        let ground = point.places.iter().find(|place| place.link == GROUND);
        if let Some(place) = ground {
            return Part { link: GROUND, shape: Shape::GroundPin(place.at) };
        }
        let place = point.places[0];
        Part { link: place.link, shape: Shape::Pin(bodies[place.link].point(place.at)) }
    })
}

/// The places of a link that its outline joins, in its frame.
fn features(linkage: &Linkage, link: LinkId) -> Vec<[f64; 2]> {
    let mechanism = &linkage.mechanism;
    let named = mechanism.points.iter().enumerate().filter_map(|(id, _)| mechanism.place_in(id, link));
    let stones = mechanism.slides.iter().filter(|slide| slide.link == link).map(|slide| slide.point);
    let carried = mechanism.slides.iter().filter(|slide| slide.on == link).map(|slide| slide.through);
    named.chain(stones).chain(carried).collect()
}

/// Convex hull (Andrew's monotone chain); collinear points give their two ends.
pub(crate) fn hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9);
    if sorted.len() < 3 {
        return sorted;
    }
    let mut lower = half_hull(sorted.iter().copied());
    let mut upper = half_hull(sorted.iter().rev().copied());
    lower.pop();
    upper.pop();
    lower.extend(upper);
    lower
}

fn half_hull(points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for p in points {
        while let [.., a, b] = chain[..] {
            let cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            let size = (b[0] - a[0]).hypot(b[1] - a[1]) * (p[0] - a[0]).hypot(p[1] - a[1]);
            if cross > 1e-9 * size {
                break;
            }
            chain.pop();
        }
        chain.push(p);
    }
    chain
}
