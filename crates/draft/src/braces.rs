//! Lists and tables in brackets and braces: `[0, 1]`, `{ a = 1 }`, on one line or several.

use std::ops::Range;

use assur_mechanism::Step;
use toml::Spanned;
use toml::de::DeValue;

use crate::layout::{in_one_piece, line_start};

/// A list or table in one piece, with its items.
pub(crate) struct Braces<'a, 't> {
    text: &'t str,
    span: Range<usize>,
    pub(crate) items: Vec<Item<'a, 't>>,
}

/// An item of a list or table.
pub(crate) struct Item<'a, 't> {
    /// Its steps from the list or table.
    pub(crate) path: Vec<Step>,
    pub(crate) value: &'a Spanned<DeValue<'t>>,
    /// Of a table from the key to the end of the value.
    pub(crate) span: Range<usize>,
}

impl<'a, 't> Braces<'a, 't> {
    /// The items of a value; none of one that is neither a list nor a table.
    pub(crate) fn of(text: &'t str, value: &'a Spanned<DeValue<'t>>) -> Self {
        let mut items = leaves(text, value);
        let mut from = value.span().start + 1;
        for item in &mut items {
            let end = item.value.span().end.max(from);
            let start = from + trivia(text.get(from..end).unwrap_or_default());
            item.span = start..end;
            from = end;
        }
        Self { text, span: value.span(), items }
    }

    /// The steps to the item at a place.
    pub(crate) fn at(self, at: usize) -> Option<Vec<Step>> {
        self.items.into_iter().find(|item| item.span.contains(&at)).map(|item| item.path)
    }

    /// The items that end at these places.
    pub(crate) fn ending_at(&self, ends: &[usize]) -> Vec<usize> {
        (0..self.items.len()).filter(|&index| ends.contains(&self.items[index].span.end)).collect()
    }

    /// The text with a further item at the end, as the last one stands: behind it or on a line of its own.
    pub(crate) fn with(&self, item: &str, newline: &str) -> String {
        let (text, inside) = (self.text, self.span.start + 1..self.span.end - 1);
        let Some(last) = self.items.last().map(|item| &item.span) else {
            let pad = if text[self.span.start..].starts_with('{') { " " } else { "" };
            let is_blank = text[inside.clone()].trim().is_empty();
            let end = if is_blank { inside.end } else { inside.start };
            return format!("{}{pad}{item}{pad}{}", &text[..inside.start], &text[end..]);
        };
        let before = self.items.len().checked_sub(2).map_or(inside.start, |index| self.items[index].span.end);
        let gap = &text[before..last.start];
        let rest = &text[last.end..inside.end];
        let Some(break_at) = gap.rfind('\n') else {
            return format!("{}, {item}{}", &text[..last.end], &text[last.end..]);
        };
        let indent = &gap[break_at + 1..];
        let indent = &indent[..indent.len() - indent.trim_start().len()];
        let is_closed = rest.lines().any(|line| line.split('#').next().unwrap_or_default().contains(','));
        let (comma, end) = if is_closed { ("", ",") } else { (",", "") };
        let line = rest.find('\n').map_or(rest.trim_end(), |at| rest[..at].trim_end());
        let rest = &text[last.end + line.len()..];
        format!("{}{comma}{line}{newline}{indent}{item}{end}{rest}", &text[..last.end])
    }

    /// The text without an item.
    pub(crate) fn without(&self, index: usize) -> String {
        let (text, item) = (self.text, &self.items[index].span);
        let removed = if let Some(lines) = self.own_lines(item) {
            lines
        } else if self.items.len() == 1 {
            self.span.start + 1..self.span.end - 1
        } else if index == 0 {
            item.start..self.items[1].span.start
        } else {
            self.items[index - 1].span.end..item.end
        };
        format!("{}{}", &text[..removed.start], &text[removed.end..])
    }

    /// The lines of an item that has them for itself.
    fn own_lines(&self, item: &Range<usize>) -> Option<Range<usize>> {
        let start = line_start(self.text, item.start);
        let after = &self.text[item.end..self.span.end];
        let line = &after[..after.find('\n')?];
        let behind = line.trim_start();
        let behind = behind.strip_prefix(',').unwrap_or(behind).trim();
        let is_own = start > self.span.start && self.text[start..item.start].trim().is_empty();
        (is_own && (behind.is_empty() || behind.starts_with('#'))).then(|| start..item.end + line.len() + 1)
    }
}

/// The items of a list, or the keys of a table with their values: those of a table that is written by longer keys (`a.b = 1`) in its
/// place. In the order of the text; without their own places.
pub(crate) fn leaves<'a, 't>(text: &str, value: &'a Spanned<DeValue<'t>>) -> Vec<Item<'a, 't>> {
    let mut items: Vec<Item<'a, 't>> = match value.get_ref() {
        DeValue::Array(array) => {
            let item = |(index, value)| Item { path: vec![Step::Index(index)], value, span: 0..0 };
            array.iter().enumerate().map(item).collect()
        }
        DeValue::Table(table) => table
            .iter()
            .flat_map(|(key, value)| {
                let name = Step::from(key.get_ref().as_ref());
                if in_one_piece(text, value) {
                    return vec![Item { path: vec![name], value, span: 0..0 }];
                }
                let mut inner = leaves(text, value);
                for item in &mut inner {
                    item.path.insert(0, name.clone());
                }
                inner
            })
            .collect(),
        _ => Vec::new(),
    };
    items.sort_by_key(|item| item.value.span().end);
    items
}

/// Length of the spaces, commas and comments at the beginning.
fn trivia(text: &str) -> usize {
    let mut rest = text;
    loop {
        rest = rest.trim_start_matches(|c: char| c.is_ascii_whitespace() || c == ',');
        if !rest.starts_with('#') {
            return text.len() - rest.len();
        }
        rest = &rest[rest.find('\n').unwrap_or(rest.len())..];
    }
}
