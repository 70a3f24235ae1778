//! Which rows of the motion are what `auto` takes, and what that costs against the best.

use assur_integrator::{AUTO, Dependence, choose};

use super::markdown::fastest;
use super::{ChartData, Row, Stage, Value};

/// Marks the rows that `auto` would take for their tolerance; a method without one is taken for every tolerance.
pub(super) fn mark(rows: &mut [Row], dependence: Dependence) {
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

/// What `auto` takes when asked for this tolerance, and its time over that of the fastest row that meets it.
pub(super) fn against_best(data: &ChartData, tolerance: f64) -> Option<(&Row, f64)> {
    let is_asked = |row: &&Row| match row.setting.get("tolerance") {
        Some(Value::Number(set)) => (set / tolerance - 1.0).abs() < 1e-6,
        _ => true,
    };
    let own = data.of(Stage::Motion).filter(|row| row.auto).find(is_asked)?;
    let best = fastest(data, Stage::Motion, tolerance)?;
    Some((own, own.seconds? / best.seconds?))
}
