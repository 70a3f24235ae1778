//! Another name, wherever the old one stands.

use assur_mechanism::{Key, Step};
use assur_scene::SceneError;
use assur_scene::edit::replaced;
use assur_words::{Text, name, text};

use crate::known::{As, Of, known};
use crate::layout::{Layout, check};
use crate::names::{Mention, Names, SlideName, link_of};
use crate::part::Part;
use crate::written::{quoted, word};
use crate::{remove, set};

/// The text with another name of a part, wherever the name stands: as key or value, in `link.point`, and in the name of a slide
/// that is made of those of its links. A slide or load without a name of its own is given one.
///
/// # Errors
///
/// That there is no such part, that it takes no name, that the name is taken, or what the reader says of it.
///
/// # Examples
///
/// ```
/// use assur_draft::{Part, rename};
///
/// let text = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0 }\n[input]\nlink = \"crank\"\n";
/// let text = rename(text, &Part::Link("crank".to_owned()), "arm").unwrap();
/// assert!(text.ends_with("[link.arm]\npoints = { O = 0 }\n[input]\nlink = \"arm\"\n"));
/// assert_eq!(rename(&text, &Part::Link("arm".to_owned()), "a.b").unwrap_err().to_string(), "`a.b` can't be the name of a link");
/// ```
pub fn rename(text: &str, part: &Part, new: &str) -> Result<String, Text> {
    let names = Names::of(Layout::of(text)?);
    let paths = names.paths(part);
    let Some(path) = paths.first() else { return Err(text!("draft-no-part", name = name(part.told()))) };
    let key = Key::from(&path[..]);
    let (old, is_taken) = match part {
        Part::Link(old) => (old.clone(), names.definitions(Of::Link).any(|link| link.word == new)),
        Part::Point(old) => (old.clone(), names.holders(new).next().is_some()),
        Part::Slide(old) => (old.clone(), names.slide_named(new).is_some()),
        Part::Load(..) => (names.word(&key.clone().at("name")).unwrap_or_default().to_owned(), false),
    };
    if old == new {
        return Ok(text.to_owned());
    }
    if is_taken {
        return Err(text!("draft-name-taken", name = name(new.to_owned())));
    }
    let result = names.replaced(|mention| names.renamed(mention, part, new));
    let result = match part {
        Part::Link(_) | Part::Point(_) => result,
        Part::Slide(_) if names.has_default_name(path, new) => remove(&result, &key.at("name")),
        _ if known(&[&path[..], &["name".into()]].concat()).is_none() => {
            return Err(text!("draft-takes-no-name", name = name(part.told())));
        }
        _ => set(&result, &key.at("name"), &quoted(new))?,
    };
    check(&result)?;
    let (before, after) = (faults(text), faults(&result));
    let is_new = |fault: &&SceneError| before.iter().all(|old| old.message != fault.message);
    match after.iter().find(is_new).filter(|_| after.len() > before.len()) {
        Some(fault) => Err(fault.message.clone()),
        None => Ok(result),
    }
}

/// The text with another name of a point in one link, or in the ground, alone: the pin that it was is open there, and with a
/// point of another link that has the new name it makes one. What names the point otherwise goes with it if no other link has it.
///
/// # Errors
///
/// That the link has no such point, or has one of the new name, or what the reader says of the name.
pub fn rename_in_link(text: &str, link: &str, point: &str, new: &str) -> Result<String, Text> {
    let names = Names::of(Layout::of(text)?);
    let has = |point: &str| names.holders(point).any(|(holder, _)| holder == link);
    if !has(point) {
        return Err(text!("draft-no-part", name = name(format!("{link}.{point}"))));
    }
    if point == new {
        return Ok(text.to_owned());
    }
    if has(new) {
        return Err(text!("draft-name-taken", name = name(new.to_owned())));
    }
    let probe = format!("[ground]\npoints = {{ {} = 0 }}\n", word(new));
    let is_of_name = |fault: &SceneError| fault.span.start > 0;
    if let Some(fault) = faults(&probe).into_iter().find(is_of_name) {
        return Err(fault.message);
    }
    let is_alone = names.holders(point).all(|(holder, _)| holder == link);
    let part = Part::Point(point.to_owned());
    let is_meant = |mention: &Mention| match (mention.stands, mention.of) {
        (As::Definition, _) => link_of(&mention.path) == link,
        (_, Of::Place) => names.frame(&mention.path).as_deref() == Some(link),
        (As::Value, Of::Point) if mention.word.contains('.') => mention.word.split('.').next() == Some(link),
        _ => is_alone,
    };
    // Where the new name has a place already, that of the old one goes.
    let places = [point, new].map(|point| Key::of("assembly").at(point));
    if is_alone && places.iter().all(|place| names.layout.find(place).stands()) {
        return rename_in_link(&remove(text, &places[0]), link, point, new);
    }
    let result = names.replaced(|mention| names.renamed(mention, &part, new).filter(|_| is_meant(mention)));
    check(&result).map(|()| result)
}

/// A key of a text as it is once a part has another name.
pub fn renamed_key(key: &Key, part: &Part, new: &str) -> Key {
    let (Part::Link(old) | Part::Point(old) | Part::Slide(old)) = part else { return key.clone() };
    let steps = key.steps();
    // The names of their elements are made of those of links and pairs.
    let is_list = ["slide", "friction", "input"].iter().any(|list| steps.first() == Some(&Step::from(*list)));
    let renamed = |(depth, step): (usize, &Step)| {
        let (Step::Name(word), chosen) = (step, known(&steps[..=depth]).and_then(|known| known.chosen))
        else {
            return step.clone();
        };
        let is_meant = match (part, chosen) {
            (Part::Link(_), Some((of, _))) => of == Of::Link,
            (Part::Point(_), Some((of, _))) => of == Of::Point,
            _ => is_list && depth == 1,
        };
        let sign =
            ['/', ':'].into_iter().find(|sign| word.contains(*sign) && !matches!(part, Part::Slide(_)));
        let ends = sign.map_or(vec![&**word], |sign| word.split(sign).collect());
        let ends: Vec<&str> =
            ends.into_iter().map(|end| if is_meant && end == old { new } else { end }).collect();
        Step::Name(ends.join(&sign.map(String::from).unwrap_or_default()))
    };
    let steps: Vec<Step> = steps.iter().enumerate().map(renamed).collect();
    Key::from(&steps[..])
}

/// The faults that the reader finds.
fn faults(text: &str) -> Vec<SceneError> {
    assur_scene::read("", text).err().map(|errors| errors.errors).unwrap_or_default()
}

impl Part {
    /// Its name, or the key of its table.
    fn told(&self) -> String {
        match self {
            Self::Link(name) | Self::Point(name) | Self::Slide(name) => name.clone(),
            Self::Load(table, index) => Key::of(*table).at(*index).to_string(),
        }
    }
}

impl Names<'_> {
    /// The text with other names where there are such.
    fn replaced(&self, new: impl Fn(&Mention) -> Option<String>) -> String {
        let text = self.layout.text;
        let changes: Vec<_> = self
            .mentions
            .iter()
            .filter_map(|mention| {
                let new = new(mention)?;
                let is_literal =
                    text[mention.span.clone()].starts_with('\'') && quoted(&new).len() == new.len() + 2;
                let written = match mention.stands {
                    As::Definition | As::Key => word(&new),
                    As::Value if is_literal && !new.contains('\'') => format!("'{new}'"),
                    As::Value => quoted(&new),
                };
                Some((&mention.span, written))
            })
            .collect();
        replaced(text, changes.iter().map(|(span, written)| (*span, &**written)))
    }

    /// What a name is once a part has another one; `None`: it stays.
    fn renamed(&self, mention: &Mention, part: &Part, new: &str) -> Option<String> {
        let word = &mention.word;
        let slide = || self.slide_named(word).map(|index| &self.slides[index]);
        let is = |old: &String| (word == old).then(|| new.to_owned());
        match (part, mention.of) {
            (Part::Link(old), Of::Link)
            | (Part::Point(old), Of::Place)
            | (Part::Slide(old), Of::Slide | Of::Pair) => is(old),
            (Part::Link(old), Of::Slide | Of::Pair) => {
                let slide =
                    slide().filter(|slide| !slide.is_own && (slide.link == *old || slide.on == *old))?;
                let [link, on] = [&slide.link, &slide.on].map(|end| if end == old { new } else { end });
                Some(SlideName::default_name(link, on))
            }
            (Part::Link(old), Of::Point) if mention.stands == As::Value => {
                let (link, point) = word.split_once('.')?;
                (link == old).then(|| format!("{new}.{point}"))
            }
            (Part::Point(old), Of::Point) => {
                match word.split_once('.').filter(|_| mention.stands == As::Value) {
                    Some((link, point)) => (point == old).then(|| format!("{link}.{new}")),
                    None => is(old),
                }
            }
            (Part::Point(old), Of::Pair) if slide().is_none() => is(old),
            _ => None,
        }
    }

    /// Whether a slide has this name without a name of its own.
    fn has_default_name(&self, path: &[Step], name: &str) -> bool {
        let slide = if let [_, Step::Index(index)] = path { self.slides.get(*index) } else { None };
        slide.is_some_and(|slide| SlideName::default_name(&slide.link, &slide.on) == name)
    }
}
