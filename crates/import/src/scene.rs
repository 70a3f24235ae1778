//! The text of a scene: the one writer for all formats.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use assur_words::{Language, name, text};

use crate::{Drawing, Driven, Input, are_apart};

/// Gravity of a drawing with weights, m/s^2.
const GRAVITY: f64 = 9.81;
/// Positions over a turn, and between two ends.
const TURN: usize = 36;
const TRAVEL: usize = 21;
/// Instants of a motion of several inputs after the first.
const SAMPLES: usize = 40;

/// The frame of a link: where its origin is drawn, and the direction of its x axis.
#[derive(Clone, Copy)]
struct Frame {
    at: [f64; 2],
    angle: f64,
}

impl Frame {
    /// The ground.
    const GROUND: Self = Self { at: [0.0; 2], angle: 0.0 };

    fn of(drawing: &Drawing, link: usize) -> Self {
        let places: Vec<[f64; 2]> =
            drawing.links[link].joints.iter().map(|joint| drawing.joints[*joint].at).collect();
        let at = places.first().copied().unwrap_or_default();
        let slide = drawing.slides.iter().find(|slide| slide.link == link || slide.on == Some(link));
        let along = places.iter().find(|other| are_apart(**other, at));
        let angle = along.map(|[x, y]| (y - at[1]).atan2(x - at[0])).or(slide.map(|slide| slide.angle));
        Self { at, angle: angle.unwrap_or_default() }
    }

    /// A place of the drawing in this frame.
    fn place(&self, [x, y]: [f64; 2]) -> String {
        let (dx, dy) = (x - self.at[0], y - self.at[1]);
        if self.angle == 0.0 {
            return format!("[{}, {}]", digits(dx), digits(dy));
        }
        let (s, c) = self.angle.sin_cos();
        format!("[{}, {}]", digits(c * dx + s * dy), digits(c * dy - s * dx))
    }
}

/// A number with the digits that hold through a turn of its frame, and without what rounding left of a zero.
fn digits(value: f64) -> String {
    const DIGITS: usize = 14;
    const NOTHING: f64 = 1e-15;
    let rounded = format!("{value:.DIGITS$e}").parse().unwrap_or(value);
    // Without the sign of a negative zero.
    format!("{}", if rounded.abs() < NOTHING { 0.0 } else { rounded })
}

/// An angle from -pi to pi.
fn turned(angle: f64) -> f64 {
    angle - TAU * ((angle - PI) / TAU).ceil()
}

/// A name as a key, or as a value.
fn key(name: &str) -> String {
    let is_bare = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    if is_bare { name.to_owned() } else { quoted(name) }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// The scene of a drawing that is one mechanism, with its remarks in a language.
pub(crate) fn write(drawing: &Drawing, format: &'static str, language: &Language) -> String {
    let mut scene = Scene { drawing, text: String::new(), frames: Vec::new() };
    scene.frames = (0..drawing.links.len()).map(|link| Frame::of(drawing, link)).collect();
    scene.remarks(format, language);
    scene.links();
    scene.slides();
    scene.inputs();
    scene.assembly();
    scene.forces();
    scene.text
}

struct Scene<'a> {
    drawing: &'a Drawing,
    text: String,
    frames: Vec<Frame>,
}

impl Scene<'_> {
    fn line(&mut self, line: &str) {
        let _ = writeln!(self.text, "{line}");
    }

    fn frame(&self, link: Option<usize>) -> Frame {
        link.map_or(Frame::GROUND, |link| self.frames[link])
    }

    fn link(&self, link: Option<usize>) -> String {
        quoted(link.map_or("ground", |link| &self.drawing.links[link].name))
    }

    fn joint(&self, joint: usize) -> &str {
        &self.drawing.joints[joint].name
    }

    fn remarks(&mut self, format: &'static str, language: &Language) {
        let drawing = self.drawing;
        let head = text!("import-head", format = name(format));
        let remarks = drawing.remarks.iter().map(|remark| {
            let told = remark.text.clone();
            if remark.is_lost { text!("import-lost", what = told) } else { told }
        });
        for told in std::iter::once(head).chain(remarks) {
            let words = told.render(language);
            let plain = |letter: char| if letter.is_control() { ' ' } else { letter };
            self.line(&format!("# {}", words.chars().map(plain).collect::<String>()));
        }
        let title: String = drawing.title.chars().filter(|letter| !letter.is_control()).collect();
        if !title.trim().is_empty() {
            self.line(&format!("\ntitle = {}", quoted(title.trim())));
        }
        if drawing.has_gravity {
            self.line(&format!("gravity = {}", digits(GRAVITY)));
        }
    }

    /// Points of a link in its frame.
    fn points(&self, joints: &[usize], frame: Frame) -> String {
        let place = |joint: &usize| {
            format!("{} = {}", key(self.joint(*joint)), frame.place(self.drawing.joints[*joint].at))
        };
        format!("points = {{ {} }}", joints.iter().map(place).collect::<Vec<_>>().join(", "))
    }

    fn links(&mut self) {
        let drawing = self.drawing;
        let used = |joint: &usize| drawing.links.iter().any(|link| link.joints.contains(joint));
        let grounded = (0..drawing.joints.len()).filter(|joint| drawing.joints[*joint].is_grounded);
        let fixed: Vec<usize> = grounded.filter(used).collect();
        if !fixed.is_empty() {
            let points = self.points(&fixed, Frame::GROUND);
            self.line(&format!("\n[ground]\n{points}"));
        }
        for (index, link) in drawing.links.iter().enumerate() {
            let points = self.points(&link.joints, self.frames[index]);
            self.line(&format!("\n[link.{}]\n{points}", key(&link.name)));
            if link.mass > 0.0 {
                let center = link.center.map_or("[0, 0]".to_owned(), |at| self.frames[index].place(at));
                self.line(&format!("mass = {}\ncenter = {center}", digits(link.mass)));
            }
            if link.inertia > 0.0 {
                self.line(&format!("inertia = {}", digits(link.inertia)));
            }
        }
    }

    fn slides(&mut self) {
        let drawing = self.drawing;
        for slide in &drawing.slides {
            let (on, own) = (self.frame(slide.on), self.frames[slide.link]);
            let lines = [
                format!("\n[[slide]]\nname = {}", quoted(&slide.name)),
                format!("link = {}\non = {}", self.link(Some(slide.link)), self.link(slide.on)),
                format!("through = {}", on.place(slide.through)),
                format!("angle = {}", digits(turned(slide.angle - on.angle))),
                format!("point = {}", quoted(self.joint(slide.joint))),
                format!("tilt = {}", digits(turned(own.angle - slide.angle))),
            ];
            self.line(&lines.join("\n"));
        }
    }

    /// The coordinate of a driven pair as it is drawn.
    fn coordinate(&self, pair: Driven) -> f64 {
        match pair {
            Driven::Pin { of, on, .. } => turned(self.frames[of].angle - self.frame(on).angle),
            Driven::Slide(slide) => {
                let slide = &self.drawing.slides[slide];
                let ([x, y], (s, c)) = (self.drawing.joints[slide.joint].at, slide.angle.sin_cos());
                c * (x - slide.through[0]) + s * (y - slide.through[1])
            }
        }
    }

    /// The keys that name a driven pair.
    fn pair(&self, pair: Driven) -> String {
        match pair {
            Driven::Pin { of, on: None, .. } => format!("link = {}", self.link(Some(of))),
            Driven::Pin { joint, of, on } => {
                format!(
                    "pin = {}\nof = {}\non = {}",
                    quoted(self.joint(joint)),
                    self.link(Some(of)),
                    self.link(on)
                )
            }
            Driven::Slide(slide) => {
                let slide = &self.drawing.slides[slide];
                match slide.on {
                    None => format!("link = {}", self.link(Some(slide.link))),
                    Some(_) => format!("slide = {}", quoted(&slide.name)),
                }
            }
        }
    }

    fn inputs(&mut self) {
        match &self.drawing.inputs[..] {
            [] => {}
            [input] => self.input(input),
            several => self.several(several),
        }
    }

    fn input(&mut self, input: &Input) {
        let at = self.coordinate(input.pair);
        self.line(&format!("\n[input]\n{}", self.pair(input.pair)));
        let backward = input.rate < 0.0;
        match input.travel {
            None => self.line(&format!("from = {}\npositions = {TURN}", digits(at))),
            Some([low, high]) => {
                let [from, to] = if backward { [high, low] } else { [low, high] };
                self.line(&format!(
                    "from = {}\nto = {}\npositions = {TRAVEL}",
                    digits(at + from),
                    digits(at + to)
                ));
            }
        }
        if backward {
            self.line("direction = \"cw\"");
        }
        if input.rate != 0.0 {
            self.line(&format!("\n[motion]\nspeed = {}", digits(input.rate.abs())));
        }
    }

    fn several(&mut self, inputs: &[Input]) {
        let mut until = 0.0_f64;
        for input in inputs {
            let at = self.coordinate(input.pair);
            self.line(&format!("\n[[input]]\n{}", self.pair(input.pair)));
            let rows = course(input);
            if let [_, .., [end, _]] = rows[..] {
                until = until.max(end);
                let rows = rows.iter().map(|[t, by]| format!("[{}, {}]", digits(*t), digits(at + by)));
                let table = rows.collect::<Vec<_>>().join(", ");
                self.line(&format!("over_time = {{ table = [{table}] }}"));
            } else {
                until = until.max(if input.rate == 0.0 { 0.0 } else { TAU / input.rate.abs() });
                self.line(&format!("from = {}\nrate = {}", digits(at), digits(input.rate)));
            }
        }
        if until > 0.0 {
            self.line(&format!("\n[motion]\nuntil = {}\nsamples = {SAMPLES}", digits(until)));
        }
    }

    fn assembly(&mut self) {
        let drawing = self.drawing;
        let moving = |joint: &usize| {
            !drawing.joints[*joint].is_grounded
                && drawing.links.iter().any(|link| link.joints.contains(joint))
        };
        self.line("\n[assembly]");
        for joint in (0..drawing.joints.len()).filter(moving) {
            let place = Frame::GROUND.place(drawing.joints[joint].at);
            self.line(&format!("{} = {place}", key(self.joint(joint))));
        }
    }

    fn forces(&mut self) {
        let drawing = self.drawing;
        for force in &drawing.forces {
            let frame = self.frames[force.link];
            self.line(&format!(
                "\n[[force]]\nname = {}\nlink = {}",
                quoted(&force.name),
                self.link(Some(force.link))
            ));
            let angle = if force.is_local { force.angle - frame.angle } else { force.angle };
            self.line(&format!("at = {}\nangle = {}", frame.place(force.at), digits(turned(angle))));
            if force.is_local {
                self.line("frame = \"link\"");
            }
            self.line(&format!("value = {}", digits(force.value)));
        }
    }
}

/// Times and coordinates of an input that goes there and back, from where it is drawn on; empty of one that turns or stands.
fn course(input: &Input) -> Vec<[f64; 2]> {
    let Some([low, high]) = input.travel.filter(|_| input.rate != 0.0) else { return Vec::new() };
    let [there, back] = if input.rate < 0.0 { [low, high] } else { [high, low] };
    let mut rows = vec![[0.0, 0.0]];
    for to in [there, back, 0.0] {
        let [time, from] = rows[rows.len() - 1];
        let way = (to - from).abs();
        if way > 0.0 {
            rows.push([time + way / input.rate.abs(), to]);
        }
    }
    rows
}
