//! Forces: polygons of every group with their vectors, the construction of the force analyzer where it has one (L fig. 1),
//! reactions, the balancing load.

use assur_analysis::results::Owner;
use assur_book::{Block, Document, Table, Unit, catalogue};
use assur_diagram::PlanVector;
use assur_figure::{Figure, Ink, Panel, Stroke};
use assur_force::{Construction, ConstructionStep, VectorKind};
use assur_mechanism::{Friction, LinkId, Load, LoadKind, Surfaces};
use assur_picture::forces::{self, beside_friction};
use assur_picture::{Look, Reaction, Series, ViewPart, assembly, curves, plans, plots, polygons};
use assur_report::topic;
use assur_words::{Text, list, measured, name, number, text, unit};

use crate::context::{Context, Told, on_paper, show, still};
use crate::formula::Finds;

/// Page of two polygons, and of a curve beside its hodograph, mm.
const POLYGONS: [f64; 2] = [165.0, 150.0];
const CURVE: [f64; 2] = [165.0, 85.0];
/// Page of two calculation schemes, and of the lever, mm.
const SCHEMES: [f64; 2] = [165.0, 110.0];
const LEVER: [f64; 2] = [150.0, 120.0];
/// Loads in one figure.
const MOST_LOADS: usize = 4;
/// Pairs with friction in one figure.
const MOST_CIRCLES: usize = 8;
/// Reactions in one diagram: there are so many strokes.
const MOST_REACTIONS: usize = 4;

/// Polygons and reactions in the chosen positions, curves of the greatest reaction and of the balancing load; nothing without
/// forces.
pub(super) fn forces(context: &Context<'_>, page: &mut Document) {
    let found = context.found;
    if found.reactions.is_empty() {
        return;
    }
    page.heading(text!("note-forces"));
    if let Some(method) = found.plans.calculation().analyzer {
        page.paragraph(text!("note-forces-text", wording = method.wording.clone()));
    }
    let drawn = loads(context);
    let size = [CURVE[0], 25.0 + 35.0 * drawn.rows() as f64];
    let is_spring = |load: &Load| matches!(load.kind, LoadKind::Spring(_));
    let has_spring = context.results.linkage.mechanism.loads.iter().any(is_spring);
    let caption = if has_spring { "note-loads-drawn-with-spring" } else { "note-loads-drawn" };
    let caption = Text::message(caption, vec![("over", context.over())]);
    show(page, context.told("note-see-loads"), (drawn, size), caption);
    context.tell(page, &[topic::inertia_loads]);
    polygons(context, page);
    lever(context, page);
    construction(context, page);
    context.tell(page, &[topic::reactions_at_positions, topic::balancing_at_positions]);
    friction(context, page);
    context.formulas.refer(page, Finds::Forces);
    touching(context, page);
    over_cycle(context, page);
}

/// The formulas of friction before its tables, of which that of efficiency and self-locking has its own title here.
fn friction(context: &Context<'_>, page: &mut Document) {
    if context.found.analysis.friction.is_none() {
        return;
    }
    let [moment, force] = ["M", "F"].map(|letter| name(letter).below(name("f")));
    page.paragraph(text!("note-friction-formulas", moment, force));
    let before = page.blocks.len();
    context.tell(page, &[topic::friction_tables]);
    for block in &mut page.blocks[before..] {
        if let Block::Facts { caption, .. } = block {
            *caption = text!("note-friction-facts");
        }
    }
}

/// The reactions of the pairs with friction in the first of the chosen positions, touching the circles of friction.
fn touching(context: &Context<'_>, page: &mut Document) {
    let (found, position) = (context.found, context.positions[0]);
    let of = |reaction| beside_friction(found, position, reaction);
    let panels: Vec<Panel> = found.reactions.iter().filter_map(of).take(MOST_CIRCLES).collect();
    if panels.is_empty() {
        return;
    }
    page.paragraph(text!("note-friction-touches"));
    let is_on_ends = |friction: &Friction| matches!(friction.surfaces, Surfaces::Faces { .. });
    if found.linkage.mechanism.frictions.iter().any(is_on_ends) {
        page.paragraph(text!("note-friction-on-ends"));
    }
    let figure = Figure { panels, columns: 2, ..Figure::default() };
    let size = [CURVE[0], 58.0 * figure.rows() as f64];
    let caption = text!("note-friction-drawn", place = context.place(position));
    show(page, "note-see-friction", (figure, size), caption);
}

/// The values of the loads that vary over the cycle (S fig. 6), the first ones of many.
fn loads(context: &Context<'_>) -> Figure {
    let (results, found) = (context.results, context.found);
    let of = |series: &Series| {
        let Owner::Load(_) = series.column.owner else { return None };
        let title = catalogue::owner(found.rows().0.schema(), series.column);
        let nodes = series.course.nodes();
        let varies = nodes.iter().any(|node| (node.value - nodes[0].value).abs() > 0.0);
        let whole = nodes.len() == results.positions();
        let curve = [(series, Stroke::Solid, Ink::First)];
        let heading = [title, Text::default()];
        let mut panel = plots::over_positions(results.base(&context.first()), heading, &curve, Vec::new());
        still(&mut panel);
        (varies && whole).then_some(panel)
    };
    let panels: Vec<Panel> = found.series.iter().filter_map(of).take(MOST_LOADS).collect();
    Figure { panels, columns: 1, ..Figure::default() }
}

/// The polygon of each group in the chosen positions beside each other, with a table of its vectors.
fn polygons(context: &Context<'_>, page: &mut Document) {
    let (results, found) = (context.results, context.found);
    let (mut is_first, mut is_first_inner) = (true, true);
    for (polygon, links) in polygons::bodies(results).iter().enumerate() {
        let vectors = |position: &usize| {
            let all = polygons::vectors(results, *position, polygon, links).into_iter();
            all.map(|(symbol, item)| (*position, symbol, item)).collect::<Vec<_>>()
        };
        let vectors: Vec<Row> = context.positions.iter().flat_map(vectors).collect();
        let drawn = |look: &Look<'_>| polygons::polygon(results, look.position, polygon, links);
        let plan = found.plans.at(context.positions[0]);
        let plan = plan.sheet.as_ref().ok().and_then(|sheet| sheet.polygons.get(polygon));
        let Some(title) = plan.map(|plan| &plan.title).filter(|_| !vectors.is_empty()) else { continue };
        if std::mem::take(&mut is_first) {
            page.paragraph(text!("note-forces-polygons"));
        }
        let has_inner = vectors.iter().any(|(.., item)| item.kind == VectorKind::Inner);
        if has_inner && std::mem::take(&mut is_first_inner) {
            page.paragraph(text!("note-forces-polygons-inner"));
        }
        loaded(context, page, links);
        let caption = text!("note-force-polygon", title, place = context.places());
        show(page, "note-see-polygon", (context.beside(drawn), POLYGONS), caption);
        page.table(table_of(vectors, text!("note-polygon-vectors", title)));
    }
}

/// The calculation scheme of some links: they alone, with their loads and the reactions of the others, in the chosen positions.
fn loaded(context: &Context<'_>, page: &mut Document, links: &[LinkId]) {
    let results = context.results;
    let drawn = context.beside(|look| assembly::loaded(results, look.position, links));
    let names = list(links.iter().map(|link| Text::from(&results.linkage.mechanism.links[*link].name)));
    let of = text!("note-links", count = links.len(), links = names);
    let caption = text!("note-loaded", of = &of, place = context.places());
    show(page, Told("note-see-loaded", vec![("of", of)]), (drawn, SCHEMES), caption);
}

/// Zhukovsky's lever in the first of the chosen positions, unless the construction of the force analyzer is drawn with its own.
fn lever(context: &Context<'_>, page: &mut Document) {
    let plans = context.found.plans.at(context.positions[0]);
    if plans.constructions.iter().any(|(method, _)| *method == context.found.analyzer) {
        return;
    }
    let look = Look { alone: true, ..context.first() };
    let caption = text!("note-lever", place = context.place(context.positions[0]));
    show(page, "note-see-lever", (on_paper(plans::lever(context.results, &look)), LEVER), caption);
}

/// A vector of a position with its symbol.
type Row = (usize, Text, PlanVector);

fn table_of(vectors: Vec<Row>, caption: Text) -> Table {
    let what = |item: &PlanVector| match item.kind {
        VectorKind::Reaction => text!("note-symbol-reaction"),
        _ => item.name.clone(),
    };
    Table::each(caption, vectors.into_iter().filter(|(.., item)| item.kind != VectorKind::Inner))
        .column(text!("note-position"), |(position, ..)| number(position))
        .column(text!("head-vector"), |(_, symbol, _)| symbol.clone())
        .column(text!("note-force"), |(.., item)| what(item))
        .column(text!("head-acts"), |(.., item)| item.note.clone())
        .measured(text!("note-size"), Unit::FORCE, |(.., item)| item.size)
        .table()
}

/// The greatest reaction with its hodograph, and the balancing load.
fn over_cycle(context: &Context<'_>, page: &mut Document) {
    let (results, found) = (context.results, context.found);
    let pairs = found.reactions.iter().enumerate().filter(|(_, reaction)| reaction.series.len() == 3);
    let size = |(index, reaction): (usize, &Reaction)| (index, found.series[reaction.series[2]].size());
    // What is rounding shows nothing.
    let is_seen = |index: usize| found.series[index].size() > found.series[index].least();
    let pairs = pairs.filter(|(_, reaction)| is_seen(reaction.series[2]));
    let most = pairs.clone().map(size).max_by(|one, other| one.1.total_cmp(&other.1)).map(|(index, _)| index);
    let moduli = pairs.filter_map(|(_, reaction)| reaction.series.last());
    let moduli: Vec<String> = moduli.map(|index| found.series[*index].short.clone()).collect();
    let is_balancing = |reaction: &Reaction| {
        reaction.of.is_none() && reaction.series.first().is_some_and(|index| is_seen(*index))
    };
    let balancing = found.reactions.iter().position(is_balancing);
    let of = most.map(|index| found.reactions[index].name.clone()).unwrap_or_default();
    let balance = balancing.and_then(|index| found.reactions[index].series.first());
    let symbol = balance.map(|index| unit(found.series[*index].unit.name));
    // All of them together, as L fig. 2 has them.
    for picked in moduli.chunks(MOST_REACTIONS) {
        let together = curves::with_legend(results, &Look { picked, ..context.first() });
        let caption = context.with_legend(text!("note-reactions-drawn", over = context.over()));
        show(page, context.told("note-see-reactions"), (on_paper(together), CURVE), caption);
    }
    let all = [
        (
            most,
            ViewPart::Overview,
            Told::from("note-see-hodograph"),
            text!("note-reaction-curve", over = context.over(), of),
        ),
        (
            balancing,
            ViewPart::Curves,
            context.told("note-see-balancing"),
            list([Some(text!("note-balancing-curve", over = context.over())), symbol].into_iter().flatten()),
        ),
    ];
    for (index, part, told, caption) in all {
        let Some(reaction) = index else { continue };
        let figure = forces::figure(results, &Look { reaction, ..context.first() }, part);
        show(page, told, (on_paper(figure), CURVE), caption);
    }
}

/// Height of a row of two stages, mm, and width of the page.
const STAGES: [f64; 2] = [165.0, 95.0];

/// The construction in the first of the chosen positions; nothing for an analyzer without one.
fn construction(context: &Context<'_>, page: &mut Document) {
    let (position, place) = (context.positions[0], context.place(context.positions[0]));
    let found = context.found;
    let sheet = found.plans.at(position);
    let own = sheet.constructions.iter().position(|(method, _)| *method == found.analyzer);
    let Some((first, (_, drawn))) = own.map(|own| (sheet.steps_of(own).start, &sheet.constructions[own]))
    else {
        return;
    };
    let mut panels: Vec<Panel> = Vec::new();
    for last in stages(drawn) {
        let look = Look { step: first + last, ..context.first() };
        let figure = on_paper(plans::figure(context.results, &look, ViewPart::Construction));
        let title = text!("note-construction-stage", last = number(last + 1));
        panels.extend(figure.panels.into_iter().map(|panel| Panel { title: title.clone(), ..panel }));
    }
    let figure = Figure { panels, columns: 2, ..Figure::default() };
    let size = [STAGES[0], STAGES[1] * figure.rows() as f64];
    let caption = text!("note-construction", title = &drawn.title, place);
    show(page, "note-see-construction", (figure, size), caption);
    page.table(steps(drawn, text!("note-construction-steps", title = &drawn.title)));
}

/// The last steps of the stages: where forces follow points and lines, or the drawing changes.
fn stages(construction: &Construction) -> Vec<usize> {
    let stage = |step: &ConstructionStep| (step.drawing, step.unit == "N");
    let steps = &construction.steps;
    let ends =
        (0..steps.len()).filter(|at| steps.get(at + 1).is_none_or(|next| stage(next) != stage(&steps[*at])));
    // What a single point shows, the next stage shows too.
    ends.filter(|at| *at > 0).collect()
}

fn steps(construction: &Construction, caption: Text) -> Table {
    let size = |step: &ConstructionStep| {
        let length = step.vector[0].hypot(step.vector[1]);
        if length > 0.0 { measured(length, 5, step.unit) } else { Text::default() }
    };
    Table::each(caption, construction.steps.iter().enumerate())
        .column(text!("note-step"), |(at, _)| number(at + 1))
        .column(text!("head-vector"), |(_, step)| step.name.clone())
        .column(text!("note-size"), |(_, step)| size(step))
        .column(text!("head-acts"), |(_, step)| step.note.clone())
        .table()
}
