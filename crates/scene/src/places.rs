//! Places of points of a link, or of the ground: coordinates, polar, or by the distances from two other points of it.

use std::collections::HashMap;

use assur_number::elementary::{hypot, sin_cos};
use assur_words::{Describe, Text, joined, name, quantity as with_unit, text};
use toml::de::DeValue;

use crate::known::Known;
use crate::linkage::coordinates;
use crate::reference::{Bound, KeyTable, table};
use crate::text::{did_you_mean, exclude, nearest, rounded, row, shown};
use crate::units::{Dimension, LEAST, within};
use crate::walk::{Entry, Section};

/// The table of the reference with the keys of a place.
const PLACE: &str = "points.NAME = { ... }";
const SIDES: &[(&str, f64)] = &[("left", 1.0), ("right", -1.0)];

/// Parts of the lengths of a triangle that rounding explains: a gap so small is none.
const ROUNDING: f64 = 1e-12;

/// The place of a point.
pub(crate) struct Placed {
    /// In the frame of the link, m.
    pub(crate) at: [f64; 2],
    /// Whether its numbers are its coordinates, and no other point of the link changes with them.
    pub(crate) is_free: bool,
}

/// How a place is given; other points by their index.
enum Given<'a> {
    Coordinates([f64; 2]),
    Polar {
        r: f64,
        angle: f64,
        about: Option<usize>,
    },
    Triangle {
        from: [usize; 2],
        lengths: [f64; 2],
        side: f64,
        entry: Entry<'a>,
    },
    /// A fault tells what is wrong.
    Nothing,
}

/// The places of the points of a link, in their order; what has a fault is at the origin.
pub(crate) fn places(points: &[Entry<'_>], link: &str) -> Vec<Placed> {
    let names = points.iter().enumerate().map(|(index, point)| (point.name.as_str(), index)).collect();
    let reader = Reader { points, names, link };
    let given: Vec<_> = points.iter().map(|point| reader.given(point)).collect();
    let parents: Vec<_> = given.iter().map(Given::parents).collect();
    let (order, waiting) = in_order(&parents);
    for circle in circles(&parents, &waiting) {
        reader.refuse_circle(&circle);
    }
    // What hangs on a fault has no place either, and no fault of its own.
    let mut found: Vec<Option<[f64; 2]>> = vec![None; points.len()];
    for index in order {
        found[index] = reader.place(index, &given[index], &found);
    }
    let mut is_free: Vec<_> = given.iter().map(|given| matches!(given, Given::Coordinates(_))).collect();
    for parent in parents.into_iter().flatten() {
        is_free[parent] = false;
    }
    let placed = |(at, is_free): (Option<[f64; 2]>, bool)| Placed { at: at.unwrap_or_default(), is_free };
    found.into_iter().zip(is_free).map(placed).collect()
}

/// Whether a place is written with a unit of length.
pub(crate) fn has_unit(value: &DeValue<'_>) -> bool {
    let of_key = |table: &toml::de::DeTable<'_>, key: &str| {
        table.get(key).is_some_and(|value| has_unit(value.get_ref()))
    };
    match value {
        DeValue::Table(table) => ["r", "lengths"].iter().any(|key| of_key(table, key)),
        DeValue::Array(array) => array.iter().any(|item| item.get_ref().is_str()),
        value => value.is_str(),
    }
}

impl Given<'_> {
    /// The points by which it is given.
    fn parents(&self) -> Vec<usize> {
        match self {
            Self::Polar { about, .. } => about.iter().copied().collect(),
            Self::Triangle { from, .. } => from.to_vec(),
            Self::Coordinates(_) | Self::Nothing => Vec::new(),
        }
    }
}

/// Every point after those by which it is given; and which points have no place in this order, because they wait for each other.
fn in_order(parents: &[Vec<usize>]) -> (Vec<usize>, Vec<bool>) {
    let mut children = vec![Vec::new(); parents.len()];
    for (index, parents) in parents.iter().enumerate() {
        for &parent in parents {
            children[parent].push(index);
        }
    }
    let mut lacking: Vec<_> = parents.iter().map(Vec::len).collect();
    let mut order: Vec<_> = (0..parents.len()).filter(|&index| lacking[index] == 0).collect();
    let mut done = 0;
    while let Some(&parent) = order.get(done) {
        for &child in &children[parent] {
            lacking[child] -= 1;
            order.extend((lacking[child] == 0).then_some(child));
        }
        done += 1;
    }
    (order, lacking.iter().map(|&count| count > 0).collect())
}

/// The circles of points that wait for each other, each once.
fn circles(parents: &[Vec<usize>], waiting: &[bool]) -> Vec<Vec<usize>> {
    let mut is_seen = vec![false; parents.len()];
    let mut circles = Vec::new();
    for start in (0..parents.len()).filter(|&start| waiting[start]) {
        let (mut way, mut at) = (Vec::new(), start);
        while !is_seen[at] {
            is_seen[at] = true;
            way.push(at);
            // Whatever waits does so for a point that waits.
            at = parents[at].iter().copied().find(|&parent| waiting[parent]).unwrap_or(at);
        }
        circles.extend(way.iter().position(|&index| index == at).map(|first| way.split_off(first)));
    }
    circles
}

/// Reads the places of the points of one link.
struct Reader<'r, 'a> {
    points: &'r [Entry<'a>],
    names: HashMap<&'r str, usize>,
    link: &'r str,
}

impl<'a> Reader<'_, 'a> {
    fn given(&self, point: &Entry<'a>) -> Given<'a> {
        let given = if point.value.is_table() {
            self.table(point)
        } else {
            coordinates(point).map(Given::Coordinates)
        };
        given.unwrap_or(Given::Nothing)
    }

    fn table(&self, point: &Entry<'a>) -> Option<Given<'a>> {
        let known = table(PLACE);
        let sort = sort(point, known)?;
        let section = point.section_as(text!(known.what), Known::Table(known, Some(sort)))?;
        if sort == "r" { self.polar(&section) } else { self.triangle(&section) }
    }

    fn polar(&self, section: &Section<'a>) -> Option<Given<'a>> {
        let (r, angle) = (section.number("r"), section.number("angle"));
        let about = match section.get("about") {
            Some(entry) => Some(self.named(&entry)?),
            None => None,
        };
        Some(Given::Polar { r: r?, angle: angle?, about })
    }

    fn triangle(&self, section: &Section<'a>) -> Option<Given<'a>> {
        let (from, entry) = (section.need("from"), section.need("lengths"));
        let lengths = entry.as_ref().and_then(|entry| entry.pair(&text!("scene-two-lengths")));
        let lengths =
            lengths.map(|pair| pair.map(|length| length.bounded(Dimension::Length, Bound::NotNegative)));
        let side = section.get("side").map_or(Some(SIDES[0].1), |entry| entry.choice(SIDES));
        let [one, other] = from?.pair(&text!("scene-two-points"))?.map(|point| self.named(&point));
        let [first, second] = lengths?;
        Some(Given::Triangle { from: [one?, other?], lengths: [first?, second?], side: side?, entry: entry? })
    }

    /// The point of this link that an entry names.
    fn named(&self, entry: &Entry<'_>) -> Option<usize> {
        let word = entry.text(text!("scene-name-of-a-point"))?;
        let found = self.names.get(word).copied();
        if found.is_none() {
            let known = self.points.iter().map(|point| point.name.as_str());
            let near = nearest(word, known.clone());
            let points = || text!("scene-points-of-link", points = row(known));
            let label = if near.is_some() { did_you_mean(word, near) } else { points() };
            let (key, link) = (shown(&entry.name), shown(self.link));
            entry.fault(text!("scene-no-point-on-link", key, link, point = shown(word)), label);
        }
        found
    }

    /// Notes points that are given by each other; or one that is given by itself.
    fn refuse_circle(&self, circle: &[usize]) {
        let Some(&first) = circle.first() else { return };
        let names = circle.iter().chain([&first]).map(|&index| shown(&self.points[index].name));
        let way = joined(" -> ", names.collect::<Vec<_>>());
        let point = &self.points[first];
        let message = text!("scene-circle-of-points", point = shown(&point.name), way);
        point.fault(message, text!("scene-one-by-coordinates"));
    }

    fn place(&self, index: usize, given: &Given<'_>, found: &[Option<[f64; 2]>]) -> Option<[f64; 2]> {
        let at = match given {
            Given::Nothing => return None,
            Given::Coordinates(at) => return Some(*at),
            Given::Polar { r, angle, about } => {
                let [x, y] = about.map_or(Some([0.0; 2]), |about| found[about])?;
                let [cos, sin] = direction(*angle);
                [x + r * cos, y + r * sin]
            }
            Given::Triangle { from, lengths, side, entry } => {
                let ends = [found[from[0]]?, found[from[1]]?];
                match apex(ends, *lengths, *side) {
                    Ok(at) => at,
                    Err(fault) => {
                        self.refuse_triangle(entry, index, *from, &fault);
                        return None;
                    }
                }
            }
        };
        self.within_range(index, at)
    }

    /// A place whose coordinates a scene may have.
    fn within_range(&self, index: usize, at: [f64; 2]) -> Option<[f64; 2]> {
        let point = &self.points[index];
        let far = at.into_iter().find(|part| part.abs() > Dimension::Length.most());
        if let Some(Err(error)) = far.map(|far| within(far, &format!("{far:.3e} m"), Dimension::Length)) {
            point.problem(error.describe(), text!("scene-no-digits"));
            return None;
        }
        // A smaller number is a rounded zero.
        Some(at.map(|part| if part.abs() < LEAST { 0.0 } else { part }))
    }

    fn refuse_triangle(&self, entry: &Entry<'_>, index: usize, from: [usize; 2], fault: &Open) {
        let [point, one, other] = [index, from[0], from[1]].map(|index| shown(&self.points[index].name));
        let length = |length: f64| with_unit(rounded(1e3 * length), "mm");
        let (message, label) = match fault {
            Open::SamePlace => {
                (text!("scene-triangle-one-place", point, one, other), text!("scene-triangle-other-points"))
            }
            &Open::Short { apart, gap } => (
                text!("scene-triangle-short", point, one, other, apart = length(apart), gap = length(gap)),
                text!("scene-triangle-lengthen", gap = length(gap)),
            ),
            &Open::Long { apart, gap } => (
                text!("scene-triangle-long", point, one, other, apart = length(apart), gap = length(gap)),
                text!("scene-triangle-shorten", gap = length(gap)),
            ),
        };
        entry.fault(message, label);
    }
}

/// Whether a place is polar or by two lengths: the sort of its table.
fn sort(point: &Entry<'_>, known: &'static KeyTable) -> Option<&'static str> {
    let keys = point.named(Text::default(), Text::default());
    let of = |sort: &str| keys.iter().find(|key| known.key(&key.name).is_some_and(|key| key.sorts == sort));
    match (of("r"), of("from")) {
        (Some(_), None) => Some("r"),
        (None, Some(_)) => Some("from"),
        (Some(polar), Some(triangle)) => {
            let both = [polar, triangle].map(|key| name(key.name.clone()));
            point.fault(exclude(both), text!("scene-leave-one-out"));
            None
        }
        (None, None) => {
            point.section(known)?.missing("r", text!("scene-why-a-place"));
            None
        }
    }
}

/// Why no point is at two distances from two others; m.
enum Open {
    SamePlace,
    /// Both lengths together are too short.
    Short {
        apart: f64,
        gap: f64,
    },
    /// One of them is too long for the other.
    Long {
        apart: f64,
        gap: f64,
    },
}

/// Cosine and sine of an angle, without the rounding of quarters of a turn.
fn direction(angle: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(angle);
    let exact = |part: f64| if part.abs() < 4.0 * f64::EPSILON { 0.0 } else { part };
    [exact(cos), exact(sin)]
}

/// The point at these distances from two others; `side`: 1 left of the line from the first to the second, -1 right of it.
fn apex([one, other]: [[f64; 2]; 2], [first, second]: [f64; 2], side: f64) -> Result<[f64; 2], Open> {
    let along = [other[0] - one[0], other[1] - one[1]];
    let apart = hypot(along[0], along[1]);
    if apart < LEAST {
        return Err(Open::SamePlace);
    }
    let least = ROUNDING * (apart + first + second);
    let short = apart - (first + second);
    let long = (first - second).abs() - apart;
    if short > least {
        return Err(Open::Short { apart, gap: short });
    }
    if long > least {
        return Err(Open::Long { apart, gap: long });
    }
    // The parts of the first length along the line and across it. The square of the part across is a product of differences, so that
    // it keeps its digits in a flat triangle.
    let part = 0.5 * (apart + (first - second) * ((first + second) / apart));
    let square = (first - part) * (first + part);
    let is_flat = short.abs().min(long.abs()) <= 4.0 * f64::EPSILON * (apart + first + second);
    let across = if is_flat || square <= 0.0 { 0.0 } else { side * square.sqrt() };
    let [cos, sin] = along.map(|part| part / apart);
    Ok([one[0] + part * cos - across * sin, one[1] + part * sin + across * cos])
}
