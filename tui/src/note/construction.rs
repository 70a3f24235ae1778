//! The construction of the force analyzer, where it has one (L fig. 1): its stages as pictures, its steps as a table.

use assur_book::{Column, Document, Table, row};
use assur_figure::{Figure, Panel};
use assur_force::{Construction, ConstructionStep};
use assur_words::{joined, number, quantity, text};

use super::NoteError;
use super::context::Context;
use crate::number::digits;
use crate::screen::state::{View, ViewPart};

/// Height of a row of two stages, mm, and width of the page.
const STAGES: [f64; 2] = [165.0, 95.0];

/// The construction in the first of the chosen positions; nothing for an analyzer without one.
pub(super) fn construction(context: &mut Context<'_>, page: &mut Document) -> Result<(), NoteError> {
    let (position, place) = (context.positions[0], context.place(context.positions[0]));
    let found = context.found()?;
    let plans = found.plans.at(position);
    let own = plans.constructions.iter().position(|(method, _)| *method == found.analyzer);
    let Some((first, (_, drawn))) = own.map(|own| (plans.steps_of(own).start, &plans.constructions[own]))
    else {
        return Ok(());
    };
    let mut panels: Vec<Panel> = Vec::new();
    for last in stages(drawn) {
        let figure = context.figure(View::Plans, position, |state| {
            state.parts.insert(View::Plans, ViewPart::Construction);
            state.chosen.step = first + last;
        });
        let title = text!("note-construction-stage", last = number(last + 1));
        panels.extend(
            figure
                .into_iter()
                .flat_map(|(figure, _)| figure.panels)
                .map(|panel| Panel { title: title.clone(), ..panel }),
        );
    }
    let figure = Figure { panels, columns: 2, ..Figure::default() };
    let size = [STAGES[0], STAGES[1] * figure.rows() as f64];
    let caption = text!("note-construction", title = &drawn.title, place);
    page.figure(Some(figure).filter(|figure| !figure.panels.is_empty()), size, caption);
    page.table(steps(drawn, text!("note-construction-steps", title = &drawn.title)));
    Ok(())
}

/// The last steps of the stages: where forces follow points and lines, or the drawing changes.
fn stages(construction: &Construction) -> Vec<usize> {
    let stage = |step: &ConstructionStep| (step.drawing, step.unit == "N");
    let steps = &construction.steps;
    let ends =
        (0..steps.len()).filter(|at| steps.get(at + 1).is_none_or(|next| stage(next) != stage(&steps[*at])));
    // What a single point shows, the next stage shows too.
    ends.filter(|at| *at > 0).collect()
}

/// Every step: its vector and what it does.
fn steps(construction: &Construction, caption: assur_words::Text) -> Table {
    let heads = [text!("note-step"), text!("head-vector"), text!("note-size"), text!("head-acts")];
    let mut table = Table::list(caption, heads.map(Column::of));
    for (at, step) in construction.steps.iter().enumerate() {
        let length = step.vector[0].hypot(step.vector[1]);
        let size = if length > 0.0 { quantity(digits(length, 5), step.unit) } else { joined("", []) };
        table.row(row![number(at + 1), step.name.clone(), size, step.note.clone()]);
    }
    table
}
