//! The list of symbols: each letter of tables, drawings and formulas with what it means and its unit.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_book::{Document, Table, Unit};
use assur_words::{Text, name, text, unit};

use crate::context::Context;

/// A symbol with its subscript behind `_`, the identity of its meaning, and its unit.
type Row = (&'static str, &'static str, Unit);

/// The symbols of the motion that has no unit of time: the coordinate and what is found by it.
fn of_motion(context: &Context<'_>) -> Vec<Row> {
    let kind = context.results.linkage.kind();
    let [speed, acceleration] = Unit::rates_of(kind);
    let mut rows = vec![("q", "note-symbol-coordinate", Unit::coordinate(kind))];
    if !kind.is_time() {
        rows.push(("ω_1", "note-symbol-input-speed", speed));
        rows.push(("ε_1", "note-symbol-input-acceleration", acceleration));
    }
    rows.extend([
        ("x, y", "note-symbol-place", Unit::LENGTH),
        ("φ", "note-symbol-angle", Unit::ANGLE),
        ("v", "note-symbol-velocity", Unit::MOVING[0]),
        ("a", "note-symbol-acceleration", Unit::MOVING[1]),
        ("ω", "note-symbol-angular-velocity", Unit::TURNING[0]),
        ("ε", "note-symbol-angular-acceleration", Unit::TURNING[1]),
        ("μ", "note-symbol-scale", Unit::NONE),
    ]);
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
    if !found.reactions.is_empty() {
        rows.push(("F", "note-symbol-force", Unit::FORCE));
        rows.push(("R", "note-symbol-reaction", Unit::FORCE));
        rows.push(("M", "note-symbol-moment", Unit::MOMENT));
    }
    if found.analysis.friction.is_some() {
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
        rows.push(("P", "note-symbol-power", Unit::POWER));
    }
    rows
}

/// The list of symbols, before everything that uses them.
pub(super) fn symbols(context: &Context<'_>, page: &mut Document) {
    let mechanism = &context.results.linkage.mechanism;
    let balancing = if mechanism.balances_by_moment() { "M" } else { "F" };
    let letter = |(symbol, ..): &Row| match symbol.split_once('_') {
        None if symbol.is_empty() => name(balancing).below(text!("note-index-of-balancing")),
        None => name(*symbol),
        Some((letter, index)) => name(letter).below(name(index)),
    };
    let rows = [of_motion(context), of_forces(context)].concat();
    let symbols = Table::each(text!("note-symbols-table"), rows)
        .column(text!("note-symbol"), letter)
        .column(text!("head-meaning"), |(_, meaning, _)| Text::message(meaning, Vec::new()))
        .column(text!("fact-unit"), |(.., own)| unit(own.name));
    page.heading(text!("note-symbols"));
    page.table(symbols.table());
}
