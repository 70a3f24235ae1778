//! `[assembly]`, `[balance]`, `[output]`: the wanted assembly, balancing load and results.

use assur_mechanism::{Balance, Output, PairId, PointId};

use assur_words::{name, text};

use crate::context::Context;
use crate::linkage::{SceneLinks, pair};
use crate::over_time::Timing;
use crate::text::{row, shown, such_as};
use crate::units::Dimension;
use crate::walk::{Entry, Section};

/// Reads `[assembly]`: rough positions of points.
pub(crate) fn assembly(root: &Section<'_>, linkage: &SceneLinks) -> Vec<(PointId, [f64; 2])> {
    let Some(entry) = root.get("assembly") else {
        return Vec::new();
    };
    let hints = entry.named(text!("scene-table-of-points"), such_as("D = [0.17, 0.28]"));
    let read = |(index, hint): (usize, &Entry<'_>)| {
        let span = hint.span.clone();
        hint.faults.tell(|told| told.place([span], move |scene| Some(&mut scene.assembly.get_mut(index)?.1)));
        let at_key = Entry { name: "assembly".to_owned(), span: hint.key.clone(), ..hint.clone() };
        let point = linkage.point_of(&at_key, &hint.name)?;
        Some((point, pair(hint, &name("[x, y]"), Dimension::Length)?))
    };
    hints.iter().enumerate().filter_map(read).collect()
}

/// Reads `[balance]`: the load that maintains the motion, if it does not act on the input.
pub(crate) fn balance(root: &Section<'_>, context: &Context<'_>) -> Option<Balance> {
    let (section, linkage) = (root.inner("balance")?, context.linkage);
    if context.timing == Timing::List {
        context.timing.refuse_mover(root.faults, &section.span, "[balance]");
        return None;
    }
    let link = linkage.link_of(&section, text!("scene-ground-carries"));
    match (section.get("at"), section.get("angle")) {
        (None, None) => Some(Balance::Moment(link?)),
        (Some(at), Some(_)) => {
            let at = linkage.place(&at, link?, |scene| match &mut scene.balance {
                Some(Balance::Force { at, .. }) => Some(at),
                _ => None,
            });
            let angle = section.number("angle");
            section.sets(1.0, |scene, key| match (&mut scene.balance, key) {
                (Some(Balance::Force { angle, .. }), "angle") => Some(angle),
                _ => None,
            });
            Some(Balance::Force { at: at?, angle: angle? })
        }
        (at, _) => {
            let absent = if at.is_none() { "at" } else { "angle" };
            section.missing(absent, text!("scene-why-at-and-angle"));
            None
        }
    }
}

/// Reads `[output]`: the wanted results.
pub(crate) fn output(root: &Section<'_>, linkage: &SceneLinks) -> Option<Output> {
    let section = root.inner("output")?;
    Some(Output {
        points: each(&section, "points", |entry| linkage.point(entry)),
        links: each(&section, "links", |entry| linkage.moving(entry, text!("scene-ground-does-not-move"))),
        slides: each(&section, "slides", |entry| linkage.slide(entry)),
        reactions: each(&section, "reactions", |entry| pair_id(entry, linkage)),
    })
}

fn each<T>(section: &Section<'_>, key: &str, read: impl Fn(&Entry<'_>) -> Option<T>) -> Vec<T> {
    let items = section.get(key).map(|entry| entry.list(text!("scene-list-of-names"))).unwrap_or_default();
    items.iter().filter_map(read).collect()
}

/// The pin or slide named by an entry.
pub(crate) fn pair_id(entry: &Entry<'_>, linkage: &SceneLinks) -> Option<PairId> {
    let name = entry.text(text!("scene-name-of-a-pair"))?;
    if let Some(id) = linkage.slides.iter().position(|slide| slide.name == name) {
        return Some(PairId::Slide(id));
    }
    let pins = linkage.points.iter().filter(|point| point.is_pin()).map(|point| point.name.as_str());
    match linkage.point_named(name) {
        Some(id) if linkage.points[id].is_pin() => Some(PairId::Pin(id)),
        Some(_) => {
            let label = text!("scene-pins", pins = row(pins));
            entry.fault(text!("scene-point-is-no-pin", point = shown(name)), label);
            None
        }
        None => {
            let slides = linkage.slides.iter().map(|slide| slide.name.as_str());
            SceneLinks::known(entry, ("pair", name), None, pins.chain(slides))
        }
    }
}
