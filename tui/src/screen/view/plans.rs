//! Plans of the position beside their vectors, and the constructions step by step.

use assur_book::{Block, Column, Table, row};
use assur_diagram::{PlanVector, VectorPlan};
use assur_force::Construction;
use assur_picture::plans::{self, Shown, labelled, shown};
use assur_report::text::Line;
use assur_words::{Describe, Text, joined, name, number, quantity, text, unit};
use ratatui::layout::{Constraint, Layout, Rect};

use super::{advice, page};
use crate::number::digits;
use crate::screen::draw::{Pen, wrapped};
use crate::screen::state::{Role, Scene, State, View, ViewPart};

/// Columns of the list beside the drawing.
const LIST: u16 = 42;

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let state = pen.state;
    let Some(found) = &scene.found else { return };
    let [list, drawing] = Layout::horizontal([Constraint::Length(LIST), Constraint::Min(0)]).areas(area);
    let plans = found.plans.at(state.position);
    let look = state.pictured();
    match shown(found, &look, state.part(View::Plans), &plans) {
        Shown::Plan(plan) => list_of_plan(pen, plan, list),
        Shown::Construction(construction, last) => list_of_steps(pen, construction, last, list),
        Shown::Nothing(_) => return advice::draw(pen, scene, View::Plans, area),
    }
    let mut figure = plans::figure(scene, &look, state.part(View::Plans));
    // Beside each other where that gives larger drawings than one below the other.
    let wide = f64::from(drawing.width) > state.look.ratio * f64::from(drawing.height);
    figure.columns = if wide { figure.panels.len() } else { 1 };
    pen.paint(&figure, drawing);
}

fn lines_of(pen: &mut Pen<'_>, lines: &[(Role, String)], area: Rect) {
    let cut = Rect { width: area.width.saturating_sub(1), ..area };
    pen.put_lines(cut, 1, lines);
}

/// How many vectors of the plan that is shown are out of sight below the first ones.
pub(crate) fn hidden(state: &State) -> usize {
    let found = state.found();
    let plans = found.map(|found| found.plans.at(state.position));
    let Some((found, plans)) = found.zip(plans.as_ref()) else { return 0 };
    match shown(found, &state.pictured(), state.part(View::Plans), plans) {
        // The closure error stands below.
        Shown::Plan(plan) => {
            (vectors(state, plan, LIST).len() + 1).saturating_sub(super::room(state).height.into())
        }
        _ => 0,
    }
}

/// The vectors of a plan in lines of a width.
fn vectors(state: &State, plan: &VectorPlan, width: u16) -> Vec<Line> {
    let part = state.part(View::Plans);
    let heads = [Text::default(), text!("head-vector"), text!("head-size"), text!("head-unit")];
    let row = |(label, item): (String, &PlanVector)| {
        row![name(label), item.name.clone(), item.size, unit(item.unit.clone())]
    };
    let vectors = labelled(part, plan).into_iter().map(row);
    let table = Table::list(Text::default(), heads.map(Column::of)).rows(vectors);
    page::told(state, width.saturating_sub(2), |page| {
        page.blocks.push(Block::Subheading(plan.title.clone()));
        if part == ViewPart::Forces {
            page.paragraph(text!("plans-key"));
        }
        page.table(table);
    })
}

/// The vectors of a plan, and its closure error.
fn list_of_plan(pen: &mut Pen<'_>, plan: &VectorPlan, list: Rect) {
    let state = pen.state;
    let lines = vectors(state, plan, list.width);
    // The closure error stands below; a long list must not push it out.
    let [above, below] = Layout::vertical([Constraint::Min(0), Constraint::Length(1)]).areas(list);
    page::draw_from(pen, &lines, state.chosen.row, above);
    let open = number(format_args!("{:.1e}", plan.residual));
    let open = (Role::Header, state.told(text!("plans-open", open = open)));
    lines_of(pen, &[open], below);
}

/// The chosen step of a construction, with the sentence that explains it.
fn list_of_steps(pen: &mut Pen<'_>, construction: &Construction, last: usize, list: Rect) {
    let state = pen.state;
    let width = usize::from(list.width.max(12)) - 2;
    let title = wrapped(&state.told(construction.title.clone()), width).into_iter();
    let mut rows: Vec<(Role, String)> = title.map(|line| (Role::Header, line)).collect();
    let next = state.keys.first("next-step");
    let [now, count] = [last + 1, construction.steps.len()].map(number);
    let told = text!("plans-step-of", step = now, count = count, key = name(next));
    rows.push((Role::Plain, state.told(told)));
    let Some(step) = construction.steps.get(last) else { return };
    let size = quantity(digits(step.vector[0].hypot(step.vector[1]), 5), step.unit.to_owned());
    let kind = joined("", [name("("), step.kind.describe(), name(")")]);
    rows.push((Role::Key, state.told(joined(" ", [step.name.clone(), kind, size]))));
    rows.extend(wrapped(&state.told(step.note.clone()), width).into_iter().map(|line| (Role::Plain, line)));
    lines_of(pen, &rows, list);
}
