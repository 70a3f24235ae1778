//! The chart as a figure.

use assur_book::{Cell, row};
use assur_figure::cells::{self, Look, Marker};
use assur_figure::{
    Axis, AxisKind, Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Sign, Stroke, Zoom, extent,
};
use assur_report::text::{Style, columns};
use assur_words::{Describe, Text, name, number, text, unit};

use super::{ChartData, Measurement, Stage, units};

/// Explanation of the line that joins the best rows.
const FRONT: Text = text!("chart-front");

/// Least error that is drawn: below it two results differ by rounding alone.
const LEAST_ERROR: f64 = 1e-17;

/// Error over time of every method, a panel for each stage, both axes logarithmic, with the Pareto front.
pub fn figure(data: &ChartData) -> Figure {
    let panels: Vec<Panel> = Stage::ALL.into_iter().filter_map(|stage| panel(data, stage)).collect();
    let legend = vec![
        Key { sample: Sample::Sign(Sign::Dot, Ink::First), text: text!("chart-point") },
        Key { sample: Sample::Line(Stroke::Chain, Ink::Text), text: FRONT },
    ];
    Figure { title: name(data.title.clone()), columns: if panels.len() > 2 { 2 } else { 1 }, panels, legend }
}

/// The methods of a stage that have a time and an error; `None` if there are none.
fn panel(data: &ChartData, stage: Stage) -> Option<Panel> {
    let rows: Vec<(&Measurement, Point)> = data
        .of(stage)
        .filter_map(|row| row.point().map(|(seconds, error)| (row, [seconds, error.max(LEAST_ERROR)])))
        .collect();
    let axis = |label: Text, at: usize| {
        let [low, high] = extent(rows.iter().map(|(_, place)| place[at]))?;
        // Whole powers of ten.
        let range = [10.0_f64.powf(low.log10().floor()), 10.0_f64.powf(high.log10().floor() + 1.0)];
        Some(Axis { label, range, kind: AxisKind::Logarithmic })
    };
    let time = text!("chart-time-axis", work = stage.work(), unit = unit("s"));
    let (x, y) = (axis(time, 0)?, axis(text!("chart-error-axis"), 1)?);
    let mut methods: Vec<&str> = rows.iter().map(|(row, _)| row.method.as_str()).collect();
    methods.sort_unstable();
    methods.dedup();
    let mut items = Vec::new();
    for (number, method) in methods.iter().enumerate() {
        let ink = Ink::Link(number + 1);
        let of_method = rows.iter().filter(|(row, _)| row.method == *method);
        let points: Vec<Point> = of_method.map(|(_, place)| *place).collect();
        items.extend(points.iter().map(|at| Item::sign(*at, Sign::Dot, ink)));
        let exact = points.iter().copied().min_by(|one, other| one[1].total_cmp(&other[1]));
        items.extend(exact.map(|at| Item::name(at, name((*method).to_owned()), ink)));
        items.push(Item::line(points, Stroke::Solid, ink));
    }
    let mut front: Vec<Point> = rows.iter().filter(|(row, _)| row.front).map(|(_, place)| *place).collect();
    front.sort_by(|one, other| one[0].total_cmp(&other[0]));
    items.push(Item::line(front, Stroke::Chain, Ink::Text));
    let title = text!("chart-panel", stage = stage.heading(), work = stage.work(), unit = unit("s"));
    Some(Panel { title, frame: Frame::Axes { x, y, cursor: None }, items })
}

/// The panel of a stage in `width` columns and `height` rows of characters; empty for a stage without a time and an error.
pub(super) fn drawn(
    data: &ChartData,
    stage: Stage,
    [width, height]: [u16; 2],
    style: Style<'static>,
) -> String {
    let Some(panel) = panel(data, stage) else { return String::new() };
    let Style { language, ascii } = style;
    let marker = if ascii { Marker::Ascii } else { Marker::Braille };
    let look = Look { marker, ratio: 2.0, zoom: Zoom::WHOLE, language };
    let mut lines = vec![vec![' '; usize::from(width)]; usize::from(height)];
    for spot in cells::draw(&Figure::of(panel), [width, height], look) {
        let line = &mut lines[usize::from(spot.row)][usize::from(spot.column)..];
        for (cell, letter) in line.iter_mut().zip(spot.text.chars()) {
            *cell = if ascii && letter == '│' { '|' } else { letter };
        }
    }
    lines.into_iter().map(|line| String::from_iter(line).trim_end().to_owned() + "\n").collect()
}

/// Columns of a chart by default.
pub const WIDTH: u16 = 92;
const HEIGHT: u16 = 24;

/// All stages for a reader, in about `width` columns; only a row of a table may be wider.
pub fn text(data: &ChartData, style: Style<'static>, width: u16) -> String {
    let mut text = style.line(&text!("chart-title", title = name(data.title.clone()))) + "\n";
    if !data.complete {
        text += &(style.line(&text!("chart-stopped")) + "\n");
    }
    for stage in Stage::ALL {
        if data.of(stage).next().is_some() {
            text.push('\n');
            text += &stage_text(data, stage, style, width, |_| true);
        }
    }
    text
}

/// One stage in about `width` columns; its table has the selected rows.
pub fn stage_text(
    data: &ChartData,
    stage: Stage,
    style: Style<'static>,
    width: u16,
    wanted: fn(&Measurement) -> bool,
) -> String {
    let mut text = style.line(&stage.heading()) + "\n";
    if let Some(how) = data.reference.get(&stage) {
        let error = data.reference_error.get(&stage).copied().unwrap_or(f64::NAN);
        let error = number(format_args!("{error:.0e}"));
        let about = style.line(&text!("chart-reference", how, error));
        text += &(textwrap::fill(&about, usize::from(width)) + "\n");
    }
    let figure = drawn(data, stage, [width, HEIGHT], style);
    if !figure.is_empty() {
        let below = style.line(&text!("chart-front-drawn", front = FRONT));
        text.extend(["\n", figure.as_str(), "  ", &below, "\n"]);
    }
    let head = [
        Text::default(),
        text!("chart-head-method"),
        text!("chart-head-setting"),
        text!("chart-head-time", work = stage.unit()),
        text!("chart-head-evaluations"),
        text!("chart-head-error"),
        Text::default(),
    ];
    let rows: Vec<_> = data.of(stage).filter(|row| wanted(row)).map(cells).collect();
    text + "\n" + &columns(&head, &rows, style)
}

fn cells(row: &Measurement) -> Vec<Cell> {
    row![
        if row.front { "*" } else { " " },
        &row.method,
        row.setting.describe(),
        row.seconds.map(units::time),
        row.evaluations.map(number),
        row.error.map(|error| units::error(error, row.at_most)),
        row.reason.clone().unwrap_or_default(),
    ]
    .into()
}
