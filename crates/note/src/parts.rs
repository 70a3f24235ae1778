//! The parts of the note: topics of the report with figures between them.

use assur_analysis::results::{Column, Failure, Owner, Quantity};
use assur_book::{Block, Document};
use assur_figure::{Item, Panel};
use assur_picture::{Look, ViewPart, assembly, curves, mechanism, motion, plans, regime};
use assur_report::topic;
use assur_words::{Text, list, number, text};

use crate::context::{Context, look, on_paper};
use crate::{forces, formula};

/// Pages of a mechanism, of several ones beside each other, and of plans, mm.
const MECHANISM: [f64; 2] = [160.0, 110.0];
const MECHANISMS: [f64; 2] = [165.0, 100.0];
const PLANS: [f64; 2] = [165.0, 85.0];
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
const PANELS: [f64; 2] = [165.0, 78.0];

pub(super) fn document(context: &Context<'_>) -> Result<Document, Text> {
    let mut page = Document::default();
    let facts = topic::summary(&context.found.analysis, &context.results.linkage);
    page.heading(text!("report-results"));
    page.facts(text!("note-main-results"), facts);
    page.paragraph(text!("report-between"));
    for part in [task, structure, kinematics, forces::forces, dynamics, formula::energy] {
        part(context, &mut page);
    }
    context.tell(&mut page, &[topic::further]);
    formula::working(context, &mut page)?;
    checks(context, &mut page);
    limits(context, &mut page);
    Ok(page)
}

/// The mechanism as it is given, drawn, moving.
fn task(context: &Context<'_>, page: &mut Document) {
    page.heading(text!("report-task"));
    page.paragraph(topic::task_text(&context.source()));
    context.tell(page, &[topic::dimensions, topic::loads_given, topic::motion_given]);
    let results = context.results;
    let frame = |position| on_paper(mechanism::figure(results, &look(position), &[]));
    let frames = results.frames().map(frame).filter(|frame| !frame.panels.is_empty());
    let frames: Vec<_> = frames.collect();
    let caption = text!("note-mechanism-moving", at = context.place(results.first_position()));
    page.blocks.extend((!frames.is_empty()).then_some(Block::Figure { frames, size: MECHANISM, caption }));
}

/// Mobility, pairs, groups, and the mechanism assembled group by group.
fn structure(context: &Context<'_>, page: &mut Document) {
    page.heading(text!("report-structure"));
    context.tell(page, &[topic::mobility, topic::pairs, topic::groups]);
    let figure = assembly::groups(context.results, context.positions[0]);
    let size = [PANELS[0], PANELS[1] * figure.rows() as f64];
    let caption = text!("note-assembly", place = context.place(context.positions[0]));
    page.figure(figure, size, caption);
}

/// The mechanism and its plans in the chosen positions, tables of rates, curves of the last quantity.
fn kinematics(context: &Context<'_>, page: &mut Document) {
    page.heading(text!("note-kinematics"));
    page.paragraph(text!("note-kinematics-text"));
    let results = context.results;
    let drawn = context.beside(|look| mechanism::figure(results, look, &[]));
    page.figure(drawn, MECHANISMS, text!("note-mechanism-at", place = context.places()));
    for (kind, caption) in [
        (ViewPart::Velocities, text!("note-velocity-plan", place = context.places())),
        (ViewPart::Accelerations, text!("note-acceleration-plan", place = context.places())),
    ] {
        let figure = context.beside(|look| plans::figure(results, look, kind));
        page.figure(figure, PLANS, caption);
    }
    context.tell(page, &[topic::rates_of_points, topic::rates_of_links]);
    // The last quantity is that of the last slide, or of the last link: what the mechanism is for.
    let transfer = results.transfers.len().saturating_sub(1);
    let curves = curves::figure(results, &Look { transfer, ..context.first() });
    let of = &curves.title;
    let caption =
        if results.linkage.kind().is_time() { text!("note-course", of) } else { text!("note-transfer", of) };
    page.figure(on_paper(curves), TRANSFER, caption);
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
        page.figure(figure, CURVES, text!("note-motion-curves"));
        return;
    }
    page.heading(text!("note-dynamics"));
    page.paragraph(text!("note-dynamics-text"));
    page.facts(text!("note-regime"), facts);
    reduced_inertia(context, page);
    let reduction = context.beside(|look| regime::drive(results, look, ViewPart::Reduction, 1));
    let caption = text!("note-link-of-reduction", place = context.places());
    page.figure(of_motion(ViewPart::Course), CURVES, text!("note-speed-and-moments"));
    page.figure(of_drive(ViewPart::Inertia), CURVE, context.with_legend(text!("note-shares-drawn")));
    page.figure(of_drive(ViewPart::EnergyMass), DIAGRAM, text!("note-energy-mass"));
    page.figure(of_motion(ViewPart::Iteration), CURVES, text!("note-iteration-drawn"));
    page.figure(reduction, LINK, caption);
    context.tell(page, &[topic::iteration, topic::drive]);
    // The last panel repeats the moments.
    let mut drive = of_drive(ViewPart::Curves);
    drive.panels.pop();
    page.figure(drive, CURVES, text!("note-characteristic"));
    page.figure(of_drive(ViewPart::Places), PLACES, text!("note-places-drawn"));
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
        let figure = curves::figure(context.results, &Look { picked, ..context.first() });
        page.figure(on_paper(figure), CURVE, context.with_legend(text!("note-reduced-inertia-drawn")));
    }
}

/// Whether all curves of a panel are zero, and show nothing.
fn is_zero(panel: &Panel) -> bool {
    panel.items.iter().flat_map(Item::points).all(|[_, y]| y == 0.0 || !y.is_finite())
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
    page.paragraph(text!("note-sources"));
    let (analysis, broken) = (&context.found.analysis, &context.results.broken);
    analysis.warnings.iter().for_each(|note| page.paragraph(Text::from(note)));
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
