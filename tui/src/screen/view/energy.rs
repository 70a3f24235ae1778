//! Energy and inertia of a steady regime: the energy-mass diagram, the shares of the reduced inertia, and how ratio, flywheel
//! and speed were found.

use assur_analysis::results::{Column, Dynamics, EnergyMass, Owner, Quantity, RegimeReport};
use assur_figure::{Axis, Frame, Ink, Item, Panel, Sign, Stroke};

use super::plots;
use crate::screen::state::{Found, Scene, State};

/// The energy-mass diagram with its two tangents.
pub(super) fn energy_mass(diagram: &EnergyMass) -> Panel {
    let inertias = || diagram.curve.iter().map(|at| at[0]);
    let x = Axis::around("reduced inertia of the links, kg m2", inertias(), 0.0);
    let [x0, y0] = diagram.origin;
    let line = |slope: f64| x.range.iter().map(|inertia| [*inertia, y0 + slope * (inertia - x0)]).collect();
    let [fast, slow] = diagram.tangents.map(|tangent| line(tangent.slope));
    let lines = vec![("work", diagram.curve.clone()), ("greatest speed", fast), ("least speed", slow)];
    let mut panel = plots::curves("energy-mass diagram, J", lines, x, None);
    panel.items.extend(diagram.tangents.map(|tangent| Item::sign(tangent.touches, Sign::Plus, Ink::Title)));
    panel
}

/// The reduced inertia over the positions, the shares of flywheel with rotor and of each link above each other.
pub(super) fn shares(state: &State, scene: &Scene, found: &Found, dynamics: &Dynamics) -> Panel {
    let table = &found.analysis.positions;
    let schema = table.schema();
    let mut sums = vec![dynamics.regime.shaft_inertia; table.len()];
    let mut names = vec!["drive".to_owned()];
    let mut levels = vec![sums.clone()];
    for owner in schema.owners(Quantity::ReducedInertia) {
        let column = schema.find(Column::of(Quantity::ReducedInertia, owner));
        let (Owner::Link(_), Some(column)) = (owner, column) else { continue };
        sums.iter_mut().zip(table.each(column)).for_each(|(sum, share)| *sum += share.unwrap_or(f64::NAN));
        names.push(format!("+ {}", schema.name(owner)));
        levels.push(sums.clone());
    }
    let places: Vec<f64> =
        table.numbers().iter().map(|number| plots::coordinate(scene, *number as f64)).collect();
    let mut items = Vec::new();
    for (number, level) in levels.iter().enumerate() {
        let points: Vec<_> = places.iter().copied().zip(level.iter().copied()).map(|(x, y)| [x, y]).collect();
        let stroke = if number + 1 == levels.len() { Stroke::Solid } else { Stroke::Dashed };
        let at = points.get((2 * number + 1) * points.len() / (2 * levels.len())).copied();
        items.push(Item::line(points, stroke, Ink::First));
        items.extend(at.map(|at| Item::name(at, (number + 1).to_string(), Ink::Title)));
    }
    let values = items.iter().flat_map(Item::points).map(|at| at[1]).collect::<Vec<_>>();
    let names: Vec<_> = names.iter().enumerate().map(|(at, name)| format!("{} {name}", at + 1)).collect();
    let y = Axis::around("kg m2", values, 0.0);
    let frame = Frame::Axes {
        x: plots::coordinate_axis(scene),
        y,
        cursor: Some(plots::coordinate(scene, state.at())),
    };
    Panel { title: format!("reduced inertia: {}", names.join("  ")), frame, items }
}

/// The iteration to the periodic regime, and the trials of ratio and flywheel, as parts of the values found (S fig. 10).
pub(super) fn iteration(regime: &RegimeReport) -> Vec<Panel> {
    let numbered =
        |values: Vec<f64>| values.into_iter().enumerate().map(|(at, y)| [(at + 1) as f64, y]).collect();
    let x = |label: &str, count: usize| Axis::around(label, [1.0, count.max(2) as f64], 0.0);
    let turns = &regime.iteration;
    let speeds = vec![
        ("start", numbered(turns.iter().map(|turn| turn.speed_start).collect())),
        ("end", numbered(turns.iter().map(|turn| turn.speed_end).collect())),
    ];
    let mut panels = Vec::new();
    if !turns.is_empty() {
        panels.push(plots::curves(
            "input speed at the ends of each cycle, rad/s",
            speeds,
            x("cycle", turns.len()),
            None,
        ));
    }
    let trials = &regime.trials;
    let Some(last) = trials.last() else { return panels };
    let mut lines = Vec::new();
    if let Some(ratio) = last.ratio {
        lines.push((
            "ratio",
            numbered(trials.iter().map(|trial| trial.ratio.unwrap_or(f64::NAN) / ratio).collect()),
        ));
    }
    if last.flywheel > 0.0 {
        lines.push((
            "flywheel",
            numbered(trials.iter().map(|trial| trial.flywheel / last.flywheel).collect()),
        ));
    }
    lines.push((
        "unevenness",
        numbered(trials.iter().map(|trial| trial.unevenness / last.unevenness).collect()),
    ));
    panels.push(plots::curves("trials, as parts of the values found", lines, x("trial", trials.len()), None));
    panels
}
