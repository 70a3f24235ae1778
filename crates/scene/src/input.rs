//! `[input]`: the input link, its coordinate and the positions.

use std::f64::consts::TAU;

use assur_mechanism::{GROUND, Input, InputPair, LinkId, Range, Sense};

use assur_words::{Text, name, number, quantity, text};

use crate::text::{exclude, rounded, row, shown};
use crate::walk::{Entry, Section};
use crate::{context::coordinate_of, linkage::SceneLinks, reference, units::Dimension};

/// Positions take no memory, but time and a place on a disk: more would fill terabytes.
const MOST: usize = 1_000_000_000;

/// Angles of less difference than this are rounding, rad or turns.
const SAME_TURN: f64 = 1e-6;

/// Reads the input; `None` if its link or pair is not known.
pub(crate) fn read(root: &Section<'_>, linkage: &SceneLinks) -> Option<Input> {
    let Some(entry) = root.get("input") else {
        root.missing("input", text!("scene-add-input"));
        return None;
    };
    let section = entry.section(reference::table("[input]"))?;
    let driven = driven(&section, linkage);
    let dimension = driven.map(|(_, _, pair)| coordinate_of(pair));
    let from = section.by_input("from", dimension).unwrap_or_default();
    // The two ends of a range must differ, and a moment of inertia by a formula must stay positive on the way.
    let varies = linkage.links.iter().any(|link| link.inertia.varying().is_some());
    if !varies && section.get("to").is_none() {
        section.sets(1.0, |scene, key| (key == "from").then_some(&mut scene.input.from));
    }
    let positions = section.get("positions").and_then(|entry| entry.count(1, MOST)).unwrap_or(12);
    let senses = [("ccw", Sense::Ccw), ("cw", Sense::Cw)];
    let sense = section.get("direction").and_then(|entry| entry.choice(&senses));
    let range = range(&section, dimension, from, positions);
    let direction = sense.unwrap_or(Sense::Ccw);
    let name = section.get("name").map(|_| section.name(Text::default, |_| None));
    let (link, on, pair) = driven?;
    Some(Input { link, on, pair, name, from, positions, range, direction })
}

/// What is driven: a link, against the ground or another one, in which pair.
type DrivenLink = (LinkId, LinkId, InputPair);

/// What is driven: exactly one of `link`, `slide` and `pin` says it.
fn driven(section: &Section<'_>, linkage: &SceneLinks) -> Option<DrivenLink> {
    let given: Vec<Entry<'_>> = ["link", "slide", "pin"].iter().filter_map(|key| section.get(key)).collect();
    let [entry, more @ ..] = &given[..] else {
        section.missing("link", text!("scene-why-an-input"));
        return None;
    };
    if let Some(other) = more.first() {
        let keys = [entry, other].map(|entry| name(entry.name.clone()));
        other.fault(exclude(keys), text!("scene-why-an-input"));
        return None;
    }
    for key in ["of", "on"].iter().filter(|_| entry.name != "pin") {
        if let Some(found) = section.get(key) {
            found.fault(text!("scene-of-a-pin"), text!("scene-leave-it-out"));
        }
    }
    match entry.name.as_str() {
        "link" => {
            let link = linkage.moving(entry, text!("scene-link-joined-to-ground"))?;
            Some((link, GROUND, pair(linkage, link, entry)?))
        }
        "slide" => {
            let id = linkage.slide(entry)?;
            let slide = &linkage.slides[id];
            let (link, on) = if slide.link == GROUND { (slide.on, GROUND) } else { (slide.link, slide.on) };
            Some((link, on, InputPair::Slide(id)))
        }
        _ => driven_pin(section, linkage, entry),
    }
}

/// A driven pin: it turns `of` against `on`.
fn driven_pin(section: &Section<'_>, linkage: &SceneLinks, entry: &Entry<'_>) -> Option<DrivenLink> {
    let point = linkage.point(entry)?;
    let joined: Vec<LinkId> = linkage.points[point].places.iter().map(|place| place.link).collect();
    let of = section.need("of")?;
    let link = linkage.link(&of)?;
    if link == GROUND {
        of.fault(text!("scene-ground-is-on"), text!("scene-swap-of-and-on"));
        return None;
    }
    let on = match (section.get("on"), &joined[..]) {
        (Some(entry), _) => linkage.link(&entry)?,
        (None, [one, other]) => {
            if *one == link {
                *other
            } else {
                *one
            }
        }
        (None, _) => {
            section.missing("on", text!("scene-which-on", pin = shown(&linkage.points[point].name)));
            return None;
        }
    };
    if link == on || ![link, on].iter().all(|link| joined.contains(link)) {
        let named = |link: LinkId| shown(&linkage.links[link].name);
        let pin = shown(&linkage.points[point].name);
        let links = row(joined.iter().map(|link| linkage.links[*link].name.as_str()));
        let message = text!("scene-ends-of-pin", pin, of = named(link), on = named(on));
        entry.fault(message, text!("scene-pin-joins", links));
        return None;
    }
    Some((link, on, InputPair::Pin(point)))
}

/// The single pair between the link and the ground.
fn pair(linkage: &SceneLinks, link: LinkId, entry: &Entry<'_>) -> Option<InputPair> {
    let joins = |id: &usize| linkage.points[*id].on(GROUND).and(linkage.points[*id].on(link)).is_some();
    let pins = (0..linkage.points.len()).filter(joins).map(InputPair::Pin);
    let slides = linkage.on_ground(link).map(InputPair::Slide);
    let pairs: Vec<InputPair> = pins.chain(slides).collect();
    if let [pair] = pairs[..] {
        return Some(pair);
    }
    let of = shown(&linkage.links[link].name);
    if pairs.is_empty() {
        entry.fault(text!("scene-input-not-joined", link = of), text!("scene-join-the-input"));
    } else {
        let names = pairs.iter().map(|pair| match *pair {
            InputPair::Pin(id) => linkage.points[id].name.as_str(),
            InputPair::Slide(id) => linkage.slides[id].name.as_str(),
        });
        let message = text!("scene-input-joined-often", link = of, count = pairs.len(), pairs = row(names));
        entry.fault(message, text!("scene-one-pair-of-input"));
    }
    None
}

fn range(section: &Section<'_>, dimension: Option<Dimension>, from: f64, positions: usize) -> Range {
    if let Some(entry) = section.get("to") {
        if let Some(cycle) = section.get("cycle") {
            cycle.fault(exclude(["cycle", "to"].map(name)), text!("scene-cycle-or-range"));
        }
        let Some(to) = section.by_input("to", dimension) else { return Range::To(from) };
        if positions > 1 && dimension.is_some() && to.total_cmp(&from).is_eq() {
            entry.fault(
                text!("scene-no-range", positions = number(positions)),
                text!("scene-one-position-or-another-end"),
            );
        }
        if dimension == Some(Dimension::Angle) && repeats_the_first(to - from, positions) {
            #[expect(clippy::cast_precision_loss, reason = "few positions divide a turn into whole degrees")]
            let apart = quantity(rounded(360.0 / (positions - 1) as f64), "deg");
            let (count, more) = (number(positions), number(positions + 1));
            let text = text!("scene-list-repeats", positions = count, apart, more);
            entry.faults.mistake(entry.span.clone(), text);
        }
        return Range::To(to);
    }
    if section.get("cycle").is_none() && dimension == Some(Dimension::Length) {
        section.missing("to", text!("scene-why-to"));
    }
    let cycle = section.by_input("cycle", dimension).unwrap_or(TAU);
    if let Some(entry) = section.get("cycle").filter(|_| dimension == Some(Dimension::Angle)) {
        let turns = cycle / TAU;
        if (turns - turns.round()).abs() > SAME_TURN {
            let text = text!("scene-part-of-a-turn", cycle = quantity(rounded(cycle.to_degrees()), "deg"));
            entry.faults.mistake(entry.span.clone(), text);
        }
    }
    Range::Cycle(cycle)
}

/// Whether positions, both ends included, run over one turn as if its end were left out: 12 of them are 30 degrees apart
/// without the end, and 32.7 with it.
#[expect(clippy::cast_precision_loss, reason = "far fewer than 2^52 positions")]
fn repeats_the_first(range: f64, positions: usize) -> bool {
    let is_whole = |degrees: f64| (degrees - degrees.round()).abs() < SAME_TURN;
    let is_turn = (range.abs() - TAU).abs() < SAME_TURN;
    is_turn
        && positions > 2
        && is_whole(360.0 / positions as f64)
        && !is_whole(360.0 / (positions - 1) as f64)
}
