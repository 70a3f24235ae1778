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

/// Draws lines from the first one that is shown; `of_row`: the role of the row of a table.
pub(super) fn draw(pen: &mut Pen<'_>, lines: &[Line], of_row: &dyn Fn(usize) -> Role, area: Rect) {
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
    let height = height - pinned.len();
    // What stands below the rows is in sight with the last one.
    let next = rest.iter().position(|line| line.kind == LineKind::Row(chosen + 1));
    let skip = next.unwrap_or(rest.len()).saturating_sub(height);
    let shown = head.iter().chain(rest.iter().skip(skip).take(height)).chain(pinned);
    let shown: Vec<Line> = shown.cloned().collect();
    let of_row = |row| if row == chosen { Role::Cursor } else { of_row(row) };
    draw(pen, &shown, &of_row, area);
}

/// Draws a table from one of its lines on, as far as that fills the area; its head stays.
pub(super) fn draw_from(pen: &mut Pen<'_>, lines: &[Line], from: usize, area: Rect) {
    let (head, rest) = parts(lines);
    let height = usize::from(area.height).saturating_sub(head.len());
    let skip = from.min(rest.len().saturating_sub(height));
    let shown: Vec<Line> = head.iter().chain(&rest[skip..]).cloned().collect();
    draw(pen, &shown, &|_| Role::Plain, area);
}

/// What stands above the rows of a table, and the rows.
fn parts(lines: &[Line]) -> (&[Line], &[Line]) {
    lines.split_at(lines.iter().take_while(|line| !matches!(line.kind, LineKind::Row(_))).count())
}
