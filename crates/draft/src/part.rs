//! Parts of a mechanism as the text has them.

use assur_mechanism::{Key, Step};
use assur_scene::reference::TABLES;
use toml::Spanned;
use toml::de::DeValue;

use crate::known::{As, Of};
use crate::layout::Layout;
use crate::names::Names;

/// What a user chooses, renames and deletes.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// A moving link, by its name.
    Link(String),
    /// A point, or pin, of all links that have it, by its name.
    Point(String),
    /// A slide, by its name or else `link/on`.
    Slide(String),
    /// What stands as a table of its own: the name of the table (`force`, `friction`, `input`), and its number in the list, from
    /// 0; of a table that is there once 0.
    Load(&'static str, usize),
}

impl Names<'_> {
    /// The keys at which a part stands; none if it doesn't.
    pub(crate) fn paths(&self, part: &Part) -> Vec<Vec<Step>> {
        match part {
            Part::Link(name) => {
                let link = self.definitions(Of::Link).find(|link| link.word == *name);
                link.map(|link| link.path.clone()).into_iter().collect()
            }
            Part::Point(name) => self.holders(name).map(|(_, path)| path.to_vec()).collect(),
            Part::Slide(name) => {
                let path = |index| vec!["slide".into(), Step::Index(index)];
                self.slide_named(name).map(path).into_iter().collect()
            }
            Part::Load(table, index) => {
                let table = self.layout.find(&Key::of(*table));
                let path = match table.value.filter(|_| table.stands()).map(Spanned::get_ref) {
                    Some(DeValue::Array(list)) if *index < list.len() => {
                        Some([&table.steps[..], &[(*index).into()]].concat())
                    }
                    Some(DeValue::Table(_)) if *index == 0 => Some(table.steps),
                    _ => None,
                };
                path.into_iter().collect()
            }
        }
    }

    /// The part that stands at a key; `None` where it is but a value of one.
    pub(crate) fn part(&self, path: &[Step]) -> Option<Part> {
        let own =
            self.mentions.iter().find(|mention| mention.stands == As::Definition && mention.path == path);
        if let Some(mention) = own {
            let name = mention.word.clone();
            return Some(if mention.of == Of::Link { Part::Link(name) } else { Part::Point(name) });
        }
        let (Step::Name(table), rest) = path.split_first()? else { return None };
        let index = match rest {
            [] => 0,
            [Step::Index(index)] => *index,
            _ => return None,
        };
        if table == "slide" {
            return self.slides.get(index).map(|slide| Part::Slide(slide.name.clone()));
        }
        let mut tables = TABLES.iter().filter(|known| known.header.starts_with('['));
        tables.find(|known| known.name() == table).map(|known| Part::Load(known.name(), index))
    }
}

/// Whether something stands at a key; elements of lists by their number or name.
pub fn stands(text: &str, key: &Key) -> bool {
    Layout::of(text).is_ok_and(|layout| layout.find(key).stands())
}
