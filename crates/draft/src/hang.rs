//! What hangs on a part, and goes with it.

use assur_mechanism::{Key, Step};
use assur_words::Text;
use toml::de::DeTable;

use crate::known::{As, Of, known, point_with};
use crate::layout::{Layout, check};
use crate::names::{Mention, Names, link_of, point_of};
use crate::part::Part;
use crate::remove;

/// The parts that must go when one goes, because they name it, or what goes with it: of a link its slides, and the loads,
/// friction and input on it and them. A link goes with its last point. Points of the ground that only it had are among them.
/// Single keys that go, too, are no parts: centers, places of the assembly, wanted results.
pub fn dependents(text: &str, part: &Part) -> Vec<Part> {
    let Ok(layout) = Layout::of(text) else { return Vec::new() };
    let names = Names::of(layout);
    let own = names.paths(part);
    let mut parts = Vec::new();
    for path in names.gone(own.clone()).iter().filter(|path| !own.contains(path)) {
        let found = names.part(path).filter(|found| !parts.contains(found) && found != part);
        parts.extend(found);
    }
    parts
}

/// The text without some parts and all that hangs on them. Lists and tables that this leaves empty go as well, unless the reader
/// needs them.
///
/// # Errors
///
/// What is wrong with the text, in the reader's words.
///
/// # Examples
///
/// ```
/// use assur_draft::{Part, delete};
///
/// let text = "\
/// [ground]
/// points = { O = 0, C = 1 }
/// [link.crank]
/// points = { O = 0, A = 1 }
/// [link.rod]
/// points = { A = 0, C = 1 }
/// [input]
/// link = \"crank\"
/// [output]
/// reactions = [\"A\", \"O\"]
/// ";
/// let text = delete(text, &[Part::Link("rod".to_owned())]).unwrap();
/// assert!(text.starts_with("[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 1 }\n[input]"));
/// assert!(text.ends_with("reactions = [\"O\"]\n"));
/// ```
pub fn delete(text: &str, parts: &[Part]) -> Result<String, Text> {
    let names = Names::of(Layout::of(text)?);
    let own = parts.iter().flat_map(|part| names.paths(part)).collect();
    let mut gone = names.gone(own);
    // Elements of a list have their numbers until those before them go.
    gone.sort_unstable();
    gone.dedup();
    let mut result = text.to_owned();
    for path in gone.iter().rev() {
        result = remove(&result, &Key::from(&path[..]));
    }
    for path in gone.iter().rev() {
        for depth in (1..path.len()).rev() {
            result = without_empty(result, &path[..depth])?;
        }
    }
    check(&result).map(|()| result)
}

/// The text without a list or table, if it is empty and the reader doesn't need it.
fn without_empty(text: String, path: &[Step]) -> Result<String, Text> {
    let layout = Layout::of(&text)?;
    let key = Key::from(path);
    let found = layout.find(&key);
    let is_empty = found.value.filter(|_| found.stands()).is_some_and(|value| {
        let value = value.get_ref();
        value.as_table().is_some_and(DeTable::is_empty)
            || value.as_array().is_some_and(|list| list.is_empty())
    });
    let is_free = known(path).is_some_and(|known| !known.is_needed && known.chosen.is_none());
    Ok(if is_empty && is_free { remove(&text, &key) } else { text })
}

impl Names<'_> {
    /// The keys that go with some, these among them.
    fn gone(&self, own: Vec<Vec<Step>>) -> Vec<Vec<Step>> {
        let mut gone = own;
        loop {
            let more: Vec<Vec<Step>> = {
                let state = State { names: self, gone: &gone };
                let dead = self
                    .mentions
                    .iter()
                    .filter(|mention| !state.is_gone(&mention.path) && state.is_dead(mention));
                dead.map(|mention| carrier(&mention.path).0)
                    .chain(state.left_over())
                    .chain(state.pointless())
                    .collect()
            };
            let count = gone.len();
            for path in more {
                if !gone.contains(&path) {
                    gone.push(path);
                }
            }
            if gone.len() == count {
                return gone;
            }
        }
    }
}

/// What goes when a name in it has lost its meaning: the key of what carries it, and whether that is more than a single key.
fn carrier(path: &[Step]) -> (Vec<Step>, bool) {
    if let Some(point) = point_with(path) {
        return (point.to_vec(), true);
    }
    let Some(known) = known(path) else { return (path.to_vec(), false) };
    let is_single = matches!(path.last(), Some(Step::Index(_)))
        || known.chosen.is_some()
        || known.table.header.ends_with(".NAME]");
    match known.element {
        Some(depth) => (path[..depth].to_vec(), true),
        None if is_single => (path.to_vec(), false),
        None => (path[..1].to_vec(), true),
    }
}

/// A text while parts of it go.
struct State<'n, 't> {
    names: &'n Names<'t>,
    gone: &'n [Vec<Step>],
}

impl State<'_, '_> {
    fn is_gone(&self, path: &[Step]) -> bool {
        self.gone.iter().any(|gone| path.starts_with(gone))
    }

    /// Whether a link is there, and goes.
    fn is_link_gone(&self, link: &str) -> bool {
        let mut own = self.names.definitions(Of::Link).filter(|mention| mention.word == link);
        own.next().is_some_and(|mention| self.is_gone(&mention.path))
    }

    /// How many links have a point now, and have it then.
    fn holders(&self, point: &str) -> [usize; 2] {
        let all = self.names.holders(point);
        all.fold([0; 2], |[now, then], (_, path)| [now + 1, then + usize::from(!self.is_gone(path))])
    }

    /// Whether a link has a point, and loses it.
    fn is_point_gone(&self, link: &str, point: &str) -> bool {
        let mut own = self.names.holders(point).filter(|(holder, _)| *holder == link);
        own.next().is_some_and(|(_, path)| self.is_gone(path))
    }

    fn is_slide_gone(&self, index: usize) -> bool {
        self.is_gone(&["slide".into(), Step::Index(index)])
    }

    /// Whether what a name means goes.
    fn is_dead(&self, mention: &Mention) -> bool {
        let word = &mention.word;
        let slide = self.names.slide_named(word);
        let is_key = |key: &str| mention.path.last() == Some(&Step::from(key));
        match mention.of {
            _ if mention.stands == As::Definition => false,
            Of::Link => self.is_link_gone(word) || is_key("link") && self.is_undriven(mention),
            Of::Slide => slide.is_some_and(|index| self.is_slide_gone(index)),
            Of::Pair if slide.is_some() => slide.is_some_and(|index| self.is_slide_gone(index)),
            Of::Place => {
                let frame = self.names.frame(&mention.path);
                frame.is_some_and(|link| self.is_point_gone(&link, word))
            }
            Of::Point if word.contains('.') => {
                word.split_once('.').is_some_and(|(link, point)| self.is_point_gone(link, point))
            }
            // What names a pin needs two links.
            Of::Point | Of::Pair => {
                let needed = if mention.of == Of::Pair || is_key("pin") { 2 } else { 1 };
                let [now, then] = self.holders(word);
                now >= needed && then < needed
            }
        }
    }

    /// Whether the link of an input loses the pair with the ground that is driven.
    fn is_undriven(&self, mention: &Mention) -> bool {
        if mention.path.first() != Some(&Step::from("input")) {
            return false;
        }
        let link = mention.word.as_str();
        let of_link = |(holder, path): (&str, &[Step])| (holder == link).then(|| path.to_vec());
        let grounded = self.names.points.iter().filter(|path| link_of(path) == "ground");
        let pins = grounded.filter_map(|ground| {
            let path = self.names.holders(point_of(ground)).find_map(of_link)?;
            Some(self.is_gone(ground) || self.is_gone(&path))
        });
        let slides = self.names.slides.iter().enumerate();
        let slides = slides.filter(|(_, slide)| slide.link == link && slide.on == "ground");
        let mut pairs = pins.chain(slides.map(|(index, _)| self.is_slide_gone(index))).peekable();
        pairs.peek().is_some() && pairs.all(|is_gone| is_gone)
    }

    /// Points of the ground that links have which go, and no other link, and that nothing else needs.
    fn left_over(&self) -> Vec<Vec<Step>> {
        let is_needed = |point: &str| {
            let named = self
                .names
                .mentions
                .iter()
                .filter(|mention| mention.stands != As::Definition && !self.is_gone(&mention.path));
            let mut named = named.filter(|mention| match mention.of {
                Of::Place => {
                    mention.word == point && self.names.frame(&mention.path).as_deref() == Some("ground")
                }
                Of::Point => mention.word == point || mention.word.strip_prefix("ground.") == Some(point),
                Of::Link | Of::Slide | Of::Pair => false,
            });
            named.any(|mention| carrier(&mention.path).1)
        };
        let is_left = |path: &&Vec<Step>| {
            let point = point_of(path);
            let mut holders = self.names.holders(point);
            let [now, then] = self.holders(point);
            link_of(path) == "ground"
                && (now > 1 && then == 1 && !self.is_gone(path))
                && holders.any(|(holder, _)| self.is_link_gone(holder))
                && !is_needed(point)
        };
        self.names.points.iter().filter(is_left).cloned().collect()
    }

    /// Links that lose all of their points.
    fn pointless(&self) -> impl Iterator<Item = Vec<Step>> {
        let links = self.names.definitions(Of::Link).filter(|link| !self.is_gone(&link.path));
        let is_pointless = |link: &&Mention| {
            let mut points =
                self.names.points.iter().filter(|point| point.starts_with(&link.path)).peekable();
            points.peek().is_some() && points.all(|point| self.is_gone(point))
        };
        links.filter(is_pointless).map(|link| link.path.clone())
    }
}
