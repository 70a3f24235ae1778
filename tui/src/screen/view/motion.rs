//! Speed, acceleration, J, J', Q over the positions, or the course over time; the numbers of the regime.

use assur_analysis::results::{Analysis, Column, Owner, Quantity};
use assur_book::{Course, catalogue};
use assur_figure::{Axis, Cursor, Figure, Panel};
use assur_mechanism::Notice;
use assur_report::text::Line;
use assur_report::topic::{self, Source};
use assur_words::{self as words, Text, joined, list, quantity, text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{advice, curves, page, plots, reduction, regime};
use crate::number::number;
use crate::screen::draw::{paint, put, short};
use crate::screen::state::{Found, Role, Scene, State, View, ViewPart};

/// Least number of rows of a readable chart.
const LEAST_ROWS: u16 = 5;
/// Columns for the numbers of the regime.
const NUMBERS: u16 = 30;
/// Rows that the curves below the table of the iteration need.
const ITERATION: u16 = 8;

pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &scene.found else { return };
    let (role, text) = heading(scene, found);
    let [title, area] =
        Layout::vertical([Constraint::Length(u16::from(!text.is_empty())), Constraint::Min(0)]).areas(area);
    put(buffer, title, 1, 0, &state.told(text), state.look.theme.style(role));
    // The tables need the whole width.
    if state.part(View::Motion) == ViewPart::Iteration {
        return iteration(state, scene, found, area, buffer);
    }
    let lines = numbers(state, &found.analysis, NUMBERS - 1);
    let width = if lines.is_empty() { 0 } else { NUMBERS };
    let [charts, numbers] = Layout::horizontal([Constraint::Min(0), Constraint::Length(width)]).areas(area);
    page::draw(state, &lines, &|_| Role::Plain, numbers, buffer);
    let most = usize::from(charts.height.saturating_sub(2) / LEAST_ROWS);
    paint(state, &figure(state, scene, most), charts, buffer);
}

/// How the regime was found, as the report tells it, and below it the same as curves where there is room.
fn iteration(state: &State, scene: &Scene, found: &Found, area: Rect, buffer: &mut Buffer) {
    let lines = told(state, scene, found, area.width);
    let skip = state.chosen.line.min(lines.len().saturating_sub(area.height.into()));
    let rows = Constraint::Length(short(lines.len()) + 1);
    let [table, below] = Layout::vertical([rows, Constraint::Min(0)]).areas(area);
    page::draw(state, &lines[skip..], &|_| Role::Plain, table, buffer);
    if below.height >= ITERATION {
        paint(state, &Figure { columns: 2, ..figure(state, scene, usize::MAX) }, below, buffer);
    }
}

/// How the regime was found and its motor chosen, in lines of a width.
pub(super) fn told(state: &State, scene: &Scene, found: &Found, width: u16) -> Vec<Line> {
    let source = Source::of(&found.analysis, &scene.linkage, Some(&[]));
    let of_motor = |note: &&Notice| note.text.identity() == Some("analysis-motors-passed-over");
    page::told(state, width.saturating_sub(2), |page| {
        topic::iteration(&source, page);
        found.analysis.notes.iter().filter(of_motor).for_each(|note| page.paragraph(Text::from(note)));
    })
}

/// Speed, acceleration, J, J', Q over the positions (at most `most`), or the course over time.
pub(super) fn figure(state: &State, scene: &Scene, most: usize) -> Figure {
    let Some(found) = &scene.found else { return Figure::default() };
    let regime = found.analysis.dynamics.as_ref().map(|dynamics| &dynamics.regime);
    let panels = match (regime, state.part(View::Motion)) {
        (_, ViewPart::Reduction) => reduction::panels(state, scene, found),
        (Some(regime), ViewPart::Iteration) => regime::iteration(regime),
        (Some(regime), ViewPart::Course) => regime::course(state, scene, found, regime),
        (_, part) if part != ViewPart::Overview || found.motion.is_empty() => course(state, found),
        _ => {
            let shown = most.clamp(1, found.motion.len());
            let from_chosen = found.motion.iter().cycle().skip(state.chosen.motion % found.motion.len());
            let wanted: Vec<usize> = from_chosen.take(shown).copied().collect();
            curves::stack(state, scene, found, None, &wanted)
        }
    };
    let columns = if state.part(View::Motion) == ViewPart::Reduction { 2 } else { 1 };
    Figure { title: heading(scene, found).1, panels, columns, legend: Vec::new() }
}

/// The most important line: the unevenness of a regime, or why there is no speed.
fn heading(scene: &Scene, found: &Found) -> (Role, Text) {
    if found.analysis.dynamics.is_some() {
        let facts = topic::regime_facts(&found.analysis);
        return (Role::Header, page::in_a_line(&facts, &["fact-unevenness", "fact-mean-speed"]));
    }
    match (&found.analysis.no_motion, &scene.linkage.mechanism.motion) {
        (Some(reason), _) => (Role::Bad, advice::not_found(reason, " ")),
        (None, None) => (Role::Dim, text!("motion-none")),
        (None, Some(_)) => (Role::Plain, Text::default()),
    }
}

/// Coordinate, speed, acceleration and energies over time.
fn course(state: &State, found: &Found) -> Vec<Panel> {
    let analysis = &found.analysis;
    let q = if analysis.input.angular { "rad" } else { "m" };
    let all = [
        ("motion-coordinate", q.to_owned(), Quantity::Transfer(0)),
        ("motion-speed", format!("{q}/s"), Quantity::Velocity),
        ("motion-acceleration", format!("{q}/s2"), Quantity::Acceleration),
    ];
    let time = Column::of(Quantity::Time, Owner::Input);
    let Some(last) = analysis.trajectory.len().checked_sub(1) else { return Vec::new() };
    let row = state.position.min(last);
    let Some(now) = analysis.trajectory.get(row, time) else { return Vec::new() };
    let times = (0..=last).filter_map(|row| analysis.trajectory.get(row, time));
    let x = Axis::around(text!("motion-time"), times, 0.0);
    let panel = |(told, unit, of): (&'static str, String, Quantity)| {
        let course = regime::sampled(found, time, of);
        let value = course.between(now).unwrap_or(f64::NAN);
        let cursor = Cursor { at: now, value: quantity(number(value), unit) };
        plots::curves(text!(told), vec![(text!(told), course)], (x.clone(), 1.0), Some(cursor))
    };
    let energies = regime::energies(found, time, (x.clone(), 1.0), now);
    all.map(panel).into_iter().chain(energies).chain(loads_over_way(found, row)).collect()
}

/// The moments of drive and loads, reduced to the input, over its way (E fig. 3): what drives along the motion, what resists
/// against it, so that it is seen where they are equal; of many the first ones.
fn loads_over_way(found: &Found, row: usize) -> Option<Panel> {
    /// Curves in one panel.
    const MOST: usize = 3;
    let (analysis, place) = (&found.analysis, Column::COORDINATE);
    let table = &analysis.trajectory;
    let (schema, last) = (table.schema(), table.len().checked_sub(1)?);
    let sense = (table.get(last, place)? - table.get(0, place)?).signum();
    let curve = |owner| {
        let column = Column::of(Quantity::ReducedLoad, owner);
        let resists = table.get(last, Column::of(Quantity::Work, owner)).is_some_and(|work| work < 0.0);
        let course = regime::over_samples(found, place, column, if resists { -sense } else { sense });
        let told =
            if let Owner::Load(_) = owner { schema.named(owner)?.into() } else { catalogue::kind(column) };
        let told = if resists { text!("regime-against", load = told) } else { told };
        (!course.is_empty()).then_some((told, course))
    };
    let owners = schema.owners(Quantity::ReducedLoad);
    let curves: Vec<(Text, Course)> = owners.into_iter().filter_map(curve).take(MOST).collect();
    let now = table.get(row, place).filter(|_| !curves.is_empty())?;
    let unit = if analysis.input.angular { "rad" } else { "m" };
    let told = list([text!("motion-coordinate"), words::unit(unit)]);
    let x = Axis::around(told, (0..table.len()).filter_map(|row| table.get(row, place)), 0.0);
    // Several curves name themselves.
    let alone = curves.iter().map(|(told, _)| told.clone()).filter(|_| curves.len() == 1);
    let title = joined(": ", std::iter::once(text!("motion-loads")).chain(alone));
    Some(plots::curves(title, curves, (x, 1.0), Some(now.into())))
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
