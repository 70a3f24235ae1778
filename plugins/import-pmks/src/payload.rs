//! The payload of a link of PMKS+: settings, joints, links and forces, each ended by a dot, each part of them by a comma.
//!
//! Numbers are whole and written with 64 digits; a zero in front is a minus. What is no whole number is written in thousandths.
//! The last character is the number of the others, modulo 62.

use assur_words::{Text, name, text};

/// Digits of numbers and flags.
const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
/// Of them, those of the sum of control.
const CONTROL: usize = 62;
/// Part of one as which numbers with a fraction are written.
const PART: f64 = 1e-3;

/// Settings of the drawing: flags, speed and units by their numbers.
#[derive(Debug, Default)]
pub(crate) struct Settings {
    pub(crate) is_clockwise: bool,
    pub(crate) has_gravity: bool,
    pub(crate) has_forces: bool,
    pub(crate) speed: f64,
    pub(crate) length: usize,
    pub(crate) force: usize,
}

#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "they are flags of the link")]
pub(crate) struct Joint {
    pub(crate) id: String,
    pub(crate) name: String,
    pub(crate) at: [f64; 2],
    pub(crate) is_slide: bool,
    pub(crate) is_input: bool,
    pub(crate) is_grounded: bool,
    pub(crate) is_welded: bool,
    /// Of the guide, rad.
    pub(crate) angle: f64,
}

#[derive(Debug)]
pub(crate) struct Link {
    pub(crate) id: String,
    pub(crate) name: String,
    /// Whether it is a link of its own: no part of a welded one.
    pub(crate) is_root: bool,
    pub(crate) is_piston: bool,
    pub(crate) mass: f64,
    pub(crate) inertia: f64,
    pub(crate) center: [f64; 2],
    pub(crate) joints: Vec<String>,
}

#[derive(Debug)]
pub(crate) struct Force {
    pub(crate) name: String,
    pub(crate) link: String,
    pub(crate) from: [f64; 2],
    pub(crate) to: [f64; 2],
    pub(crate) value: f64,
    pub(crate) is_local: bool,
}

#[derive(Debug, Default)]
pub(crate) struct Payload {
    pub(crate) settings: Settings,
    pub(crate) joints: Vec<Joint>,
    pub(crate) links: Vec<Link>,
    pub(crate) forces: Vec<Force>,
}

impl Payload {
    pub(crate) fn parse(payload: &str) -> Result<Self, Text> {
        let content = checked(payload)?;
        let mut parts = content.split('.');
        let settings = settings(&mut parts)?;
        let mut list = || parts.by_ref().take_while(|part| !part.is_empty()).collect::<Vec<_>>();
        let [joints, links, forces] = [list(), list(), list()];
        Ok(Self {
            settings,
            joints: joints.into_iter().map(joint).collect::<Result<_, _>>()?,
            links: links.into_iter().map(link).collect::<Result<_, _>>()?,
            forces: forces.into_iter().map(force).collect::<Result<_, _>>()?,
        })
    }
}

/// The payload without its sum of control, which must be right.
fn checked(payload: &str) -> Result<&str, Text> {
    let (at, control) = payload.char_indices().next_back().ok_or_else(|| text!("import-pmks-empty"))?;
    let content = &payload[..at];
    // The program counts as its language does.
    let count = content.encode_utf16().count();
    if DIGITS.as_bytes().get(count % CONTROL).copied().map(char::from) != Some(control) {
        return Err(text!("import-pmks-not-whole", count));
    }
    Ok(content)
}

fn settings<'a>(parts: &mut impl Iterator<Item = &'a str>) -> Result<Settings, Text> {
    let mut next = || parts.next().unwrap_or_default();
    let (flags, _scale, counts, units) = (next(), next(), next(), next());
    let whole = |digits: &str| {
        digits.chars().try_fold(0_usize, |all, one| all.checked_mul(64)?.checked_add(digit(one)?))
    };
    let flags = whole(flags).ok_or_else(|| bad("settings", flags))?;
    let flag = |bit: u32| flags >> bit & 1 == 1;
    let speed = counts.split(',').next().unwrap_or_default();
    let unit = |at: usize| units.chars().nth(at).and_then(digit).unwrap_or_default();
    Ok(Settings {
        is_clockwise: flag(0),
        has_gravity: flag(1),
        has_forces: flag(7),
        speed: number("speed", speed)?,
        length: unit(0),
        force: unit(2),
    })
}

fn digit(letter: char) -> Option<usize> {
    DIGITS.find(letter)
}

fn bad(of: &str, found: &str) -> Text {
    text!("import-pmks-number", of = name(of.to_owned()), found = name(found.to_owned()))
}

/// A whole number.
fn number(of: &str, written: &str) -> Result<f64, Text> {
    let size = written.chars().try_fold(0.0, |all: f64, one| Some(64.0 * all + digit(one)? as f64));
    let size = size.ok_or_else(|| bad(of, written))?;
    Ok(if written.starts_with('0') && size != 0.0 { -size } else { size })
}

/// The parts of a joint, a link or a force, which stand behind its flags.
struct Fields<'a> {
    of: &'a str,
    rest: std::str::Split<'a, char>,
}

impl<'a> Fields<'a> {
    /// The flags, and what stands behind them.
    fn of(part: &'a str, flags: usize) -> Result<(&'a str, Self), Text> {
        let (flags, rest) = part.split_at_checked(flags).ok_or_else(|| bad(part, part))?;
        let of = rest.split(',').next().unwrap_or_default();
        Ok((flags, Self { of, rest: rest.split(',') }))
    }

    fn word(&mut self) -> &'a str {
        self.rest.next().unwrap_or_default()
    }

    fn number(&mut self) -> Result<f64, Text> {
        Ok(PART * number(self.of, self.word())?)
    }

    fn place(&mut self) -> Result<[f64; 2], Text> {
        Ok([self.number()?, self.number()?])
    }
}

/// `FLAGS id,name,x,y,angle`: slide, input, ground, welded, curve.
fn joint(part: &str) -> Result<Joint, Text> {
    let (flags, mut fields) = Fields::of(part, 1)?;
    let bits = flags.chars().next().and_then(digit).ok_or_else(|| bad(part, flags))?;
    let flag = |bit: u32| bits >> bit & 1 == 1;
    Ok(Joint {
        id: fields.word().to_owned(),
        name: fields.word().to_owned(),
        at: fields.place()?,
        angle: fields.number()?,
        is_slide: flag(0),
        is_input: flag(1),
        is_grounded: flag(2),
        is_welded: flag(3),
    })
}

/// `Y|N R|P id,name,mass,inertia,x,y,color,joint,joint,...,,part,part,...`: root or part, link or piston.
fn link(part: &str) -> Result<Link, Text> {
    let (kind, mut fields) = Fields::of(part, 2)?;
    let (id, name) = (fields.word().to_owned(), fields.word().to_owned());
    let (mass, inertia, center) = (fields.number()?, fields.number()?, fields.place()?);
    let _color = fields.word();
    let joints = fields.rest.take_while(|joint| !joint.is_empty()).map(str::to_owned).collect();
    Ok(Link {
        id,
        name,
        is_root: kind.starts_with('Y'),
        is_piston: kind.ends_with('P'),
        mass,
        inertia,
        center,
        joints,
    })
}

/// `FLAGS id,link,name,x,y,x,y,size`: local, outward.
fn force(part: &str) -> Result<Force, Text> {
    let (flags, mut fields) = Fields::of(part, 1)?;
    let bits = flags.chars().next().and_then(digit).ok_or_else(|| bad(part, flags))?;
    let (_id, link, name) = (fields.word(), fields.word().to_owned(), fields.word().to_owned());
    let (from, to, value) = (fields.place()?, fields.place()?, fields.number()?);
    Ok(Force { name, link, from, to, value, is_local: bits & 1 == 1 })
}
