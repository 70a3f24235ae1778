//! Masses and moments of inertia: one table of all links.

use assur_mechanism::{Key, Mechanism};
use assur_scene::edit::{decimal, quoted};
use assur_scene::reference::{SceneKey, table};
use assur_words::{Text, name, text};

use crate::change::{Change, Step};
use crate::field::Field;
use crate::rows::toml_number;
use crate::tables::Tables;

/// The keys of a link that say how it is filled with mass.
const KEYS: [&str; 3] = ["mass", "center", "inertia"];

/// Several links with the same keys.
#[derive(Debug, Clone)]
pub struct Grid {
    /// The keys of the columns, each with a sentence that says what it is.
    pub columns: Vec<(&'static str, Text)>,
    /// A row for each moving link, in the order of the text.
    pub rows: Vec<GridRow>,
}

/// A link in a grid.
#[derive(Debug, Clone)]
pub struct GridRow {
    /// The name of the link.
    pub link: String,
    /// A field for each column.
    pub fields: Vec<Field>,
}

/// Mass, center of mass and moment of inertia of all moving links.
pub fn masses(text: &str) -> Grid {
    let tables = Tables::of(text);
    let known: Vec<&SceneKey> = KEYS.iter().filter_map(|key| table("[link.NAME]").key(key)).collect();
    let row = |link: String| {
        let key = |known: &SceneKey| Key::of("link").at(link.as_str()).at(known.name);
        let fields = known.iter().map(|known| Field::of(&tables, key(known), known, &[])).collect();
        GridRow { link, fields }
    };
    Grid {
        columns: known.iter().map(|known| (known.name, text!(known.about))).collect(),
        rows: tables.links().into_iter().map(row).collect(),
    }
}

/// A link as a uniform rod between the two of its points that are farthest from each other, with so many kg per meter: its mass, its
/// center of mass in the middle, and its moment of inertia, mass times length squared by 12. The change is at the link; a link of one
/// point, or whose points can't be read, has none of it.
pub fn rod(text: &str, link: &str, per_meter: f64) -> Change {
    let at = Key::of("link").at(link);
    let mut step = Step::of(text);
    let Some([one, other]) = ends(text, link) else {
        return Change::refused(text, &at, text!("form-no-rod", link = name(link.to_owned())));
    };
    let length = (one[0] - other[0]).hypot(one[1] - other[1]);
    let mass = per_meter * length;
    let [x, y] = [0, 1].map(|axis| toml_number(decimal(f64::midpoint(one[axis], other[axis]))));
    let quantity = |number: f64, unit: &str| format!("\"{} {unit}\"", toml_number(decimal(number)));
    let values =
        [quantity(mass, "kg"), format!("[{x}, {y}]"), quantity(mass * length * length / 12.0, "kg*m^2")];
    for (key, value) in KEYS.iter().zip(values) {
        let key = at.clone().at(*key);
        if let Err(message) = step.set(&key, &value) {
            return Change::refused(text, &at, message);
        }
        step.also.push(key);
    }
    step.done(&at)
}

/// The two points of a link that are farthest from each other, m.
fn ends(text: &str, link: &str) -> Option<[[f64; 2]; 2]> {
    let tables = Tables::of(text);
    let at = Key::of("link").at(link).at("points");
    let point = |name: String| {
        Some(format!("{} = {}", quoted(&name), tables.written(&at.clone().at(name.as_str()))?))
    };
    let points = tables.names(&at).into_iter().map(point).collect::<Option<Vec<_>>>()?.join(", ");
    // Read alone, so that faults elsewhere don't matter.
    let scene = format!(
        "[ground]\npoints = {{ '__' = 0 }}\n[link.rod]\npoints = {{ {points} }}\n[link.'__']\npoints = {{ '__' = 0 }}\n[input]\nlink = '__'\n"
    );
    let Mechanism { points, .. } = assur_scene::read("", &scene).ok()?;
    let places: Vec<_> = points.iter().filter_map(|point| point.on(1)).collect();
    let apart = |[one, other]: &[[f64; 2]; 2]| (one[0] - other[0]).hypot(one[1] - other[1]);
    let pairs = places.iter().flat_map(|one| places.iter().map(|other| [*one, *other]));
    // The first of pairs that are equally far.
    let longest = pairs.reduce(|best, pair| if apart(&pair) > apart(&best) { pair } else { best })?;
    (apart(&longest) > 0.0).then_some(longest)
}
