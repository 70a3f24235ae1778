//! The list of symbols: each letter of tables, drawings and formulas with what it means and its unit.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_book::{Document, Table, Unit};
use assur_scene::Chapter;
use assur_words::{Text, list, name, text, unit};

use crate::context::Context;
use crate::working;

/// A symbol with its subscript behind `_`, the identity of its meaning, and its unit.
type Row = (&'static str, &'static str, Unit);

/// Stands for the names of the position function and its derivatives, which a language has.
const FUNCTIONS: &str = "PF";
/// Stands for the upper indices of the plans of accelerations, which a language has.
const UPPER: &str = "upper";

/// The letters above the symbols of accelerations.
fn upper() -> Text {
    let letters = [
        text!("plan-symbol-normal"),
        text!("plan-symbol-tangential"),
        text!("plan-symbol-coriolis"),
        text!("plan-symbol-relative"),
    ];
    list(letters)
}

/// The symbols of the motion that has no unit of time: the coordinate and what is found by it.
fn of_motion(context: &Context<'_>) -> Vec<Row> {
    let kind = context.results.linkage.kind();
    let [speed, acceleration] = Unit::rates_of(kind);
    let mut rows = vec![];
    if context.note.has(Chapter::Structure) {
        rows.push(("W", "note-symbol-mobility", Unit::NONE));
        rows.push(("n", "note-symbol-moving", Unit::NONE));
        rows.push(("p_5", "note-symbol-pairs", Unit::NONE));
    }
    rows.push(("q", "note-symbol-coordinate", Unit::coordinate(kind)));
    if !kind.is_time() {
        rows.push((FUNCTIONS, "note-symbol-position-function", Unit::NONE));
    }
    // Of an input that turns they are among the rates of links.
    if !kind.is_time() && !kind.is_angle() {
        rows.push(("ω", "note-symbol-input-speed", speed));
        rows.push(("ε", "note-symbol-input-acceleration", acceleration));
    }
    rows.extend([
        ("x, y", "note-symbol-place", Unit::LENGTH),
        ("φ", "note-symbol-angle", Unit::ANGLE),
        ("v", "note-symbol-velocity", Unit::MOVING[0]),
        ("a", "note-symbol-acceleration", Unit::MOVING[1]),
        ("ω", "note-symbol-angular-velocity", Unit::TURNING[0]),
        ("ε", "note-symbol-angular-acceleration", Unit::TURNING[1]),
    ]);
    if context.note.has(Chapter::Kinematics) {
        rows.push((UPPER, "note-symbol-upper", Unit::NONE));
    }
    rows.push(("μ", "note-symbol-scale", Unit::NONE));
    rows
}

/// Those of masses and forces, where the scene has some.
fn of_forces(context: &Context<'_>) -> Vec<Row> {
    let found = context.found;
    let mechanism = &context.results.linkage.mechanism;
    let mut rows = Vec::new();
    if mechanism.heavy_links().next().is_some() {
        rows.push(("m", "note-symbol-mass", Unit::KILOGRAM));
        rows.push(("I", "note-symbol-inertia", Unit::INERTIA));
        let [inertia, _] = Unit::inertias(context.results.linkage.kind());
        rows.push(("J", "note-symbol-reduced-inertia", inertia));
    }
    if context.note.has(Chapter::Working) && mechanism.motion.is_some() {
        let moment = Unit::load_of(context.results.linkage.kind());
        rows.push(("Q", "note-symbol-reduced-load", moment));
    }
    if !found.reactions.is_empty() {
        rows.push(("F", "note-symbol-force", Unit::FORCE));
        rows.push(("R", "note-symbol-reaction", Unit::FORCE));
        rows.push(("M", "note-symbol-moment", Unit::MOMENT));
    }
    let has_slides = !mechanism.slides.is_empty();
    if has_slides && !found.reactions.is_empty() {
        rows.push(("N", "note-symbol-normal", Unit::FORCE));
    }
    if found.analysis.friction.is_some() {
        rows.push(("f", "note-symbol-coefficient", Unit::NONE));
        rows.push(("ρ", "note-symbol-circle", Unit::LENGTH));
        rows.push(("M_f", "note-symbol-friction-moment", Unit::MOMENT));
        rows.push(("F_f", "note-symbol-friction-force", Unit::FORCE));
        rows.push(("P_f", "note-symbol-friction-power", Unit::POWER));
    }
    let has = |quantity| found.rows().0.schema().find(Column::of(quantity, Owner::Input)).is_some();
    if has(Quantity::Balancing) {
        rows.push(("", "note-symbol-balancing", Unit::load(mechanism.balances_by_moment())));
    }
    if found.analysis.dynamics.is_some() {
        rows.push(("δ", "note-symbol-unevenness", Unit::NONE));
    }
    rows
}

/// Those of works, energies and powers, where the note has some.
fn of_energy(context: &Context<'_>) -> Vec<Row> {
    let analysis = &context.found.analysis;
    let mut rows = Vec::new();
    let has_energy = analysis.dynamics.is_some()
        || !working::energy(analysis, &context.results.linkage.mechanism).is_empty();
    if has_energy {
        rows.push(("A", "note-symbol-work", Unit::JOULE));
        rows.push(("T", "note-symbol-kinetic", Unit::JOULE));
    }
    if analysis.dynamics.is_some() || context.note.has(Chapter::Working) {
        rows.push(("P", "note-symbol-power", Unit::POWER));
    }
    let motor = analysis.dynamics.as_ref().is_some_and(|found| found.motor.is_some());
    if motor {
        rows.push(("η", "note-symbol-efficiency", Unit::NONE));
    }
    rows
}

/// The list of symbols, before everything that uses them.
pub(super) fn symbols(context: &Context<'_>, page: &mut Document) {
    let mechanism = &context.results.linkage.mechanism;
    let balancing = if mechanism.balances_by_moment() { "M" } else { "F" };
    let letter = |(symbol, ..): &Row| match symbol.split_once('_') {
        None if *symbol == FUNCTIONS => text!("note-functions"),
        None if *symbol == UPPER => upper(),
        None if symbol.is_empty() => name(balancing).below(text!("note-index-of-balancing")),
        None => name(*symbol),
        Some((letter, index)) => name(letter).below(name(index)),
    };
    let rows = [of_motion(context), of_forces(context), of_energy(context)].concat();
    let symbols = Table::each(text!("note-symbols-table"), rows)
        .column(text!("note-symbol"), letter)
        .column(text!("head-meaning"), |(_, meaning, _)| Text::message(meaning, Vec::new()))
        .column(text!("fact-unit"), |(.., own)| unit(own.name));
    page.heading(text!("note-symbols"));
    page.table(symbols.table());
}
