//! Where names of links, points, slides and pairs stand in a text, as the reference of the keys says.

use std::collections::BTreeSet;
use std::ops::Range;

use assur_mechanism::{Key, Step};
use toml::Spanned;
use toml::de::DeValue;

use crate::braces::Braces;
use crate::known::{As, Of, known, point_with};
use crate::layout::{Layout, line_start};

/// A name in a text.
#[derive(Debug)]
pub(crate) struct Mention {
    /// The key at which it stands, elements of lists by their number.
    pub(crate) path: Vec<Step>,
    pub(crate) span: Range<usize>,
    pub(crate) word: String,
    pub(crate) of: Of,
    pub(crate) stands: As,
}

/// A slide of a text.
#[derive(Debug)]
pub(crate) struct SlideName {
    /// Its name, or else `link/on`.
    pub(crate) name: String,
    pub(crate) link: String,
    pub(crate) on: String,
    /// Whether the name is its own.
    pub(crate) is_own: bool,
}

impl SlideName {
    /// The name without one of its own.
    pub(crate) fn default_name(link: &str, on: &str) -> String {
        format!("{link}/{on}")
    }
}

/// The names of a text.
#[derive(Debug)]
pub(crate) struct Names<'t> {
    pub(crate) layout: Layout<'t>,
    pub(crate) mentions: Vec<Mention>,
    /// The keys of points of links, and of the ground.
    pub(crate) points: BTreeSet<Vec<Step>>,
    /// In the order of the text.
    pub(crate) slides: Vec<SlideName>,
}

impl<'t> Names<'t> {
    /// All names of a text.
    pub(crate) fn of(layout: Layout<'t>) -> Self {
        let mut names = Self { layout, mentions: Vec::new(), points: BTreeSet::new(), slides: Vec::new() };
        let mut found = Finder { text: names.layout.text, mentions: Vec::new() };
        for section in &names.layout.sections {
            found.keys(&[], &section.path, section.header.start);
            for entry in &section.entries {
                let (outer, inner) = entry.path.split_at(section.path.len());
                let start = line_start(names.layout.text, entry.key.start).max(section.header.end);
                found.keys(outer, inner, start);
                if let Some(value) = names.layout.find(&Key::from(&entry.path[..])).value {
                    found.value(&entry.path, value);
                }
            }
        }
        names.mentions = found.mentions;
        names.points = names.definitions(Of::Point).map(|mention| mention.path.clone()).collect();
        let list = Key::of("slide");
        let count = names
            .layout
            .find(&list)
            .value
            .and_then(|list| list.get_ref().as_array())
            .map_or(0, |list| list.len());
        names.slides = (0..count).map(|index| names.slide(&list.clone().at(index))).collect();
        names
    }

    fn slide(&self, key: &Key) -> SlideName {
        let [name, link, on] =
            ["name", "link", "on"].map(|word| self.word(&key.clone().at(word)).map(str::to_owned));
        let (link, on) = (link.unwrap_or_default(), on.unwrap_or_default());
        let is_own = name.is_some();
        SlideName { name: name.unwrap_or_else(|| SlideName::default_name(&link, &on)), link, on, is_own }
    }

    /// The text at a key.
    pub(crate) fn word(&self, key: &Key) -> Option<&str> {
        let found = self.layout.find(key);
        found.value.filter(|_| found.stands())?.get_ref().as_str()
    }

    /// The slide of a name.
    pub(crate) fn slide_named(&self, name: &str) -> Option<usize> {
        self.slides.iter().position(|slide| slide.name == name)
    }

    /// The keys that make a link, or a point of a link.
    pub(crate) fn definitions(&self, of: Of) -> impl Iterator<Item = &Mention> {
        self.mentions.iter().filter(move |mention| mention.of == of && mention.stands == As::Definition)
    }

    /// The links that have a point, the ground with them.
    pub(crate) fn holders<'a>(&'a self, point: &'a str) -> impl Iterator<Item = (&'a str, &'a [Step])> {
        let own = self.points.iter().filter(move |path| point_of(path) == point);
        own.map(|path| (link_of(path), &path[..]))
    }

    /// The link in whose frame the place at a key is.
    pub(crate) fn frame(&self, path: &[Step]) -> Option<String> {
        if let Some(point) = point_with(path) {
            return Some(link_of(point).to_owned());
        }
        let (key, table) = path.split_last()?;
        if let [_, Step::Name(link)] = table {
            return Some(link.clone());
        }
        let of = if *key == Step::from("through") { "on" } else { "link" };
        self.word(&Key::from(table).at(of)).map(str::to_owned)
    }
}

/// The link to whose points a key belongs.
pub(crate) fn link_of(path: &[Step]) -> &str {
    match path {
        [.., Step::Name(link), _, _] => link,
        _ => "",
    }
}

/// The point of a key.
pub(crate) fn point_of(path: &[Step]) -> &str {
    if let Some(Step::Name(point)) = path.last() { point } else { "" }
}

/// Finds names while a text is gone through.
struct Finder<'t> {
    text: &'t str,
    mentions: Vec<Mention>,
}

impl Finder<'_> {
    fn value(&mut self, path: &[Step], value: &Spanned<DeValue<'_>>) {
        if let DeValue::String(text) = value.get_ref() {
            let of = known(path).and_then(|known| known.named(text));
            self.mentions.extend(of.map(|of| Mention {
                path: path.to_vec(),
                span: value.span(),
                word: text.to_string(),
                of,
                stands: As::Value,
            }));
        }
        for item in Braces::of(self.text, value).items {
            if value.get_ref().is_table() {
                self.keys(path, &item.path, item.span.start);
            }
            self.value(&[path, &item.path].concat(), item.value);
        }
    }

    /// The names among the words of a key, which begins at this place or behind its brackets.
    fn keys(&mut self, outer: &[Step], inner: &[Step], start: usize) {
        let mut at = start;
        for (depth, step) in inner.iter().enumerate() {
            let Step::Name(name) = step else { continue };
            let Some(span) = next_word(self.text, at) else { return };
            at = span.end;
            let path = [outer, &inner[..=depth]].concat();
            if let Some((of, stands)) = known(&path).and_then(|known| known.chosen) {
                self.mentions.push(Mention { path, span, word: name.clone(), of, stands });
            }
        }
    }
}

/// The bytes of the next name of a key, behind spaces, points and brackets.
fn next_word(text: &str, at: usize) -> Option<Range<usize>> {
    let rest = text.get(at..)?;
    let is_between = |c: char| c.is_whitespace() || matches!(c, '.' | '[' | '\u{feff}');
    let word = rest.trim_start_matches(is_between);
    let start = at + rest.len() - word.len();
    let length = match word.chars().next()? {
        quote @ ('"' | '\'') => {
            let mut is_escaped = false;
            let is_end = |c: char| {
                let ends = c == quote && !is_escaped;
                is_escaped = quote == '"' && c == '\\' && !is_escaped;
                ends
            };
            1 + word[1..].find(is_end)? + 1
        }
        _ => word.find(|c: char| c.is_whitespace() || matches!(c, '.' | '=' | ']')).unwrap_or(word.len()),
    };
    Some(start..start + length)
}
