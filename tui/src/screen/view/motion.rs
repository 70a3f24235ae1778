//! Speed, acceleration, J, J', Q over the positions, or the motion over time; the numbers of the regime.

use assur_analysis::results::Analysis;
use assur_figure::Figure;
use assur_mechanism::Warning;
use assur_picture::motion::{figure, heading};
use assur_report::text::Line;
use assur_report::topic::{self, Source};
use assur_words::Text;
use ratatui::layout::{Constraint, Layout, Rect};

use super::page;
use crate::screen::draw::{Pen, short};
use crate::screen::state::{Found, Role, Scene, State, View, ViewPart};

/// Least number of rows of a readable chart.
const LEAST_ROWS: u16 = 5;
/// Columns for the numbers of the regime.
const NUMBERS: u16 = 30;
/// Rows that the curves below the table of the iteration need.
const ITERATION: u16 = 8;

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let state = pen.state;
    let Some(found) = &scene.found else { return };
    let (role, text) = (role(found), heading(found));
    let [title, area] =
        Layout::vertical([Constraint::Length(u16::from(!text.is_empty())), Constraint::Min(0)]).areas(area);
    pen.tell(title, 1, 0, text, role);
    // The tables need the whole width.
    if state.part(View::Motion) == ViewPart::Iteration {
        return iteration(pen, scene, found, area);
    }
    let lines = numbers(state, &found.analysis, NUMBERS - 1);
    let width = if lines.is_empty() { 0 } else { NUMBERS };
    let [charts, numbers] = Layout::horizontal([Constraint::Min(0), Constraint::Length(width)]).areas(area);
    page::draw(pen, &lines, 0, &|_| Role::Plain, numbers);
    let most = usize::from(charts.height.saturating_sub(2) / LEAST_ROWS);
    pen.paint(&figure(scene, &state.pictured(), state.part(View::Motion), most), charts);
}

/// How the regime was found, as the report tells it, and below it the same as curves where there is room.
fn iteration(pen: &mut Pen<'_>, scene: &Scene, found: &Found, area: Rect) {
    let lines = told(pen.state, scene, found, area.width);
    let rows = Constraint::Length(short(lines.len()) + 1);
    let [table, below] = Layout::vertical([rows, Constraint::Min(0)]).areas(area);
    page::draw(pen, &lines, pen.state.chosen.line, &|_| Role::Plain, table);
    if below.height >= ITERATION {
        pen.paint(
            &Figure { columns: 2, ..figure(scene, &pen.state.pictured(), ViewPart::Iteration, usize::MAX) },
            below,
        );
    }
}

/// How the regime was found and its motor chosen, in lines of a width.
pub(super) fn told(state: &State, scene: &Scene, found: &Found, width: u16) -> Vec<Line> {
    let source = Source::of(&found.analysis, &scene.linkage, Some(&[]));
    let of_motor = |note: &&Warning| note.text.identity() == Some("analysis-motors-passed-over");
    page::told(state, width.saturating_sub(2), |page| {
        topic::iteration(&source, page);
        found.analysis.warnings.iter().filter(of_motor).for_each(|note| page.paragraph(Text::from(note)));
    })
}

/// The numbers of the regime that have room beside its curves.
pub(super) fn numbers(state: &State, analysis: &Analysis, width: u16) -> Vec<Line> {
    let shown = [
        "fact-mean-speed",
        "fact-unevenness",
        "fact-least-speed",
        "fact-greatest-speed",
        "fact-excess-work",
        "fact-dynamic-unevenness",
        "fact-driving-moment",
        "fact-braking-moment",
        "fact-required-power",
        "fact-power-taken",
    ];
    page::some_facts(state, width, topic::regime_facts(analysis), &shown)
}

fn role(found: &Found) -> Role {
    match (&found.analysis.dynamics, &found.analysis.no_motion, &found.linkage.mechanism.motion) {
        (Some(_), ..) => Role::Header,
        (_, Some(_), _) => Role::Bad,
        (_, _, None) => Role::Dim,
        _ => Role::Plain,
    }
}
