//! The steady regime as plots: speed beside the first turn, moments with their mean, motor, iteration.

use assur_analysis::results::{Dynamics, RegimePoint, RegimeReport};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::put;
use crate::screen::draw::lines::Lines;
use crate::screen::draw::raster::short;
use crate::screen::number::digits;
use crate::screen::quantities::coordinate_unit;
use crate::screen::state::State;
use crate::screen::study::Study;
use crate::screen::theme::Role;

/// Points of a quantity over the cycle, the coordinate in the unit that is shown.
fn over(study: &Study, regime: &RegimeReport, read: impl Fn(&RegimePoint) -> f64) -> Vec<[f64; 2]> {
    let (_, factor) = coordinate_unit(&study.linkage);
    regime.course.iter().map(|row| [factor * row.coordinate, read(row)]).collect()
}

fn axis(state: &State, study: &Study) -> (String, f64) {
    let (unit, factor) = coordinate_unit(&study.linkage);
    let at = factor * study.linkage.mechanism.input.coordinate(state.position);
    (format!("{}, {unit}", state.texts.coordinate), at)
}

/// Speed in the regime and in the first turn, above the moments.
pub(crate) fn draw_course(
    state: &State,
    study: &Study,
    regime: &RegimeReport,
    area: Rect,
    buffer: &mut Buffer,
) {
    let [above, below] = Layout::vertical([Constraint::Ratio(1, 2); 2]).areas(area);
    draw_speed(state, study, regime, above, buffer);
    draw_moments(state, study, regime, below, buffer);
}

fn draw_speed(state: &State, study: &Study, regime: &RegimeReport, area: Rect, buffer: &mut Buffer) {
    let (axis, at) = axis(state, study);
    let mut lines = vec![(state.texts.regime, over(study, regime, |row| row.speed))];
    if regime.course.iter().any(|row| row.first_turn.is_some()) {
        lines.push((state.texts.first_turn, over(study, regime, |row| row.first_turn.unwrap_or(f64::NAN))));
    }
    Lines { title: state.texts.speeds, curves: lines, axis: &axis, cursor: Some(at) }
        .draw(area, state.look, buffer);
}

/// Moments of the drive and the resistance on the input, with the mean resistance.
pub(crate) fn draw_moments(
    state: &State,
    study: &Study,
    regime: &RegimeReport,
    area: Rect,
    buffer: &mut Buffer,
) {
    let (axis, at) = axis(state, study);
    // The resistance counts against the motion, as its mean does.
    let sense = study.linkage.mechanism.input.sign();
    let lines = vec![
        (state.texts.drive_moment, over(study, regime, |row| sense * row.drive)),
        (state.texts.resistance, over(study, regime, |row| -sense * row.load)),
        (state.texts.mean_resistance, over(study, regime, |_| regime.mean_resistance)),
    ];
    Lines { title: state.texts.moments, curves: lines, axis: &axis, cursor: Some(at) }
        .draw(area, state.look, buffer);
}

/// The motor's characteristic, with its working section.
pub(crate) fn draw_characteristic(state: &State, dynamics: &Dynamics, area: Rect, buffer: &mut Buffer) {
    let Some(work) = dynamics.motor.as_ref().map(|motor| &motor.work) else {
        put(buffer, area, 1, 0, state.texts.no_motor, state.look.theme.style(Role::Dim));
        return;
    };
    let lines = vec![
        (state.texts.characteristic, work.curve.clone()),
        (state.texts.working_section, work.working_section.clone()),
    ];
    let cursor = Some(0.5 * (work.speed[0] + work.speed[1]));
    Lines { title: state.texts.motor_torque, curves: lines, axis: state.texts.motor_speed, cursor }
        .draw(area, state.look, buffer);
}

/// The way to the regime: a row a turn, then a row a trial of ratio and flywheel.
pub(crate) fn draw_iteration(state: &State, regime: &RegimeReport, area: Rect, buffer: &mut Buffer) {
    let mut lines = vec![(Role::Header, state.texts.iteration.to_owned())];
    lines.push((Role::Dim, state.texts.iteration_columns.to_owned()));
    for turn in &regime.iteration {
        let [start, end] = [turn.speed_start, turn.speed_end].map(|value| digits(value, 8));
        lines.push((
            Role::Plain,
            format!("{:>4} {start:>16} {end:>16} {:>12.2e}", turn.number, turn.residual),
        ));
    }
    if !regime.trials.is_empty() {
        lines.push((Role::Plain, String::new()));
        lines.push((Role::Header, state.texts.trials.to_owned()));
        lines.push((Role::Dim, state.texts.trial_columns.to_owned()));
    }
    for trial in &regime.trials {
        let ratio = trial.ratio.map_or_else(|| "-".to_owned(), |ratio| digits(ratio, 6));
        let [flywheel, speed, unevenness] =
            [trial.flywheel, trial.mean_speed, trial.unevenness].map(|value| digits(value, 6));
        let row = format!("{:>4} {ratio:>12} {flywheel:>12} {speed:>14} {unevenness:>12}", trial.number);
        lines.push((Role::Plain, row));
    }
    for (row, (role, line)) in lines.iter().enumerate() {
        put(buffer, area, 1, short(row), line, state.look.theme.style(*role));
    }
}
