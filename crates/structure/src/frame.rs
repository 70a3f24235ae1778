//! The links and pairs of a group, as indices and lengths in the compiled chain, without the parts that are left out.

use std::collections::HashSet;

use assur_group::{Driven, GroupFrame, Pair, PairGeometry};
use assur_mechanism::{Driver, GROUND, InputPair, LinkId, Mechanism, PairId, Place, PointId, Slide, SlideId};
use assur_number::elementary;

use crate::{NamedPair, PassivePart, Structure};

/// The parts that are left out.
pub(crate) struct LeftOut {
    links: Vec<bool>,
    pairs: HashSet<(PairId, LinkId)>,
}

impl LeftOut {
    pub(crate) fn of(mechanism: &Mechanism, parts: &[PassivePart]) -> Self {
        let mut found = Self { links: vec![false; mechanism.links.len()], pairs: HashSet::new() };
        for part in parts {
            match *part {
                PassivePart::Link(link) => found.links[link] = true,
                PassivePart::Pair(pair, link) => _ = found.pairs.insert((pair, link)),
            }
        }
        found
    }

    /// Whether a link is left out.
    pub(crate) fn link(&self, link: LinkId) -> bool {
        self.links[link]
    }

    /// Whether a pair of a link is left out, alone or with the link.
    pub(crate) fn pair(&self, pair: PairId, link: LinkId) -> bool {
        self.link(link) || self.is_alone(pair, link)
    }

    /// Whether a pair of a link is left out by itself.
    pub(crate) fn is_alone(&self, pair: PairId, link: LinkId) -> bool {
        self.pairs.contains(&(pair, link))
    }
}

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

/// The greatest distance between two joints of one link or of the ground; between two points where the joints coincide,
/// and 1 m if all points do. A far point that only draws a path or carries a load says nothing about the size of a mechanism.
pub(crate) fn typical_length(mechanism: &Mechanism) -> f64 {
    let places = |least: usize| -> Vec<Place> {
        let joined = mechanism.points.iter().filter(|point| point.places.len() >= least);
        joined.flat_map(|point| point.places.iter().copied()).collect()
    };
    let mut joints = places(2);
    // Where on its line a guide is given says nothing.
    joints.extend(mechanism.slides.iter().map(|slide| Place { link: slide.link, at: slide.point }));
    let mut lengths = [joints, places(1)].into_iter().map(greatest_distance);
    lengths.find(|length| *length > 0.0).unwrap_or(1.0)
}

/// The greatest distance between two places of one link.
fn greatest_distance(mut places: Vec<Place>) -> f64 {
    places.sort_unstable_by_key(|place| place.link);
    let mut longest = 0.0_f64;
    for of_link in places.chunk_by(|a, b| a.link == b.link) {
        let far = outlying(of_link);
        for (i, a) in far.iter().enumerate() {
            for b in &far[..i] {
                longest = longest.max(elementary::hypot(a[0] - b[0], a[1] - b[1]));
            }
        }
    }
    longest
}

/// The places that may have the greatest distance from each other: two places are as far apart as the longer side of
/// the box around all, so a place from which no corner of the box is that far is none of the farthest two.
fn outlying(places: &[Place]) -> Vec<[f64; 2]> {
    let bound =
        |k: usize, better: fn(f64, f64) -> f64| places.iter().map(|p| p.at[k]).reduce(better).unwrap_or(0.0);
    let [low, high] =
        [f64::min as fn(f64, f64) -> f64, f64::max].map(|better| [bound(0, better), bound(1, better)]);
    let side = (high[0] - low[0]).max(high[1] - low[1]);
    let reach = |at: &[f64; 2]| {
        let [x, y] = [0, 1].map(|k| (at[k] - low[k]).max(high[k] - at[k]));
        elementary::hypot(x, y)
    };
    // A little less than the side, because of rounding.
    places.iter().map(|place| place.at).filter(|at| reach(at) >= 0.999 * side).collect()
}

/// Where a pin or slide lies in its bodies: in `a`, which for a slide is the sliding link, and in `b`.
fn geometry(mechanism: &Mechanism, source: PairId, a: LinkId, b: LinkId) -> PairGeometry {
    match source {
        PairId::Pin(point) => {
            let at = |link| mechanism.place_in(point, link).unwrap_or_default();
            PairGeometry::Pin { at_a: at(a), at_b: at(b) }
        }
        PairId::Slide(slide) => {
            let Slide { point, through, angle, tilt, .. } = mechanism.slides[slide];
            PairGeometry::Slide { point, through, angle, tilt }
        }
    }
}

fn named(mechanism: &Mechanism, source: PairId, id: usize, a: LinkId, b: LinkId) -> NamedPair {
    NamedPair { pair: Pair { id, a, b, geometry: geometry(mechanism, source, a, b) }, source }
}

/// The pairs that are driven, the first of all, in the order of the scene.
pub(crate) fn driven_pairs(mechanism: &Mechanism) -> Vec<NamedPair> {
    let pair = |(id, driver): (usize, &Driver)| match driver.pair {
        InputPair::Pin(point) => named(mechanism, PairId::Pin(point), id, driver.link, driver.on),
        InputPair::Slide(slide) => slide_pair(mechanism, slide, id),
    };
    mechanism.input.drivers.iter().enumerate().map(pair).collect()
}

/// The driven pairs of these links with each other and with links that are solved. The body that holds a coordinate follows all
/// links, in the order of the drives.
fn driven(
    mechanism: &Mechanism,
    links: &[LinkId],
    is_solved: impl Fn(LinkId) -> bool,
    pairs: &[NamedPair],
) -> Vec<Driven> {
    let has = |driver: &Driver| {
        let ends = [driver.link, driver.on];
        ends.iter().any(|link| links.contains(link))
            && ends.iter().all(|link| links.contains(link) || is_solved(*link))
    };
    let drivers =
        mechanism.input.drivers.iter().enumerate().filter(|(_, driver)| driver.is_relative() && has(driver));
    drivers.map(|(id, _)| Driven { pair: pairs[id].pair, coordinate: mechanism.links.len() + id }).collect()
}

fn slide_pair(mechanism: &Mechanism, slide: SlideId, id: usize) -> NamedPair {
    let Slide { link, on, .. } = mechanism.slides[slide];
    named(mechanism, PairId::Slide(slide), id, link, on)
}

impl Structure {
    /// Takes lengths and directions from a mechanism with the same links, pins, slides and input: the structure then
    /// equals [`Structure::of`] of this mechanism.
    pub fn set_geometry(&mut self, mechanism: &Mechanism) {
        self.scale = typical_length(mechanism);
        for NamedPair { pair, source } in &mut self.pairs {
            pair.geometry = geometry(mechanism, *source, pair.a, pair.b);
        }
        let passive = self.passive.iter_mut().map(|passive| &mut passive.frame);
        for frame in self.groups.iter_mut().map(|group| &mut group.frame).chain(passive) {
            frame.scale = self.scale;
            let driven = frame.driven.iter_mut().map(|driven| &mut driven.pair);
            for pair in frame.inner.iter_mut().chain(&mut frame.outer).chain(driven) {
                *pair = self.pairs[pair.id].pair;
            }
        }
    }
}

/// The pairs of these links with each other and with solved links; they are appended to `pairs`.
pub(crate) fn frame_of(
    (mechanism, incidence, left_out): (&Mechanism, &Incidence, &LeftOut),
    links: Vec<LinkId>,
    rank: &[usize],
    scale: f64,
    pairs: &mut Vec<NamedPair>,
) -> GroupFrame {
    let driven = driven(mechanism, &links, |link| rank[link] != usize::MAX, pairs);
    let mut frame = GroupFrame { links, inner: Vec::new(), outer: Vec::new(), driven, scale };
    let held: Vec<(PairId, LinkId)> =
        frame.held().iter().map(|(driven, [held, _])| (pairs[driven.pair.id].source, *held)).collect();
    let is_hung = |pair: PairId, link: LinkId| {
        let slides = |of: &(PairId, LinkId)| of.0 == pair && matches!(pair, PairId::Slide(_));
        !(left_out.is_alone(pair, link) || held.contains(&(pair, link)) || held.iter().any(slides))
    };
    let mut found = pins_of(
        (mechanism, &is_hung),
        &common(&incidence.points, &frame.links),
        &frame.links,
        rank,
        pairs.len(),
    );
    let slides = common(&incidence.slides, &frame.links).into_iter();
    for id in slides.filter(|id| is_hung(PairId::Slide(*id), mechanism.slides[*id].link)) {
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

/// A pair that is left out alone; of a pin, with the body that is solved first.
pub(crate) fn pair_alone(
    mechanism: &Mechanism,
    (pair, link): (PairId, LinkId),
    rank: &[usize],
    scale: f64,
    pairs: &mut Vec<NamedPair>,
) -> GroupFrame {
    let found = match pair {
        PairId::Slide(slide) => slide_pair(mechanism, slide, pairs.len()),
        PairId::Pin(point) => {
            let others = mechanism.points[point].places.iter().filter(|place| place.link != link);
            let anchor = others.min_by_key(|place| rank[place.link]).map_or(GROUND, |place| place.link);
            named(mechanism, pair, pairs.len(), link, anchor)
        }
    };
    pairs.push(found);
    GroupFrame { outer: vec![found.pair], scale, ..GroupFrame::default() }
}

/// Pairs of the pins, between links of a group and between the group and solved links.
fn pins_of(
    (mechanism, is_hung): (&Mechanism, &dyn Fn(PairId, LinkId) -> bool),
    points: &[PointId],
    links: &[LinkId],
    rank: &[usize],
    first: usize,
) -> Vec<NamedPair> {
    let mut found = Vec::new();
    let points = points.iter().map(|&id| (id, &mechanism.points[id]));
    for (id, point) in points.filter(|(_, point)| point.is_pin()) {
        let held = || point.places.iter().filter(|place| is_hung(PairId::Pin(id), place.link));
        let members: Vec<_> = held().filter(|place| links.contains(&place.link)).collect();
        let solved = held().filter(|place| rank[place.link] != usize::MAX);
        // All links of a pin are joined to one body: the first that is solved, otherwise the first link of the group.
        let anchor = solved.min_by_key(|place| rank[place.link]);
        let (anchor, hung) = match (anchor, &members[..]) {
            (Some(anchor), hung) => (anchor, hung),
            (None, [anchor, hung @ ..]) => (*anchor, hung),
            (None, []) => continue,
        };
        for place in hung {
            found.push(named(mechanism, PairId::Pin(id), first + found.len(), place.link, anchor.link));
        }
    }
    found
}
