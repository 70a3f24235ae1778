//! What is left of a text without a key.

use std::ops::Range;

use assur_mechanism::{Key, Step};
use assur_scene::edit::replaced;

use crate::braces::{Braces, leaves};
use crate::find::Found;
use crate::layout::{Layout, in_one_piece, line_end, line_start};

impl Layout<'_> {
    /// The text without what was found; `None` where not all of the key stands.
    pub(crate) fn without(&self, found: &Found<'_, '_>) -> Option<String> {
        let value = found.value.filter(|_| found.stands())?;
        let path = found.standing();
        if let Some((depth, _)) = found.owner {
            let ends: Vec<usize> = if in_one_piece(self.text, value) {
                vec![value.span().end]
            } else {
                leaves(self.text, value).iter().map(|item| item.value.span().end).collect()
            };
            return self.without_items(&path[..depth], &ends);
        }
        let mut removed = self.spans_of_sections(path, None);
        removed.extend(self.lines_of(path));
        Some(replaced(self.text, removed.iter().map(|span| (span, ""))))
    }

    /// The text without those items of a list or table in braces that end at these places, or whose value does.
    fn without_items(&self, owner: &[Step], ends: &[usize]) -> Option<String> {
        let mut text = self.text.to_owned();
        let items = Braces::of(self.text, self.find(&Key::from(owner)).value?).ending_at(ends);
        for index in items.into_iter().rev() {
            let layout = Layout::of(&text).ok()?;
            let braces = Braces::of(&text, layout.find(&Key::from(owner)).value?);
            let rest = braces.without(index);
            text = rest;
        }
        Some(text)
    }

    /// The lines of a key, or of the longer keys of a table, that stand below headers of other tables.
    fn lines_of(&self, path: &[Step]) -> impl Iterator<Item = Range<usize>> {
        let others = self.sections.iter().filter(move |section| !section.path.starts_with(path));
        let entries = others.flat_map(|section| &section.entries);
        entries.filter(move |entry| entry.path.starts_with(path)).map(|entry| {
            let start = line_start(self.text, entry.key.start).max(self.sections[0].header.start);
            start..line_end(self.text, entry.value.end)
        })
    }

    /// The bytes of all sections of a table with the comments above them, but of one of them not, and the blank lines that they leave.
    pub(crate) fn spans_of_sections(&self, path: &[Step], except: Option<usize>) -> Vec<Range<usize>> {
        let is_removed = |index: usize| {
            let section = self.sections.get(index).filter(|_| index > 0 && except != Some(index));
            section.is_some_and(|section| section.path.starts_with(path))
        };
        let mut spans = Vec::new();
        for first in (1..self.sections.len()).filter(|&index| is_removed(index) && !is_removed(index - 1)) {
            let last =
                (first..self.sections.len()).take_while(|&index| is_removed(index)).last().unwrap_or(first);
            spans.push(self.with_blanks(self.lead(first)..self.tail(last)));
        }
        spans
    }
}
