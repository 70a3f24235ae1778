//! The steady regime as plots: speed with that of the first turn, moments with their mean, motor, iteration.

use assur_analysis::results::{Dynamics, RegimePoint, RegimeReport};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use crate::number::digits;
use crate::screen::draw::{Lines, put, put_lines};
use crate::screen::state::{Role, Scene, State, coordinate_unit};

/// Points of a quantity over the cycle, the coordinate in the unit that is shown.
fn over(scene: &Scene, regime: &RegimeReport, read: impl Fn(&RegimePoint) -> f64) -> Vec<[f64; 2]> {
    let (_, factor) = coordinate_unit(&scene.linkage);
    regime.course.iter().map(|row| [factor * row.coordinate, read(row)]).collect()
}

fn axis(state: &State, scene: &Scene) -> (String, f64) {
    let (unit, factor) = coordinate_unit(&scene.linkage);
    let at = factor * scene.linkage.mechanism.input.coordinate(state.position);
    (format!("{}, {unit}", "coordinate"), at)
}

/// Speed in the regime and in the first turn, above the moments.
pub(crate) fn draw_course(
    state: &State,
    scene: &Scene,
    regime: &RegimeReport,
    area: Rect,
    buffer: &mut Buffer,
) {
    let [above, below] = Layout::vertical([Constraint::Ratio(1, 2); 2]).areas(area);
    draw_speed(state, scene, regime, above, buffer);
    draw_moments(state, scene, regime, below, buffer);
}

fn draw_speed(state: &State, scene: &Scene, regime: &RegimeReport, area: Rect, buffer: &mut Buffer) {
    let (axis, at) = axis(state, scene);
    let mut lines = vec![("regime", over(scene, regime, |row| row.speed))];
    if regime.course.iter().any(|row| row.first_turn.is_some()) {
        lines.push(("first turn", over(scene, regime, |row| row.first_turn.unwrap_or(f64::NAN))));
    }
    Lines { title: "input speed, rad/s", curves: lines, axis: &axis, cursor: Some(at) }
        .draw(area, state.look, buffer);
}

/// Moments of the drive and the resistance on the input, with the mean resistance.
pub(crate) fn draw_moments(
    state: &State,
    scene: &Scene,
    regime: &RegimeReport,
    area: Rect,
    buffer: &mut Buffer,
) {
    let (axis, at) = axis(state, scene);
    // The resistance is shown against the motion, as its mean is.
    let sense = scene.linkage.mechanism.input.sign();
    let lines = vec![
        ("motor", over(scene, regime, |row| sense * row.drive)),
        ("resistance", over(scene, regime, |row| -sense * row.load)),
        ("mean", over(scene, regime, |_| regime.mean_resistance)),
    ];
    Lines { title: "moments on the input, N m", curves: lines, axis: &axis, cursor: Some(at) }
        .draw(area, state.look, buffer);
}

/// The motor's characteristic, with its working section.
pub(crate) fn draw_characteristic(state: &State, dynamics: &Dynamics, area: Rect, buffer: &mut Buffer) {
    let Some(work) = dynamics.motor.as_ref().map(|motor| &motor.work) else {
        put(buffer, area, 1, 0, "this regime has no motor of a catalogue", state.look.theme.style(Role::Dim));
        return;
    };
    let lines = vec![("whole", work.curve.clone()), ("working section", work.working_section.clone())];
    let cursor = Some(0.5 * (work.speed[0] + work.speed[1]));
    Lines { title: "motor characteristic, N m", curves: lines, axis: "speed of the motor, rad/s", cursor }
        .draw(area, state.look, buffer);
}

/// The iterations to the regime: a row for each turn, then a row for each trial of ratio and flywheel.
pub(crate) fn draw_iteration(state: &State, regime: &RegimeReport, area: Rect, buffer: &mut Buffer) {
    let mut lines = vec![(Role::Header, "iteration to the periodic regime, from the mean speed".to_owned())];
    lines.push((Role::Dim, "turn   start, rad/s     end, rad/s     difference".to_owned()));
    for turn in &regime.iteration {
        let [start, end] = [turn.speed_start, turn.speed_end].map(|value| digits(value, 8));
        lines.push((
            Role::Plain,
            format!("{:>4} {start:>16} {end:>16} {:>12.2e}", turn.number, turn.residual),
        ));
    }
    if !regime.trials.is_empty() {
        lines.push((Role::Plain, String::new()));
        lines.push((Role::Header, "trials of ratio and flywheel".to_owned()));
        lines.push((Role::Dim, "  No        ratio        kg m2    mean, rad/s   unevenness".to_owned()));
    }
    for trial in &regime.trials {
        let ratio = trial.ratio.map_or_else(|| "-".to_owned(), |ratio| digits(ratio, 6));
        let [flywheel, speed, unevenness] =
            [trial.flywheel, trial.mean_speed, trial.unevenness].map(|value| digits(value, 6));
        let row = format!("{:>4} {ratio:>12} {flywheel:>12} {speed:>14} {unevenness:>12}", trial.number);
        lines.push((Role::Plain, row));
    }
    put_lines(buffer, area, 1, state.look, &lines);
}
