//! Dynamics: the regime, its iteration, motor and flywheel.

use assur_analysis::results::Dynamics;
use assur_figure::{Item, Panel};

use super::Context;
use super::document::Block;
use crate::number::{digits, trimmed};
use crate::screen::state::{Part, View};
use crate::words::Words;

/// Digits of a result, and of a row of an iteration.
const DIGITS: usize = 6;
/// Page of the energy-mass diagram, and of the link of reduction, mm.
const DIAGRAM: [f64; 2] = [130.0, 110.0];
const LINK: [f64; 2] = [165.0, 75.0];
/// Page of two curves, and of one, mm.
const CURVES: [f64; 2] = [160.0, 120.0];
const CURVE: [f64; 2] = [160.0, 80.0];

/// Numbers, iteration and curves of the regime; curves of the motion where there is no regime.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let position = context.positions[0];
    let Some(dynamics) = context.state.found().and_then(|found| found.analysis.dynamics.clone()) else {
        let motion = context.figure(View::Motion, position, |_| {}).map(|(mut figure, _)| {
            figure.panels.retain(|panel| !is_zero(panel));
            [Block::Heading(words.get("motion")), Block::picture(figure, CURVES, words.get("motion-curves"))]
        });
        return motion.into_iter().flatten().collect();
    };
    let mut blocks = vec![
        Block::Heading(words.get("dynamics")),
        Block::Text(words.get("dynamics-text")),
        Block::table(
            words,
            "regime",
            ["quantity", "value", "unit"].map(|id| words.get(id)),
            numbers(words, &dynamics),
        ),
    ];
    let moments = context.figure(View::Motion, position, |state| {
        state.parts.insert(View::Motion, Part::Course);
    });
    blocks.extend(moments.map(|(figure, _)| Block::picture(figure, CURVES, words.get("speed-and-moments"))));
    let reduction = context.beside(View::Drive, |state| {
        state.parts.insert(View::Drive, Part::Reduction);
    });
    let values = [("place", context.places())];
    blocks.extend(
        reduction.map(|figure| Block::picture(figure, LINK, words.with("link-of-reduction", &values))),
    );
    for (view, part, size, id) in [
        (View::Drive, Part::Inertia, CURVE, "shares-drawn"),
        (View::Drive, Part::EnergyMass, DIAGRAM, "energy-mass"),
        (View::Motion, Part::Iteration, CURVES, "iteration-drawn"),
    ] {
        let figure = context.figure(view, position, |state| {
            state.parts.insert(view, part);
        });
        blocks.extend(figure.map(|(figure, _)| Block::picture(figure, size, words.get(id))));
    }
    blocks.extend(iteration(words, &dynamics));
    // The second panel repeats the moments.
    let drive = context.figure(View::Drive, position, |_| {}).filter(|(figure, _)| figure.panels.len() > 1);
    blocks.extend(drive.map(|(mut figure, _)| {
        figure.panels.truncate(1);
        Block::picture(figure, CURVE, words.get("characteristic"))
    }));
    blocks
}

/// Whether all curves of a panel are zero, and show nothing.
fn is_zero(panel: &Panel) -> bool {
    panel.items.iter().flat_map(Item::points).all(|[_, y]| y == 0.0 || !y.is_finite())
}

fn numbers(words: &Words, dynamics: &Dynamics) -> Vec<Vec<String>> {
    // What is positive where the drive drives has another name, and the other sign, where the loads drive.
    let loads_drive = dynamics.regime.loads_drive();
    let one_of = |usual: &'static str, other: &'static str, value: f64| {
        if loads_drive { (other, Some(-value)) } else { (usual, Some(value)) }
    };
    let (mean, mean_moment) = one_of("mean-resistance", "mean-driving", dynamics.regime.mean_resistance);
    let (net, net_work) = one_of("resistance-work", "net-driving-work", dynamics.regime.resistance_work);
    let (needed, power) = one_of("required-power", "power-taken", dynamics.figures.required_power);
    let all = [
        ("mean-speed", Some(dynamics.figures.mean_speed), "rad/s"),
        ("unevenness", Some(dynamics.figures.unevenness), ""),
        ("least-speed", Some(dynamics.figures.speed_min), "rad/s"),
        ("greatest-speed", Some(dynamics.figures.speed_max), "rad/s"),
        ("cycle-time", Some(dynamics.regime.cycle_time), "s"),
        (mean, mean_moment, "N m"),
        (net, net_work, "J"),
        ("excess-work", Some(dynamics.figures.excess_work), "J"),
        (needed, power, "W"),
        ("motor-power", dynamics.motor.as_ref().map(|motor| motor.rated.power), "W"),
        ("ratio", dynamics.figures.ratio, ""),
        ("flywheel", dynamics.flywheel, "kg m2"),
        ("shaft-inertia", Some(dynamics.regime.shaft_inertia).filter(|inertia| *inertia > 0.0), "kg m2"),
    ];
    let rows = all.into_iter().filter_map(|(id, value, unit)| {
        Some(vec![words.get(id), words.number(&trimmed(value?, DIGITS)), words.unit(unit)])
    });
    let motor = dynamics.motor.as_ref().filter(|motor| !motor.designation.is_empty());
    rows.chain(motor.map(|motor| vec![words.get("motor"), motor.designation.clone(), String::new()]))
        .collect()
}

/// The iteration to the periodic regime, the trials of ratio and flywheel, and the flywheel by each method.
fn iteration(words: &Words, dynamics: &Dynamics) -> Vec<Block> {
    let number = |value: f64| words.number(&digits(value, DIGITS));
    let head = |ids: &[&str]| ids.iter().map(|id| words.get(id)).collect::<Vec<_>>();
    let turns = dynamics.regime.iteration.iter().map(|turn| {
        let difference = words.number(&format!("{:.1e}", turn.residual));
        vec![turn.number.to_string(), number(turn.speed_start), number(turn.speed_end), difference]
    });
    let trials = dynamics.regime.trials.iter().map(|trial| {
        let mut cells = vec![trial.number.to_string()];
        cells.push(trial.ratio.map_or_else(|| "–".to_owned(), number));
        cells.extend([trial.flywheel, trial.mean_speed, trial.unevenness].map(number));
        cells
    });
    let methods = dynamics.flywheel_methods.iter().map(|row| {
        let part = |part: f64| words.number(&format!("{:+.2}", 1e2 * part));
        let off = row.difference.map_or_else(|| "–".to_owned(), part);
        vec![words.phrase(row.method), number(row.flywheel), off]
    });
    let all = [
        ("iteration", head(&["turn", "start-speed", "end-speed", "difference"]), turns.collect::<Vec<_>>()),
        (
            "trials",
            head(&["trial", "ratio", "flywheel-unit", "mean-speed-unit", "unevenness"]),
            trials.collect(),
        ),
        ("flywheel-methods", head(&["method", "flywheel-unit", "deviation"]), methods.collect()),
    ];
    let mut blocks = Vec::new();
    for (id, head, rows) in all.into_iter().filter(|(.., rows)| !rows.is_empty()) {
        blocks.push(Block::table(words, id, head, rows));
    }
    blocks
}
