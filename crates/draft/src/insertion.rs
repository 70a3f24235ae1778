//! A text with a value that did not stand in it, or stood as a table with headers.

use assur_mechanism::Step;
use assur_scene::edit::replaced;
use toml::Spanned;
use toml::de::DeValue;

use crate::braces::Braces;
use crate::find::Found;
use crate::layout::{Entry, Layout, line_end};
use crate::place::{header, header_depth};
use crate::written::{dotted, nested, pairs};

impl Layout<'_> {
    /// The text with a value at a key that doesn't stand; `None` where there is no place for it.
    pub(crate) fn inserted(
        &self,
        found: &Found<'_, '_>,
        (toml, value): (&str, &Spanned<DeValue<'_>>),
    ) -> Option<String> {
        let (steps, depth) = (&found.steps[..], found.depth);
        let step = steps.get(depth)?;
        let is_list = match found.value.map(Spanned::get_ref) {
            None | Some(DeValue::Table(_)) if matches!(step, Step::Name(_)) => false,
            Some(DeValue::Array(list)) if *step == Step::Index(list.len()) => true,
            _ => return None,
        };
        let rest = nested(&steps[depth + 1..], toml)?;
        let line = |from: usize| format!("{} = {rest}", dotted(&steps[from..=depth]));
        if let Some((outer, braces)) = found.braces {
            let item = if is_list { rest } else { line(outer) };
            return Some(Braces::of(self.text, braces).with(&item, self.newline()));
        }
        if !is_list && depth > 0 {
            if let Some((section, entry)) = self.last_line(found.standing()) {
                return Some(self.with_line(section, Some(entry), &line(self.sections[section].path.len())));
            }
            if let Some(section) = self.section(found.standing()) {
                let last = self.sections[section].entries.len().checked_sub(1);
                return Some(self.with_line(section, last, &line(depth)));
            }
        }
        let header = if is_list { depth + 1 } else { header_depth(steps, value.get_ref()).max(depth) };
        self.with_tables(steps, header, (toml, value))
    }

    /// The section of a table that is written by longer keys (`points.A = 0`), and the last of these there.
    pub(crate) fn last_line(&self, path: &[Step]) -> Option<(usize, usize)> {
        self.sections.iter().enumerate().find_map(|(index, section)| {
            let is_within = |entry: &Entry| entry.path.starts_with(path);
            let own = section.path.len() < path.len();
            Some((index, section.entries.iter().rposition(|entry| own && is_within(entry))?))
        })
    }

    /// The text with a value at a key whose header has so many steps; a line above all headers where the value is no table.
    fn with_tables(
        &self,
        steps: &[Step],
        depth: usize,
        (toml, value): (&str, &Spanned<DeValue<'_>>),
    ) -> Option<String> {
        let lines = if steps.len() > depth && depth > 0 {
            vec![format!("{} = {}", dotted(&steps[depth..=depth]), nested(&steps[depth + 1..], toml)?)]
        } else if steps.len() == depth && value.get_ref().is_table() {
            pairs(toml, value)
        } else if let (true, Some(inner)) = (steps.len() + 1 == depth, children(toml, value)) {
            return inner.into_iter().try_fold(self.text.to_owned(), |text, (step, toml)| {
                let layout = Layout::of(&text).ok()?;
                let steps = [steps, &[step]].concat();
                layout.with_tables(&steps, depth, (&toml, &DeValue::parse(&toml).ok()?))
            });
        } else {
            let line = format!("{} = {}", dotted(&steps[..1]), nested(&steps[1..], toml)?);
            return Some(self.with_root_key(&steps[0], &line));
        };
        let path = &steps[..depth];
        let table = [&[header(path)], &lines[..]].concat().join("\n");
        Some(self.with_lines(self.place_of(path), &table, true))
    }

    /// The text with another table in the place of one with a header; `None` where there is none.
    pub(crate) fn with_table(
        &self,
        path: &[Step],
        (toml, value): (&str, &Spanned<DeValue<'_>>),
    ) -> Option<String> {
        let index = self.section(path).filter(|_| value.get_ref().is_table())?;
        let own = line_end(self.text, self.sections[index].header.end)..self.content_end(index);
        let lines: String = pairs(toml, value).into_iter().map(|line| line + self.newline()).collect();
        let mut spans: Vec<_> =
            self.spans_of_sections(path, Some(index)).into_iter().map(|span| (span, "")).collect();
        spans.push((own, &lines));
        Some(replaced(self.text, spans.iter().map(|(span, lines)| (span, *lines))))
    }
}

/// The tables in a table or list, with their steps; `None` if there is something else in it.
fn children(toml: &str, value: &Spanned<DeValue<'_>>) -> Option<Vec<(Step, String)>> {
    let of = |step: Step, value: &Spanned<DeValue<'_>>| {
        value.get_ref().is_table().then(|| (step, format!("{{ {} }}", pairs(toml, value).join(", "))))
    };
    match value.get_ref() {
        DeValue::Table(table) => {
            let mut all: Vec<_> = table.iter().collect();
            all.sort_by_key(|(key, _)| key.span().start);
            all.into_iter().map(|(key, value)| of(key.get_ref().as_ref().into(), value)).collect()
        }
        DeValue::Array(list) => {
            list.iter().enumerate().map(|(index, value)| of(index.into(), value)).collect()
        }
        _ => None,
    }
}
