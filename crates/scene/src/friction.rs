//! `[[friction]]`: dry friction in pairs.

use assur_mechanism::{Friction, GROUND, Middle, Motion, PairId, Surfaces};
use assur_words::text;

use crate::over_time::Timing;
use crate::text::{row, shown, such_as};
use crate::walk::{Entry, Section, quoted};
use crate::{context::Context, linkage::SceneLinks, reference, wishes};

/// The shortest length of contact, m: below it the moment of the guide is a couple of forces whose digits are lost.
const LEAST_CONTACT: f64 = 1e-6;

pub(crate) fn read(root: &Section<'_>, context: &Context<'_>, motion: Option<&Motion>) -> Vec<Friction> {
    if let Some(entry) = root.get("friction").filter(|_| context.timing == Timing::List) {
        context.need_motion(&entry, quoted("[[friction]]"));
    }
    if let (Some(Motion::Transient { .. } | Motion::Steady { .. }), Some(balance), Some(_)) =
        (motion, root.get("balance"), root.get("friction"))
    {
        let message = text!("scene-friction-in-free-motion");
        root.faults.add(balance.key, message, text!("scene-friction-prescribed"));
    }
    let mut all: Vec<Friction> = Vec::new();
    for section in root.inners("friction") {
        let Some(friction) = one(&section, context.linkage, all.len()) else { continue };
        if all.iter().any(|known| known.pair == friction.pair)
            && let Some(entry) = section.get("pair")
        {
            entry.fault(text!("scene-friction-twice", pair = entry.written()), text!("scene-leave-one-out"));
        }
        all.push(friction);
    }
    all
}

fn one(section: &Section<'_>, linkage: &SceneLinks, id: usize) -> Option<Friction> {
    let pair = section.need("pair").and_then(|entry| wishes::pair_id(&entry, linkage));
    let coefficient = section.number("coefficient");
    section.sets(1.0, move |scene, key| match (&mut scene.frictions[id], key) {
        (Friction { coefficient: number, .. }, "coefficient")
        | (Friction { surfaces: Surfaces::Journal { radius: number, .. }, .. }, "radius")
        | (Friction { surfaces: Surfaces::Faces { length: number, .. }, .. }, "length")
        | (Friction { surfaces: Surfaces::Faces { offset: number, .. }, .. }, "offset") => Some(number),
        _ => None,
    });
    let surfaces = match pair? {
        PairId::Pin(point) => {
            refuse(section, "pin", "scene-friction-of-slides");
            let radius = section.number("radius");
            let links = || linkage.points[point].places.iter().map(|place| place.link);
            let owner = match section.get("owner") {
                None => links().min(),
                Some(entry) => owner(&entry, linkage, &links().collect::<Vec<_>>()),
            };
            Surfaces::Journal { radius: radius?, owner: owner.unwrap_or(GROUND) }
        }
        PairId::Slide(_) => {
            refuse(section, "slide", "scene-friction-of-pins");
            slide(section)?
        }
    };
    Some(Friction { pair: pair?, coefficient: coefficient?, surfaces })
}

/// Notes keys that have no meaning for this sort of pair.
fn refuse(section: &Section<'_>, sort: &str, message: &'static str) {
    let all = &reference::table("[[friction]]").keys;
    let others = all.iter().filter(|key| !key.sorts.is_empty() && key.sorts != sort);
    for entry in others.filter_map(|key| section.get(key.name)) {
        entry.fault(text!(message, key = shown(&entry.name)), text!("scene-leave-it-out"));
    }
}

fn owner(entry: &Entry<'_>, linkage: &SceneLinks, links: &[usize]) -> Option<usize> {
    let owner = linkage.link(entry)?;
    if !links.contains(&owner) {
        let names = links.iter().map(|link| linkage.links[*link].name.as_str());
        let on = shown(&linkage.links[owner].name);
        entry
            .fault(text!("scene-friction-owner", link = on), text!("scene-belongs-to", holders = row(names)));
        return None;
    }
    Some(owner)
}

fn slide(section: &Section<'_>) -> Option<Surfaces> {
    let given = section.get("middle");
    let words = [("point", Middle::Point), ("through", Middle::Through)];
    let middle = given.as_ref().map_or(Some(Middle::Point), |entry| entry.choice(&words));
    let Some(entry) = section.get("length") else {
        for entry in given.into_iter().chain(section.get("offset")) {
            entry.fault(
                text!("scene-friction-without-length", key = shown(&entry.name)),
                text!("scene-friction-add-length"),
            );
        }
        return Some(Surfaces::Place);
    };
    let (length, offset) = (section.number("length"), section.number("offset"));
    if length.is_some_and(|length| !entry.is_within(length, LEAST_CONTACT..)) {
        entry.problem(text!("scene-friction-short-contact", got = entry.written()), such_as("\"90 mm\""));
    }
    Some(Surfaces::Faces { length: length?, middle: middle?, offset: offset? })
}
