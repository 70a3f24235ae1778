//! The rows of a table as JSON objects.

use std::{collections::BTreeMap, fmt::Write, ops::Range};

use assur_analysis::results::{Column, Owner, Quantity, Schema, Several, Table};
use rayon::prelude::*;

use super::{JsonError, finite, quoted, serialized};
use crate::template::{Template, Templates};
use assur_book::catalogue::{KEYS, PathStep, path};

/// Numbers that a thread writes at a time: some milliseconds of work.
const NUMBERS: usize = 1 << 16;

/// What a number takes with what stands before it, in characters: room for the text of a row.
const USUAL: usize = 24;

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

/// The path as people write it: `.points.A.pf0[1]`.
pub(super) fn spelled(path: &[PathStep<'_>]) -> String {
    path.iter().fold(String::new(), |mut text, step| {
        let _ = match step {
            PathStep::Key(key) => write!(text, ".{key}"),
            PathStep::Item(item) => write!(text, "[{item}]"),
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
    /// What stands at the end of some rows, by their numbers.
    ends: BTreeMap<usize, Vec<u8>>,
}

impl Rows {
    pub(super) fn new(schema: &Schema, form: Form, ascii: bool) -> Self {
        let ranks = schema.columns().iter().map(|column| {
            let path = path(schema, *column)?;
            KEYS.split(' ').position(|key| path[0] == PathStep::Key(key.into()))
        });
        let mut ranked: Vec<_> =
            ranks.enumerate().filter_map(|(column, rank)| Some((rank?, column))).collect();
        ranked.sort_unstable();
        Self {
            form,
            ascii,
            columns: ranked.into_iter().map(|(_, column)| column).collect(),
            ends: BTreeMap::new(),
        }
    }

    /// Puts several solutions at the ends of the rows that have them.
    pub(super) fn several(&mut self, several: &[Several]) -> Result<(), JsonError> {
        for one in several.iter().filter(|one| one.solutions.len() > 1) {
            let text = serialized(finite(&one.solutions)?, self.ascii)?;
            let end = [&b",\"solutions\":"[..], &text, b"}"].concat();
            self.ends.insert(one.index, end);
        }
        Ok(())
    }

    /// The rows of a table, each after a comma; those of a large table in parts that all threads write.
    pub(super) fn text(&self, table: &Table) -> Vec<Vec<u8>> {
        let together = (NUMBERS / self.columns.len().max(1)).max(1);
        if table.len() <= 2 * together {
            return vec![self.some(table, 0..table.len())];
        }
        let starts = (0..table.len()).into_par_iter().step_by(together);
        starts.map(|start| self.some(table, start..(start + together).min(table.len()))).collect()
    }

    fn some(&self, table: &Table, rows: Range<usize>) -> Vec<u8> {
        let Self { form, ascii, columns, ends } = self;
        let mut templates = Templates::new(table, columns.iter().copied());
        let mut out = Vec::with_capacity(rows.len() * columns.len() * USUAL);
        for row in rows {
            let make = |has: &dyn Fn(usize) -> bool| {
                let columns = columns.iter().map(|column| (*column, has(*column)));
                template(table.schema(), columns, *form, *ascii)
            };
            let template = templates.of(table, row, make);
            out.extend_from_slice(b",{");
            if form.numbered {
                out.extend_from_slice(b"\"index\":");
                out.extend_from_slice(table.numbers()[row].to_string().as_bytes());
            }
            template.write(table, row, &mut out, number);
            if let Some(end) = ends.get(&table.numbers()[row]) {
                out.pop();
                out.extend_from_slice(end);
            }
        }
        out
    }
}

/// The shortest text that reads back as the same number.
fn number(value: f64, out: &mut Vec<u8>) {
    out.extend_from_slice(zmij::Buffer::new().format_finite(value).as_bytes());
}

/// Whether a number that a row lacks is null in it, not left out: what passive parts leave undetermined, and dry friction at rest
/// in a motion.
fn is_null(schema: &Schema, column: usize, form: Form) -> bool {
    let of_friction = |of: Quantity| matches!(of, Quantity::FrictionMoment | Quantity::FrictionForce);
    let has_friction = || schema.columns().iter().any(|column| of_friction(column.quantity));
    let Column { quantity, owner, .. } = schema.columns()[column];
    let undetermined = match quantity {
        Quantity::Force | Quantity::Moment => matches!(owner, Owner::Pair(_) | Owner::PairOn(..)),
        Quantity::Balancing => true,
        other => of_friction(other),
    };
    schema.is_nullable(column) || !form.numbered && undetermined && has_friction()
}

/// The text of a row, without its opening brace; of each column, whether the row has a number.
fn template(
    schema: &Schema,
    columns: impl Iterator<Item = (usize, bool)>,
    form: Form,
    ascii: bool,
) -> Template {
    let mut writer = Writer { text: String::new(), open: Vec::new(), ascii, any: form.numbered };
    let mut pieces = Vec::new();
    let columns = columns.filter(|(column, has)| *has || is_null(schema, *column, form));
    let path_of = |(column, has): (usize, bool)| {
        let mut found = path(schema, schema.columns()[column])?;
        if !has && matches!(found.last(), Some(PathStep::Item(_))) {
            // A vector is null as a whole.
            (found.pop() == Some(PathStep::Item(0))).then_some(())?;
        }
        Some(((column, has), found))
    };
    let paths: Vec<_> = columns.filter_map(path_of).collect();
    let mut paths = paths.into_iter().peekable();
    for key in KEYS.split(' ') {
        let under = |path: &[PathStep<'_>]| path[0] == PathStep::Key(key.into());
        if form.always.contains(&key) && !paths.peek().is_some_and(|(_, path)| under(path)) {
            writer.go(vec![PathStep::Key(key.into())]);
            writer.text += "{}";
        }
        while let Some(((column, has), path)) = paths.next_if(|(_, path)| under(path)) {
            writer.go(path);
            if has {
                pieces.push((std::mem::take(&mut writer.text), column));
            } else {
                writer.text += "null";
            }
        }
    }
    writer.close(0);
    Template { pieces, end: writer.text + "}" }
}

/// Text between the values of an object, which come in the order of their paths.
struct Writer<'a> {
    text: String,
    /// The path of the last value.
    open: Vec<PathStep<'a>>,
    ascii: bool,
    /// Whether the object has a value.
    any: bool,
}

impl<'a> Writer<'a> {
    /// Closes all objects and arrays below this depth.
    fn close(&mut self, depth: usize) {
        for step in self.open.iter().skip(depth + 1).rev() {
            self.text.push(if matches!(step, PathStep::Key(_)) { '}' } else { ']' });
        }
    }

    /// Text up to the value of this path.
    fn go(&mut self, path: Vec<PathStep<'a>>) {
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
                self.text.push(if matches!(step, PathStep::Key(_)) { '{' } else { '[' });
            }
            if let PathStep::Key(key) = step {
                self.text += &quoted(key, self.ascii);
                self.text.push(':');
            }
        }
        self.open = path;
    }
}
