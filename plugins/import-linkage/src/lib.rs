//! Files `.linkage2` of the program Linkage by David Rector: XML with connectors, links of connectors, and ratios of gears.
//!
//! A unit of its coordinates is 1/96 in, whichever units the program shows; y points up, positive rpm turn clockwise (manual of
//! the program, Rotating anchors). An anchor is a point of the ground, a slider travels between two connectors that share a link.

mod file;
#[cfg(test)]
mod tests;

use std::f64::consts::TAU;

use assur_import::{Drawing, Driven, ImporterPlugin, Input, Joint, Link, Sign, Slide, Source, are_apart};
use assur_words::{Text, list, name, number, quantity, text};

use file::{Connector, Element, File};

assur_words::resources!();

/// A unit of the coordinates, m.
const UNIT: f64 = 0.0254 / 96.0;
/// Least excess of the radius of a curved slot over half the distance of its ends, in units of the file, as the program keeps it.
const LEAST_EXCESS: f64 = 0.0009;

inventory::submit! {
    ImporterPlugin {
        name: "linkage",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("import-linkage"),
        source: text!("import-linkage.source"),
        signs: &[Sign::Ending(".linkage2"), Sign::Prefix("<linkage2")],
        read,
    }
}

fn read(source: &Source<'_>) -> Result<Drawing, Text> {
    let (letters, is_latin) = file::letters(source.bytes);
    let file = File::parse(&letters)?;
    let unit = source.unit.unwrap_or(UNIT);
    let mut reading = Reading { file: &file, unit, drawing: Drawing::default() };
    let told = quantity(format!("{:.6}", 1e3 * unit), "mm");
    reading.drawing.tell(text!("import-linkage-unit", unit = told, shown = name(file.units.clone())));
    if is_latin {
        reading.drawing.tell(text!("import-linkage-latin"));
    }
    reading.joints();
    reading.links();
    reading.fasten();
    reading.cranks();
    reading.cylinders();
    reading.sliders();
    reading.left_out();
    Ok(reading.drawing)
}

struct Reading<'a> {
    file: &'a File,
    unit: f64,
    drawing: Drawing,
}

impl Reading<'_> {
    fn joints(&mut self) {
        let joint = |connector: &Connector| Joint {
            name: connector.name(),
            at: connector.at.map(|x| x * self.unit),
            is_grounded: connector.is_anchor,
        };
        self.drawing.joints = self.file.connectors.iter().map(joint).collect();
    }

    /// A link for each element, in its order; of what only measures or decorates without a joint.
    fn links(&mut self) {
        let link = |element: &Element| {
            let mut joints: Vec<usize> = Vec::new();
            for joint in element.connectors.iter().filter_map(|id| self.file.connector(id)) {
                if !element.is_decoration() && !joints.contains(&joint) {
                    joints.push(joint);
                }
            }
            Link { name: element.name(), joints, ..Link::default() }
        };
        self.drawing.links = self.file.elements.iter().map(link).collect();
    }

    fn named(&self, link: usize) -> Text {
        name(self.drawing.links[link].name.clone())
    }

    fn joint(&self, joint: usize) -> Text {
        name(self.drawing.joints[joint].name.clone())
    }

    /// Links that a joint belongs to.
    fn links_of(&self, joint: usize) -> Vec<usize> {
        (0..self.drawing.links.len())
            .filter(|link| self.drawing.links[*link].joints.contains(&joint))
            .collect()
    }

    /// What is fastened to a link is a part of it.
    fn fasten(&mut self) {
        for (joint, connector) in self.file.connectors.iter().enumerate() {
            let held = connector
                .fastened
                .iter()
                .chain(self.file.fastened.iter().filter(|one| one.0 == connector.id).map(|one| &one.1));
            for link in held.filter_map(|id| self.file.element(id)) {
                if !connector.is_decoration && !self.drawing.links[link].joints.contains(&joint) {
                    self.drawing.links[link].joints.push(joint);
                }
            }
        }
        for (link, element) in self.file.elements.iter().enumerate() {
            let to = element.fastened.as_ref().and_then(|id| self.file.element(id));
            if let Some(to) = to.filter(|to| *to != link && !element.is_decoration()) {
                let (kept, other) = (self.named(to), self.named(link));
                self.drawing.weld([to, link]);
                self.drawing.tell(text!("import-linkage-fastened", link = other, to = kept));
            }
        }
    }

    /// Links that an input can turn: those that no other anchor holds.
    fn turned_by(&self, joint: usize) -> Vec<usize> {
        let at = self.drawing.joints[joint].at;
        let is_held = |other: &usize| {
            self.drawing.joints[*other].is_grounded && are_apart(self.drawing.joints[*other].at, at)
        };
        let is_free = |link: &usize| !self.drawing.links[*link].joints.iter().any(is_held);
        self.links_of(joint).into_iter().filter(is_free).collect()
    }

    /// A rotating anchor turns all links at it as one; a pin that is no anchor turns the second of its links on the first.
    fn cranks(&mut self) {
        for (joint, connector) in self.file.connectors.iter().enumerate().filter(|(_, one)| one.is_input) {
            let links = self.turned_by(joint);
            let (of, on) = match (connector.is_anchor, &links[..]) {
                (true, [first, others @ ..]) => {
                    for other in others {
                        let (kept, other_name) = (self.named(*first), self.named(*other));
                        self.drawing.weld([*first, *other]);
                        self.drawing.tell(text!("import-linkage-fastened", link = other_name, to = kept));
                    }
                    (*first, None)
                }
                (false, [on, of, ..]) => (*of, Some(*on)),
                _ => {
                    self.drawing.lose(text!("import-linkage-input-of-nothing", joint = self.joint(joint)));
                    continue;
                }
            };
            let rate = -connector.rpm * TAU / 60.0;
            let sense = if rate < 0.0 { -1.0 } else { 1.0 };
            let ends = [-connector.offset, connector.limit - connector.offset];
            let [one, other] = ends.map(|end| sense * end.to_radians());
            let travel = (connector.limit > 0.0).then_some([one.min(other), one.max(other)]);
            self.drawing.inputs.push(Input { pair: Driven::Pin { joint, of, on }, rate, travel });
            let rpm = number(connector.rpm);
            self.drawing.tell(text!("import-linkage-rpm", joint = self.joint(joint), rpm));
            self.by_hand(connector.is_manual, self.joint(joint));
        }
    }

    fn by_hand(&mut self, is_manual: bool, of: Text) {
        if is_manual {
            self.drawing.tell(text!("import-linkage-by-hand", of));
        }
    }

    /// An actuator is a barrel and a rod without mass.
    fn cylinders(&mut self) {
        for (link, element) in self.file.elements.iter().enumerate().filter(|(_, one)| one.is_actuator) {
            let joints = self.drawing.links[link].joints.clone();
            let places: Vec<[f64; 2]> = joints.iter().map(|joint| self.drawing.joints[*joint].at).collect();
            let ([barrel, rod], [from, to]) = match (&joints[..], &places[..]) {
                (&[barrel, rod], &[from, to]) if are_apart(from, to) => ([barrel, rod], [from, to]),
                _ => {
                    self.drawing.lose(text!(
                        "import-linkage-cylinder",
                        link = self.named(link),
                        count = joints.len()
                    ));
                    continue;
                }
            };
            let own = self.drawing.links[link].name.clone();
            self.drawing.tell(text!("import-linkage-replaced-cylinder", link = name(own.clone())));
            let other = self.drawing.links.len();
            self.drawing.links[link] =
                Link { name: format!("{own}-barrel"), joints: vec![barrel], ..Link::default() };
            self.drawing.links.push(Link {
                name: format!("{own}-rod"),
                joints: vec![rod],
                ..Link::default()
            });
            let (through, angle) = (from, (to[1] - from[1]).atan2(to[0] - from[0]));
            let slide = Slide {
                name: format!("{own}-stroke"),
                link: other,
                on: Some(link),
                joint: rod,
                through,
                angle,
            };
            self.drawing.slides.push(slide);
            let (stroke, offset) = (element.throw * self.unit, element.offset * self.unit);
            // A cycle is a stroke there and a stroke back.
            let rate = 2.0 * stroke * element.cpm / 60.0;
            let travel = if rate < 0.0 { [offset - stroke, offset] } else { [-offset, stroke - offset] };
            let pair = Driven::Slide(self.drawing.slides.len() - 1);
            self.drawing.inputs.push(Input { pair, rate, travel: Some(travel) });
            self.by_hand(element.is_manual, name(own));
        }
    }

    /// A slider is a block without mass on the link that has its slot; in a curved slot, a rod to the center of the curve.
    fn sliders(&mut self) {
        for (joint, connector) in self.file.connectors.iter().enumerate() {
            let Some(ends) = &connector.slot else { continue };
            let ends = ends.each_ref().map(|id| self.file.connector(id));
            let (true, [Some(from), Some(to)]) = (!connector.is_decoration, ends) else { continue };
            let shared =
                self.links_of(from).into_iter().find(|link| self.drawing.links[*link].joints.contains(&to));
            let is_grounded = [from, to].iter().all(|end| self.drawing.joints[*end].is_grounded);
            let [a, b] = [from, to].map(|end| self.drawing.joints[end].at);
            let held = connector.is_anchor || self.links_of(joint).iter().any(|link| Some(*link) != shared);
            if !held || !are_apart(a, b) || shared.is_none() && !is_grounded {
                self.drawing.lose(text!("import-linkage-slot", joint = self.joint(joint)));
            } else if connector.radius == 0.0 {
                self.block(joint, shared, [a, b]);
            } else {
                self.arm(joint, shared, [a, b], connector.radius * self.unit);
            }
        }
    }

    fn block(&mut self, joint: usize, on: Option<usize>, [from, to]: [[f64; 2]; 2]) {
        let own = self.drawing.joints[joint].name.clone();
        self.drawing.tell(text!("import-linkage-replaced-pin", joint = name(own.clone())));
        let link = self.drawing.links.len();
        self.drawing.links.push(Link {
            name: format!("{own}-block"),
            joints: vec![joint],
            ..Link::default()
        });
        let angle = (to[1] - from[1]).atan2(to[0] - from[0]);
        self.drawing.slides.push(Slide {
            name: format!("{own}-slot"),
            link,
            on,
            joint,
            through: from,
            angle,
        });
    }

    /// The center of the curve lies to the left of the line between its ends, where the radius is positive.
    fn arm(&mut self, joint: usize, on: Option<usize>, [from, to]: [[f64; 2]; 2], radius: f64) {
        let own = self.drawing.joints[joint].name.clone();
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let half = 0.5 * dx.hypot(dy);
        let size = radius.abs().max(half + LEAST_EXCESS * self.unit);
        let away = (size * size - half * half).sqrt().copysign(radius) / (2.0 * half);
        let at = [0.5 * (from[0] + to[0]) - away * dy, 0.5 * (from[1] + to[1]) + away * dx];
        let center = self.drawing.joints.len();
        self.drawing.joints.push(Joint { name: format!("{own}-center"), at, is_grounded: on.is_none() });
        if let Some(on) = on {
            self.drawing.links[on].joints.push(center);
        }
        let joints = vec![center, joint];
        self.drawing.links.push(Link { name: format!("{own}-arm"), joints, ..Link::default() });
        let radius = quantity(format!("{:.4}", 1e3 * size), "mm");
        self.drawing.tell(text!("import-linkage-replaced-curve", joint = name(own), radius));
    }

    /// What the file has beside a mechanism of pins and slides.
    fn left_out(&mut self) {
        for ratio in &self.file.ratios {
            let named = |id: &String| self.file.element(id).map(|link| self.named(link));
            let links = list(ratio.links.iter().filter_map(named));
            let sizes = name(ratio.sizes.clone());
            self.drawing.lose(if ratio.is_chain {
                text!("import-linkage-chain", links, sizes)
            } else {
                text!("import-linkage-gears", links, sizes)
            });
        }
        let fastened = self.file.connectors.iter().enumerate().filter(|(_, one)| one.is_turned_by_another);
        for joint in fastened.map(|(joint, _)| joint).collect::<Vec<_>>() {
            self.drawing.lose(text!("import-linkage-turned", of = self.joint(joint)));
        }
        for link in 0..self.file.elements.len() {
            if self.file.elements[link].is_turned_by_another {
                self.drawing.lose(text!("import-linkage-turned", of = name(self.file.elements[link].name())));
            }
        }
        let drawn = self.file.connectors.iter().filter(|one| one.is_decoration).count()
            + self.file.elements.iter().filter(|one| one.is_decoration()).count();
        if drawn > 0 {
            self.drawing.tell(text!("import-linkage-decoration", count = drawn));
        }
        self.drawing.tell(text!("import-linkage-looks"));
    }
}
