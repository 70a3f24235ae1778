//! Which rows of the motion are the choice of `auto`.

use assur_integrator::{AUTO, Dependence, choose};

use super::{Row, Stage, Value};

/// Marks the rows that `auto` would choose for their tolerance; a method without one is chosen for every tolerance.
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
