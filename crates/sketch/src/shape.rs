//! The links and pairs of what is added, with the sorts that were chosen.

use assur_group::PairSort::Slide;
use assur_mechanism::{LinkId, Mechanism};
use assur_words::{Text, text};

use crate::number::rounded;
use crate::pose::{Line, Pose, distance, off, reduced};
use crate::{Addition, Sketch, Target};

/// A pair: a link of what is added with another one of it, or with an outer body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bond {
    /// The link; of a slide that which slides.
    pub(crate) link: usize,
    /// The other link; `None` for an outer body.
    pub(crate) on: Option<usize>,
    /// Whether it is a slide.
    pub(crate) slides: bool,
}

/// Links and pairs, first the inner ones.
#[derive(Debug)]
pub(crate) struct Shape {
    pub(crate) links: usize,
    pub(crate) bonds: Vec<Bond>,
    pub(crate) inner: usize,
}

impl Shape {
    pub(crate) fn of(addition: &Addition) -> Self {
        let pattern = addition.pattern;
        let inner = pattern.inner.iter().map(|(ends, _)| (ends[0], Some(ends[1])));
        let ends: Vec<_> = inner.chain(pattern.outer.iter().map(|(link, _)| (*link, None))).collect();
        let pairs = |link: usize| ends.iter().filter(|(one, on)| *one == link || *on == Some(link)).count();
        let bond = |(&(link, on), sort): (&(usize, Option<usize>), &_)| {
            let slides = *sort == Slide;
            // Of two links the one with fewer pairs slides, as a stone.
            match on {
                Some(on) if slides && pairs(on) < pairs(link) => Bond { link: on, on: Some(link), slides },
                _ => Bond { link, on, slides },
            }
        };
        let bonds = ends.iter().zip(&addition.sorts).map(bond).collect();
        Self { links: pattern.links, bonds, inner: pattern.inner.len() }
    }

    /// The pairs of a link that are pins, the outer ones first.
    pub(crate) fn pins(&self, link: usize) -> impl Iterator<Item = usize> {
        let all = (self.inner..self.bonds.len()).chain(0..self.inner);
        all.filter(move |bond| !self.bonds[*bond].slides && self.has(*bond, link))
    }

    /// The slides of a link, those in which it slides first.
    pub(crate) fn slides(&self, link: usize) -> impl Iterator<Item = usize> {
        let all = |own: bool| {
            let of = move |bond: &usize| self.bonds[*bond].slides && (self.bonds[*bond].link == link) == own;
            (0..self.bonds.len()).filter(of)
        };
        all(true).chain(all(false)).filter(move |bond| self.has(*bond, link))
    }

    /// Whether a link slides on another one.
    pub(crate) fn is_slider(&self, link: usize) -> bool {
        self.bonds.iter().any(|bond| bond.slides && bond.link == link)
    }

    fn has(&self, bond: usize, link: usize) -> bool {
        self.bonds[bond].link == link || self.bonds[bond].on == Some(link)
    }
}

/// A pair in the plane.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Joint {
    /// The place of a pin.
    Pin([f64; 2]),
    /// The line of a guide.
    Guide(Line),
}

impl Joint {
    /// The pin, or the point through which the guide goes.
    pub(crate) fn place(self) -> [f64; 2] {
        match self {
            Self::Pin(place) | Self::Guide((place, _)) => place,
        }
    }
}

/// What an outer pair joins.
#[derive(Debug)]
pub(crate) struct Outer {
    pub(crate) joint: Joint,
    /// The point that is the pin, or one on the guide; `None`: a new one, or coordinates.
    pub(crate) point: Option<String>,
    /// The link that gets a new point or carries the guide.
    pub(crate) link: LinkId,
    pub(crate) pose: Pose,
}

impl Outer {
    /// What a target is in the plane; its numbers are rounded as they are written.
    pub(crate) fn of(
        sketch: &Sketch,
        (number, target): (usize, &Target),
        slides: bool,
        step: f64,
    ) -> Result<Self, Text> {
        let mechanism = &sketch.mechanism;
        match target {
            Target::Point(point) if !slides => {
                let place =
                    sketch.place(point).ok_or_else(|| text!("sketch-no-place", name = quoted(point)))?;
                let joint = Joint::Pin(place);
                Ok(Self { joint, point: Some(point.clone()), link: 0, pose: Pose::GROUND })
            }
            Target::New { link, at } if !slides => {
                let (link, pose) = carrier(sketch, link)?;
                let place = pose.point(pose.local(*at).map(|part| rounded(part, step)));
                Ok(Self { joint: Joint::Pin(place), point: None, link, pose })
            }
            Target::Guide { link, through, angle, point } if slides => {
                let (link, pose) = carrier(sketch, link)?;
                let own = pose.local(*through).map(|part| rounded(part, step));
                let turn = rounded(reduced(angle - pose.angle).to_degrees(), 0.01).to_radians();
                let mut line = (pose.point(own), pose.angle + turn);
                let named = point.as_ref().map(|point| {
                    let at = mechanism.point(point).and_then(|point| mechanism.place_in(point, link));
                    at.ok_or_else(|| {
                        text!(
                            "sketch-not-on-link",
                            name = quoted(point),
                            link = quoted(&mechanism.links[link].name)
                        )
                    })
                });
                if let Some(own) = named.transpose()? {
                    line.0 = pose.point(own);
                }
                let point = point.clone().or_else(|| on_line(mechanism, link, &pose, line));
                Ok(Self { joint: Joint::Guide(line), point, link, pose })
            }
            _ if slides => Err(text!("sketch-wants-guide", number = assur_words::number(number))),
            _ => Err(text!("sketch-wants-point", number = assur_words::number(number))),
        }
    }
}

/// A named point of a link on a line, the nearest to where the line was given.
fn on_line(mechanism: &Mechanism, link: LinkId, pose: &Pose, line: Line) -> Option<String> {
    let points = mechanism.points.iter().filter_map(|point| Some((point, pose.point(point.on(link)?))));
    let on = points.filter(|(_, at)| off(line, *at).abs() <= 1e-9 + 1e-9 * distance(*at, line.0));
    let nearest = on.min_by(|a, b| distance(a.1, line.0).total_cmp(&distance(b.1, line.0)));
    nearest.map(|(point, _)| point.name.to_string())
}

/// A link that stands, and its pose.
fn carrier(sketch: &Sketch, link: &str) -> Result<(LinkId, Pose), Text> {
    let id = sketch.mechanism.link(link).ok_or_else(|| text!("sketch-no-link", name = quoted(link)))?;
    let pose = sketch.bodies[id].ok_or_else(|| text!("sketch-no-pose", name = quoted(link)))?;
    Ok((id, pose))
}

/// A name in quotes.
pub(crate) fn quoted(name: &str) -> Text {
    assur_words::name(format!("`{name}`"))
}
