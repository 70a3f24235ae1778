//! The chart as a figure, and as a page for a reader.

use assur_book::{Column, Digits, Document, Table, Unit};
use assur_figure::{
    Axis, AxisKind, Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Sign, Stroke, extent,
};
use assur_words::{Describe, Text, name, number, quantity, text, unit};

use super::{ChartData, Measurement, Stage};

/// Width and height of the figure of a stage on paper, mm.
const FIGURE: [f64; 2] = [160.0, 100.0];

impl ChartData {
    /// Every stage under its heading.
    pub fn tell(&self, page: &mut Document) {
        page.title(text!("chart-title", title = &self.title));
        if !self.complete {
            page.paragraph(text!("chart-stopped"));
        }
        for stage in Stage::ALL.into_iter().filter(|stage| self.of(*stage).next().is_some()) {
            page.heading(stage.heading());
            self.tell_stage(stage, |_| true, page);
        }
    }

    /// A stage: its reference, its figure, and a row for each selected method and setting.
    pub fn tell_stage(&self, stage: Stage, wanted: fn(&Measurement) -> bool, page: &mut Document) {
        if let (Some(how), Some(error)) = (self.reference.get(&stage), self.reference_error.get(&stage)) {
            page.paragraph(text!("chart-reference", how, error = number(format_args!("{error:.0e}"))));
        }
        let below = text!("chart-front-drawn", front = FRONT);
        page.figure(panel(self, stage).map_or_else(Figure::default, Figure::of), FIGURE, below);
        let mark = |mark: &'static str, is_marked: bool| name(if is_marked { mark } else { "" });
        let error = Column::short(text!("chart-head-error"), Unit::NONE).with(Digits::Exponent);
        let table = Table::each(Text::default(), self.of(stage).filter(|row| wanted(row)))
            .column(Text::default(), |row| mark("*", row.front))
            .column(text!("head-method"), |row| &row.method)
            .column(text!("chart-head-setting"), |row| row.setting.describe())
            .column(text!("chart-head-time", work = stage.unit()), |row| row.seconds.map(time))
            .column(text!("chart-head-evaluations"), |row| row.evaluations.map(number))
            .column(Text::default(), |row| mark("≤", row.at_most))
            .add(error, |row| row.error)
            .column(Text::default(), |row| row.reason.clone().unwrap_or_default());
        page.table(table.table());
    }
}

/// A time with its unit, three digits: `215 ns`, `1.20 ms`.
pub fn time(seconds: f64) -> Text {
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, "µs"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let digits = if value < 9.995 { 2 } else { usize::from(value < 99.95) };
    quantity(format!("{value:.digits$}"), unit)
}

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
    Figure { title: Text::from(&data.title), columns: if panels.len() > 2 { 2 } else { 1 }, panels, legend }
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
        Some(Axis { label, range, kind: AxisKind::Logarithmic, scale: None })
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
    // Where a method has several settings, they stand in the room that the names leave.
    let several = |row: &Measurement| rows.iter().filter(|(other, _)| other.method == row.method).count() > 1;
    items.extend(rows.iter().filter(|(row, _)| several(row)).map(|(row, at)| Item::Name {
        at: *at,
        text: row.setting.values(),
        ink: Ink::Dim,
        needed: false,
    }));
    let mut front: Vec<Point> = rows.iter().filter(|(row, _)| row.front).map(|(_, place)| *place).collect();
    front.sort_by(|one, other| one[0].total_cmp(&other[0]));
    items.push(Item::line(front, Stroke::Chain, Ink::Text));
    let title = text!("chart-panel", stage = stage.heading(), work = stage.work(), unit = unit("s"));
    Some(Panel { title, frame: Frame::Axes { x, y, cursor: None }, items })
}
