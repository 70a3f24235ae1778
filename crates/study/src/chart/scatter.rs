//! The scatter of a stage, time across and error upwards, both logarithmic: as data, and as text.

use super::{ChartData, Row, Stage};

/// A method at a setting, as a point of the scatter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mark {
    /// Time of one unit of work, s.
    pub(crate) seconds: f64,
    /// Relative error; where it is zero, the lower end of the axis.
    pub(crate) error: f64,
    /// Which method: an index into [`Scatter::methods`].
    pub(crate) method: usize,
    /// On the Pareto front.
    pub(crate) front: bool,
}

/// One stage, ready to draw.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scatter {
    /// The stage.
    pub(crate) stage: Stage,
    /// The methods, in the order of the rows.
    pub(crate) methods: Vec<String>,
    /// The points, in the order of the rows; those of the front, sorted by time, make the joined line.
    pub(crate) marks: Vec<Mark>,
    /// Exponents of ten between which the times lie.
    pub(crate) time_decades: [i32; 2],
    /// Exponents of ten between which the errors lie.
    pub(crate) error_decades: [i32; 2],
}

/// The smallest error that is drawn: smaller ones are drawn here.
const LEAST_ERROR: f64 = 1e-18;

impl Scatter {
    /// The scatter of a stage; `None` where it has no row with time and error.
    pub(crate) fn of(data: &ChartData, stage: Stage) -> Option<Self> {
        let mut methods: Vec<String> = Vec::new();
        let mut marks = Vec::new();
        for row in data.of(stage) {
            let Some((seconds, error)) = row.point().filter(|(seconds, _)| *seconds > 0.0) else { continue };
            let method = index_of(&mut methods, row);
            marks.push(Mark { seconds, error: error.max(LEAST_ERROR), method, front: row.front });
        }
        let time_decades = decades(marks.iter().map(|mark| mark.seconds))?;
        let error_decades = decades(marks.iter().map(|mark| mark.error))?;
        Some(Self { stage, methods, marks, time_decades, error_decades })
    }

    /// The marks of the front by time.
    pub(crate) fn front(&self) -> Vec<Mark> {
        let mut front: Vec<Mark> = self.marks.iter().copied().filter(|mark| mark.front).collect();
        front.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        front
    }
}

/// The letter of a method, as drawn.
pub(crate) fn letter(method: usize) -> char {
    let letters = ('a'..='z').chain('A'..='Z');
    letters.cycle().nth(method).unwrap_or('?')
}

fn index_of(methods: &mut Vec<String>, row: &Row) -> usize {
    methods.iter().position(|name| *name == row.method).unwrap_or_else(|| {
        methods.push(row.method.clone());
        methods.len() - 1
    })
}

#[expect(clippy::cast_possible_truncation, reason = "exponents of finite numbers fit")]
fn decades(values: impl Iterator<Item = f64> + Clone) -> Option<[i32; 2]> {
    let low = values.clone().reduce(f64::min)?.log10().floor() as i32;
    let high = values.reduce(f64::max)?.log10().ceil() as i32;
    Some([low, high.max(low + 1)])
}
