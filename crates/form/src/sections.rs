//! The tables of a scene: those that stand, and those that may be added.

use assur_mechanism::Key;
use assur_scene::reference::{KeyTable, TABLES, table};
use assur_words::{Text, name, text};

use crate::tables::{Tables, headers, label};

/// A kind of table of a scene.
#[derive(Debug, Clone)]
pub struct Section {
    /// How the reference writes it: `[[force]]`, `[link.NAME]`; of the scene as a whole empty.
    pub header: &'static str,
    /// What it is, with an article: a force.
    pub what: Text,
    /// A sentence that says more.
    pub about: Text,
    /// Those that stand, in the order of the text.
    pub instances: Vec<Instance>,
    /// Whether [`added`](crate::added) may add one.
    pub can_add: bool,
}

/// A table that stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Instance {
    /// Its key, elements of lists by number.
    pub key: Key,
    /// Its name, or the part that it is about; of a table that stands once empty.
    pub label: Text,
}

/// All kinds of tables of a scene in the order of the reference; the first is the scene as a whole, with what stands before all tables.
pub fn sections(text: &str) -> Vec<Section> {
    let tables = Tables::of(text);
    let is_own = |known: &&KeyTable| known.header.is_empty() || known.header.starts_with('[');
    TABLES.iter().filter(is_own).map(|known| section(&tables, known)).collect()
}

fn section(tables: &Tables<'_>, known: &'static KeyTable) -> Section {
    let (header, key) = (known.header, Key::of(known.name()));
    let one = |key: Key, label: Text| Instance { key, label };
    let is_list = tables.get(&key).is_some_and(|value| value.get_ref().is_array());
    let instances: Vec<_> = if header.is_empty() {
        vec![one(Key::from(&[][..]), Text::default())]
    } else if header.contains(".NAME") {
        let links = tables.names(&key).into_iter();
        links.map(|link| one(key.clone().at(link.as_str()), name(link))).collect()
    } else if header.starts_with("[[") {
        let all = (0..tables.count(&key)).map(|index| key.clone().at(index));
        let label = |key: &Key| tables.table(key).and_then(label).unwrap_or_default();
        all.map(|key| one(key.clone(), name(label(&key)))).collect()
    } else {
        let own = tables.stands(&key) && !is_list;
        own.then(|| one(key.clone(), Text::default())).into_iter().collect()
    };
    // An input is a table or a list.
    let can_add = match header {
        "" => false,
        list if list.starts_with("[[") => is_list || !tables.stands(&key),
        named => !named.contains(".NAME") && !tables.stands(&key),
    };
    let about = table("").keys.iter().find(|key| headers(key).any(|own| own == header));
    let about = about.map(|key| text!(key.about)).unwrap_or_default();
    Section { header, what: text!(known.what), about, instances, can_add }
}
