//! Where new tables and keys go.

use std::ops::Range;

use assur_mechanism::Step;
use assur_scene::reference::TABLES;
use toml::de::DeValue;

use crate::layout::{Layout, line_end, line_start};
use crate::written::dotted;

/// The place of a key of the scene in the reference.
fn rank(step: &Step) -> usize {
    let keys = TABLES.first().map(|table| &table.keys[..]).unwrap_or_default();
    let is = |name: &str| matches!(step, Step::Name(own) if own == name);
    keys.iter().position(|key| is(key.name)).unwrap_or(usize::MAX)
}

/// How many steps of a key the header of its table has, as the reference writes it; 0: it is a key above all headers.
pub(crate) fn header_depth(steps: &[Step], value: &DeValue<'_>) -> usize {
    let tables = |list: &[toml::Spanned<DeValue<'_>>]| {
        !list.is_empty() && list.iter().all(|item| item.get_ref().is_table())
    };
    let is_list = match steps.get(1) {
        Some(second) => matches!(second, Step::Index(_)),
        None => value.as_array().is_some_and(|list| tables(list)),
    };
    let has_names =
        |first: &str| TABLES.iter().any(|table| table.header.ends_with(".NAME]") && table.name() == first);
    match steps.first() {
        _ if is_list => 2,
        _ if steps.len() == 1 && !value.is_table() => 0,
        Some(Step::Name(first)) if has_names(first) => 2,
        _ => 1,
    }
}

/// A header: `[link.crank]`, of an element of a list `[[force]]`.
pub(crate) fn header(path: &[Step]) -> String {
    let name = dotted(path);
    if matches!(path.last(), Some(Step::Index(_))) { format!("[[{name}]]") } else { format!("[{name}]") }
}

impl Layout<'_> {
    /// Where a new table begins: behind the last one of its list or kind, else behind the last one of those that the reference has
    /// just before it.
    pub(crate) fn place_of(&self, path: &[Step]) -> usize {
        let own = if matches!(path.last(), Some(Step::Index(_))) { &path[..path.len() - 1] } else { path };
        let of = |path: &[Step]| self.sections.iter().rposition(|section| section.path.starts_with(path));
        let before = || {
            let ranked = self.sections.iter().enumerate().skip(1).filter_map(|(index, section)| {
                let known = rank(section.path.first()?);
                (known < rank(&path[0])).then_some((known, index))
            });
            ranked.max().map(|(_, index)| index)
        };
        self.tail(of(own).or_else(|| of(&path[..1])).or_else(before).unwrap_or(0))
    }

    /// The text with a line below an entry of a section, or else below its header.
    pub(crate) fn with_line(&self, section: usize, entry: Option<usize>, line: &str) -> String {
        let section = &self.sections[section];
        let above = entry.map_or(section.header.clone(), |index| {
            let entry = &section.entries[index];
            entry.key.start..entry.value.end
        });
        let start = &self.text[line_start(self.text, above.start)..];
        let indent = &start[..start.len() - start.trim_start_matches([' ', '\t']).len()];
        self.with_lines(line_end(self.text, above.end), &format!("{indent}{line}"), false)
    }

    /// The text with a key above all headers, where the order of the reference has it.
    pub(crate) fn with_root_key(&self, step: &Step, line: &str) -> String {
        let entries = &self.sections[0].entries;
        let before = entries.iter().rposition(|entry| rank(&entry.path[0]) <= rank(step));
        match (before, entries.first()) {
            (Some(_), _) => self.with_line(0, before, line),
            (None, Some(first)) => self.with_lines(self.own_line(first.key.start), line, false),
            (None, None) => {
                let at = self.tail(0);
                let has_blank = self.text[at..].lines().next().is_none_or(|next| next.trim().is_empty());
                let apart = if has_blank { "" } else { "\n" };
                self.with_lines(at, &format!("{line}{apart}"), false)
            }
        }
    }

    /// Where the line of a place begins, behind a byte order mark.
    fn own_line(&self, at: usize) -> usize {
        line_start(self.text, at).max(self.sections[0].header.start)
    }

    /// The text with lines at a place where a line begins, or at its end; `apart`: with blank lines before and after them.
    pub(crate) fn with_lines(&self, at: usize, lines: &str, apart: bool) -> String {
        let (before, after) = self.text.split_at(at);
        let newline = self.newline();
        let is_first = at <= self.sections[0].header.start;
        let close = if is_first || before.ends_with('\n') { "" } else { newline };
        let is_blank = |line: Option<&str>| line.is_none_or(|line| line.trim().is_empty());
        let above = if apart && !is_first && !is_blank(before.lines().next_back()) { newline } else { "" };
        let below = if apart && !is_blank(after.lines().next()) { newline } else { "" };
        format!("{before}{close}{above}{}{newline}{below}{after}", lines.replace('\n', newline))
    }

    /// Lines with the blank ones after them, where there are blank ones before them; the last ones of the text with those before.
    pub(crate) fn with_blanks(&self, lines: Range<usize>) -> Range<usize> {
        let before = &self.text[self.sections[0].header.start.min(lines.start)..lines.start];
        let mut end = lines.end;
        while end < self.text.len() && self.text[end..line_end(self.text, end)].trim().is_empty() {
            end = line_end(self.text, end);
        }
        if end == self.text.len() {
            let kept = lines.start - before.len() + before.trim_end().len();
            let start = if before.trim().is_empty() { lines.start } else { line_end(self.text, kept) };
            return start..end;
        }
        let is_apart = before.lines().next_back().is_none_or(|line| line.trim().is_empty());
        lines.start..if is_apart { end } else { lines.end }
    }
}
