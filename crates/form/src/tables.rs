//! The tables of a scene's text, as far as it is TOML: values by key, and the names of its parts.

use std::ops::Range;

use assur_mechanism::{Key, Step};
use assur_scene::Dimension;
use assur_scene::reference::{self, KeyTable, SceneKey, ValueKind};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A shorter text can't have more tables than are read.
const SURELY_FEW: usize = 300_000;

/// The tables of a text; of one that is too great to be read, none.
#[derive(Debug)]
pub(crate) struct Tables<'t> {
    text: &'t str,
    root: Spanned<DeTable<'t>>,
}

/// What stands at a key.
pub(crate) type Value<'a, 't> = &'a Spanned<DeValue<'t>>;

impl<'t> Tables<'t> {
    pub(crate) fn of(text: &'t str) -> Self {
        let refused = || {
            let identity = |errors: &assur_scene::SceneErrors| errors.errors.first()?.message.identity();
            let first = assur_scene::read("", text).err().as_ref().and_then(identity);
            matches!(first, Some("scene-many-tables" | "scene-file-too-large"))
        };
        let text = if text.len() > SURELY_FEW && refused() { "" } else { text };
        Self { text, root: DeTable::parse_recoverable(text).0 }
    }

    /// The value of a key; elements of lists may be given by their names.
    pub(crate) fn get(&self, key: &Key) -> Option<Value<'_, 't>> {
        let (first, rest) = key.steps().split_first()?;
        let Step::Name(first) = first else { return None };
        let first = self.root.get_ref().get(first.as_str())?;
        rest.iter().try_fold(first, |value, step| match (value.get_ref(), step) {
            (DeValue::Table(table), Step::Name(name)) => table.get(name.as_str()),
            (DeValue::Array(array), Step::Index(index)) => array.get(*index),
            (DeValue::Array(array), Step::Name(name)) => {
                array.iter().find(|item| item.get_ref().as_table().and_then(label).as_ref() == Some(name))
            }
            _ => None,
        })
    }

    /// The table of a key; of the empty key the whole.
    pub(crate) fn table(&self, key: &Key) -> Option<&DeTable<'t>> {
        if key.steps().is_empty() { Some(self.root.get_ref()) } else { self.get(key)?.get_ref().as_table() }
    }

    pub(crate) fn stands(&self, key: &Key) -> bool {
        key.steps().is_empty() || self.get(key).is_some()
    }

    /// The text of a value, quotes included; of a table with a header its header.
    pub(crate) fn written(&self, key: &Key) -> Option<&'t str> {
        self.text.get(self.get(key)?.span())
    }

    /// The text that is the value of a key.
    pub(crate) fn word(&self, key: &Key) -> Option<&str> {
        self.get(key)?.get_ref().as_str()
    }

    /// How many elements a list has; of a table, or without one, 0.
    pub(crate) fn count(&self, key: &Key) -> usize {
        self.get(key).and_then(|value| Some(value.get_ref().as_array()?.len())).unwrap_or_default()
    }

    /// The key with the elements of its lists by number.
    pub(crate) fn numbered(&self, key: &Key) -> Key {
        let mut own = Key::from(&[][..]);
        for step in key.steps() {
            let list = self.get(&own).and_then(|value| value.get_ref().as_array());
            let named = |name: &String| {
                let has = |item: &Spanned<DeValue<'_>>| {
                    item.get_ref().as_table().and_then(label).as_ref() == Some(name)
                };
                list.and_then(|list| list.iter().position(has))
            };
            let index = if let Step::Name(name) = step { named(name) } else { None };
            own = own.at(index.map_or_else(|| step.clone(), Step::Index));
        }
        own
    }

    /// The names in a table in the order of the text.
    pub(crate) fn names(&self, key: &Key) -> Vec<String> {
        let mut names: Vec<_> = self.table(key).into_iter().flatten().map(|(name, _)| name).collect();
        names.sort_by_key(|name| name.span().start);
        names.into_iter().map(|name| name.get_ref().to_string()).collect()
    }

    /// The innermost key at a byte of the text, with elements of lists by number.
    pub(crate) fn key_at(&self, byte: usize) -> Option<Key> {
        let mut best = None;
        in_table(self.root.get_ref(), &mut Vec::new(), &mut |steps, span| {
            let is_narrower = |(_, best): &(Key, usize)| span.len() <= *best;
            if (span.start..span.end.max(span.start + 1)).contains(&byte)
                && best.as_ref().is_none_or(is_narrower)
            {
                best = Some((Key::from(steps), span.len()));
            }
        });
        best.map(|(key, _)| key)
    }

    /// The moving links.
    pub(crate) fn links(&self) -> Vec<String> {
        self.names(&Key::of("link"))
    }

    /// The points of a link, or of the ground.
    pub(crate) fn points_of(&self, link: &str) -> Vec<String> {
        let owner = if link == "ground" { Key::of("ground") } else { Key::of("link").at(link) };
        self.names(&owner.at("points"))
    }

    /// The points of the link, or of the ground, among whose points a key is: of `about` and `from`. `None` of other keys.
    pub(crate) fn points_beside(&self, key: &Key) -> Option<Vec<String>> {
        let place =
            |depth: usize| table_at(&key.steps()[..depth]).is_some_and(|table| table.name() == "points");
        let depth = (1..key.steps().len()).find(|depth| place(*depth))?;
        let (own, points) = key.steps()[..depth].split_last()?;
        let names = self.names(&Key::from(points)).into_iter();
        Some(names.filter(|name| *own != Step::from(name.as_str())).collect())
    }

    /// The links, the ground included, that have a point.
    pub(crate) fn holders(&self, point: &str) -> Vec<String> {
        let links = ["ground".to_owned()].into_iter().chain(self.links());
        links.filter(|link| self.points_of(link).iter().any(|own| own == point)).collect()
    }

    /// Slides: name, the link that slides, and on which.
    pub(crate) fn slides(&self) -> Vec<[String; 3]> {
        let all = (0..self.count(&Key::of("slide"))).map(|index| Key::of("slide").at(index));
        let part = |key: &Key, name: &str| self.word(&key.clone().at(name)).unwrap_or_default().to_owned();
        let slide =
            |key: Key| Some([self.table(&key).and_then(label)?, part(&key, "link"), part(&key, "on")]);
        all.filter_map(slide).collect()
    }

    /// Whether a pair is a `pin` or a `slide`; `None` of one that the scene does not have.
    pub(crate) fn sort_of_pair(&self, pair: &str) -> Option<&'static str> {
        let is_slide = self.slides().iter().any(|[name, ..]| name == pair);
        if is_slide { Some("slide") } else { (self.holders(pair).len() > 1).then_some("pin") }
    }

    /// The names of all links, points, slides or pairs, as the reference calls them.
    pub(crate) fn parts(&self, what: &str) -> Vec<String> {
        let slides = || self.slides().into_iter().map(|[name, ..]| name);
        let points = || {
            let all = ["ground".to_owned()].into_iter().chain(self.links());
            let mut points: Vec<String> = Vec::new();
            for point in all.flat_map(|link| self.points_of(&link)) {
                if !points.contains(&point) {
                    points.push(point);
                }
            }
            points
        };
        match what {
            "link" => self.links(),
            "point" => points(),
            "slide" => slides().collect(),
            "pair" => {
                points().into_iter().filter(|point| self.holders(point).len() > 1).chain(slides()).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Whether the coordinate of the mechanism is the time.
    pub(crate) fn is_over_time(&self) -> bool {
        let input = Key::of("input");
        self.stands(&input.clone().at("over_time"))
            || self.get(&input).is_some_and(|value| value.get_ref().is_array())
    }

    /// What the coordinate of the input is to which a key refers; `None` where the scene does not say.
    pub(crate) fn coordinate(&self, key: &Key) -> Option<Dimension> {
        let input = match key.steps() {
            [Step::Name(list), index @ Step::Index(_), ..] if list == "input" => {
                Key::of("input").at(index.clone())
            }
            _ => Key::of("input"),
        };
        let word = |name: &str| self.word(&input.clone().at(name));
        if let Some(link) = word("link") {
            let ends = |slide: &[String; 3]| {
                let [_, one, other] = slide;
                [(one, other), (other, one)].iter().any(|(one, other)| *one == link && *other == "ground")
            };
            let turns = self.points_of(link).iter().any(|point| self.points_of("ground").contains(point));
            let slides = !turns && self.slides().iter().any(ends);
            return Some(if slides { Dimension::Length } else { Dimension::Angle });
        }
        let slides = word("slide").map(|_| Dimension::Length);
        slides.or_else(|| word("pin").map(|_| Dimension::Angle))
    }
}

/// The name of an element of a list: its own, of a slide its default name; of others what they act on.
pub(crate) fn label(table: &DeTable<'_>) -> Option<String> {
    let text = |key: &str| table.get(key).and_then(|value| value.get_ref().as_str());
    let both = || Some(format!("{}/{}", text("link")?, text("on")?));
    let other = || ["pair", "link", "slide", "pin"].iter().find_map(|key| text(key)).map(str::to_owned);
    text("name").map(str::to_owned).or_else(both).or_else(other)
}

/// Calls a function with the key and the bytes of each key and value.
fn in_table(table: &DeTable<'_>, steps: &mut Vec<Step>, tell: &mut impl FnMut(&[Step], Range<usize>)) {
    for (name, value) in table {
        steps.push(Step::Name(name.get_ref().to_string()));
        tell(steps, name.span());
        within(value, steps, tell);
        steps.pop();
    }
}

fn within(value: &Spanned<DeValue<'_>>, steps: &mut Vec<Step>, tell: &mut impl FnMut(&[Step], Range<usize>)) {
    tell(steps, value.span());
    match value.get_ref() {
        DeValue::Table(table) => in_table(table, steps, tell),
        DeValue::Array(array) => {
            for (index, item) in array.iter().enumerate() {
                steps.push(Step::Index(index));
                within(item, steps, tell);
                steps.pop();
            }
        }
        _ => {}
    }
}

/// The headers of the tables that a key may have as its value.
pub(crate) fn headers(key: &SceneKey) -> impl Iterator<Item = &'static str> {
    key.kinds.iter().filter_map(|kind| if let ValueKind::Table(header) = kind { Some(*header) } else { None })
}

/// The table of the reference at a key whose elements of lists are by number.
pub(crate) fn table_at(steps: &[Step]) -> Option<&'static KeyTable> {
    let (mut table, mut rest) = (reference::table(""), steps);
    while let [Step::Name(name), after @ ..] = rest {
        let is_list = matches!(after.first(), Some(Step::Index(_)));
        let header = headers(own(table, name)?).find(|header| header.starts_with("[[") == is_list)?;
        let named = usize::from(is_list || header.contains(".NAME"));
        (table, rest) = (reference::table(header), after.get(named..)?);
    }
    rest.is_empty().then_some(table)
}

/// What the reference says of a key whose elements of lists are by number.
pub(crate) fn key_of(steps: &[Step]) -> Option<&'static SceneKey> {
    let (Step::Name(name), before) = steps.split_last()? else { return None };
    own(table_at(before)?, name)
}

/// The key of this name; where names are chosen by the user, the one that stands for them.
fn own(table: &'static KeyTable, name: &str) -> Option<&'static SceneKey> {
    table.key(name).or_else(|| table.keys.iter().find(|key| is_chosen(key)))
}

/// Whether the name of a key is chosen by the user.
pub(crate) fn is_chosen(key: &SceneKey) -> bool {
    key.name.chars().all(|letter| letter.is_ascii_uppercase())
}

/// The key of the table that has a key.
pub(crate) fn owner(key: &Key) -> Key {
    Key::from(key.steps().split_last().map_or(&[][..], |(_, before)| before))
}

/// The last name of a key; empty where it is an element of a list.
pub(crate) fn last(key: &Key) -> &str {
    if let Some(Step::Name(name)) = key.steps().last() { name } else { "" }
}
