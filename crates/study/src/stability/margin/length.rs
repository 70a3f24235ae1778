//! The lengths of a mechanism, and the mechanism with one of them changed.

use assur_mechanism::{LinkId, Mechanism};
use assur_words::{Text, text};

pub(crate) enum Length {
    /// From one joint of a link to another one, which moves.
    Joints {
        link: LinkId,
        from: usize,
        to: usize,
    },
    Offset {
        slide: usize,
    },
}

/// All lengths of a mechanism that are not zero, and the offsets of its guides.
pub(super) fn lengths(mechanism: &Mechanism) -> Vec<Length> {
    let mut lengths = Vec::new();
    let pins: Vec<usize> = (0..mechanism.points.len()).filter(|&p| mechanism.points[p].is_pin()).collect();
    for link in 0..mechanism.links.len() {
        let joints: Vec<_> =
            pins.iter().copied().filter(|&p| mechanism.place_in(p, link).is_some()).collect();
        for (i, &from) in joints.iter().enumerate() {
            for &to in &joints[i + 1..] {
                if distance(mechanism, link, from, to) > 0.0 {
                    lengths.push(Length::Joints { link, from, to });
                }
            }
        }
    }
    lengths.extend((0..mechanism.slides.len()).map(|slide| Length::Offset { slide }));
    lengths
}

fn ends(mechanism: &Mechanism, link: LinkId, from: usize, to: usize) -> [[f64; 2]; 2] {
    [from, to].map(|point| mechanism.place_in(point, link).unwrap_or_default())
}

fn distance(mechanism: &Mechanism, link: LinkId, from: usize, to: usize) -> f64 {
    let [a, b] = ends(mechanism, link, from, to);
    (b[0] - a[0]).hypot(b[1] - a[1])
}

impl Length {
    /// In words, and its value, m.
    pub(super) fn show(&self, mechanism: &Mechanism) -> (Text, f64) {
        match *self {
            Self::Joints { link, from, to } => {
                let [start, end] = [from, to].map(|point| &mechanism.points[point].name);
                let words =
                    text!("stability-joints", link = &mechanism.links[link].name, from = start, to = end);
                (words, distance(mechanism, link, from, to))
            }
            Self::Offset { slide } => {
                let found = &mechanism.slides[slide];
                let (s, c) = found.angle.sin_cos();
                let value = c * found.through[1] - s * found.through[0];
                (text!("stability-offset", slide = &found.name), value)
            }
        }
    }

    pub(super) fn ends_at_zero(&self) -> bool {
        matches!(self, Self::Joints { .. })
    }

    /// The mechanism with this length increased by `change`, m.
    #[expect(
        clippy::float_cmp,
        reason = "a guide that is given by the name of a joint has the very numbers of the joint"
    )]
    pub(super) fn changed(&self, mechanism: &Mechanism, change: f64) -> Mechanism {
        let mut mechanism = mechanism.clone();
        match *self {
            Self::Joints { link, from, to } => {
                let [a, b] = ends(&mechanism, link, from, to);
                let part = change / distance(&mechanism, link, from, to);
                let moved = [b[0] + part * (b[0] - a[0]), b[1] + part * (b[1] - a[1])];
                let points = mechanism.points[to].places.iter_mut().map(|place| (place.link, &mut place.at));
                // The place of a guide through the joint, or of a slide held by it, is dimensioned from the joint.
                let slides = mechanism
                    .slides
                    .iter_mut()
                    .flat_map(|slide| [(slide.link, &mut slide.point), (slide.on, &mut slide.through)]);
                for (_, at) in points.chain(slides).filter(|(on, at)| *on == link && **at == b) {
                    *at = moved;
                }
            }
            Self::Offset { slide } => {
                let found = &mut mechanism.slides[slide];
                let (s, c) = found.angle.sin_cos();
                found.through = [found.through[0] - s * change, found.through[1] + c * change];
            }
        }
        mechanism
    }
}
