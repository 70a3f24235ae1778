//! The rows of a table as JSON objects.

use std::borrow::Cow;
use std::fmt::Write;

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema, Table};

use super::quoted;
use crate::template::{Template, Templates};

/// The keys of a row, in their order.
const KEYS: [&str; 23] = [
    "time",
    "coordinate",
    "speed",
    "acceleration",
    "work_driving",
    "work_resisting",
    "kinetic_energy",
    "links",
    "points",
    "slides",
    "velocities",
    "accelerations",
    "reduced",
    "loads",
    "inertia_loads",
    "shaking",
    "reactions",
    "balancing",
    "reactions_by_cause",
    "balancing_by_cause",
    "holding",
    "residuals",
    "condition",
];

/// What the objects of a table have besides its columns.
#[derive(Debug, Clone, Copy)]
pub(super) struct Form {
    /// Whether they begin with the number of the position.
    pub(super) numbered: bool,
    /// Keys that stand even where there is nothing under them.
    pub(super) always: &'static [&'static str],
}

/// The positions of a scene.
pub(super) const POSITIONS: Form =
    Form { numbered: true, always: &["links", "points", "slides", "condition"] };
/// The samples of a motion.
pub(super) const TRAJECTORY: Form = Form { numbered: false, always: &["links"] };

/// A step into an object or an array.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step<'a> {
    Key(Cow<'a, str>),
    Item(usize),
}

/// Where a column stands in the object of a row; `None` where JSON does not have it.
pub(super) fn path(schema: &Schema, column: Column) -> Option<Vec<Step<'_>>> {
    use Quantity as Q;
    let key = |key: &'static str| Step::Key(key.into());
    let name = || Step::Key(schema.name(column.owner));
    let of = |list: &'static str| match column.owner {
        Owner::Link(_) => vec![key(list), key("links"), name()],
        Owner::Slide(_) => vec![key(list), key("slides"), name()],
        _ => vec![key(list), key("points"), name()],
    };
    let cause = column.cause.map(|cause| Step::Key(schema.causes[cause].as_str().into()));
    let mut path = match (column.quantity, column.owner) {
        (Q::Time, _) => vec![key("time")],
        (Q::Transfer(_), Owner::Input) => vec![key("coordinate")],
        (Q::Velocity, Owner::Input) => vec![key("speed")],
        (Q::Acceleration, Owner::Input) => vec![key("acceleration")],
        (Q::Transfer(order), _) => {
            let order = ["pf0", "pf1", "pf2"].get(usize::from(order))?;
            of("").into_iter().skip(1).chain([key(order)]).collect()
        }
        (Q::Velocity, _) => of("velocities"),
        (Q::Acceleration, _) => of("accelerations"),
        (Q::DrivingWork, _) => vec![key("work_driving")],
        (Q::ResistingWork, _) => vec![key("work_resisting")],
        (Q::KineticEnergy, _) => vec![key("kinetic_energy")],
        (Q::ReducedInertia, Owner::Link(_)) => vec![key("reduced"), key("inertia_of_links"), name()],
        (Q::ReducedInertia, _) => vec![key("reduced"), key("inertia")],
        (Q::ReducedInertiaDerivative, _) => vec![key("reduced"), key("inertia_derivative")],
        (Q::ReducedMoment, _) => vec![key("reduced"), key("moment")],
        (Q::Force | Q::Moment, _) => {
            let part = match column.owner {
                Owner::PairOn(_, link) => Step::Key(schema.link(link).into()),
                _ => key("moment"),
            };
            let all = if cause.is_some() { key("reactions_by_cause") } else { key("reactions") };
            [all].into_iter().chain(cause).chain([name(), part]).collect()
        }
        (Q::Balancing, _) => match cause {
            Some(cause) => vec![key("balancing_by_cause"), cause],
            None => vec![key("balancing")],
        },
        (Q::Holding, _) => vec![key("holding"), key("moment")],
        (Q::HoldingBound, _) => vec![key("holding"), key("bound")],
        (Q::Load, _) => vec![key("loads"), name()],
        (Q::InertiaForce, _) => vec![key("inertia_loads"), name(), key("force")],
        (Q::InertiaMoment, _) => vec![key("inertia_loads"), name(), key("moment")],
        (Q::ShakingForce, _) => vec![key("shaking"), key("force")],
        (Q::ShakingMoment, _) => vec![key("shaking"), key("moment")],
        (Q::Residual(of), owner) => vec![key("residuals"), Step::Key(of.name(owner))],
        (Q::Condition, _) => vec![key("condition"), name()],
        _ => return None,
    };
    path.extend(match column.part {
        Part::Whole => None,
        Part::X => Some(Step::Item(0)),
        Part::Y => Some(Step::Item(1)),
    });
    Some(path)
}

/// The path as people write it: `.points.A.pf0[1]`.
pub(super) fn spelled(path: &[Step<'_>]) -> String {
    path.iter().fold(String::new(), |mut text, step| {
        let _ = match step {
            Step::Key(key) => write!(text, ".{key}"),
            Step::Item(item) => write!(text, "[{item}]"),
        };
        text
    })
}

/// The rows of tables of one schema as the items of an array.
#[derive(Debug)]
pub(super) struct Rows {
    form: Form,
    ascii: bool,
    columns: Vec<usize>,
}

impl Rows {
    pub(super) fn new(schema: &Schema, form: Form, ascii: bool) -> Self {
        let rank = |column: &usize| {
            let path = path(schema, schema.columns()[*column]);
            path.and_then(|path| KEYS.iter().position(|key| path[0] == Step::Key((*key).into())))
        };
        let mut columns: Vec<usize> =
            (0..schema.columns().len()).filter(|column| rank(column).is_some()).collect();
        columns.sort_by_key(rank);
        Self { form, ascii, columns }
    }

    /// The rows of a table, each after a comma.
    pub(super) fn text(&self, table: &Table) -> Vec<u8> {
        let Self { form, ascii, columns } = self;
        let mut templates = Templates::new(table, columns.iter().copied());
        let mut out = Vec::new();
        for row in 0..table.len() {
            let make = |has: &dyn Fn(usize) -> bool| {
                let columns = columns.iter().copied().filter(|column| has(*column));
                template(table.schema(), columns, *form, *ascii)
            };
            let template = templates.of(table, row, make);
            out.extend_from_slice(b",{");
            if form.numbered {
                out.extend_from_slice(b"\"index\":");
                out.extend_from_slice(table.numbers()[row].to_string().as_bytes());
            }
            template.write(table, row, &mut out, number);
        }
        out
    }
}

/// The shortest text that reads back as the same number.
fn number(value: f64, out: &mut Vec<u8>) {
    out.extend_from_slice(zmij::Buffer::new().format_finite(value).as_bytes());
}

/// The text of a row with numbers in these columns, without its opening brace.
fn template(schema: &Schema, columns: impl Iterator<Item = usize>, form: Form, ascii: bool) -> Template {
    let mut writer = Writer { text: String::new(), open: Vec::new(), ascii, any: form.numbered };
    let mut pieces = Vec::new();
    let paths: Vec<_> =
        columns.filter_map(|column| Some((column, path(schema, schema.columns()[column])?))).collect();
    let mut paths = paths.into_iter().peekable();
    for key in KEYS {
        let under = |path: &[Step<'_>]| path[0] == Step::Key(key.into());
        if form.always.contains(&key) && !paths.peek().is_some_and(|(_, path)| under(path)) {
            writer.go(vec![Step::Key(key.into())]);
            writer.text += "{}";
        }
        while let Some((column, path)) = paths.next_if(|(_, path)| under(path)) {
            writer.go(path);
            pieces.push((std::mem::take(&mut writer.text), column));
        }
    }
    writer.close(0);
    Template { pieces, end: writer.text + "}" }
}

/// Text between the values of an object, which come in the order of their paths.
struct Writer<'a> {
    text: String,
    /// The path of the last value.
    open: Vec<Step<'a>>,
    ascii: bool,
    /// Whether the object has a value.
    any: bool,
}

impl<'a> Writer<'a> {
    /// Closes all objects and arrays below this depth.
    fn close(&mut self, depth: usize) {
        for step in self.open.iter().skip(depth + 1).rev() {
            self.text.push(if matches!(step, Step::Key(_)) { '}' } else { ']' });
        }
    }

    /// Text up to the value of this path.
    fn go(&mut self, path: Vec<Step<'a>>) {
        let same = self.open.iter().zip(&path).take_while(|(a, b)| a == b).count();
        // The path of another value may begin with this whole one.
        let same = same.min(path.len() - 1).min(self.open.len().saturating_sub(1));
        self.close(same);
        if self.any {
            self.text.push(',');
        }
        self.any = true;
        for (depth, step) in path.iter().enumerate().skip(same) {
            if depth > same {
                self.text.push(if matches!(step, Step::Key(_)) { '{' } else { '[' });
            }
            if let Step::Key(key) = step {
                self.text += &quoted(key, self.ascii);
                self.text.push(':');
            }
        }
        self.open = path;
    }
}
