//! `[ground]` and `[link.NAME]`: points, mass, center, inertia.

use assur_mechanism::{
    GROUND, Inertia, Key, Link, LinkId, Mechanism, Name, Place, Point, PointId, Slide, SlideId,
    links_of_length_zero,
};
use assur_words::{Text, joined, name as name_of, text};

use crate::linkage::SceneLinks;
use crate::places::{Placed, places};
use crate::text::{in_quotes, is_unprintable, row, shown, such_as};
use crate::walk::{Entry, Section};
use crate::{edit::place, inertia, reference};

/// Reads the ground and the links; returns the first point of each link as well.
pub(crate) fn read(root: &Section<'_>) -> (SceneLinks, Vec<Option<PointId>>) {
    let mut linkage = SceneLinks::default();
    linkage.add_link(massless(Name::ground()));
    let mut firsts = vec![None];
    if let Some(ground) = root.inner("ground") {
        linkage.links[GROUND].name = ground.labelled(Name::ground());
        if let Some(points) = ground.get("points") {
            firsts[GROUND] = add_points(&mut linkage, &points, GROUND);
        }
    }
    let entry = root.get("link");
    let links =
        entry.as_ref().map(|entry| entry.named(text!("scene-tables-of-links"), text!("scene-write-link")));
    let links = links.unwrap_or_default();
    if links.is_empty() && entry.is_none_or(|entry| entry.value.is_table()) {
        root.missing("link", text!("scene-add-links"));
    }
    // All points are read before the masses, because a center of mass may be given by a point.
    let sections: Vec<_> = links.iter().map(|entry| add_link(&mut linkage, &mut firsts, entry)).collect();
    for (index, section) in sections.iter().enumerate() {
        if let Some(section) = section {
            add_mass(&mut linkage, (index + 1, firsts[index + 1]), section);
        }
    }
    (linkage, firsts)
}

/// Refuses links without a slide whose pins all coincide: they rotate freely about them, so their angle is not
/// determined.
pub(crate) fn refuse_points(root: &Section<'_>, linkage: &SceneLinks) {
    for id in links_of_length_zero(linkage.links.len(), &linkage.points, &linkage.slides) {
        let link = &linkage.links[id].name;
        let on_link = |point: &&Point| point.is_pin() && point.on(id).is_some();
        let pins = row(linkage.points.iter().filter(on_link).map(|pin| pin.name.as_str()));
        let message = text!("scene-no-length", link = shown(link), pins);
        if let Some(span) = place(root.table(), Key::of("link").at(link).steps()) {
            root.faults.add(span, message, text!("scene-give-length"));
        }
    }
}

fn massless(name: Name) -> Link {
    Link { name, mass: 0.0, center: [0.0; 2], inertia: Inertia::NONE }
}

/// A faulty link is added too: its name is then known to the rest of the scene.
fn add_link<'a>(
    linkage: &mut SceneLinks,
    firsts: &mut Vec<Option<PointId>>,
    entry: &Entry<'a>,
) -> Option<Section<'a>> {
    check_name(entry, "scene-no-link-name");
    if entry.name == "ground" {
        entry.fault(text!("scene-ground-as-link"), text!("scene-points-of-ground"));
    }
    if entry.name == "moment" {
        // In results the moment of a slide is listed beside the forces on its links, under this name.
        entry.faults.add(entry.key.clone(), text!("scene-link-moment"), text!("scene-results-use-it"));
    }
    let id = linkage.add_link(massless(entry.name.as_str().into()));
    firsts.push(None);
    let section = entry.section(reference::table("[link.NAME]"))?;
    linkage.links[id].name = section.labelled(entry.name.as_str().into());
    if let Some(points) = section.need("points") {
        firsts[id] = add_points(linkage, &points, id);
    }
    Some(section)
}

/// Adds the points of a link; returns the first of them.
fn add_points(linkage: &mut SceneLinks, entry: &Entry<'_>, link: LinkId) -> Option<PointId> {
    let mut first = None;
    let points = entry.named(text!("scene-table-of-points"), such_as("{ A = 0, B = \"120 mm\" }"));
    let places = places(&points, &linkage.links[link].name);
    for (point, placed) in points.iter().zip(&places) {
        check_name(point, "scene-no-point-name");
        let id = linkage.add_place(point, Place { link, at: placed.at }, placed.is_free);
        first = first.or(Some(id));
    }
    if link != GROUND {
        doubt_length(&points, &places);
    }
    first
}

/// Notes a negative length with a unit in the place of the only point of a link beside its origin: it is a coordinate, so that the link
/// is turned round.
fn doubt_length(points: &[Entry<'_>], places: &[Placed]) {
    let ([one, other], [Placed { at: a, .. }, Placed { at: b, .. }]) = (points, places) else { return };
    let (a, b) = (*a, *b);
    let is_origin = |[x, y]: [f64; 2]| x == 0.0 && y == 0.0;
    let (point, x) = if is_origin(a) { (other, b[0]) } else { (one, a[0]) };
    let alone = is_origin(a) || is_origin(b);
    if let (true, true, Some(text)) = (alone, x < 0.0, point.value.as_str()) {
        let length = in_quotes(text.trim().trim_start_matches(['-', '\u{2212}']).trim_start());
        let place = joined("", [name_of("["), in_quotes(text), name_of(", 0]")]);
        let told = text!("scene-negative-length", point = shown(&point.name), length = length, place = place);
        point.faults.mistake(point.span.clone(), told);
    }
}

/// Names are printed in tables and used in "link.point".
fn check_name(entry: &Entry<'_>, message: &'static str) {
    let name = &entry.name;
    if name.trim().is_empty() || name.contains('.') || name.chars().any(is_unprintable) {
        let message = text!(message, name = shown(name));
        entry.faults.add(entry.key.clone(), message, text!("scene-what-is-a-name"));
    }
    entry.faults.check_name(&entry.key, name);
}

fn add_mass(linkage: &mut SceneLinks, (id, first): (LinkId, Option<PointId>), section: &Section<'_>) {
    let mass = section.number("mass").unwrap_or_default();
    let inertia = inertia::read(linkage, id, section);
    let center = match section.get("center") {
        Some(entry) => linkage.location(&entry, id, move |scene| Some(&mut scene.links[id].center)),
        None => default_center(linkage, section, (id, first), mass > 0.0 || !inertia.is_none()),
    };
    // Without a center there is no mass.
    if center.is_some() {
        section.sets(1.0, move |scene, key| match (key, &mut scene.links[id]) {
            ("mass", link) => Some(&mut link.mass),
            ("inertia", Link { inertia: Inertia::Constant(inertia), .. }) => Some(inertia),
            _ => None,
        });
    }
    let link = &mut linkage.links[id];
    (link.mass, link.inertia, link.center) = (mass, inertia, center.unwrap_or_default());
}

/// The center of mass of a link with one point is at this point by default.
fn default_center(
    linkage: &SceneLinks,
    section: &Section<'_>,
    (link, first): (LinkId, Option<PointId>),
    heavy: bool,
) -> Option<[f64; 2]> {
    let count = section.get("points").and_then(|entry| Some(entry.value.as_table()?.len()));
    if count == Some(1) {
        return linkage
            .copied(section.faults, (first?, link), move |scene| Some(&mut scene.links[link].center));
    }
    if heavy {
        section.missing("center", text!("scene-why-a-center"));
    }
    None
}

/// Reads the slides into the linkage.
pub(crate) fn read_slides(root: &Section<'_>, linkage: &mut SceneLinks, firsts: &[Option<PointId>]) {
    for section in root.inners("slide") {
        if let Some(slide) = one(&section, linkage, firsts) {
            linkage.slides.push(slide);
        }
    }
}

fn one(section: &Section<'_>, linkage: &mut SceneLinks, firsts: &[Option<PointId>]) -> Option<Slide> {
    let id = linkage.slides.len();
    let [angle, tilt] = ["angle", "tilt"].map(|key| section.number(key).unwrap_or_default());
    section.sets(1.0, move |scene, key| match key {
        "angle" => Some(&mut scene.slides[id].angle),
        "tilt" => Some(&mut scene.slides[id].tilt),
        _ => None,
    });
    let (link, on) = (section.need("link"), section.need("on"));
    let swap = || text!("scene-swap-slide");
    let link_id = link.as_ref().and_then(|entry| linkage.moving(entry, swap()));
    let on_id = on.as_ref().and_then(|entry| linkage.link(entry));
    let through = section
        .get("through")
        .and_then(|entry| linkage.location(&entry, on_id?, move |scene| Some(&mut scene.slides[id].through)));
    let (link, on) = (link_id?, on_id?);
    let point = match section.get("point") {
        Some(entry) => linkage.location(&entry, link, point_of(id)),
        None => firsts[link].and_then(|first| linkage.copied(section.faults, (first, link), point_of(id))),
    };
    if link == on {
        let entry = section.get("on")?;
        let message = text!("scene-slide-on-itself", link = shown(&linkage.links[link].name));
        entry.fault(message, text!("scene-another-link"));
    }
    let default = joined("/", [link, on].map(|link| Text::from(&linkage.links[link].name)));
    let taken = |name: &Name| {
        let pin = linkage.point_named(name).is_some_and(|point| linkage.points[point].is_pin());
        let is_new = linkage.slide_names.insert(name.to_string());
        pin.then_some("scene-pin-and-slide").or_else(|| (!is_new).then_some("scene-two-slides"))
    };
    Some(Slide {
        name: section.name(|| default, taken),
        link,
        on,
        point: point.unwrap_or_default(),
        through: through.unwrap_or_default(),
        angle,
        tilt,
    })
}

/// The point of a slide in a mechanism.
fn point_of(slide: SlideId) -> impl Fn(&mut Mechanism) -> Option<&mut [f64; 2]> {
    move |scene| Some(&mut scene.slides[slide].point)
}
