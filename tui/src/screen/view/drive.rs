//! The drive: motor, ratio, flywheel by every method.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::motion::regime;
use super::put;
use crate::screen::draw::raster::short;
use crate::screen::number::digits;
use crate::screen::state::State;
use crate::screen::study::Study;
use crate::screen::theme::Role;

/// Second column of the view.
const RIGHT: u16 = 42;

/// Draws the view.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &study.found else { return };
    let Some(dynamics) = &found.analysis.dynamics else { return };
    let mut left = Vec::new();
    if let Some(motor) = &dynamics.motor {
        let catalogue = motor.catalogue.as_deref().unwrap_or("-");
        left.push(format!("motor {} ({catalogue})", motor.designation));
        left.push(format!("  rated power {} W", digits(motor.power, 5)));
        left.push(format!("  synchronous speed {} rad/s", digits(motor.synchronous_speed, 5)));
        left.push(format!("  rated speed {} rad/s", digits(motor.rated_speed, 5)));
        left.extend(motor.max_torque_ratio.map(|x| format!("  breakdown / rated torque {}", digits(x, 4))));
        left.extend(motor.inertia.map(|x| format!("  rotor inertia {} kg m2", digits(x, 5))));
        left.extend(motor.warnings.iter().map(|warning| format!("  ! {warning}")));
    }
    left.extend(dynamics.ratio.map(|x| format!("ratio {}", digits(x, 6))));
    left.extend(dynamics.flywheel.map(|x| format!("flywheel {} kg m2", digits(x, 6))));
    for (method, value) in dynamics.flywheel_by_method.iter() {
        left.push(format!("  by {method}: {} kg m2", digits(*value, 6)));
    }
    let right = regime(dynamics, found.analysis.input.angular);
    for (column, lines) in [(1, left), (RIGHT, right)] {
        for (row, line) in lines.iter().enumerate() {
            put(buffer, area, column, short(row) + 1, line, state.look.theme.style(Role::Plain));
        }
    }
}
