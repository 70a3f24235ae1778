//! Forces: polygons of every group with their vectors, reactions, the balancing load.

use assur_analysis::results::{Owner, Quantity};
use assur_figure::{Figure, Ink, Panel, Stroke};

use super::Context;
use super::document::{Block, still};
use super::kinematics::{cells, printed};
use crate::screen::state::{Part, Reaction, Series, View};
use crate::screen::view::{plans, plots};

/// Page of two polygons, and of a curve beside its hodograph, mm.
const POLYGONS: [f64; 2] = [165.0, 80.0];
const CURVE: [f64; 2] = [165.0, 85.0];
/// Loads in one figure.
const MOST_LOADS: usize = 4;
/// A force this small beside the greatest one of the position is rounding.
const ROUNDING: f64 = 1e-12;

/// Heading, polygons and reactions in the chosen positions, curves of the greatest reaction and of the balancing load;
/// nothing without forces.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let Some(found) = context.state.found().filter(|found| !found.reactions.is_empty()) else {
        return Vec::new();
    };
    let values = [("analyzer", found.analyzer.clone())];
    let mut blocks =
        vec![Block::Heading(words.get("forces")), Block::Text(words.with("forces-text", &values))];
    blocks.extend(loads(context));
    for &position in context.positions {
        blocks.extend(inertia_loads(context, position));
    }
    blocks.extend(polygons(context));
    for &position in context.positions {
        blocks.extend(reactions(context, position));
    }
    blocks.extend(curves(context));
    blocks
}

/// The values of the loads that vary over the cycle (S fig. 6), the first ones of many.
fn loads(context: &Context<'_>) -> Option<Block> {
    let (words, scene, found) = (context.words, context.state.scene.as_ref()?, context.state.found()?);
    let of = |series: &Series| {
        let Owner::Load(_) = series.column.owner else { return None };
        let title = words.name(&found.analysis.positions.schema().name(series.column.owner));
        let nodes = series.course.nodes();
        let varies = nodes.iter().any(|node| (node.value - nodes[0].value).abs() > 0.0);
        let whole = nodes.len() == scene.positions();
        let curve = [(series, Stroke::Solid, Ink::First)];
        let mut panel = plots::over_positions(
            context.state,
            scene,
            [assur_words::name(title), assur_words::Text::default()],
            &curve,
            Vec::new(),
        );
        still(&mut panel);
        (varies && whole).then_some(panel)
    };
    let panels: Vec<Panel> = found.series.iter().filter_map(of).take(MOST_LOADS).collect();
    let figure = Figure { panels, columns: 1, ..Figure::default() };
    let size = [CURVE[0], 25.0 + 35.0 * figure.rows() as f64];
    (!figure.panels.is_empty()).then(|| Block::picture(figure, size, words.get("loads-drawn")))
}

/// Principal vectors and principal moments of the inertia loads in a position.
fn inertia_loads(context: &Context<'_>, position: usize) -> Option<Block> {
    let (words, table) = (context.words, &context.state.found()?.analysis.positions);
    let row = table.row_of(position)?;
    let quantities = [Quantity::InertiaForce, Quantity::InertiaMoment];
    let owners = table.schema().owners(quantities[0]).into_iter();
    let rows = cells(words, table, row, owners, &quantities);
    let units = [("Φ_{x}", "N"), ("Φ_{y}", "N"), ("Φ", "N"), ("M_{Φ}", "N m")];
    let head = units.map(|(symbol, unit)| format!("{symbol}, {}", words.unit(unit)));
    let head = std::iter::once(words.get("link")).chain(head).collect();
    let caption = words.with("inertia-loads", &[("place", context.place(position))]);
    (!rows.is_empty()).then_some(Block::Table { caption, head, rows })
}

/// The polygon of each group in the chosen positions beside each other, with a table of its vectors.
fn polygons(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let count = |position: &usize| {
        let found = context.state.found()?;
        found.plans.at(*position).sheet.as_ref().ok().map(|sheet| sheet.polygons.len())
    };
    let count = context.positions.iter().filter_map(count).max().unwrap_or(0);
    let mut blocks = Vec::new();
    for polygon in 0..count {
        let (mut title, mut rows) = (String::new(), Vec::new());
        for position in context.positions {
            let Some(found) = context.state.found() else { continue };
            let sheet = found.plans.at(*position);
            let Some(plan) = sheet.sheet.as_ref().ok().and_then(|sheet| sheet.polygons.get(polygon)) else {
                continue;
            };
            title = plan.title.render(words.spoken());
            rows.extend(
                plans::labelled(Part::Forces, plan).into_iter().filter(|(label, _)| label != "..").map(
                    |(label, item)| {
                        let size = printed(words, item.size, 0.0);
                        vec![
                            position.to_string(),
                            label,
                            item.name.render(words.spoken()),
                            item.note.render(words.spoken()),
                            size,
                        ]
                    },
                ),
            );
        }
        let figure = context.beside(View::Plans, |state| {
            state.parts.insert(View::Plans, Part::Forces);
            state.chosen.polygon = polygon;
        });
        let values = [("title", title), ("place", context.places())];
        let caption = words.with("force-polygon", &values);
        blocks.extend(figure.map(|figure| Block::picture(figure, POLYGONS, caption)));
        if !rows.is_empty() {
            let mut head = ["position-number", "vector", "force", "acts"].map(|id| words.get(id)).to_vec();
            head.push(format!("F, {}", words.unit("N")));
            blocks.push(Block::Table { caption: words.with("polygon-vectors", &values[..1]), head, rows });
        }
    }
    blocks
}

/// The reactions and the balancing load in a position; of two links the force on the other one is opposite.
fn reactions(context: &Context<'_>, position: usize) -> Option<Block> {
    let (words, found) = (context.words, context.state.found()?);
    let at = |index: &usize| found.series[*index].at(position);
    let pairs =
        || found.reactions.iter().filter(|one| one.series.len() == 3 && at(&one.series[2]).is_finite());
    let limit = ROUNDING * pairs().map(|one| at(&one.series[2])).fold(0.0, f64::max);
    let dash = || "–".to_owned();
    let row = |one: &Reaction| {
        let [x, y, size] = [0, 1, 2].map(|part| at(&one.series[part]));
        let [down, across] = [y, x].map(|part| if part.abs() <= limit { 0.0 } else { part });
        let direction =
            if size > limit { printed(words, down.atan2(across).to_degrees(), 0.0) } else { dash() };
        let moment = one.moment.as_ref().map(at).filter(|moment| moment.is_finite());
        let mut cells = vec![words.name(&one.pair), words.name(&one.link)];
        cells.extend([x, y, size].map(|value| printed(words, value, limit)));
        cells.extend([direction, moment.map_or_else(dash, |moment| printed(words, moment, limit))]);
        cells
    };
    let mut rows: Vec<Vec<String>> = pairs().map(row).collect();
    if let Some(load) = found.balancing().filter(|load| load.at(position).is_finite()) {
        let mut cells = vec![words.get("balancing-load")];
        cells.resize(7, dash());
        cells[if load.unit == "N" { 4 } else { 6 }] = printed(words, load.at(position), 0.0);
        rows.push(cells);
    }
    let newton = words.unit("N");
    let mut head = vec![words.get("pair"), words.get("on-link")];
    head.extend(["F_{x}", "F_{y}", "F"].map(|symbol| format!("{symbol}, {newton}")));
    head.extend([words.get("direction"), format!("M, {}", words.unit("N m"))]);
    let caption = words.with("reactions", &[("place", context.place(position))]);
    Some(Block::Table { caption, head, rows })
}

/// The greatest reaction with its hodograph, and the balancing load.
fn curves(context: &mut Context<'_>) -> Vec<Block> {
    let (words, position) = (context.words, context.positions[0]);
    let Some(found) = context.state.found() else { return Vec::new() };
    let pairs = found.reactions.iter().enumerate().filter(|(_, reaction)| reaction.series.len() == 3);
    let size = |(index, reaction): (usize, &Reaction)| (index, found.series[reaction.series[2]].size());
    let most = pairs.map(size).max_by(|one, other| one.1.total_cmp(&other.1)).map(|(index, _)| index);
    let balancing = found.reactions.iter().position(|reaction| reaction.pair.is_empty());
    let name = most.map(|index| found.reactions[index].name.render(words.spoken())).unwrap_or_default();
    let of = [("of", words.phrase(&name))];
    let all = [
        (most, Part::Overview, words.with("reaction-curve", &of)),
        (balancing, Part::Curves, words.get("balancing")),
    ];
    let mut blocks = Vec::new();
    for (index, part, caption) in all {
        let Some(index) = index else { continue };
        let figure = context.figure(View::Forces, position, |state| {
            state.parts.insert(View::Forces, part);
            state.chosen.reaction = index;
        });
        blocks.extend(figure.map(|(figure, _)| Block::picture(figure, CURVE, caption)));
    }
    blocks
}
