//! The links, points and slides of a scene by name.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use assur_mechanism::{GROUND, Link, LinkId, Mechanism, Place, Point, PointId, Slide, SlideId};

use assur_words::{Text, name as words, text};

use crate::error::{Fault, Faults};
use crate::places::has_unit;
use crate::reference::Bound;
use crate::text::{did_you_mean, nearest, row, shown};
use crate::units::{Dimension, quantity};
use crate::walk::{Entry, Section};

/// Links, points and slides of the scene.
#[derive(Debug, Default)]
pub(crate) struct SceneLinks {
    pub(crate) links: Vec<Link>,
    pub(crate) points: Vec<Point>,
    pub(crate) slides: Vec<Slide>,
    /// Points by name.
    names: HashMap<String, PointId>,
    links_by_name: HashMap<String, LinkId>,
    pub(crate) slide_names: HashSet<String>,
    /// Where in the file a point has its coordinates on a link; none of one whose numbers are no coordinates, or by which others are given.
    written: HashMap<(PointId, LinkId), Range<usize>>,
    /// Whether some coordinate of a moving link is written with a unit.
    pub(crate) has_units: bool,
}

impl SceneLinks {
    /// The link named by an entry.
    pub(crate) fn link(&self, entry: &Entry<'_>) -> Option<LinkId> {
        self.link_named(entry, entry.text(text!("scene-name-of-a-link"))?)
    }

    /// The link of a name that an entry has.
    pub(crate) fn link_named(&self, entry: &Entry<'_>, name: &str) -> Option<LinkId> {
        let found = self.links_by_name.get(name).copied();
        Self::known(entry, ("link", name), found, self.links.iter().map(|link| link.name.as_str()))
    }

    /// Adds a link; of two with one name the first is found.
    pub(crate) fn add_link(&mut self, link: Link) -> LinkId {
        let id = self.links.len();
        self.links_by_name.entry(link.name.to_string()).or_insert(id);
        self.links.push(link);
        id
    }

    /// The moving link named by an entry.
    pub(crate) fn moving(&self, entry: &Entry<'_>, why: Text) -> Option<LinkId> {
        let link = self.link(entry)?;
        if link == GROUND {
            entry.wants(text!("scene-a-moving-link"), text!("scene-the-ground"), why);
            return None;
        }
        Some(link)
    }

    /// The moving link that a section needs.
    pub(crate) fn link_of(&self, section: &Section<'_>, why: Text) -> Option<LinkId> {
        section.need("link").and_then(|entry| self.moving(&entry, why))
    }

    /// The point named by an entry.
    pub(crate) fn point(&self, entry: &Entry<'_>) -> Option<PointId> {
        self.point_of(entry, entry.text(text!("scene-name-of-a-point"))?)
    }

    /// The point of a name that an entry has.
    pub(crate) fn point_of(&self, entry: &Entry<'_>, name: &str) -> Option<PointId> {
        let known = self.points.iter().map(|point| point.name.as_str());
        Self::known(entry, ("point", name), self.point_named(name), known)
    }

    /// The slide named by an entry.
    pub(crate) fn slide(&self, entry: &Entry<'_>) -> Option<SlideId> {
        let name = entry.text(text!("scene-name-of-a-slide"))?;
        let names = self.slides.iter().map(|slide| slide.name.as_str());
        Self::known(entry, ("slide", name), names.clone().position(|slide| slide == name), names)
    }

    /// Slides between a link and the ground, in either order.
    pub(crate) fn on_ground(&self, link: LinkId) -> impl Iterator<Item = SlideId> {
        let joins = move |slide: &Slide| slide.link == link && slide.on == GROUND;
        (0..self.slides.len()).filter(move |&index| joins(&self.slides[index]))
    }

    pub(crate) fn point_named(&self, name: &str) -> Option<PointId> {
        self.names.get(name).copied()
    }

    /// Adds a point of a link; the point may be new or a pin. `is_free`: whether the numbers of the entry are its coordinates, and stand in
    /// the mechanism nowhere else than here and where the point is named.
    pub(crate) fn add_place(&mut self, entry: &Entry<'_>, place: Place, is_free: bool) -> PointId {
        let id = *self.names.entry(entry.name.clone()).or_insert(self.points.len());
        if id == self.points.len() {
            self.points.push(Point { name: entry.name.as_str().into(), places: Vec::new() });
        }
        let index = self.points[id].places.len();
        self.points[id].places.push(place);
        self.has_units |= place.link != GROUND && has_unit(entry.value);
        if !is_free {
            return id;
        }
        self.written.insert((id, place.link), entry.span.clone());
        entry.faults.tell(|told| {
            told.place([entry.span.clone()], move |scene| Some(&mut scene.points[id].places[index].at));
        });
        id
    }

    /// The place of a point on a link, m; tells that it has another place in the mechanism.
    pub(crate) fn copied(
        &self,
        faults: &Faults,
        (point, link): (PointId, LinkId),
        at: impl Fn(&mut Mechanism) -> Option<&mut [f64; 2]> + Send + Sync + 'static,
    ) -> Option<[f64; 2]> {
        faults.tell(|told| told.place(self.written.get(&(point, link)).cloned(), at));
        self.points[point].on(link)
    }

    /// What was found of a name; where there is nothing, that is noted with the nearest known name.
    pub(crate) fn known<'n, T>(
        entry: &Entry<'_>,
        (what, name): (&'static str, &str),
        found: Option<T>,
        known: impl Iterator<Item = &'n str> + Clone,
    ) -> Option<T> {
        if found.is_some() {
            return found;
        }
        // Made only while faults are kept: the search for the nearest name takes time.
        entry.faults.note(|| {
            let near = nearest(name, known.clone()).or_else(|| turned_around(name, known.clone()));
            let label = match (near, known.clone().next()) {
                (Some(_), _) => did_you_mean(name, near),
                (None, None) => text!("scene-none-of-them", what = words(what)),
                (None, Some(_)) => text!("scene-all-of-them", what = words(what), names = row(known)),
            };
            let key = shown(&entry.name);
            let message = text!("scene-no-such-part", key, what = words(what), name = shown(name));
            Fault::new(entry.span.clone(), message).label(label)
        });
        None
    }

    /// Names and coordinates of the points of a link.
    fn points_of(&self, link: LinkId) -> impl Iterator<Item = (&str, [f64; 2])> + Clone {
        self.points.iter().filter_map(move |point| Some((point.name.as_str(), point.on(link)?)))
    }

    /// A place fixed in a link: one of its points, coordinates, or a number on its x axis; `at`: where it stands in the mechanism.
    pub(crate) fn place(
        &self,
        entry: &Entry<'_>,
        link: LinkId,
        at: impl Fn(&mut Mechanism) -> Option<&mut Place> + Send + Sync + 'static,
    ) -> Option<Place> {
        let place = self.location(entry, link, move |scene| Some(&mut at(scene)?.at))?;
        Some(Place { link, at: place })
    }

    /// Coordinates of a place fixed in a link, in the frame of the link, m: one of its points, [x, y], or a number on
    /// its x axis; `at`: where they stand in the mechanism.
    pub(crate) fn location(
        &self,
        entry: &Entry<'_>,
        link: LinkId,
        at: impl Fn(&mut Mechanism) -> Option<&mut [f64; 2]> + Send + Sync + 'static,
    ) -> Option<[f64; 2]> {
        let point = entry.value.as_str().and_then(|name| self.point_named(name));
        let source = point.and_then(|point| self.written.get(&(point, link)));
        entry.faults.tell(|told| told.place([entry.span.clone()].into_iter().chain(source.cloned()), at));
        let Some(name) = entry.value.as_str() else {
            return coordinates(entry);
        };
        let places = point.map(|point| &self.points[point].places);
        if let Some(place) = places.into_iter().flatten().find(|place| place.link == link) {
            entry.may_be(Some(Dimension::Length), Bound::Any);
            return Some(place.at);
        }
        // As in `points`, a text that begins with a digit is a length on the x axis.
        if name.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | '\u{2212}')) {
            return coordinates(entry);
        }
        entry.text(text!("scene-point-or-place"))?;
        entry.faults.note(|| {
            let (message, label) = self.not_on(entry, name, link);
            Fault::new(entry.span.clone(), message).label(label)
        });
        None
    }

    /// What is said where a link has no point of a name: message and correction.
    fn not_on(&self, entry: &Entry<'_>, name: &str, link: LinkId) -> (Text, Text) {
        let on = &self.links[link].name;
        let Some(point) = self.point_named(name) else {
            let known = self.points_of(link).map(|point| point.0);
            let near = nearest(name, known.clone());
            let label = if near.is_some() { did_you_mean(name, near) } else { self.listed(link) };
            let key = shown(&entry.name);
            let message = text!("scene-no-point-on-link", key, link = shown(on), point = shown(name));
            return (message, label);
        };
        let holders = self.points[point].places.iter().map(|place| self.links[place.link].name.as_str());
        let message = text!(
            "scene-point-elsewhere",
            key = shown(&entry.name),
            point = shown(name),
            link = shown(on),
            holders = row(holders)
        );
        (message, self.listed(link))
    }

    fn listed(&self, link: LinkId) -> Text {
        let mut names = self.points_of(link).map(|point| point.0).peekable();
        if names.peek().is_none() {
            text!("scene-link-without-points")
        } else {
            text!("scene-points-of-link", points = row(names))
        }
    }
}

/// The known slide of the same two links, of a name that has them in the other order: `ram/ground` of `ground/ram`.
fn turned_around<'n>(name: &str, mut known: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let (one, other) = name.split_once('/')?;
    known.find(|known| known.split_once('/') == Some((other, one)))
}

/// Coordinates [x, y] in m, or one number on the x axis.
pub(crate) fn coordinates(entry: &Entry<'_>) -> Option<[f64; 2]> {
    if entry.value.is_array() {
        return pair(entry, &words("[x, y]"), Dimension::Length);
    }
    if entry.value.is_table() || entry.value.is_bool() || entry.value.is_datetime() {
        entry.wrong(text!("scene-coordinates"), text!("scene-such-coordinates"));
        return None;
    }
    if let Some([x, y]) = entry.value.as_str().and_then(two_in_one) {
        entry.wrong(text!("scene-coordinates"), words(format!("[{x}, {y}]")));
        return None;
    }
    entry.bounded(Dimension::Length, Bound::Any).map(|x| [x, 0.0])
}

/// Both coordinates of "15 mm, 0" as they are written in a list; `None` of another text: "15,5 mm" has a decimal comma.
fn two_in_one(text: &str) -> Option<[String; 2]> {
    let both = text.split_once(',').filter(|(x, y)| y.starts_with(' ') || x.contains(char::is_alphabetic))?;
    let shown = |text: &str| {
        let (text, is_bare) = (text.trim(), text.trim().parse::<f64>().is_ok());
        let is_length = quantity(text, Dimension::Length).is_ok();
        is_length.then(|| if is_bare { text.to_owned() } else { format!("\"{text}\"") })
    };
    Some([shown(both.0)?, shown(both.1)?])
}

/// Two quantities of one dimension.
pub(crate) fn pair(
    entry: &Entry<'_>,
    wanted: &Text,
    dimension: impl Into<Option<Dimension>>,
) -> Option<[f64; 2]> {
    let dimension = dimension.into();
    let [a, b] = entry.pair(wanted)?;
    let (a, b) = (a.quantity(dimension), b.quantity(dimension));
    Some([a?, b?])
}
