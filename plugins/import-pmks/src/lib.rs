//! Links of PMKS+, the Planar Mechanism Kinematic Simulator: the whole mechanism is the payload behind the question mark.
//!
//! Lengths are in the unit that the drawing has chosen, masses in kg, moments of inertia in kg times that unit squared, angles in
//! radians; the input turns with so many rpm. A piston is a block on a guide, a part of a welded link is no link of its own.

mod payload;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use assur_import::{
    Drawing, Driven, Force, ImporterPlugin, Input, Joint, Link, Sign, Slide, Source, are_apart,
};
use assur_words::{Text, name, text};

use payload::Payload;

assur_words::resources!();

/// Units of length, m, and of force, N, by their numbers; what stands behind them means the second one.
const LENGTHS: [(&str, f64); 3] = [("in", 0.0254), ("cm", 0.01), ("m", 1.0)];
const FORCES: [(&str, f64); 2] = [("lbf", 4.448_221_615_260_5), ("N", 1.0)];
/// The range of an input that slides, which a link does not tell, as part of the drawing's size.
const RANGE: f64 = 0.1;

inventory::submit! {
    ImporterPlugin {
        name: "pmks",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("import-pmks"),
        source: text!("import-pmks.source"),
        signs: &[
            Sign::Prefix("https://app.pmksplus.com"),
            Sign::Prefix("http://app.pmksplus.com"),
            Sign::Prefix("app.pmksplus.com"),
        ],
        read,
    }
}

fn read(source: &Source<'_>) -> Result<Drawing, Text> {
    let letters = String::from_utf8_lossy(source.bytes);
    let letters = letters.trim().trim_start_matches('\u{feff}');
    // Of an address only what stands behind the question mark; a payload alone is taken as it is.
    let behind = match letters.split_once('?') {
        Some((_, payload)) => payload,
        None if letters.contains("://") => "",
        None => letters,
    };
    let payload = behind.split('#').next().unwrap_or_default();
    let payload = decoded(payload.strip_prefix("mech=").unwrap_or(payload));
    let payload = Payload::parse(&payload)?;
    let unit = LENGTHS.get(payload.settings.length).unwrap_or(&LENGTHS[1]);
    let mut reading = Reading {
        payload: &payload,
        unit: source.unit.unwrap_or(unit.1),
        drawing: Drawing::default(),
        numbers: payload.links.iter().filter(|link| link.is_root).map(|link| link.id.clone()).collect(),
        guides: BTreeMap::new(),
    };
    let force = FORCES.get(payload.settings.force).unwrap_or(&FORCES[1]);
    let shown = name(source.unit.map_or(unit.0.to_owned(), |unit| format!("{unit} m")));
    reading.drawing.tell(text!("import-pmks-units", length = shown, force = name(force.0)));
    reading.joints();
    reading.links()?;
    reading.guides();
    reading.inputs();
    reading.forces(force.1);
    reading.left_out();
    Ok(reading.drawing)
}

/// A part of an address with its escaped bytes as letters.
fn decoded(part: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = part.as_bytes();
    while let Some((first, behind)) = rest.split_first() {
        let escaped =
            behind.get(..2).filter(|_| *first == b'%').and_then(|two| std::str::from_utf8(two).ok());
        let byte = escaped.and_then(|two| u8::from_str_radix(two, 16).ok());
        bytes.push(byte.unwrap_or(*first));
        rest = if byte.is_some() { &behind[2..] } else { behind };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

struct Reading<'a> {
    payload: &'a Payload,
    unit: f64,
    drawing: Drawing,
    /// Identities of the links.
    numbers: Vec<String>,
    /// The slides of prismatic joints.
    guides: BTreeMap<usize, usize>,
}

impl Reading<'_> {
    fn place(&self, at: [f64; 2]) -> [f64; 2] {
        at.map(|x| x * self.unit)
    }

    fn joints(&mut self) {
        let joint = |joint: &payload::Joint| Joint {
            name: if joint.name.is_empty() { joint.id.clone() } else { joint.name.clone() },
            at: self.place(joint.at),
            is_grounded: joint.is_grounded && !joint.is_slide,
        };
        self.drawing.joints = self.payload.joints.iter().map(joint).collect();
    }

    fn roots(&self) -> impl Iterator<Item = &payload::Link> {
        self.payload.links.iter().filter(|link| link.is_root)
    }

    fn links(&mut self) -> Result<(), Text> {
        let mut links = Vec::new();
        for link in self.roots() {
            let mut joints = Vec::new();
            for id in &link.joints {
                let found = self.payload.joints.iter().position(|joint| joint.id == *id);
                let missing =
                    || text!("import-pmks-no-joint", link = name(link.id.clone()), joint = name(id.clone()));
                let joint = found.ok_or_else(missing)?;
                if !joints.contains(&joint) {
                    joints.push(joint);
                }
            }
            // A piston has no center and no inertia: it is a block that does not turn.
            let first = joints.iter().find(|joint| !self.payload.joints[**joint].is_slide);
            let center = if link.is_piston {
                first.map(|joint| self.drawing.joints[*joint].at)
            } else {
                Some(self.place(link.center))
            };
            let name = if link.name.is_empty() { link.id.clone() } else { link.name.clone() };
            links.push(Link {
                name,
                joints,
                mass: link.mass,
                center,
                inertia: link.inertia * self.unit * self.unit,
            });
        }
        self.drawing.links = links;
        Ok(())
    }

    fn links_of(&self, joint: usize) -> Vec<usize> {
        (0..self.drawing.links.len())
            .filter(|link| self.drawing.links[*link].joints.contains(&joint))
            .collect()
    }

    fn joint(&self, joint: usize) -> Text {
        name(self.drawing.joints[joint].name.clone())
    }

    /// A prismatic joint guides one link on another, or on the ground; pistons come last: they slide.
    fn guides(&mut self) {
        let pistons: Vec<bool> = self.roots().map(|link| link.is_piston).collect();
        for (joint, own) in self.payload.joints.iter().enumerate().filter(|(_, joint)| joint.is_slide) {
            let mut bodies: Vec<Option<usize>> = self.links_of(joint).into_iter().map(Some).collect();
            bodies.sort_by_key(|link| link.is_some_and(|link| pistons[link]));
            if own.is_grounded {
                bodies.insert(0, None);
            }
            let [on, Some(link)] = bodies[..] else {
                let count = bodies.len();
                self.drawing.lose(text!("import-pmks-guide", joint = self.joint(joint), count));
                continue;
            };
            let through = self.drawing.joints[joint].at;
            if let Some(on) = on {
                self.drawing.links[on].joints.retain(|other| *other != joint);
            }
            // Where another joint of the sliding link stands in the same place, it is the one on the line.
            let twin = self.drawing.links[link].joints.iter().copied();
            let twin = twin.filter(|other| *other != joint && !self.payload.joints[*other].is_slide);
            let twin = twin.clone().find(|other| !are_apart(self.drawing.joints[*other].at, through));
            if twin.is_some() {
                self.drawing.links[link].joints.retain(|other| *other != joint);
            }
            let slide = Slide {
                name: format!("{}-guide", self.drawing.joints[joint].name),
                link,
                on,
                joint: twin.unwrap_or(joint),
                through,
                angle: own.angle,
            };
            self.guides.insert(joint, self.drawing.slides.len());
            self.drawing.slides.push(slide);
        }
    }

    fn inputs(&mut self) {
        let settings = &self.payload.settings;
        let sense = if settings.is_clockwise { -1.0 } else { 1.0 };
        for (joint, own) in self.payload.joints.iter().enumerate().filter(|(_, joint)| joint.is_input) {
            let told = self.joint(joint);
            let input = if own.is_slide {
                let slide = self.guides.get(&joint).copied();
                let range = RANGE * self.size();
                slide.map(|slide| Input {
                    pair: Driven::Slide(slide),
                    rate: sense * settings.speed * self.unit,
                    travel: Some([0.0, range].map(|end| sense * end)).map(|[a, b]| [a.min(b), a.max(b)]),
                })
            } else {
                let rate = sense * settings.speed * TAU / 60.0;
                let pair = match (own.is_grounded, &self.links_of(joint)[..]) {
                    (true, &[of, ..]) => Some(Driven::Pin { joint, of, on: None }),
                    (false, &[on, of, ..]) => Some(Driven::Pin { joint, of, on: Some(on) }),
                    _ => None,
                };
                pair.map(|pair| Input { pair, rate, travel: None })
            };
            match input {
                Some(input) => self.drawing.inputs.push(input),
                None => self.drawing.lose(text!("import-pmks-input", joint = told.clone())),
            }
            if own.is_slide {
                self.drawing.tell(text!("import-pmks-range", joint = told));
            }
        }
    }

    /// The greater side of the drawing, m.
    fn size(&self) -> f64 {
        let side = |axis: usize| {
            let all = self.drawing.joints.iter().map(|joint| joint.at[axis]);
            all.clone().fold(f64::MIN, f64::max) - all.fold(f64::MAX, f64::min)
        };
        side(0).max(side(1))
    }

    fn forces(&mut self, unit: f64) {
        for force in &self.payload.forces {
            let [dx, dy] = [0, 1].map(|axis| force.to[axis] - force.from[axis]);
            let Some(link) = self.numbers.iter().position(|id| *id == force.link) else {
                let (own, link) = (name(force.name.clone()), name(force.link.clone()));
                self.drawing.lose(text!("import-pmks-force", force = own, link));
                continue;
            };
            self.drawing.forces.push(Force {
                name: force.name.clone(),
                link,
                at: self.place(force.from),
                angle: dy.atan2(dx),
                value: force.value * unit,
                is_local: force.is_local,
            });
        }
        let settings = &self.payload.settings;
        self.drawing.has_gravity = settings.has_gravity || settings.has_forces;
        if !self.drawing.has_gravity {
            self.drawing.tell(text!("import-pmks-no-gravity"));
        }
    }

    fn left_out(&mut self) {
        let welded = self.payload.joints.iter().enumerate().filter(|(_, joint)| joint.is_welded);
        for joint in welded.map(|(joint, _)| joint).collect::<Vec<_>>() {
            self.drawing.tell(text!("import-pmks-welded", joint = self.joint(joint)));
        }
        self.drawing.tell(text!("import-pmks-looks"));
    }
}
