//! Commands of the view of the sheet: its fields are switched and reordered, which `[sheet] fields` of the scene has then.

use assur_mechanism::Key;
use assur_scene::{SHEET_FIELDS, SheetField};

use super::draft;
use crate::screen::state::{State, round};

pub(super) fn choose(state: &mut State, by: isize) {
    state.chosen.field = round(state.chosen.field, by, SHEET_FIELDS.len());
}

/// Takes the chosen field as the last one, or leaves it out.
pub(super) fn switch(state: &mut State) {
    let Some((fields, chosen)) = fields(state) else { return };
    let (mut wanted, is_wanted) = (taken(&fields), chosen.1);
    if is_wanted {
        wanted.retain(|field| *field != chosen.0);
    } else {
        wanted.push(chosen.0);
    }
    write(state, &wanted, chosen.0);
}

/// Moves the chosen field among those that are taken.
pub(super) fn shift(state: &mut State, by: isize) {
    let Some((fields, (chosen, _))) = fields(state) else { return };
    let mut wanted = taken(&fields);
    let Some(at) = wanted.iter().position(|field| *field == chosen) else { return };
    if let Some(to) = at.checked_add_signed(by).filter(|to| *to < wanted.len()) {
        wanted.swap(at, to);
        write(state, &wanted, chosen);
    }
}

/// Shows the next of several sheets.
pub(super) fn turn(state: &mut State) {
    let count = state.sheets().map_or(1, |sheets| sheets.as_ref().as_ref().map_or(1, Vec::len));
    state.chosen.sheet = round(state.chosen.sheet, 1, count);
}

/// A field, and whether it is taken.
type Row = (SheetField, bool);

/// All fields, and the chosen one.
fn fields(state: &State) -> Option<(Vec<Row>, Row)> {
    let fields = state.sheet_fields()?;
    let chosen = *fields.get(state.chosen.field)?;
    Some((fields, chosen))
}

fn taken(fields: &[Row]) -> Vec<SheetField> {
    fields.iter().filter(|(_, is_taken)| *is_taken).map(|(field, _)| *field).collect()
}

/// Writes the fields into the text of the scene; the chosen one stays chosen.
fn write(state: &mut State, wanted: &[SheetField], chosen: SheetField) {
    let word = |field: &SheetField| SHEET_FIELDS.iter().find(|(_, own)| own == field).map(|(word, _)| *word);
    let words: Vec<String> = wanted.iter().filter_map(word).map(|word| format!("\"{word}\"")).collect();
    let toml = format!("[{}]", words.join(", "));
    let text = assur_draft::set(state.draft.text(), &Key::of("sheet").at("fields"), &toml);
    draft::take(state, text);
    let others = SHEET_FIELDS.iter().map(|(_, field)| *field).filter(|field| !wanted.contains(field));
    let order: Vec<SheetField> = wanted.iter().copied().chain(others).collect();
    state.chosen.field = order.iter().position(|field| *field == chosen).unwrap_or(0);
}
