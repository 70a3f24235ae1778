//! Moves points and guides of a scene in the position that is drawn.

use assur_draft::set;
use assur_group::plane::{minus, plus};
use assur_mechanism::{Driver, GROUND, InputPair, Key, LinkId, PointId, Slide, SlideId};
use assur_scene::edit::ParsedText;
use assur_scene::{Dimension, reading};
use assur_words::{Text, text};

use crate::Sketch;
use crate::number::{like, place_like, point_key, written};
use crate::pose::{Pose, angle_of, distance, is_origin, off, reduced, way};
use crate::shape::quoted;

/// A point is where it was put if it is not farther from there, m: what is written is rounded to less.
const THERE: f64 = 1e-5;

/// The text of a scene with a point at another place of the plane (m) in the position that is drawn. `sketch` is of this scene.
///
/// Of a pivot the coordinates in the ground change. Of any other point those in all its links do, where other points stay; a link of two
/// points that is written as a length keeps this form and turns, and if it is driven, the first coordinate follows. A stone with this
/// point alone goes with it, and the link with its guide follows; where that can't be, the stone gets an offset. The place in
/// `[assembly]` follows. A place that is a table, polar or by two lengths, becomes two coordinates; points of a link that are given by this
/// one follow it.
///
/// # Errors
///
/// No such point, a link of it has no place, a triangle of two lengths does not close any more, or what is wrong with the text, in the
/// reader's words.
pub fn move_point(text: &str, sketch: &Sketch, point: &str, to: [f64; 2]) -> Result<String, Text> {
    let id = sketch.mechanism.point(point).ok_or_else(|| text!("sketch-no-point", name = quoted(point)))?;
    let change = Change { text, sketch, point: id, to };
    let moved = change.made(false)?;
    let lies_there = |text: &str| {
        let reading = reading("", text).ok()?;
        Some(distance(crate::sketch(&reading.mechanism).place(point)?, to) < THERE)
    };
    let moved =
        if change.has_slides() && lies_there(&moved) != Some(true) { change.made(true)? } else { moved };
    open_triangle(&moved).map_or(Ok(moved), Err)
}

/// What the reader says of the first triangle of two lengths that does not close.
fn open_triangle(text: &str) -> Option<Text> {
    // Of most scenes nothing is read.
    if !text.contains("lengths") {
        return None;
    }
    let errors = reading("", text).err()?.errors.into_iter();
    let is_open = |message: &Text| message.identity().is_some_and(|own| own.starts_with("scene-triangle"));
    errors.map(|error| error.message).find(is_open)
}

/// The text of a scene with the guide of a slide turned by an angle, rad, about the point through which it goes.
///
/// # Errors
///
/// No such slide, or what is wrong with the text, in the reader's words.
pub fn turn_guide(text: &str, sketch: &Sketch, slide: &str, by: f64) -> Result<String, Text> {
    let slide = slide_of(sketch, slide)?;
    let key = key_of(slide).at("angle");
    let value = like(&written(text, &key), reduced(slide.angle + by), Dimension::Angle);
    set(text, &key, &value)
}

/// The text of a scene with the guide of a slide moved by a vector of the plane, m, in the position that is drawn.
///
/// # Errors
///
/// No such slide, its link has no place, or what is wrong with the text, in the reader's words.
pub fn move_guide(text: &str, sketch: &Sketch, slide: &str, by: [f64; 2]) -> Result<String, Text> {
    let slide = slide_of(sketch, slide)?;
    let key = key_of(slide).at("through");
    let through = plus(slide.through, pose_of(sketch, slide.on)?.turned_back(by));
    let old = written(text, &key);
    set(text, &key, &place_like(&old, through, old.len() == 1))
}

fn slide_of<'a>(sketch: &'a Sketch, name: &str) -> Result<&'a Slide, Text> {
    let found = sketch.mechanism.slides.iter().find(|slide| slide.name == name);
    found.ok_or_else(|| text!("sketch-no-slide", name = quoted(name)))
}

fn key_of(slide: &Slide) -> Key {
    Key::of("slide").at(&slide.name)
}

fn pose_of(sketch: &Sketch, link: LinkId) -> Result<Pose, Text> {
    let named = || quoted(&sketch.mechanism.links[link].name);
    sketch.bodies[link].ok_or_else(|| text!("sketch-no-pose", name = named()))
}

/// A point that is moved.
struct Change<'a> {
    text: &'a str,
    sketch: &'a Sketch,
    point: PointId,
    to: [f64; 2],
}

impl Change<'_> {
    /// The text with the point moved; `stays`: all links but those of two points keep their places.
    fn made(&self, stays: bool) -> Result<String, Text> {
        let point = &self.sketch.mechanism.points[self.point];
        let mut edits = Vec::new();
        if point.on(GROUND).is_some() {
            self.put(GROUND, Pose::GROUND, &mut edits);
        } else {
            for place in &point.places {
                self.on_link(place.link, stays, &mut edits)?;
            }
        }
        if self.sketch.mechanism.assembly.iter().any(|(wanted, _)| *wanted == self.point) {
            let key = Key::of("assembly").at(&point.name);
            let value = place_like(&written(self.text, &key), self.to, false);
            edits.push((key, value));
        }
        edits.iter().try_fold(self.text.to_owned(), |text, (key, value)| set(&text, key, value))
    }

    /// The slides of a link of the point.
    fn slides(&self, link: LinkId) -> impl Iterator<Item = (SlideId, &Slide)> {
        let all = self.sketch.mechanism.slides.iter().enumerate();
        all.filter(move |(_, slide)| slide.link == link || slide.on == link)
    }

    fn has_slides(&self) -> bool {
        let places = &self.sketch.mechanism.points[self.point].places;
        places.iter().any(|place| self.slides(place.link).next().is_some())
    }

    /// What changes in a link that moves.
    fn on_link(&self, link: LinkId, stays: bool, edits: &mut Vec<(Key, String)>) -> Result<(), Text> {
        let pose = pose_of(self.sketch, link)?;
        let points = self.sketch.mechanism.points.iter().enumerate();
        let others: Vec<_> = points
            .filter(|(id, _)| *id != self.point)
            .filter_map(|(id, point)| Some((id, point.on(link)?)))
            .collect();
        match others[..] {
            [] if !stays => self.with_stone(link, edits),
            [other] if self.is_bar(link, other) => self.as_bar(link, pose, other, edits),
            _ => {
                self.put(link, pose, edits);
                if stays {
                    self.keep_guides(link, edits);
                }
            }
        }
        Ok(())
    }

    /// Writes the coordinates of the place.
    fn put(&self, link: LinkId, pose: Pose, edits: &mut Vec<(Key, String)>) {
        let key = self.key(link, self.point);
        let old = written(self.text, &key);
        let value = place_like(&old, pose.local(self.to), link != GROUND || old.len() == 1);
        edits.push((key, value));
    }

    fn key(&self, link: LinkId, point: PointId) -> Key {
        point_key(&self.sketch.mechanism, link, &self.sketch.mechanism.points[point].name)
    }

    /// Whether a link is written as a length: one of its two points at the origin, the other by a single number. If it is driven, the
    /// coordinate can follow.
    fn is_bar(&self, link: LinkId, (other, at): (PointId, [f64; 2])) -> bool {
        let mechanism = &self.sketch.mechanism;
        let own = mechanism.place_in(self.point, link).unwrap_or_default();
        let end = if is_origin(at) { self.point } else { other };
        let is_length =
            is_origin(own) != is_origin(at) && written(self.text, &self.key(link, end)).len() == 1;
        let drives = |driver: &Driver| driver.link == link || driver.on == link;
        let follows = mechanism.input.sole().is_some() || !mechanism.input.drivers.iter().any(drives);
        is_length && follows && self.slides(link).next().is_none()
    }

    /// A link of two points with another length, which turns.
    fn as_bar(
        &self,
        link: LinkId,
        pose: Pose,
        (other, at): (PointId, [f64; 2]),
        edits: &mut Vec<(Key, String)>,
    ) {
        let is_end = is_origin(at);
        let other_place = pose.point(at);
        let [start, end] = if is_end { [other_place, self.to] } else { [self.to, other_place] };
        let own = self.sketch.mechanism.place_in(self.point, link).unwrap_or_default();
        // A negative number: the x axis points away from the end.
        let sign = if own[0] + at[0] < 0.0 { -1.0 } else { 1.0 };
        let key = self.key(link, if is_end { self.point } else { other });
        edits.push((
            key.clone(),
            like(&written(self.text, &key), sign * distance(start, end), Dimension::Length),
        ));
        let along = minus(end, start).map(|part| sign * part);
        let turned = reduced(angle_of(along) - pose.angle);
        let Some(driver) = self.sketch.mechanism.input.sole() else { return };
        if let InputPair::Pin(_) = driver.pair {
            let turned = if driver.link == link { turned } else { -turned };
            if driver.link == link || driver.on == link {
                self.shift_input(turned, Dimension::Angle, edits);
            }
        }
    }

    /// A stone that goes with its point; where it is driven, the coordinate follows.
    fn with_stone(&self, link: LinkId, edits: &mut Vec<(Key, String)>) {
        let driver = self.sketch.mechanism.input.sole().filter(|driver| driver.link == link);
        let Some(InputPair::Slide(slide)) = driver.map(|driver| driver.pair) else { return };
        if let (Some(line), Some(before)) = (self.sketch.guide_of(slide), self.place())
            && self.sketch.mechanism.slides[slide].link == link
        {
            self.shift_input(way(line, self.to) - way(line, before), Dimension::Length, edits);
        }
    }

    fn place(&self) -> Option<[f64; 2]> {
        self.sketch.place(&self.sketch.mechanism.points[self.point].name)
    }

    /// The first coordinate changed by so much.
    fn shift_input(&self, by: f64, dimension: Dimension, edits: &mut Vec<(Key, String)>) {
        let key = Key::of("input").at("from");
        let from = self.sketch.mechanism.input.from + by;
        let from = if dimension == Dimension::Angle { reduced(from) } else { from };
        edits.push((key.clone(), like(&written(self.text, &key), from, dimension)));
    }

    /// Writes where the guides of a link are that are given by the point.
    fn keep_guides(&self, link: LinkId, edits: &mut Vec<(Key, String)>) {
        let mechanism = &self.sketch.mechanism;
        let name = &mechanism.points[self.point].name;
        let parsed = ParsedText::of(self.text);
        for (id, slide) in self.slides(link) {
            let (key, own) =
                if slide.link == link { ("point", slide.point) } else { ("through", slide.through) };
            let key = key_of(slide).at(key);
            let is_name = parsed
                .find(&key)
                .is_ok_and(|found| found.iter().any(|place| place.text.as_deref() == Some(name.as_str())));
            // Without a key the first point of the link is on the line.
            let is_first = slide.link == link && mechanism.place_in(self.point, link) == Some(own);
            let is_default = is_first && written(self.text, &key).is_empty();
            let leaves = self.sketch.guide_of(id).is_none_or(|line| off(line, self.to).abs() > THERE / 10.0);
            if leaves && (is_name || is_default) {
                edits.push((key, place_like(&[], own, false)));
            }
        }
    }
}
