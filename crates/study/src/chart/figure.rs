//! The chart as a figure.

use assur_figure::cells::{self, Look, Marker};
use assur_figure::{
    Axis, Figure, Frame, Ink, Item, Key, Kind, Panel, Point, Sample, Sign, Stroke, Zoom, extent,
};
use assur_report::text::columns;
use assur_words::{Language, name};

use super::{ChartData, Row, Stage, units};

/// Explanation of the line that joins the best rows.
pub(super) const FRONT: &str = "Pareto front: no other method is both faster and more exact";

/// Least error that is drawn: below it two results differ by rounding alone.
const LEAST_ERROR: f64 = 1e-17;

/// Error over time of every method, a panel for each stage, both axes logarithmic, with the Pareto front.
pub fn figure(data: &ChartData) -> Figure {
    let panels: Vec<Panel> = Stage::ALL.into_iter().filter_map(|stage| panel(data, stage)).collect();
    let legend = vec![
        Key { sample: Sample::Sign(Sign::Dot, Ink::First), text: name("a method at one setting") },
        Key { sample: Sample::Line(Stroke::Chain, Ink::Text), text: name(FRONT) },
    ];
    Figure { title: name(data.title.clone()), columns: if panels.len() > 2 { 2 } else { 1 }, panels, legend }
}

/// The methods of a stage that have a time and an error; `None` if there are none.
fn panel(data: &ChartData, stage: Stage) -> Option<Panel> {
    let rows: Vec<(&Row, Point)> = data
        .of(stage)
        .filter_map(|row| row.point().map(|(seconds, error)| (row, [seconds, error.max(LEAST_ERROR)])))
        .collect();
    let axis = |label: &str, at: usize| {
        let [low, high] = extent(rows.iter().map(|(_, place)| place[at]))?;
        // Whole powers of ten.
        let range = [10.0_f64.powf(low.log10().floor()), 10.0_f64.powf(high.log10().floor() + 1.0)];
        Some(Axis { label: name(label.to_owned()), range, kind: Kind::Logarithmic })
    };
    let (x, y) = (axis(&format!("time of {}, s", stage.unit_words()), 0)?, axis("relative error", 1)?);
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
    let title = name(format!("{}: relative error over time of {}, s", stage.heading(), stage.unit_words()));
    Some(Panel { title, frame: Frame::Axes { x, y, cursor: None }, items })
}

/// The panel of a stage in so many columns and rows of characters; nothing for a stage without a time and an error.
pub(super) fn drawn(data: &ChartData, stage: Stage, [width, height]: [u16; 2], ascii: bool) -> String {
    let Some(panel) = panel(data, stage) else { return String::new() };
    let marker = if ascii { Marker::Ascii } else { Marker::Braille };
    let look = Look { marker, ratio: 2.0, zoom: Zoom::WHOLE, language: Language::english() };
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
/// Lines of a figure.
const HEIGHT: u16 = 24;

/// All stages for a reader, in about `width` columns; only a row of a table may be wider.
pub fn text(data: &ChartData, ascii: bool, width: u16) -> String {
    let dash = if ascii { "-" } else { "—" };
    let mut text = format!("Speed against accuracy {dash} {}\n", data.title);
    if !data.complete {
        text += "Stopped before the end: what had been measured is shown.\n";
    }
    for stage in Stage::ALL {
        if data.of(stage).next().is_some() {
            text.push('\n');
            text += &stage_text(data, stage, ascii, width, |_| true);
        }
    }
    text
}

/// One stage in about `width` columns; its table has the selected rows.
pub fn stage_text(
    data: &ChartData,
    stage: Stage,
    ascii: bool,
    width: u16,
    wanted: fn(&Row) -> bool,
) -> String {
    let mut text = format!("{}\n", stage.heading());
    if let Some(how) = data.reference.get(&stage) {
        let error = data.reference_error.get(&stage).copied().unwrap_or(f64::NAN);
        let about = format!("Reference: {how}; own error about {error:.0e}.");
        text += &(textwrap::fill(&about, usize::from(width)) + "\n");
    }
    let figure = drawn(data, stage, [width, HEIGHT], ascii);
    if !figure.is_empty() {
        text.extend(["\n", figure.as_str(), "  dotted, and * below: ", FRONT, "\n"]);
    }
    let head = ["", "method", "setting", &format!("time/{}", stage.unit()), "evaluations", "error", ""];
    let rows: Vec<_> = data.of(stage).filter(|row| wanted(row)).map(|row| cells(row, ascii)).collect();
    text + "\n" + &columns(&head, &rows, ascii)
}

fn cells(row: &Row, ascii: bool) -> Vec<String> {
    let dash = || "-".to_owned();
    vec![
        if row.front { "*" } else { " " }.to_owned(),
        row.method.clone(),
        row.setting.to_string(),
        row.seconds.map_or_else(dash, |seconds| units::time(seconds, ascii)),
        row.evaluations.map_or_else(dash, |count| count.to_string()),
        row.error.map_or_else(dash, |error| units::error(error, row.at_most, ascii)),
        row.reason.clone().unwrap_or_default(),
    ]
}
