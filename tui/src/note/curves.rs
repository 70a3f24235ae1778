//! Curves of results over the cycle.

use assur_analysis::results::Column;
use assur_figure::{Axis, Frame, Ink, Item, Kind, Panel, Point, Stroke};
use assur_mechanism::Range;

use super::Context;

/// Curves of points over an axis.
pub(super) fn plot(title: String, x: Axis, curves: Vec<(Vec<Point>, Stroke, Ink)>) -> Panel {
    let y = Axis::around("", curves.iter().flat_map(|(points, ..)| points).map(|at| at[1]), 0.0);
    let items = curves.into_iter().map(|(points, stroke, ink)| Item::line(points, stroke, ink)).collect();
    Panel { title, frame: Frame::Axes { x, y, cursor: None }, items }
}

impl Context<'_> {
    /// A column of the results over the coordinate as it is shown; a cycle ends with its first value. `None` where a
    /// position lacks it.
    pub(super) fn cycle(&self, column: Column) -> Option<Vec<Point>> {
        let (scene, found) = (self.state.scene.as_ref()?, self.state.found()?);
        let table = &found.analysis.positions;
        let (column, input) = (table.schema().find(column)?, &scene.linkage.mechanism.input);
        let factor = if input.is_angle() { 180.0 / std::f64::consts::PI } else { 1e3 };
        let points = table.numbers().iter().zip(table.each(column));
        let points: Option<Vec<Point>> =
            points.map(|(number, value)| Some([factor * input.coordinate(*number), value?])).collect();
        let mut points = points?;
        if let (true, Range::Cycle(cycle), Some(first)) =
            (scene.closed(), input.range, points.first().copied())
        {
            points.push([first[0] + factor * input.sign() * cycle, first[1]]);
        }
        Some(points)
    }

    /// The axis of the coordinate under curves.
    pub(super) fn coordinate_axis(&self, curves: &[Vec<Point>]) -> Axis {
        let angular = self.state.found().is_some_and(|found| found.analysis.input.angular);
        let (kind, id) =
            if angular { (Kind::Degrees, "coordinate-deg") } else { (Kind::Linear, "coordinate-mm") };
        Axis { kind, ..Axis::around(self.words.get(id), curves.iter().flatten().map(|at| at[0]), 0.0) }
    }
}
