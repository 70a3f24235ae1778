//! A form: its fields, the sentence on the chosen one or what is wrong with it, and the file below.

use assur_figure::{Axis, Figure, Frame, Ink, Item, Panel, Stroke};
use assur_words::{Text, joined, list, name, text, unit};
use ratatui::layout::{Constraint, Layout, Rect};

use super::build::{FILE, state_of};
use super::{file, values};
use crate::screen::draw::{Pen, cut, short, wrapped};
use crate::screen::state::{FormSource, FormTask, Role, State};

/// Rows for the sentence on the chosen field; the help has a longer one whole.
const ABOUT: usize = 5;

/// The curve of the rows that are filled in, in the units of their columns.
pub(super) fn curve(state: &State) -> Option<Figure> {
    let FormSource::Rows(at) = &state.build.form()?.source else { return None };
    let rows = assur_form::rows(state.draft.text(), at)?;
    let [x, y] = [0, 1].map(|axis| {
        let label = list([rows.columns[axis].what.clone(), unit(rows.columns[axis].unit)]);
        Axis::around(label, rows.curve.iter().map(|point| point[axis]), 0.0)
    });
    let items = vec![Item::line(rows.curve.clone(), Stroke::Solid, Ink::First)];
    let frame = Frame::Axes { x, y, cursor: None };
    Some(Figure::of(Panel { title: Text::default(), frame, items }))
}

/// A form: its fields, the sentence on the chosen one or what is wrong with it, and the file below.
pub(super) fn draw(pen: &mut Pen<'_>, form: &FormTask, area: Rect) {
    let state = pen.state;
    let width = usize::from(area.width);
    let about: Vec<(Role, String)> = of_field(state, form, width);
    let rows = form.rows.len() + 1;
    let most = usize::from(area.height).saturating_sub(about.len() + usize::from(FILE));
    let shown = rows.min(most.max(4));
    let [top, below, below_all] = Layout::vertical([
        Constraint::Length(short(shown)),
        Constraint::Length(short(about.len())),
        Constraint::Min(0),
    ])
    .areas(area);
    pen.put(top, 0, 0, &state.told(form.heading.clone()), Role::Header);
    let list = Rect { y: top.y + 1, height: top.height.saturating_sub(1), ..top };
    let height = usize::from(list.height);
    let skip = (form.chosen + 1).saturating_sub(height);
    let widest = form.rows.iter().map(|row| row.label.chars().count()).max().unwrap_or(0).min(width / 2);
    for (row, (index, field)) in form.rows.iter().enumerate().skip(skip).take(height).enumerate() {
        let is_chosen = index == form.chosen;
        let entry = form.entry.as_ref().filter(|_| is_chosen);
        let value = entry.map_or(field.value.as_str(), |entry| entry);
        let label = values::tail(&field.label, widest);
        let sign = if is_chosen { '>' } else { ' ' };
        let room = width.saturating_sub(widest + 3);
        let value = if entry.is_some() {
            format!("{}_", values::tail(value, room.saturating_sub(1)))
        } else {
            cut(value, room)
        };
        let role = match (is_chosen, field.stands) {
            (true, _) => Role::Cursor,
            (_, true) => Role::Plain,
            _ => Role::Dim,
        };
        pen.put(list, 0, short(row), &format!("{sign}{label:<widest$}  {value}"), role);
    }
    pen.mark_rows(list, skip..form.rows.len().min(skip + height), form.rows.len());
    pen.put_lines(below, 0, &about);
    file::draw(pen, below_all);
}

/// The sentence on the chosen field, with what it may be; or why what is typed is not taken.
fn of_field(state: &State, form: &FormTask, width: usize) -> Vec<(Role, String)> {
    let mut lines = Vec::new();
    let mut tell = |role: Role, text: Text| {
        lines.extend(wrapped(&state.told(text), width).into_iter().map(|line| (role, line)));
    };
    if let Some(fault) = &form.fault {
        tell(Role::Bad, fault.clone());
    } else if let Some(field) = form.field() {
        tell(Role::Dim, field.about.clone());
        let limits = Some(&field.limits).filter(|limits| !limits.is_empty());
        let values = std::iter::once(&field.values).chain(limits).cloned();
        tell(Role::Dim, joined("; ", values));
        if matches!(form.source, FormSource::Rows(_)) {
            tell(Role::Dim, text!("build-row-keys"));
        }
    } else if let FormSource::Rows(_) = form.source {
        tell(Role::Dim, text!("build-row-keys"));
    } else {
        tell(Role::Dim, text!("build-field-name"));
    }
    if lines.len() > ABOUT {
        lines.truncate(ABOUT - 1);
        let more = state.told(text!("build-about-more", key = name(state.keys.first("help"))));
        lines.push((Role::Key, cut(&more, width)));
    }
    lines
        .into_iter()
        .chain(state_of(state, width).into_iter().filter(|(role, _)| *role == Role::Bad).take(3))
        .collect()
}
