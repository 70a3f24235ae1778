//! The Pareto front.

use assur_integrator::{AUTO, Dependence, choose};

use super::{Row, Stage, Value};

/// Indices of the points for which no other point is better in both coordinates (smaller is better), from the fastest
/// to the most exact. Of equal points the first is on the front.
pub(crate) fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|a, b| {
        let ((xa, ya), (xb, yb)) = (points[*a], points[*b]);
        xa.total_cmp(&xb).then(ya.total_cmp(&yb)).then(a.cmp(b))
    });
    let mut least = f64::INFINITY;
    order.retain(|index| {
        let better = points[*index].1 < least;
        least = least.min(points[*index].1);
        better
    });
    order
}

/// Marks the rows that are on the front of their stage.
pub(crate) fn mark(rows: &mut [super::Row]) {
    for stage in super::Stage::ALL {
        let known: Vec<(usize, (f64, f64))> = rows
            .iter()
            .enumerate()
            .filter(|(_, row)| row.stage == stage && row.whole())
            .filter_map(|(index, row)| Some((index, row.point()?)))
            .collect();
        let points: Vec<(f64, f64)> = known.iter().map(|(_, point)| *point).collect();
        for index in front(&points) {
            rows[known[index].0].front = true;
        }
    }
}

/// Marks the rows that `auto` would choose for their tolerance; a method without one is chosen for every tolerance.
pub(super) fn mark_choice(rows: &mut [Row], dependence: Dependence) {
    for row in rows.iter_mut().filter(|row| row.stage == Stage::Motion) {
        let tolerance = match row.setting.get("tolerance") {
            Some(Value::Number(tolerance)) => tolerance,
            None if row.setting.0.is_empty() => f64::EPSILON,
            _ => continue,
        };
        row.auto = choose(AUTO, &dependence, tolerance)
            .is_ok_and(|choice| choice.first.integrator.name == row.method);
    }
}
