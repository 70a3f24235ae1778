//! Cost and accuracy of the methods on a scene as a chart.

use assur_figure::{Axis, Figure, Frame, Ink, Item, Key, Kind, Panel, Point, Sample, Sign, Stroke, extent};
use assur_study::chart::{ChartData, Row, Stage};

/// Error over time of every method, a panel for each stage, both axes logarithmic, with the Pareto front.
pub(crate) fn figure(data: &ChartData) -> Figure {
    let panels: Vec<Panel> = Stage::ALL.into_iter().filter_map(|stage| panel(data, stage)).collect();
    let legend = vec![
        Key { sample: Sample::Sign(Sign::Dot, Ink::First), text: "a method at one setting".into() },
        Key {
            sample: Sample::Line(Stroke::Chain, Ink::Text),
            text: "Pareto front: no other method is both faster and more exact".into(),
        },
    ];
    Figure { title: data.title.clone(), columns: if panels.len() > 2 { 2 } else { 1 }, panels, legend }
}

/// Least error that is drawn: below it two results differ by rounding alone.
const LEAST_ERROR: f64 = 1e-17;

/// The methods of a stage that have a time and an error; `None` if there are none.
fn panel(data: &ChartData, stage: Stage) -> Option<Panel> {
    let rows: Vec<&Row> =
        data.rows.iter().filter(|row| row.stage == stage && row.point().is_some()).collect();
    let place =
        |row: &Row| row.point().map_or([f64::NAN; 2], |(seconds, error)| [seconds, error.max(LEAST_ERROR)]);
    let axis = |label: &str, at: usize| {
        let [low, high] = extent(rows.iter().map(|row| place(row)[at]))?;
        // Whole powers of ten.
        let range = [10.0_f64.powf(low.log10().floor()), 10.0_f64.powf(high.log10().floor() + 1.0)];
        Some(Axis { label: label.to_owned(), range, kind: Kind::Logarithmic })
    };
    let (x, y) = (axis(&format!("time of {}, s", stage.unit_words()), 0)?, axis("relative error", 1)?);
    let mut methods: Vec<&str> = rows.iter().map(|row| row.method.as_str()).collect();
    methods.sort_unstable();
    methods.dedup();
    let mut items = Vec::new();
    for (number, method) in methods.iter().enumerate() {
        let ink = Ink::Link(number + 1);
        let points: Vec<Point> =
            rows.iter().filter(|row| row.method == *method).map(|row| place(row)).collect();
        items.extend(points.iter().map(|at| Item::sign(*at, Sign::Dot, ink)));
        let exact = points.iter().copied().min_by(|one, other| one[1].total_cmp(&other[1]));
        items.extend(exact.map(|at| Item::name(at, *method, ink)));
        items.push(Item::line(points, Stroke::Solid, ink));
    }
    let mut front: Vec<Point> = rows.iter().filter(|row| row.front).map(|row| place(row)).collect();
    front.sort_by(|one, other| one[0].total_cmp(&other[0]));
    items.push(Item::line(front, Stroke::Chain, Ink::Text));
    let title = format!("{}: relative error over time of {}, s", stage.heading(), stage.unit_words());
    Some(Panel { title, frame: Frame::Axes { x, y, cursor: None }, items })
}
