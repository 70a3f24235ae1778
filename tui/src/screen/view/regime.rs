//! The steady regime as plots: speed with that of the first turn, moments with their mean, motor, iteration.

use assur_analysis::results::{Analysis, Dynamics, Iteration, RegimePoint, RegimeReport, Trial};
use assur_figure::{Axis, Figure, Panel};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{energy, motion, plots};
use crate::number::digits;
use crate::screen::draw::{paint, put_lines, short, table};
use crate::screen::state::{Role, Scene, State, coordinate_unit};

/// Rows that the curves below the table of the iteration need.
const PLOTS: u16 = 8;

/// Points of a quantity over the cycle, the coordinate in the unit that is shown.
fn over(scene: &Scene, regime: &RegimeReport, read: impl Fn(&RegimePoint) -> f64) -> Vec<[f64; 2]> {
    let (_, factor) = coordinate_unit(&scene.linkage);
    regime.course.iter().map(|row| [factor * row.coordinate, read(row)]).collect()
}

/// The present coordinate in the unit that is shown.
fn cursor(state: &State, scene: &Scene) -> f64 {
    plots::coordinate(scene, state.at())
}

/// Speed in the regime and in the first turn, then the moments and the energies.
pub(super) fn course(state: &State, scene: &Scene, analysis: &Analysis, regime: &RegimeReport) -> Vec<Panel> {
    let mut lines = vec![("regime", over(scene, regime, |row| row.speed))];
    if regime.course.iter().any(|row| row.first_turn.is_some()) {
        lines.push(("first turn", over(scene, regime, |row| row.first_turn.unwrap_or(f64::NAN))));
    }
    let speed = plots::curves("input speed, rad/s", lines, axis(scene, regime), Some(cursor(state, scene)));
    let places: Vec<f64> = over(scene, regime, |_| 0.0).into_iter().map(|at| at[0]).collect();
    let energies = motion::energies(analysis, &places, axis(scene, regime), cursor(state, scene));
    [speed, moments(state, scene, regime)].into_iter().chain(energies).collect()
}

/// The coordinate over the cycle of the regime.
fn axis(scene: &Scene, regime: &RegimeReport) -> Axis {
    let ends = over(scene, regime, |_| 0.0).into_iter().map(|at| at[0]);
    let own = plots::coordinate_axis(scene);
    Axis { kind: own.kind, ..Axis::around(own.label, ends, 0.0) }
}

/// Moments of the drive and the resistance on the input, with the mean resistance.
pub(super) fn moments(state: &State, scene: &Scene, regime: &RegimeReport) -> Panel {
    // The resistance is shown against the motion, as its mean is.
    let sense = scene.linkage.mechanism.input.sign();
    let lines = vec![
        ("motor", over(scene, regime, |row| sense * row.drive)),
        ("resistance", over(scene, regime, |row| -sense * row.load)),
        ("mean", over(scene, regime, |_| regime.mean_resistance)),
    ];
    plots::curves("moments on the input, N m", lines, axis(scene, regime), Some(cursor(state, scene)))
}

/// The motor's characteristic, with its working section; `None` without a motor of a catalogue.
pub(super) fn characteristic(dynamics: &Dynamics) -> Option<Panel> {
    let work = &dynamics.motor.as_ref()?.work;
    let lines = vec![("whole", work.curve.clone()), ("working section", work.working_section.clone())];
    let x = Axis::around("speed of the motor, rad/s", work.curve.iter().map(|at| at[0]), 0.0);
    let cursor = Some(0.5 * (work.speed[0] + work.speed[1]));
    Some(plots::curves("motor characteristic, N m", lines, x, cursor))
}

/// The iterations to the regime: a row for each turn, then a row for each trial of ratio and flywheel.
pub(crate) fn draw_iteration(state: &State, regime: &RegimeReport, area: Rect, buffer: &mut Buffer) {
    let turn = |turn: &Iteration| {
        let [start, end] = [turn.speed_start, turn.speed_end].map(|value| digits(value, 8));
        vec![turn.number.to_string(), start, end, format!("{:.2e}", turn.residual)]
    };
    let mut lines = vec![(Role::Header, "iteration to the periodic regime, from the mean speed".to_owned())];
    let turns: Vec<_> = regime.iteration.iter().map(turn).collect();
    lines.extend(table(&["turn", "start, rad/s", "end, rad/s", "difference"], &turns));
    let trial = |trial: &Trial| {
        let ratio = trial.ratio.map_or_else(|| "-".to_owned(), |ratio| digits(ratio, 6));
        let numbers = [trial.flywheel, trial.mean_speed, trial.unevenness].map(|value| digits(value, 6));
        [trial.number.to_string(), ratio].into_iter().chain(numbers).collect()
    };
    if !regime.trials.is_empty() {
        lines.push((Role::Plain, String::new()));
        lines.push((Role::Header, "trials of ratio and flywheel".to_owned()));
        let trials: Vec<Vec<String>> = regime.trials.iter().map(trial).collect();
        lines.extend(table(&["No", "ratio", "kg m2", "mean, rad/s", "unevenness"], &trials));
    }
    let [numbers, below] =
        Layout::vertical([Constraint::Length(short(lines.len()) + 1), Constraint::Min(0)]).areas(area);
    put_lines(buffer, numbers, 1, state, &lines);
    if below.height >= PLOTS {
        let panels = energy::iteration(regime);
        paint(state, &Figure { title: String::new(), panels, columns: 2, legend: Vec::new() }, below, buffer);
    }
}
