//! The parts of the note: topics of the report with figures between them.

use assur_analysis::results::{Column, Failure, Owner, Quantity};
use assur_book::{Block, Document};
use assur_picture::{Look, Picture, Series, ViewPart, assembly, curves, mechanism, motion, plans, regime};
use assur_report::topic;
use assur_scene::Chapter;
use assur_words::{Text, joined, list, name, number, text, unit};

use crate::context::{Context, Told, is_zero, look, on_paper, show, show_frames};
use crate::formula::Finds;
use crate::{conclusions, forces, formula, symbols};

/// Pages of a mechanism, of several ones beside each other, and of plans, mm.
const MECHANISM: [f64; 2] = [160.0, 120.0];
const MECHANISMS: [f64; 2] = [170.0, 220.0];
const PLANS: [f64; 2] = [165.0, 165.0];
/// Page of all positions over each other, whose names need room, mm.
const OVERLAID: [f64; 2] = [165.0, 195.0];
/// Pages of three curves, of two, and of one, mm.
const TRANSFER: [f64; 2] = [160.0, 130.0];
const CURVES: [f64; 2] = [160.0, 120.0];
const CURVE: [f64; 2] = [160.0, 80.0];
/// Page of the energy-mass diagram, and of the link of reduction, mm.
const DIAGRAM: [f64; 2] = [130.0, 110.0];
const LINK: [f64; 2] = [165.0, 75.0];
/// Page of the two drives, mm.
const PLACES: [f64; 2] = [165.0, 90.0];
/// Width of the assembly and height of a row of its panels, mm.
const PANELS: [f64; 2] = [165.0, 85.0];
/// Positions over each other, of a cycle, and of a motion over a part of one.
const OVER: usize = 12;
const OVER_PART: usize = 7;

/// Writes a part of the note.
type Part = fn(&Context<'_>, &mut Document);

pub(super) fn document(context: &Context<'_>) -> Result<Document, Text> {
    let mut page = Document::default();
    symbols::symbols(context, &mut page);
    let parts: [(Chapter, Part); 6] = [
        (Chapter::Task, task),
        (Chapter::Structure, structure),
        (Chapter::Kinematics, kinematics),
        (Chapter::Forces, forces::forces),
        (Chapter::Dynamics, dynamics),
        (Chapter::Energy, formula::energy),
    ];
    for (_, part) in parts.iter().filter(|(chapter, _)| context.note.has(*chapter)) {
        part(context, &mut page);
    }
    curves(context, &mut page)?;
    if context.note.has(Chapter::Results) {
        main_results(context, &mut page);
        context.tell(&mut page, &[topic::further]);
    }
    if context.note.has(Chapter::Working) {
        formula::working(context, &mut page)?;
    }
    let parts: [(Chapter, Part); 4] = [
        (Chapter::Checks, checks),
        (Chapter::Model, limits),
        (Chapter::Conclusions, conclusions::conclusions),
        (Chapter::Sources, sources),
    ];
    for (_, part) in parts.iter().filter(|(chapter, _)| context.note.has(*chapter)) {
        part(context, &mut page);
    }
    let has_friction = context.found.analysis.friction.is_some();
    context.formulas.resolve(&mut page, context.positions[0], has_friction);
    Ok(page)
}

/// The most important numbers of what was found.
fn main_results(context: &Context<'_>, page: &mut Document) {
    let facts = topic::summary(&context.found.analysis, &context.results.linkage);
    page.heading(text!("report-results"));
    page.facts(text!("note-main-results"), facts);
    page.paragraph(text!("report-between"));
}

/// The further diagrams that the scene asks for.
///
/// # Errors
///
/// In words: a column that the results don't have.
fn curves(context: &Context<'_>, page: &mut Document) -> Result<(), Text> {
    if context.note.curves.is_empty() {
        return Ok(());
    }
    page.heading(text!("note-curves"));
    for names in &context.note.curves {
        let column = |name: &String| {
            let (mut look, shown) = (context.first(), (Picture::Curves, ViewPart::Overview));
            let told = |text: &Text| text.render(context.language);
            let found = look.choose(context.results, shown, name, told);
            let series = found.ok().and_then(|()| context.results.column(look.column));
            series.map(|series| series.short.clone()).ok_or_else(|| no_column(name))
        };
        let picked: Vec<String> = names.iter().map(column).collect::<Result<_, _>>()?;
        let figure = curves::with_legend(context.results, &Look { picked: &picked, ..context.first() });
        let titles = picked.iter().filter_map(|short| context.results.named(short)).map(Series::title);
        let caption = text!("note-curves-of", over = context.over(), of = list(titles));
        show(page, "note-see-curves", (on_paper(figure), CURVES), caption);
    }
    Ok(())
}

fn no_column(column: &str) -> Text {
    text!("note-no-column", column = name(column.to_owned()))
}

/// The works that the calculation follows.
fn sources(_: &Context<'_>, page: &mut Document) {
    page.heading(text!("note-sources"));
    for source in ["note-source-s", "note-source-e", "note-source-d", "note-source-l"] {
        page.paragraph(text!(source));
    }
}

/// The mechanism as it is given, drawn, moving.
fn task(context: &Context<'_>, page: &mut Document) {
    page.heading(text!("report-task"));
    page.blocks.extend(context.note.task.clone().map(Block::Paragraph));
    page.paragraph(topic::task_text(&context.source()));
    if context.results.samples().is_some() {
        page.paragraph(text!("note-instants", places = context.places()));
    }
    context.tell(page, &[topic::dimensions, topic::loads_given, topic::motion_given]);
    let results = context.results;
    let frame = |position| on_paper(mechanism::figure(results, &look(position), &[]));
    let frames = results.frames().map(frame).filter(|frame| !frame.panels.is_empty());
    let frames: Vec<_> = frames.collect();
    let caption = text!("note-mechanism-moving", at = context.place(results.first_position()));
    show_frames(page, "note-see-mechanism", (frames, MECHANISM), caption);
    let others = evenly(results.positions(), results.is_cycle());
    let over = on_paper(assembly::positions(results, &others, context.positions[0]));
    let caption = text!("note-all-positions", place = context.place(context.positions[0]));
    show(page, context.told("note-see-all-positions"), (over, OVERLAID), caption);
}

/// The positions that are drawn over each other; of a motion that doesn't return to its first one, with the last.
fn evenly(count: usize, is_cycle: bool) -> Vec<usize> {
    let most = if is_cycle { OVER } else { OVER_PART };
    if count <= most {
        return (0..count).collect();
    }
    let (steps, parts) = if is_cycle { (count, most) } else { (count - 1, most - 1) };
    (0..most).map(|at| at * steps / parts).collect()
}

/// Mobility, pairs, groups, and the mechanism assembled group by group.
fn structure(context: &Context<'_>, page: &mut Document) {
    page.heading(text!("report-structure"));
    context.tell(page, &[topic::mobility, topic::pairs, topic::groups]);
    let figure = on_paper(assembly::groups(context.results, context.positions[0]));
    let size = [PANELS[0], PANELS[1] * figure.rows() as f64];
    let place = context.place(context.positions[0]);
    let (told, what) = if context.results.linkage.structure.groups.is_empty() {
        ("note-see-input-link", text!("note-input-apart"))
    } else {
        ("note-see-assembly", text!("note-parts-apart"))
    };
    show(page, told, (figure, size), text!("note-assembly", what, place));
}

/// The mechanism and its plans in the chosen positions, tables of rates, curves of the last quantity.
fn kinematics(context: &Context<'_>, page: &mut Document) {
    page.heading(text!("note-kinematics"));
    page.paragraph(text!("note-kinematics-text"));
    let results = context.results;
    let drawn = context.beside(|look| mechanism::figure(results, look, &[]));
    let caption = text!("note-mechanism-at", place = context.places());
    show(page, "note-see-positions", (drawn, MECHANISMS), caption);
    for (kind, told, caption) in [
        (ViewPart::Velocities, "note-see-velocities", text!("note-velocity-plan", place = context.places())),
        (
            ViewPart::Accelerations,
            "note-see-accelerations",
            text!("note-acceleration-plan", place = context.places()),
        ),
    ] {
        let figure = context.beside(|look| plans::figure(results, look, kind));
        let several = context.positions.len() > 1;
        let caption = if several { context.with_legend(caption) } else { caption };
        show(page, told, (figure, PLANS), caption);
    }
    context.tell(page, &[topic::rates_of_points, topic::rates_of_links]);
    context.formulas.refer(page, Finds::Motion);
    // The last quantity is that of the last slide, or of the last link: what the mechanism is for.
    let transfer = results.transfers.len().saturating_sub(1);
    let curves = curves::figure(results, &Look { transfer, ..context.first() });
    let of = &curves.title;
    let is_time = results.linkage.kind().is_time();
    let caption = if is_time { text!("note-course", of) } else { text!("note-transfer", of) };
    let told = match results.transfers.last().map(|transfer| transfer.owner) {
        _ if is_time => "note-see-course-of",
        Some(Owner::Slide(_)) => "note-see-displacement",
        Some(Owner::Link(_)) => "note-see-angle",
        _ => "note-see-transfer",
    };
    let told = Told(told, vec![("over", context.over()), ("of", of.clone())]);
    show(page, told, (on_paper(curves), TRANSFER), caption);
}

/// Numbers, iteration and curves of the regime; curves of the motion where there is no regime.
fn dynamics(context: &Context<'_>, page: &mut Document) {
    let (results, look) = (context.results, &context.first());
    let of_motion = |part| on_paper(motion::figure(results, look, part, usize::MAX));
    let of_drive = |part| on_paper(regime::drive(results, look, part, 1));
    let facts = topic::regime_facts(&context.found.analysis);
    if facts.is_empty() {
        let mut figure = of_motion(ViewPart::Overview);
        if figure.panels.is_empty() {
            return;
        }
        figure.panels.retain(|panel| !is_zero(panel));
        page.heading(text!("report-motion"));
        reduced_inertia(context, page);
        show(page, "note-see-motion", (figure, CURVES), text!("note-motion-curves"));
        return;
    }
    page.heading(text!("note-dynamics"));
    page.paragraph(text!("note-dynamics-text"));
    page.facts(text!("note-regime"), facts);
    reduced_inertia(context, page);
    let reduction = context.beside(|look| regime::drive(results, look, ViewPart::Reduction, 1));
    let caption = text!("note-link-of-reduction", place = context.places());
    let course = (of_motion(ViewPart::Course), CURVES);
    show(page, "note-see-course", course, text!("note-speed-and-moments"));
    let shares = (on_paper(regime::shares_on_paper(results, look)), CURVE);
    show(page, "note-see-shares", shares, context.with_legend(text!("note-shares-drawn")));
    let diagram = (of_drive(ViewPart::EnergyMass), DIAGRAM);
    show(page, "note-see-energy-mass", diagram, text!("note-energy-mass"));
    let iteration = (of_motion(ViewPart::Iteration), CURVES);
    show(page, "note-see-iteration", iteration, text!("note-iteration-drawn"));
    show(page, "note-see-reduction", (reduction, LINK), caption);
    context.tell(page, &[topic::iteration, topic::drive]);
    // The last panel repeats the moments.
    let mut drive = of_drive(ViewPart::Curves);
    drive.panels.pop();
    formula::drive(context, page);
    show(page, "note-see-characteristic", (drive, CURVES), text!("note-characteristic"));
    let places = (of_drive(ViewPart::Places), PLACES);
    show(page, "note-see-places", places, text!("note-places-drawn"));
}

/// J and its derivative in one diagram (S fig. 8); nothing where there is no mass.
fn reduced_inertia(context: &Context<'_>, page: &mut Document) {
    let found = context.found;
    let of =
        |quantity| found.series.iter().find(|series| series.column == Column::of(quantity, Owner::Input));
    let both = [Quantity::ReducedInertia, Quantity::ReducedInertiaDerivative].map(of);
    let [Some(inertia), Some(slope)] = both else { return };
    if inertia.size() > 0.0 {
        let picked = &[inertia, slope].map(|series| series.short.clone());
        let mut figure = curves::with_legend(context.results, &Look { picked, ..context.first() });
        let heading = |symbol, series: &Series| list([name(symbol), unit(series.unit.name)]);
        let title = joined("; ", [heading("J", inertia), heading("J'", slope)]);
        figure.panels.iter_mut().for_each(|panel| panel.title.clone_from(&title));
        let caption = context.with_legend(text!("note-reduced-inertia-drawn"));
        show(page, "note-see-inertia", (on_paper(figure), CURVE), caption);
    }
}

fn checks(context: &Context<'_>, page: &mut Document) {
    let found = context.found;
    if !found.analysis.checks.is_empty() {
        page.heading(text!("report-checks"));
        page.paragraph(text!("note-checks-text"));
        topic::checks(&found.analysis.checks, page);
    }
}

/// What the model leaves out, what was decided on the way, and what could not be found.
fn limits(context: &Context<'_>, page: &mut Document) {
    page.heading(text!("note-model"));
    let has_friction = context.found.analysis.friction.is_some();
    let model = if has_friction { "note-model-text-friction" } else { "note-model-text" };
    page.paragraph(text!(model));
    let (analysis, broken) = (&context.found.analysis, &context.results.broken);
    // What is probably not meant in the scene is for who writes it, and is told beside the note.
    let told = analysis.warnings.iter().filter(|warning| !warning.is_mistake());
    told.for_each(|note| page.paragraph(Text::from(note)));
    let positions = |all: Vec<usize>| list(all.into_iter().map(number));
    if !broken.is_empty() {
        page.paragraph(text!("note-no-position", positions = positions(broken.keys().copied().collect())));
    }
    let placed = |failure: &&Failure| !broken.contains_key(&failure.index);
    let failures: Vec<&Failure> = analysis.failures.iter().filter(placed).collect();
    if let Some(first) = failures.first() {
        let reason = Text::from(&first.message);
        let all = positions(failures.iter().map(|failure| failure.index).collect());
        page.paragraph(text!("note-no-forces", positions = all, reason));
    }
    if let Some(why) = &analysis.no_motion {
        page.paragraph(Text::from(why));
    }
}
