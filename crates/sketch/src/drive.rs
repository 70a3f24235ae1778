//! What could drive a mechanism.

use assur_draft::{remove, set};
use assur_mechanism::{GROUND, InputPair, Key, LinkId, Mechanism, Name};
use assur_scene::edit::quoted;
use assur_words::{Text, text};

use crate::Sketch;
use crate::number::{degrees, millimeters, rounded, step_of};
use crate::pose::{distance, reduced, way};
use crate::reach::SAME;

/// How far a sliding input goes, in parts of its first displacement.
const STROKE: f64 = 0.2;

/// The first displacement that counts for the stroke at least, m.
const LEAST: f64 = 0.1;

/// The keys of `[input]` that say what is driven, and those that hold for one coordinate alone.
const OWN_KEYS: [&str; 10] = ["link", "slide", "pin", "of", "on", "from", "to", "cycle", "over_time", "unit"];

/// A pair that could be driven.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// The link that would be driven.
    pub link: LinkId,
    /// The link against which it would be driven.
    pub on: LinkId,
    /// The pair.
    pub pair: InputPair,
    /// The keys of `[input]` that say so.
    keys: Vec<(&'static str, String)>,
}

/// All pairs that could be driven: links that are pinned to the ground or slide on it, then pins and slides between moving links.
pub fn drives(mechanism: &Mechanism) -> Vec<Drive> {
    let mut all = Vec::new();
    for (id, point) in mechanism.points.iter().enumerate() {
        let links: Vec<LinkId> = point.places.iter().map(|place| place.link).collect();
        let on = if links.contains(&GROUND) { GROUND } else { links[0] };
        let driven = links.iter().filter(|link| **link != on);
        all.extend(driven.map(|link| Drive::of(mechanism, *link, on, InputPair::Pin(id))));
    }
    for (id, slide) in mechanism.slides.iter().enumerate() {
        let (link, on) = if slide.link == GROUND { (slide.on, GROUND) } else { (slide.link, slide.on) };
        all.push(Drive::of(mechanism, link, on, InputPair::Slide(id)));
    }
    all.sort_by_key(|drive| drive.on != GROUND);
    all
}

impl Drive {
    fn of(mechanism: &Mechanism, link: LinkId, on: LinkId, pair: InputPair) -> Self {
        let name = |link: LinkId| mechanism.links[link].name.to_string();
        let joins =
            |one: LinkId, other: LinkId| [one, other] == [link, GROUND] || [one, other] == [GROUND, link];
        let pins = mechanism.points.iter().filter(|point| point.on(link).and(point.on(GROUND)).is_some());
        let slides = mechanism.slides.iter().filter(|slide| joins(slide.link, slide.on));
        let keys = match pair {
            _ if on == GROUND && pins.count() + slides.count() == 1 => vec![("link", name(link))],
            InputPair::Slide(slide) => vec![("slide", mechanism.slides[slide].name.to_string())],
            InputPair::Pin(point) => {
                let pin = mechanism.points[point].name.to_string();
                vec![("pin", pin), ("of", name(link)), ("on", name(on))]
            }
        };
        Self { link, on, pair, keys }
    }

    /// What would move, in words.
    pub fn words(&self, mechanism: &Mechanism) -> Text {
        let (link, on) = (&mechanism.named_link(self.link), &mechanism.named_link(self.on));
        match self.pair {
            InputPair::Pin(point) => text!("sketch-turns", link, on, pin = &mechanism.named_point(point)),
            InputPair::Slide(_) => text!("sketch-slides", link, on),
        }
    }

    /// Whether its coordinate is an angle (rad); otherwise a displacement (m).
    pub fn is_angle(&self) -> bool {
        matches!(self.pair, InputPair::Pin(_))
    }

    /// Its coordinate in the position that is drawn: rad, or m. `None` where the links are not placed.
    pub fn coordinate(&self, sketch: &Sketch) -> Option<f64> {
        let (own, on) = (sketch.bodies[self.link]?, sketch.bodies[self.on]?);
        match self.pair {
            InputPair::Pin(_) => Some(reduced(own.angle - on.angle)),
            InputPair::Slide(id) => {
                let slide = &sketch.mechanism.slides[id];
                let place = sketch.bodies[slide.link]?.point(slide.point);
                Some(way(sketch.guide_of(id)?, place))
            }
        }
    }
}

/// The text of a scene whose input is this one, from the coordinate at which it is now (rad, or m): of a turning one over a turn, of a
/// sliding one by 20 % more. Positions and direction stay; further inputs and laws over time go. Where another mode would be taken,
/// the places of pins are given in `[assembly]`. `sketch` is of this scene.
///
/// # Errors
///
/// What is wrong with the text, in the reader's words.
pub fn drive(text: &str, sketch: &Sketch, drive: &Drive, present: f64) -> Result<String, Text> {
    let text = driven(text, sketch, drive, present)?;
    let Ok(reading) = assur_scene::reading("", &text) else { return Ok(text) };
    let (after, size) = (crate::sketch(&reading.mechanism), sketch.size());
    let pins = sketch.mechanism.points.iter().filter(|point| point.is_pin() && point.on(GROUND).is_none());
    let places = pins.filter_map(|point| Some((&point.name, sketch.place(&point.name)?)));
    let elsewhere =
        |(name, at): &(&Name, [f64; 2])| after.place(name).is_none_or(|now| distance(now, *at) > SAME * size);
    places.filter(elsewhere).try_fold(text, |text, (name, at)| {
        let at = at.map(|part| millimeters(rounded(part, step_of(size))));
        set(&text, &Key::of("assembly").at(name), &format!("[{}, {}]", at[0], at[1]))
    })
}

/// The text with another input.
fn driven(text: &str, sketch: &Sketch, drive: &Drive, present: f64) -> Result<String, Text> {
    let input = Key::of("input");
    let mut text = text.to_owned();
    if sketch.mechanism.input.is_list {
        text = remove(&text, &input);
    }
    let mut keys: Vec<(&str, String)> = drive.keys.iter().map(|(key, name)| (*key, quoted(name))).collect();
    if drive.is_angle() {
        keys.push(("from", degrees(present)));
    } else {
        let step = step_of(present.abs().max(LEAST));
        let stroke = (STROKE * present.abs().max(LEAST)).copysign(present);
        keys.push(("from", millimeters(rounded(present, step))));
        keys.push(("to", millimeters(rounded(present + stroke, step))));
    }
    for key in OWN_KEYS.iter().filter(|key| !keys.iter().any(|(set, _)| set == *key)) {
        text = remove(&text, &input.clone().at(*key));
    }
    keys.iter().try_fold(text, |text, (key, value)| set(&text, &input.clone().at(*key), value))
}
