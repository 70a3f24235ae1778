//! The links and pairs of a group, as indices and lengths in the compiled chain.

use assur_group::{GroupFrame, Pair, PairGeometry};
use assur_mechanism::{GROUND, InputPair, LinkId, Mechanism, PairId, PointId, SlideId};

use crate::NamedPair;

/// Points and slides of each link, in the order of the scene.
pub(crate) struct Incidence {
    points: Vec<Vec<PointId>>,
    slides: Vec<Vec<SlideId>>,
}

impl Incidence {
    pub(crate) fn of(mechanism: &Mechanism) -> Self {
        let none = vec![Vec::new(); mechanism.links.len()];
        let (mut points, mut slides) = (none.clone(), none);
        for (id, point) in mechanism.points.iter().enumerate() {
            for place in &point.places {
                points[place.link].push(id);
            }
        }
        for (id, slide) in mechanism.slides.iter().enumerate() {
            slides[slide.link].push(id);
            slides[slide.on].push(id);
        }
        Self { points, slides }
    }
}

/// What some links have in common, each item once, in the order of the scene.
fn common(of: &[Vec<usize>], links: &[LinkId]) -> Vec<usize> {
    let mut all: Vec<usize> = links.iter().flat_map(|&link| of[link].iter().copied()).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// The greatest distance between two points of one link or of the ground; 1 m if there is none.
pub(crate) fn typical_length(mechanism: &Mechanism, incidence: &Incidence) -> f64 {
    let mut longest = 0.0_f64;
    for (link, points) in incidence.points.iter().enumerate() {
        let places: Vec<_> = points.iter().filter_map(|&id| mechanism.place_in(id, link)).collect();
        for (i, a) in places.iter().enumerate() {
            for b in &places[..i] {
                longest = longest.max((a[0] - b[0]).hypot(a[1] - b[1]));
            }
        }
    }
    if longest > 0.0 { longest } else { 1.0 }
}

pub(crate) fn input_pair(mechanism: &Mechanism) -> NamedPair {
    match mechanism.input.pair {
        InputPair::Pin(point) => {
            let at = |link| mechanism.place_in(point, link).unwrap_or_default();
            let geometry = PairGeometry::Pin { at_a: at(mechanism.input.link), at_b: at(GROUND) };
            let pair = Pair { id: 0, a: mechanism.input.link, b: GROUND, geometry };
            NamedPair { pair, source: PairId::Pin(point) }
        }
        InputPair::Slide(slide) => slide_pair(mechanism, slide, 0),
    }
}

fn slide_pair(mechanism: &Mechanism, id: usize, index: usize) -> NamedPair {
    let slide = &mechanism.slides[id];
    let geometry = PairGeometry::Slide {
        point: slide.point,
        through: slide.through,
        angle: slide.angle,
        tilt: slide.tilt,
    };
    let pair = Pair { id: index, a: slide.link, b: slide.on, geometry };
    NamedPair { pair, source: PairId::Slide(id) }
}

/// The pairs of these links with each other and with solved links; they are appended to `pairs`.
pub(crate) fn frame_of(
    mechanism: &Mechanism,
    incidence: &Incidence,
    links: Vec<LinkId>,
    rank: &[usize],
    scale: f64,
    pairs: &mut Vec<NamedPair>,
) -> GroupFrame {
    let mut frame = GroupFrame { links, inner: Vec::new(), outer: Vec::new(), scale };
    let mut found =
        pins_of(mechanism, &common(&incidence.points, &frame.links), &frame.links, rank, pairs.len());
    for id in common(&incidence.slides, &frame.links) {
        let slide = &mechanism.slides[id];
        let within = |link: LinkId| frame.links.contains(&link);
        let solved = |link: LinkId| rank[link] != usize::MAX;
        if within(slide.link) && (within(slide.on) || solved(slide.on))
            || within(slide.on) && solved(slide.link)
        {
            found.push(slide_pair(mechanism, id, pairs.len() + found.len()));
        }
    }
    for named in &found {
        let inner = frame.links.contains(&named.pair.a) && frame.links.contains(&named.pair.b);
        if inner { &mut frame.inner } else { &mut frame.outer }.push(named.pair);
    }
    pairs.extend(found);
    frame
}

/// Pairs of the pins, between links of a group and between the group and solved links.
fn pins_of(
    mechanism: &Mechanism,
    points: &[PointId],
    links: &[LinkId],
    rank: &[usize],
    first: usize,
) -> Vec<NamedPair> {
    let mut found = Vec::new();
    let points = points.iter().map(|&id| (id, &mechanism.points[id]));
    for (id, point) in points.filter(|(_, point)| point.is_pin()) {
        let members: Vec<_> = point.places.iter().filter(|place| links.contains(&place.link)).collect();
        let solved = point.places.iter().filter(|place| rank[place.link] != usize::MAX);
        // All links of a pin are joined to one body: the first that is solved, otherwise the first link of the group.
        let anchor = solved.min_by_key(|place| rank[place.link]);
        let (anchor, hung) = match (anchor, &members[..]) {
            (Some(anchor), hung) => (anchor, hung),
            (None, [anchor, hung @ ..]) => (*anchor, hung),
            (None, []) => continue,
        };
        for place in hung {
            let geometry = PairGeometry::Pin { at_a: place.at, at_b: anchor.at };
            let pair = Pair { id: first + found.len(), a: place.link, b: anchor.link, geometry };
            found.push(NamedPair { pair, source: PairId::Pin(id) });
        }
    }
    found
}
