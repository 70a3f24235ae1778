//! The form for one table.

use assur_mechanism::Key;
use assur_scene::reference::{KeyTable, SceneKey, ValueKind};
use assur_words::{Text, joined, name};

use crate::choices::Offers;
use crate::field::{Field, Opening, point, what};
use crate::sort::{openings, sort};
use crate::tables::{Tables, headers, is_chosen, key_of, label, last, owner as owner_of, table_at};

/// A table with the keys that it may have.
#[derive(Debug, Clone)]
pub struct Form {
    /// The key of the table, elements of lists by number; of the scene as a whole empty.
    pub at: Key,
    /// What it is, and its name.
    pub heading: Text,
    /// Its sorts, to be made by [`made`](crate::made), where it is the value of a key and there are several.
    pub sorts: Vec<Opening>,
    /// The keys that a table of its sort may have, in the order of the reference, and those that stand there although they may not.
    pub fields: Vec<Field>,
}

/// The form for a table that stands, or that may be added with its first key: `motion`, `force[0]`, `force[0].value`,
/// `link.crank`, `link.crank.points`; of the empty key what stands before all tables. A key that is no table has no fields.
pub fn table(text: &str, at: &Key, offers: Offers<'_>) -> Form {
    let tables = Tables::of(text);
    let at = tables.numbered(at);
    let is_points = |key: &&SceneKey| key.kinds.contains(&ValueKind::Points);
    let owner = key_of(at.steps());
    // The table of a point is the value of one among the points.
    let of_point = || key_of(owner_of(&at).steps()).filter(is_points);
    let opener = owner.filter(|key| !is_points(key)).or_else(of_point);
    let mut sorts = opener.map(|key| openings(&tables, &at, key)).unwrap_or_default();
    sorts.retain(|opening| opening.sort.is_some());
    let (what, fields) = match (table_at(at.steps()), owner) {
        (Some(known), _) => {
            (what(known.header, sort(&tables, &at, known)), of_table(&tables, &at, known, offers))
        }
        (None, Some(points)) if points.kinds.contains(&ValueKind::Points) => {
            (points.values(), of_points(&tables, &at, points))
        }
        _ => (Text::default(), Vec::new()),
    };
    let own = tables.table(&at).and_then(label).unwrap_or_else(|| last(&at).to_owned());
    let heading = if own.is_empty() { what } else { joined(": ", [what, name(own)]) };
    Form { at, heading, sorts, fields }
}

fn of_points(tables: &Tables<'_>, at: &Key, points: &SceneKey) -> Vec<Field> {
    tables.names(at).into_iter().map(|name| point(tables, at.clone().at(name.as_str()), points)).collect()
}

fn of_table(tables: &Tables<'_>, at: &Key, known: &KeyTable, offers: Offers<'_>) -> Vec<Field> {
    let own = sort(tables, at, known);
    let field = |key: &SceneKey, name: &str| Field::of(tables, at.clone().at(name), key, offers);
    let mut fields = Vec::new();
    for key in &known.keys {
        if is_chosen(key) {
            let (standing, fixed) = (tables.names(at), tables.points_of("ground"));
            let more = tables.parts("point").into_iter();
            let more = more.filter(|point| !standing.contains(point) && !fixed.contains(point));
            fields.extend(standing.iter().cloned().chain(more).map(|name| field(key, &name)));
        } else if headers(key).all(|header| !header.starts_with('['))
            && (key.is_of(own) || tables.stands(&at.clone().at(key.name)))
        {
            let points = key.kinds.contains(&ValueKind::Points);
            let points = if points { of_points(tables, &at.clone().at(key.name), key) } else { Vec::new() };
            if points.is_empty() {
                fields.push(field(key, key.name));
            }
            fields.extend(points);
        }
    }
    fields
}
