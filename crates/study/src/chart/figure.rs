//! The chart as a figure.

use assur_figure::cells::{self, Look, Marker};
use assur_figure::{
    Axis, Figure, Frame, Ink, Item, Key, Kind, Panel, Point, Sample, Sign, Stroke, Zoom, extent,
};

use super::{ChartData, Row, Stage};

/// Explanation of the line that joins the best rows.
pub(super) const FRONT: &str = "Pareto front: no other method is both faster and more exact";

/// Least error that is drawn: below it two results differ by rounding alone.
const LEAST_ERROR: f64 = 1e-17;

/// Error over time of every method, a panel for each stage, both axes logarithmic, with the Pareto front.
pub fn figure(data: &ChartData) -> Figure {
    let panels: Vec<Panel> = Stage::ALL.into_iter().filter_map(|stage| panel(data, stage)).collect();
    let legend = vec![
        Key { sample: Sample::Sign(Sign::Dot, Ink::First), text: "a method at one setting".into() },
        Key { sample: Sample::Line(Stroke::Chain, Ink::Text), text: FRONT.into() },
    ];
    Figure { title: data.title.clone(), columns: if panels.len() > 2 { 2 } else { 1 }, panels, legend }
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
        Some(Axis { label: label.to_owned(), range, kind: Kind::Logarithmic })
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
        items.extend(exact.map(|at| Item::name(at, *method, ink)));
        items.push(Item::line(points, Stroke::Solid, ink));
    }
    let mut front: Vec<Point> = rows.iter().filter(|(row, _)| row.front).map(|(_, place)| *place).collect();
    front.sort_by(|one, other| one[0].total_cmp(&other[0]));
    items.push(Item::line(front, Stroke::Chain, Ink::Text));
    let title = format!("{}: relative error over time of {}, s", stage.heading(), stage.unit_words());
    Some(Panel { title, frame: Frame::Axes { x, y, cursor: None }, items })
}

/// The panel of a stage in so many columns and rows of characters; nothing for a stage without a time and an error.
pub(super) fn drawn(data: &ChartData, stage: Stage, [width, height]: [u16; 2], ascii: bool) -> String {
    let Some(panel) = panel(data, stage) else { return String::new() };
    let marker = if ascii { Marker::Ascii } else { Marker::Braille };
    let look = Look { marker, ratio: 2.0, zoom: Zoom::WHOLE };
    let mut lines = vec![vec![' '; usize::from(width)]; usize::from(height)];
    for spot in cells::draw(&Figure::of(panel), [width, height], look) {
        let line = &mut lines[usize::from(spot.row)][usize::from(spot.column)..];
        for (cell, letter) in line.iter_mut().zip(spot.text.chars()) {
            *cell = if ascii && letter == '│' { '|' } else { letter };
        }
    }
    lines.into_iter().map(|line| String::from_iter(line).trim_end().to_owned() + "\n").collect()
}
