//! The chart as a figure.

use assur_figure::{
    Axis, AxisKind, Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Sign, Stroke, extent,
};
use assur_words::{Text, name, text, unit};

use super::{ChartData, Measurement, Stage};

/// Explanation of the line that joins the best rows.
pub(super) const FRONT: Text = text!("chart-front");

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
pub(super) fn panel(data: &ChartData, stage: Stage) -> Option<Panel> {
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
