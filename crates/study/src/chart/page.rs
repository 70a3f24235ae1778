//! The chart as a page for a reader.

use assur_book::{Column, Digits, Document, Table, Unit};
use assur_figure::Figure;
use assur_words::{Describe, Text, name, number, quantity, text};

use super::figure::{FRONT, panel};
use super::{ChartData, Measurement, Stage};

/// Width and height of the figure of a stage on paper, mm.
const FIGURE: [f64; 2] = [160.0, 100.0];

impl ChartData {
    /// Every stage under its heading.
    pub fn tell(&self, page: &mut Document) {
        page.title(text!("chart-title", title = name(self.title.clone())));
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
        page.figure(panel(self, stage).map(Figure::of), FIGURE, below);
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
