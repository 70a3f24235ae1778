//! `[input]`: what is driven, its coordinate and the positions; `[[input]]`: several, over time.

use std::collections::HashSet;
use std::f64::consts::TAU;

use assur_mechanism::{Driver, GROUND, Input, InputPair, LinkId, Name, PairId, Range, Sense, Step, TimeLaw};

use assur_words::{Text, name, number, quantity, text};

use crate::over_time::{Instants, Timing, instants, law};
use crate::reading::element_names;
use crate::text::{exclude, rounded, row, shown};
use crate::walk::{Entry, Section};
use crate::{context::coordinate_of, linkage::SceneLinks, reference, units::Dimension};

/// Positions take no memory, but time and a place on a disk: more would fill terabytes.
pub(crate) const MOST: usize = 1_000_000_000;

/// Angles of less difference than this are rounding, rad or turns.
const SAME_TURN: f64 = 1e-6;

/// Reads the input; `None` if its link or pair is not known.
pub(crate) fn read(root: &Section<'_>, linkage: &SceneLinks, timing: Timing) -> Option<Input> {
    let Some(entry) = root.get("input") else {
        root.missing("input", text!("scene-add-input"));
        return None;
    };
    if timing == Timing::List {
        return list(root, &entry, linkage);
    }
    let section = entry.section(reference::table("[input]"))?;
    let driven = driven(&section, linkage);
    let senses = [("ccw", Sense::Ccw), ("cw", Sense::Cw)];
    let sense = section.get("direction").and_then(|entry| entry.choice(&senses));
    let name = section.get("name").map(|_| section.name(Text::default, |_| None));
    if timing == Timing::Law {
        refuse_beside_law(&section, &["from", "positions", "to", "cycle"]);
        let instants = instants(root, timing);
        let law = section
            .get("over_time")
            .zip(driven.as_ref())
            .and_then(|(entry, driver)| law(&entry, coordinate_of(driver.pair), instants));
        let driver = Driver { law: Some(law?), ..driven? };
        return Some(Input { name, ..over_time(vec![driver], instants?) });
    }
    let dimension = driven.as_ref().map(|driver| coordinate_of(driver.pair));
    let from = section.by_input("from", dimension).unwrap_or_default();
    // The two ends of a range must differ, and a moment of inertia by a formula must stay positive on the way.
    let varies = linkage.links.iter().any(|link| link.inertia.varying().is_some());
    if !varies && section.get("to").is_none() {
        section.sets(1.0, |scene, key| (key == "from").then_some(&mut scene.input.from));
    }
    let positions = section.get("positions").and_then(|entry| entry.count(1, MOST)).unwrap_or(12);
    let range = range(&section, dimension, from, positions);
    let direction = sense.unwrap_or(Sense::Ccw);
    Some(Input { drivers: vec![driven?], is_list: false, name, from, positions, range, direction })
}

/// An input whose coordinate is the time.
fn over_time(drivers: Vec<Driver>, Instants { until, count }: Instants) -> Input {
    Input { drivers, positions: count, range: Range::To(until), ..Input::default() }
}

/// Reads a list of inputs, each over time.
fn list(root: &Section<'_>, entry: &Entry<'_>, linkage: &SceneLinks) -> Option<Input> {
    let instants = instants(root, Timing::List);
    let items = entry.list(Text::default());
    if items.is_empty() {
        root.missing("input", text!("scene-add-input"));
    }
    let mut known = HashSet::new();
    let mut drivers = Vec::new();
    for (index, (item, label)) in items.iter().zip(labels(entry)).enumerate() {
        let Some(driver) = one(item, (index, label), linkage, instants) else { continue };
        let (ends, pair) = ([driver.link.min(driver.on), driver.link.max(driver.on)], driver.pair_id());
        if !known.insert((ends, pair)) {
            let pair = match pair {
                PairId::Pin(point) => &linkage.points[point].name,
                PairId::Slide(slide) => &linkage.slides[slide].name,
            };
            item.fault(text!("scene-driven-twice", pair = shown(pair)), text!("scene-leave-one-out"));
        }
        drivers.push(driver);
    }
    let all = instants.filter(|_| drivers.len() == items.len() && !items.is_empty())?;
    Some(Input { is_list: true, ..over_time(drivers, all) })
}

/// What results call each input of a list: as keys do, and with its number where two have one name.
fn labels(entry: &Entry<'_>) -> Vec<Name> {
    let names =
        entry.value.as_array().map(|array| element_names(&[Step::from("input")], array)).unwrap_or_default();
    let label = |(index, name): (usize, &Option<String>)| match name {
        Some(name) if names.iter().filter(|other| other.as_ref() == Some(name)).count() == 1 => {
            name.as_str().into()
        }
        name => format!("{}:{}", name.as_deref().unwrap_or_default(), index + 1).into(),
    };
    names.iter().enumerate().map(label).collect()
}

/// Reads an input of a list; `index`: its place there.
fn one(
    item: &Entry<'_>,
    (index, label): (usize, Name),
    linkage: &SceneLinks,
    instants: Option<Instants>,
) -> Option<Driver> {
    let section = item.section(reference::table("[[input]]"))?;
    let driven = driven(&section, linkage);
    let dimension = driven.as_ref().map(|driver| coordinate_of(driver.pair));
    let given = if let Some(entry) = section.get("over_time") {
        refuse_beside_law(&section, &["from", "rate"]);
        dimension.and_then(|dimension| law(&entry, dimension, instants))
    } else {
        let (from, rate) = (section.by_input("from", dimension), section.by_input("rate", dimension));
        section.sets(1.0, move |scene, key| scene.input.drivers.get_mut(index)?.law.as_mut()?.number(key));
        from.zip(rate).map(|(from, rate)| TimeLaw::uniform(from, rate))
    };
    // Without a motion nothing moves.
    let rests = instants.is_some_and(|instants| instants.until <= 0.0);
    let law = given.map(|law| if rests { TimeLaw::uniform(law.at(0.0)[0], 0.0) } else { law });
    Some(Driver { label, law: Some(law?), ..driven? })
}

/// Notes keys that a law over time leaves no place for.
fn refuse_beside_law(section: &Section<'_>, keys: &[&str]) {
    for entry in keys.iter().filter_map(|key| section.get(key)) {
        let keys = [entry.name.as_str(), "over_time"].map(shown);
        section.faults.add(entry.key, exclude(keys), text!("scene-leave-one-out"));
    }
}

/// What is driven, without a law: exactly one of `link`, `slide` and `pin` says it.
fn driven(section: &Section<'_>, linkage: &SceneLinks) -> Option<Driver> {
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
    let (link, on, pair) = match entry.name.as_str() {
        "link" => {
            let link = linkage.moving(entry, text!("scene-link-joined-to-ground"))?;
            (link, GROUND, pair(linkage, link, entry)?)
        }
        "slide" => {
            let id = linkage.slide(entry)?;
            let slide = &linkage.slides[id];
            let (link, on) = if slide.link == GROUND { (slide.on, GROUND) } else { (slide.link, slide.on) };
            (link, on, InputPair::Slide(id))
        }
        _ => driven_pin(section, linkage, entry)?,
    };
    Some(Driver { link, on, pair, label: entry.value.as_str()?.into(), law: None })
}

/// A driven pin: it turns `of` against `on`.
fn driven_pin(
    section: &Section<'_>,
    linkage: &SceneLinks,
    entry: &Entry<'_>,
) -> Option<(LinkId, LinkId, InputPair)> {
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
