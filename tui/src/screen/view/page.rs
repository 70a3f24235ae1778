//! What the report and the note tell, in the lines of a view: blocks of a document in the width of the terminal.

use assur_book::{Block, Document, Fact};
use assur_report::text::{Line, LineKind, Style, lines};
use assur_words::Text;
use ratatui::layout::Rect;

use crate::screen::draw::{Pen, short};
use crate::screen::state::{Role, State};

/// What a topic tells, in lines of a width. The view and its parts have names of their own, so headings and rules are left out.
pub(super) fn told(state: &State, width: u16, topic: impl FnOnce(&mut Document)) -> Vec<Line> {
    let mut page = Document::default();
    topic(&mut page);
    page.blocks.retain(|block| !matches!(block, Block::Title(_) | Block::Heading(_)));
    let style = Style { language: state.language(), ascii: false };
    let all = lines(&page.blocks, style, width.into()).into_iter();
    all.filter(|line| line.kind != LineKind::Rule).collect()
}

/// The facts that have one of these identities, in lines of a width.
pub(super) fn some_facts(state: &State, width: u16, facts: Vec<Fact>, ids: &[&str]) -> Vec<Line> {
    let shown = facts.into_iter().filter(|fact| ids.contains(&fact.id)).collect();
    told(state, width, |page| page.facts(Text::default(), shown))
}

/// Draws lines from one of them on, as far as that fills the area; `of_row`: the role of the row of a table.
pub(super) fn draw(
    pen: &mut Pen<'_>,
    lines: &[Line],
    from: usize,
    of_row: &dyn Fn(usize) -> Role,
    area: Rect,
) {
    let height = usize::from(area.height);
    let skip = from.min(lines.len().saturating_sub(height));
    put(pen, &lines[skip..], of_row, area);
    pen.mark_rows(area, skip..lines.len().min(skip + height), lines.len());
}

fn put(pen: &mut Pen<'_>, lines: &[Line], of_row: &dyn Fn(usize) -> Role, area: Rect) {
    let mut before = None;
    for (row, line) in lines.iter().take(area.height.into()).enumerate() {
        let role = match line.kind {
            LineKind::Heading => Role::Header,
            LineKind::Head => Role::Dim,
            LineKind::Row(number) => of_row(number),
            LineKind::Words | LineKind::Rule => Role::Plain,
        };
        pen.put(area, 1, short(row), &line.text, role);
        if role == Role::Cursor && before != Some(line.kind) {
            pen.put(area, 0, short(row), ">", role);
        }
        before = Some(line.kind);
    }
}

/// Draws a table of which a row is chosen: its head and the last `pinned` rows or paragraphs stay, and the chosen row is
/// in sight.
pub(super) fn draw_chosen(
    pen: &mut Pen<'_>,
    lines: &[Line],
    (chosen, pinned): (usize, usize),
    of_row: &dyn Fn(usize) -> Role,
    area: Rect,
) {
    let (head, rest) = parts(lines);
    let height = usize::from(area.height).saturating_sub(head.len());
    let last: usize =
        rest.chunk_by(|one, next| one.kind == next.kind).rev().take(pinned).map(<[Line]>::len).sum();
    let (rest, pinned) = rest.split_at(rest.len() - last.min(height));
    // What stands below the rows is in sight with the last one.
    let next = rest.iter().position(|line| line.kind == LineKind::Row(chosen + 1));
    let skip = next.unwrap_or(rest.len()).saturating_sub(height - pinned.len());
    let of_row = |row| if row == chosen { Role::Cursor } else { of_row(row) };
    put_rows(pen, [head, rest, pinned], skip, &of_row, area);
}

/// Draws a table from one of its lines on, as far as that fills the area; its head stays.
pub(super) fn draw_from(pen: &mut Pen<'_>, lines: &[Line], from: usize, area: Rect) {
    let (head, rest) = parts(lines);
    let height = usize::from(area.height).saturating_sub(head.len());
    let skip = from.min(rest.len().saturating_sub(height));
    put_rows(pen, [head, rest, &[]], skip, &|_| Role::Plain, area);
}

/// Draws a table without the first lines of its rows, between what stays above and below, and marks which rows are in sight.
fn put_rows(
    pen: &mut Pen<'_>,
    [head, rest, pinned]: [&[Line]; 3],
    skip: usize,
    of_row: &dyn Fn(usize) -> Role,
    area: Rect,
) {
    let room = usize::from(area.height).saturating_sub(head.len() + pinned.len());
    let shown = &rest[skip..rest.len().min(skip + room)];
    put(pen, &[head, shown, pinned].concat(), of_row, area);
    let rows = |lines: &[Line]| lines.chunk_by(|one, next| one.kind == next.kind).count();
    let (before, all) = (rows(&rest[..skip]), rows(rest));
    let (top, height) = (short(head.len()).min(area.height), short(room).min(area.height));
    let of_rows = Rect { y: area.y + top, height: height.min(area.height - top), ..area };
    pen.mark_rows(of_rows, before..all.min(before + rows(shown)), all);
}

/// What stands above the rows of a table, and the rows.
fn parts(lines: &[Line]) -> (&[Line], &[Line]) {
    lines.split_at(lines.iter().take_while(|line| !matches!(line.kind, LineKind::Row(_))).count())
}
