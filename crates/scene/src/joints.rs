//! `[[spring]]` and `[[contact]]`: loads between two links.

use assur_mechanism::{Contact, LoadId, LoadKind, Place, PointId, Spring, Value};

use assur_words::{name, text};

use crate::text::{row, shown};
use crate::walk::{Entry, Section, quoted};
use crate::{context::Context, linkage::pair, units::Dimension, value};

pub(crate) fn spring(section: &Section<'_>, context: &Context<'_>, id: LoadId) -> Option<LoadKind> {
    let (stiffness, length) = (section.number("stiffness"), section.number("length"));
    let damping = section.number("damping").unwrap_or_default();
    if let Some(entry) = section.get("damping").filter(|_| damping > 0.0) {
        context.need_motion(&entry, quoted("damping"));
    }
    let ends = section.need("between").and_then(|entry| ends(&entry, context, id))?;
    Some(Spring { ends, stiffness: stiffness?, length: length?, damping }.into())
}

fn ends(entry: &Entry<'_>, context: &Context<'_>, id: LoadId) -> Option<[Place; 2]> {
    let [a, b] = entry.pair(&text!("scene-two-points"))?;
    let (first, second) = (end(&a, context), end(&b, context));
    let ((p, first), (q, second)) = (first?, second?);
    let linkage = context.linkage;
    let [one, other] = [p, q].map(|point| &linkage.points[point]);
    let both = (0..linkage.links.len()).find(|&link| one.on(link).and(other.on(link)).is_some());
    if let Some(link) = both {
        let message = text!("scene-both-ends-on-link", link = shown(&linkage.links[link].name));
        entry.fault(message, text!("scene-such-a-spring"));
        return None;
    }
    for (end, (point, place)) in [(p, first), (q, second)].into_iter().enumerate() {
        linkage.copied(entry.faults, (point, place.link), move |scene| {
            Some(&mut scene.loads[id].kind.spring_mut()?.ends[end].at)
        });
    }
    Some([first, second])
}

/// A point, alone or as "link.point". Any link of a pin may be taken, since a pin is at one place in all its links.
fn end(entry: &Entry<'_>, context: &Context<'_>) -> Option<(PointId, Place)> {
    let text = entry.text(text!("scene-point-of-link"))?;
    let linkage = context.linkage;
    let Some((link, point)) = text.split_once('.') else {
        let id = linkage.point(entry)?;
        return linkage.points[id].places.first().map(|place| (id, *place));
    };
    let link = linkage.link_named(entry, link)?;
    let id = linkage.point_of(entry, point)?;
    let places = &linkage.points[id].places;
    let place = places.iter().find(|place| place.link == link);
    if place.is_none() {
        let holders = places.iter().map(|place| linkage.links[place.link].name.as_str());
        let on = shown(&linkage.links[link].name);
        entry.fault(
            text!("scene-not-on-link", point = shown(point), link = on),
            text!("scene-belongs-to", holders = row(holders)),
        );
    }
    place.map(|place| (id, *place))
}

pub(crate) fn contact(section: &Section<'_>, context: &Context<'_>, id: LoadId) -> Option<LoadKind> {
    let linkage = context.linkage;
    let radius = section.number("radius");
    let angle = match section.get("angle").filter(|entry| entry.value.is_table()) {
        Some(entry) => value::read(&entry, Dimension::Angle, false, context),
        None => section.number("angle").map(Value::Constant),
    };
    let (friction, against_sliding) = friction(section);
    if let Some(entry) =
        section.get("angle").filter(|_| against_sliding && angle.as_ref().is_some_and(Value::follows_motion))
    {
        entry.fault(text!("scene-angle-of-sliding"), text!("scene-law-over-coordinate"));
    }
    let force = value::sized(section, "force", Dimension::Force, false, context, id);
    let during = section.get("during").and_then(|entry| interval(&entry, context));
    let link = linkage.link_of(section, text!("scene-arc-of-a-link"));
    let center = section.need("center").and_then(|entry| {
        linkage.place(&entry, link?, move |scene| Some(&mut scene.loads[id].kind.contact_mut()?.center))
    });
    let (center, radius, angle, force) = (center?, radius?, angle?, force?);
    Some(Contact { center, radius, angle, force, friction, against_sliding, during }.into())
}

/// The coefficient of friction, and whether its sign is found from the sliding: a number with its sign, or
/// `{ against_sliding = 0.1 }`.
fn friction(section: &Section<'_>) -> (f64, bool) {
    let against_sliding = section.get("friction").is_some_and(|entry| entry.value.is_table());
    let coefficient = if against_sliding {
        section.inner("friction").and_then(|friction| friction.number("against_sliding"))
    } else {
        section.number("friction")
    };
    (coefficient.unwrap_or_default(), against_sliding)
}

fn interval(entry: &Entry<'_>, context: &Context<'_>) -> Option<[f64; 2]> {
    let [from, to] = pair(entry, &name("[from, to]"), context.coordinate())?;
    if from > to {
        entry.fault(text!("scene-during-backward"), text!("scene-from-less-than-to"));
    } else if from.total_cmp(&to).is_eq() && context.coordinate().is_some() {
        entry.fault(text!("scene-during-nothing"), text!("scene-from-less-than-to"));
    }
    Some([from, to])
}
