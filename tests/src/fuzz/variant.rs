//! Variants of the shipped scenes that a person might well write: other numbers, friction, moments of inertia by formula, passive
//! links, another assembly, another sense, another first position. Unlike mutations most of them can be calculated, so that their
//! checks are what they try.

use std::fmt::Write;

use assur_mechanism::{GROUND, Mechanism};
use assur_scene::edit::{ParsedText, replaced};
use assur_testkit::Rng;

/// A change of a scene's text; `None` where the scene has no place for it.
type Change = fn(&str, &Mechanism, &mut Rng) -> Option<String>;

/// The text of variant `number` of the shipped scenes; the same for the same number.
pub fn variant(number: u64) -> String {
    let mut rng = Rng::new(number);
    let (name, text) = rng.pick(assur_fixtures::SCENES);
    let mut text = (*text).to_owned();
    let changes: [Change; 6] = [numbers, friction, inertia, passive, assembly, input];
    let wanted = 1 + rng.below(changes.len() - 1);
    for _ in 0..wanted {
        let change = rng.pick(&changes);
        let Ok(mechanism) = assur_scene::read(name, &text) else { break };
        let next = change(&text, &mechanism, &mut rng);
        text = next.filter(|next| assur_scene::read(name, next).is_ok()).unwrap_or(text);
    }
    text
}

/// Lengths a little, masses, speeds and sizes of loads more.
#[allow(clippy::unnecessary_wraps, reason = "one `Change` of several")]
fn numbers(text: &str, _: &Mechanism, rng: &mut Rng) -> Option<String> {
    let changed: Vec<_> = (ParsedText::of(text).values().into_iter())
        .filter_map(|value| {
            let is_of = |part: &str| value.key.to_string().contains(part);
            if is_of("positions")
                || is_of("samples")
                || is_of("tolerance")
                || is_of("until")
                || rng.chance(0.5)
            {
                return None;
            }
            let most = if is_of("points") || is_of("through") { 4.0 } else { 60.0 };
            let now = value.moved(&value.written, rng.signed(0.0, most))?;
            Some((value.span, now))
        })
        .collect();
    Some(replaced(text, changed.iter().map(|(span, now)| (span, now.as_str()))))
}

/// Dry friction in some pairs that have none.
#[allow(clippy::unnecessary_wraps, reason = "one `Change` of several")]
fn friction(text: &str, mechanism: &Mechanism, rng: &mut Rng) -> Option<String> {
    let known = |pair: &str| text.contains(&format!("pair = \"{pair}\""));
    let mut all = String::new();
    let coefficient = |rng: &mut Rng| {
        let most = *rng.pick(&[0.1, 0.3, 1.0]);
        (rng.range(0.0, most) * 100.0).round() / 100.0
    };
    for point in mechanism.points.iter().filter(|point| point.places.len() > 1 && !known(&point.name)) {
        if rng.chance(0.4) {
            let radius = *rng.pick(&[0.005, 0.02, 0.05]);
            let c = coefficient(rng);
            let _ = write!(
                all,
                "\n[[friction]]\npair = \"{}\"\ncoefficient = {c}\nradius = {radius}\n",
                point.name
            );
        }
    }
    for slide in mechanism.slides.iter().filter(|slide| !known(&slide.name)) {
        if rng.chance(0.5) {
            let c = coefficient(rng);
            let _ = write!(all, "\n[[friction]]\npair = \"{}\"\ncoefficient = {c}\n", slide.name);
            if rng.chance(0.5) {
                let _ = writeln!(all, "length = {}", rng.pick(&[0.02, 0.12, 0.4]));
                if rng.chance(0.5) {
                    let _ = writeln!(all, "offset = {}", rng.pick(&[0.01, 0.05]));
                }
                if rng.chance(0.3) {
                    all.push_str("middle = \"through\"\n");
                }
            }
        }
    }
    Some(format!("{text}\n{all}"))
}

/// A moment of inertia by formula, of a link that is pinned to the ground.
fn inertia(text: &str, mechanism: &Mechanism, rng: &mut Rng) -> Option<String> {
    let pinned = |link: &usize| {
        let joins = |id: usize| move |place: &assur_mechanism::Place| place.link == id;
        mechanism
            .points
            .iter()
            .any(|point| point.places.iter().any(joins(GROUND)) && point.places.iter().any(joins(*link)))
    };
    let links: Vec<_> = (1..mechanism.links.len()).filter(pinned).collect();
    let name = &mechanism.links[*links.get(rng.below(links.len()))?].name;
    let mean = rng.range(0.01, 0.5);
    let part = mean * rng.range(0.01, 0.99);
    let k = if rng.chance(0.5) { (1 + rng.below(400)) as f64 } else { rng.range(0.05, 12.0) };
    let wave = rng.pick(&["sin", "cos"]);
    let law = format!("{{ formula = \"{mean} + {part}*{wave}({k}*q)\" }}");
    let key = format!("link.{name}.inertia");
    if let Some(value) = ParsedText::of(text).values().into_iter().find(|value| value.key.to_string() == key)
    {
        return Some(replaced(text, [(&value.span, law.as_str())]));
    }
    let head = format!("[link.{name}]");
    let end = text.find(&head)? + head.len();
    let end = end + text[end..].find('\n')?;
    Some(format!("{}\ninertia = {law}{}", &text[..end], &text[end..]))
}

/// A link beside another one, from one of its pins to another: a passive one that fits.
fn passive(text: &str, mechanism: &Mechanism, rng: &mut Rng) -> Option<String> {
    let link = 1 + rng.below(mechanism.links.len() - 1);
    let pins: Vec<_> = (mechanism.points.iter())
        .filter(|point| point.places.len() > 1)
        .filter_map(|point| Some((&point.name, point.places.iter().find(|place| place.link == link)?.at)))
        .collect();
    let [one, other] = [0, 1].map(|_| pins.get(rng.below(pins.len())));
    let ((one, a), (other, b)) = (one?, other?);
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    if length == 0.0 {
        return None;
    }
    let mass = if rng.chance(0.5) { "mass = 2\ncenter = 0.01\ninertia = 0.003\n" } else { "" };
    let head = text.find("[input]")?;
    let link = format!("[link.beside]\npoints = {{ {one} = 0, {other} = {length:?} }}\n{mass}\n");
    Some(format!("{}{link}{}", &text[..head], &text[head..]))
}

/// Another assembly: without the places of the scene, or with some of them mirrored.
#[allow(clippy::unnecessary_wraps, reason = "one `Change` of several")]
fn assembly(text: &str, _: &Mechanism, rng: &mut Rng) -> Option<String> {
    let values: Vec<_> = (ParsedText::of(text).values().into_iter())
        .filter(|value| value.key.to_string().starts_with("assembly.") && rng.chance(0.5))
        .map(|value| (value.moved(&value.written, -200.0), value.span))
        .collect();
    let changed = values.iter().filter_map(|(now, span)| Some((span, now.as_deref()?)));
    Some(replaced(text, changed))
}

/// The other sense, another first position, another speed.
fn input(text: &str, mechanism: &Mechanism, rng: &mut Rng) -> Option<String> {
    let head = text.find("[input]")? + "[input]".len();
    let (before, mut after) = (&text[..head], text[head..].to_owned());
    let section = |after: &str| after.find("\n[").unwrap_or(after.len());
    if rng.chance(0.5) {
        let end = section(&after);
        if let Some(at) = after[..end].find("direction = \"cw\"") {
            after.replace_range(at + 13..at + 15, "ccw");
        } else if !after[..end].contains("direction") {
            after.insert_str(0, "\ndirection = \"cw\"");
        }
    }
    let end = section(&after);
    if mechanism.input.is_angle() && !after[..end].contains("from") {
        let from = if rng.chance(0.3) { 90.0 * rng.below(4) as f64 } else { rng.range(-180.0, 360.0) };
        after.insert_str(0, &format!("\nfrom = \"{from} deg\""));
    }
    Some(format!("{before}{after}"))
}
