//! The tables of what is added.

use std::fmt::Write as _;

use assur_mechanism::{GROUND, Key};
use assur_scene::edit::quoted;

use crate::frame::{Frame, line};
use crate::group::Plan;
use crate::number::{degrees, key_of, millimeters, point_key, rounded, stands};
use crate::pose::{Line, Pose, foot, is_origin, off, reduced};
use crate::shape::{Bond, Joint};

/// Tables as TOML, and what they have.
#[derive(Default)]
pub(crate) struct Tables {
    pub(crate) toml: String,
    pub(crate) slides: Vec<String>,
    pub(crate) fields: Vec<Key>,
}

/// The tables of all that is added.
pub(crate) fn tables(plan: &Plan<'_>, joints: &[Joint], frames: &[Frame]) -> Tables {
    let mut tables = Tables::default();
    let (mut lengths, mut others) = (Vec::new(), Vec::new());
    let pivots = outer_points(plan, &mut tables.toml);
    for (name, frame) in plan.links.iter().zip(frames) {
        let key = Key::of("link").at(name.as_str()).at("points");
        let mut points = Vec::new();
        for (index, (point, at)) in frame.points.iter().enumerate() {
            let key = key.clone().at(point.as_str());
            let value = if index == 0 {
                "0".to_owned()
            } else if at[1] == 0.0 {
                lengths.push(key);
                millimeters(at[0])
            } else {
                others.extend([0, 1].map(|axis| key.clone().at(axis)));
                both(*at)
            };
            points.push(format!("{} = {value}", key_of(point)));
        }
        let _ = write!(tables.toml, "[link.{}]\npoints = {{ {} }}\n\n", key_of(name), points.join(", "));
    }
    tables.fields = [lengths, others, pivots].concat();
    for (index, bond) in plan.shape.bonds.iter().enumerate() {
        if let Some(line) = line(joints[index]) {
            slide(plan, (index, bond, line), frames, &mut tables);
        }
    }
    assembly(plan, joints, frames, &mut tables.toml);
    tables
}

/// Two coordinates, m.
fn both([x, y]: [f64; 2]) -> String {
    format!("[{}, {}]", millimeters(x), millimeters(y))
}

/// The new points of links that stand; the keys of their coordinates.
fn outer_points(plan: &Plan<'_>, toml: &mut String) -> Vec<Key> {
    let mechanism = &plan.sketch.mechanism;
    let (mut keys, mut links) = (Vec::new(), Vec::<(usize, Vec<String>)>::new());
    for (outer, name) in plan.outer.iter().zip(&plan.pins[plan.shape.inner..]) {
        let (Joint::Pin(place), None) = (outer.joint, &outer.point) else { continue };
        let at = outer.pose.local(place).map(|part| rounded(part, plan.step));
        let point = format!("{} = {}", key_of(name), both(at));
        match links.iter_mut().find(|(link, _)| *link == outer.link) {
            Some((_, points)) => points.push(point),
            None => links.push((outer.link, vec![point])),
        }
        let key = point_key(mechanism, outer.link, name);
        keys.extend([0, 1].map(|axis| key.clone().at(axis)));
    }
    for (link, points) in links {
        let name = key_of(&mechanism.links[link].name);
        let table = if link == GROUND { name } else { format!("link.{name}") };
        let _ = write!(toml, "[{table}]\npoints = {{ {} }}\n", points.join(", "));
        if let Some(point) = center(plan, link) {
            let _ = writeln!(toml, "center = {}", quoted(&point));
        }
        toml.push('\n');
    }
    keys
}

/// The point in which the center of mass of a link is because it has no other one, if the scene does not say so.
fn center(plan: &Plan<'_>, link: usize) -> Option<String> {
    let mechanism = &plan.sketch.mechanism;
    let mut points = mechanism.points.iter().filter(|point| point.on(link).is_some());
    let only = points.next().filter(|_| points.next().is_none())?;
    let is_left_out = !stands(plan.text, &Key::of("link").at(&mechanism.links[link].name).at("center"));
    (link != GROUND && mechanism.links[link].is_heavy() && is_left_out).then(|| only.name.to_string())
}

/// The table of a slide.
fn slide(plan: &Plan<'_>, (index, bond, line): (usize, &Bond, Line), frames: &[Frame], tables: &mut Tables) {
    let (own, name) = (&frames[bond.link], &plan.links[bond.link]);
    let outer = index.checked_sub(plan.shape.inner).map(|index| &plan.outer[index]);
    let (on, pose) = match (bond.on, outer) {
        (Some(on), _) => (plan.links[on].as_str(), frames[on].pose),
        (None, Some(outer)) => (plan.sketch.mechanism.links[outer.link].name.as_str(), outer.pose),
        (None, None) => return,
    };
    let slide = format!("{name}/{on}");
    let mut table = Table::new(&slide);
    table.put("link", &quoted(name));
    table.put("on", &quoted(on));
    let near = 1e-9 * plan.size;
    let inner_point = || {
        let carried = frames.get(bond.on?)?;
        let on_line = |(_, at): &&(String, [f64; 2])| off(line, carried.pose.point(*at)).abs() < plan.step;
        carried.points.iter().find(on_line).map(|(point, _)| point.clone())
    };
    if let Some(point) = outer.map_or_else(inner_point, |outer| outer.point.clone()) {
        table.put("through", &quoted(&point));
    } else {
        // The point that the caller gave, or the one next to the origin.
        let through = if outer.is_some() { line.0 } else { foot(line, pose.at) };
        table.place("through", &pose, through, plan.step);
    }
    let finest = if outer.is_some() { 0.01 } else { 1.0 };
    let turn = rounded(reduced(line.1 - pose.angle).to_degrees(), finest).to_radians();
    table.angle("angle", turn);
    if off(line, own.pose.at).abs() > near {
        table.place("point", &own.pose, foot(line, own.pose.at), plan.step);
    }
    table.angle("tilt", rounded(reduced(own.pose.angle - line.1).to_degrees(), 1.0).to_radians());
    tables.toml += &table.toml;
    tables.toml.push('\n');
    tables.fields.extend(table.fields);
    tables.slides.push(slide);
}

/// A table of a slide while it is written.
struct Table {
    toml: String,
    key: Key,
    fields: Vec<Key>,
}

impl Table {
    fn new(slide: &str) -> Self {
        Self { toml: "[[slide]]\n".to_owned(), key: Key::of("slide").at(slide), fields: Vec::new() }
    }

    fn put(&mut self, key: &str, value: &str) {
        let _ = writeln!(self.toml, "{key} = {value}");
    }

    /// An angle, rad; left out where it is 0.
    fn angle(&mut self, key: &str, angle: f64) {
        if angle.abs() > 1e-9 {
            self.put(key, &degrees(angle));
            self.fields.push(self.key.clone().at(key));
        }
    }

    /// A place in the plane in the frame of a link; left out where it is the origin.
    fn place(&mut self, key: &str, pose: &Pose, place: [f64; 2], step: f64) {
        let at = pose.local(place).map(|part| rounded(part, step));
        if key != "through" || !is_origin(at) {
            self.put(key, &both(at));
            self.fields.extend([0, 1].map(|axis| self.key.clone().at(key).at(axis)));
        }
    }
}

/// The places of the points that tell the mode: the inner pins; where there are none, or the kind iterates, all new points of the links.
fn assembly(plan: &Plan<'_>, joints: &[Joint], frames: &[Frame], toml: &mut String) {
    let inner = plan.pins[..plan.shape.inner].iter().zip(joints);
    let pins = inner.filter_map(|(name, joint)| match joint {
        Joint::Pin(place) => Some((name.clone(), *place)),
        Joint::Guide(_) => None,
    });
    let mut places: Vec<(String, [f64; 2])> = pins.collect();
    let is_group = plan.addition.plugin.is_none_or(|plugin| plugin.iterates || plugin.ways.most > 1);
    if is_group && (places.is_empty() || plan.addition.plugin.is_some_and(|plugin| plugin.iterates)) {
        places.extend(plan.own.iter().filter_map(|(link, name)| {
            let frame = &frames[*link];
            let (_, at) = frame.points.iter().find(|(point, _)| point == name)?;
            Some((name.clone(), frame.pose.point(*at)))
        }));
    }
    if !places.is_empty() {
        *toml += "[assembly]\n";
    }
    for (name, place) in places {
        let _ = writeln!(toml, "{} = {}", key_of(&name), both(place.map(|part| rounded(part, plan.step))));
    }
}
