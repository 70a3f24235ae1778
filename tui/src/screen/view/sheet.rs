//! The drawing sheet: its fields in their order, beside them the sheet with a box for each.

use assur_sheet::preview;
use assur_words::{Text, name, number, text};
use ratatui::layout::{Constraint, Layout, Rect};

use crate::screen::draw::{Pen, cut, wrapped};
use crate::screen::state::{Role, State};

/// Columns of the list of fields.
const LIST: u16 = 28;

pub(super) fn draw(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    let [list, sheet] = Layout::horizontal([Constraint::Length(LIST), Constraint::Min(0)]).areas(area);
    let Some(fields) = state.sheet_fields() else { return };
    let chosen = fields.get(state.chosen.field).map(|(field, _)| *field);
    for (row, (field, is_taken)) in (0_u16..).zip(&fields) {
        let place = if *is_taken { format!("{:>2}", row + 1) } else { " -".to_owned() };
        let (sign, role) = if Some(*field) == chosen { (">", Role::Chosen) } else { (" ", Role::Plain) };
        let line = format!("{sign}{place} {}", state.told(preview::name(*field)));
        pen.put(list, 0, row, &cut(&line, usize::from(LIST - 1)), role);
    }
    let Some(sheets) = state.sheets() else { return };
    match &*sheets {
        Ok(pages) => {
            let shown = state.chosen.sheet.min(pages.len().saturating_sub(1));
            let Some(page) = pages.get(shown) else { return };
            let [title, drawing] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(sheet);
            let format = name(format!("{:?}", page.format));
            let told = text!(
                "view-sheet-shown",
                number = number(shown + 1),
                count = number(pages.len()),
                format = format
            );
            pen.tell(title, 1, 0, told, Role::Header);
            pen.paint(&preview::figure(page, chosen), drawing);
        }
        Err(reason) => tell(pen, state, text!("view-sheet-none", reason = reason), sheet),
    }
}

fn tell(pen: &mut Pen<'_>, state: &State, told: Text, area: Rect) {
    let width = usize::from(area.width.saturating_sub(2)).max(1);
    let lines: Vec<_> =
        wrapped(&state.told(told), width).into_iter().map(|line| (Role::Plain, line)).collect();
    pen.put_lines(area, 1, &lines);
}
