//! The conclusions: what was found, what proves it, and what is weak, all from the facts of the results.

use assur_analysis::results::Check;
use assur_book::{Document, Fact, Value};
use assur_report::topic::{self, About};
use assur_words::{Text, joined, number, text};

use crate::context::Context;

/// What a paragraph tells of, and the identity of its sentence.
const PARAGRAPHS: [(About, &str); 5] = [
    (About::Structure, "note-concluded-structure"),
    (About::Motion, "note-concluded-motion"),
    (About::Forces, "note-concluded-forces"),
    (About::Regime, "note-concluded-regime"),
    (About::Checks, "note-concluded-checks"),
];

pub(super) fn conclusions(context: &Context<'_>, page: &mut Document) {
    let analysis = &context.found.analysis;
    let facts = topic::results(analysis, &context.results.linkage);
    page.heading(text!("note-conclusions"));
    for (about, id) in PARAGRAPHS {
        let told = |fact| sentence(fact, &analysis.checks);
        let own = facts.iter().filter(|(of, _)| *of == about).map(|(_, fact)| told(fact));
        let own = joined("; ", own);
        if !own.is_empty() {
            page.paragraph(Text::message(id, vec![("facts", own)]));
        }
    }
    let motor = analysis.dynamics.iter().flat_map(|found| &found.motor).flat_map(|motor| &motor.warnings);
    let told = analysis.warnings.iter().filter(|warning| !warning.is_mistake()).map(Text::from);
    // Which motors were not taken is no remark on the results.
    let told = told.filter(|told| told.identity() != Some("analysis-motors-passed-over"));
    let weak: Vec<Text> = told.chain(motor.map(|warning| Text::from(&warning.text))).collect();
    let id = if weak.is_empty() { "note-concluded-nothing-weak" } else { "note-concluded-weak" };
    page.paragraph(text!(id));
    for remark in weak {
        page.paragraph(remark.heading());
    }
}

/// A fact in a row of others; that of the checks in words, where each of them has a verdict.
fn sentence(fact: &Fact, checks: &[Check]) -> Text {
    match (fact.id, &fact.value, &fact.at[..]) {
        ("fact-checks-hold", ..) if checks.iter().all(|check| check.finding.holds.is_some()) => {
            return text!("note-checks-all", count = number(checks.len()));
        }
        ("fact-self-braking" | "fact-dead-angle", Value::Number(_), [from, to]) => {
            let [from, to] = [fact.at_unit.number(*from), fact.at_unit.show(*to)];
            return text!("note-fact-stretch", what = fact.what(), from, to, length = fact.with_unit());
        }
        _ => {}
    }
    let place = if fact.is_constant { Text::default() } else { fact.place() };
    let sign = if matches!(fact.value, Value::Text(_)) { "—" } else { "=" };
    let told = joined(" ", [fact.what(), assur_words::name(sign), fact.with_unit()]);
    if place.is_empty() { told } else { text!("note-fact-at", fact = told, place) }
}
