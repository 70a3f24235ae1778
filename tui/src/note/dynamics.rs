//! Dynamics: the regime, its iteration, motor and flywheel.

use assur_analysis::results::{Column, Dynamics, Owner, Quantity};
use assur_figure::mechanism::Drawing;
use assur_figure::{Bounds, Figure, Frame, Ink, Item, Panel, Point, Stroke};
use assur_mechanism::LinkId;

use super::Context;
use super::document::Block;
use super::words::Words;
use crate::number::{digits, trimmed};
use crate::screen::state::{Part, View};

/// Digits of a result and of a row of an iteration, and of a number in a figure.
const DIGITS: usize = 6;
const FIGURE_DIGITS: usize = 4;
/// Page of the energy-mass diagram, and of the link of reduction, mm.
const DIAGRAM: [f64; 2] = [130.0, 110.0];
const LINK: [f64; 2] = [165.0, 75.0];
/// Length of the arrow of the reduced force, and how far from its point the ground is drawn, in radii of the point.
const ARROW: f64 = 0.8;
const NEAR: f64 = 1.5;
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
    blocks.extend(link_of_reduction(context, &dynamics));
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
    let all = [
        ("mean-speed", Some(dynamics.mean_speed), "rad/s"),
        ("unevenness", Some(dynamics.unevenness), ""),
        ("least-speed", Some(dynamics.speed_min), "rad/s"),
        ("greatest-speed", Some(dynamics.speed_max), "rad/s"),
        ("cycle-time", Some(dynamics.regime.cycle_time), "s"),
        ("mean-resistance", Some(dynamics.regime.mean_resistance), "N m"),
        ("resistance-work", Some(dynamics.regime.resistance_work), "J"),
        ("excess-work", Some(dynamics.excess_work), "J"),
        ("required-power", Some(dynamics.required_power), "W"),
        ("motor-power", dynamics.motor.as_ref().map(|motor| motor.rated.power), "W"),
        ("ratio", dynamics.ratio, ""),
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
    let all: [(&str, Vec<String>, Vec<Vec<String>>); 3] = [
        ("iteration", head(&["turn", "start-speed", "end-speed", "difference"]), turns.collect()),
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

/// The input link alone in the chosen positions, with the reduced force at its point of reduction and the reduced mass
/// there (E fig. 1c).
fn link_of_reduction(context: &Context<'_>, dynamics: &Dynamics) -> Option<Block> {
    let (scene, found, point) =
        (context.state.scene.as_ref()?, context.state.found()?, dynamics.reduction_point.as_ref()?);
    let linkage = &scene.linkage;
    let input = linkage.mechanism.input.link;
    let hidden: Vec<LinkId> = (1..linkage.mechanism.links.len()).filter(|link| *link != input).collect();
    let drawing = Drawing { linkage, strokes: &scene.outline.strokes, marked: &[], hidden: &hidden };
    let id = linkage.mechanism.point(&point.name)?;
    let table = &found.analysis.positions;
    let panel = |position: &usize| {
        let (pose, row) = (scene.poses.get(*position)?.as_ref()?, table.row_of(*position)?);
        let of = |quantity| table.get(row, Column::of(quantity, Owner::Input));
        let (force, mass) = (
            of(Quantity::ReducedMoment)? / point.radius,
            of(Quantity::ReducedInertia)? / point.radius.powi(2),
        );
        let motion = linkage.point_motion(id, pose);
        let to = [0, 1].map(|axis| motion.pf0[axis] + ARROW * force.signum() * motion.pf1[axis]);
        let mut items = drawing.items(pose);
        items.push(Item::Arrow { from: motion.pf0, to, stroke: Stroke::Solid, ink: Ink::Second });
        items.push(Item::name(to, "F", Ink::Title));
        // The rest of the ground is far away.
        let near = |at: &Point| (at[0] - motion.pf0[0]).hypot(at[1] - motion.pf0[1]) <= NEAR * point.radius;
        items.retain(|item| item.points().iter().all(near));
        let bounds = Bounds::around(items.iter().flat_map(Item::points));
        let frame = Frame::Plane { bounds, unit: "mm".into(), factor: 1e3, scale: ("l", "m".into()) };
        let [force, mass] = [force.abs(), mass].map(|value| digits(value, FIGURE_DIGITS));
        Some(Panel {
            title: format!("{}: F = {force} N, m = {mass} kg", context.coordinate(*position)),
            frame,
            items,
        })
    };
    let panels: Vec<Panel> = context.positions.iter().filter_map(panel).collect();
    let columns = panels.len().clamp(1, 2);
    let caption = context.words.with("link-of-reduction", &[("point", point.name.clone())]);
    let figure = Figure { panels, columns, ..Figure::default() };
    (!figure.panels.is_empty()).then(|| Block::picture(figure, LINK, caption))
}
