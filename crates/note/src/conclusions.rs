//! The conclusions: what was found, what proves it, and what is weak, all from the facts of the results.

use assur_book::{Document, Fact, Value};
use assur_report::topic::{self, About};
use assur_words::{Text, joined, text};

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
        let own = facts.iter().filter(|(of, _)| *of == about).map(|(_, fact)| sentence(fact));
        let own = joined("; ", own);
        if !own.is_empty() {
            page.paragraph(Text::message(id, vec![("facts", own)]));
        }
    }
    let motor = analysis.dynamics.iter().flat_map(|found| &found.motor).flat_map(|motor| &motor.warnings);
    let told = analysis.warnings.iter().filter(|warning| !warning.is_mistake()).map(Text::from);
    let weak = told.chain(motor.map(|warning| Text::from(&warning.text)));
    let weak: Vec<Text> = weak.collect();
    if weak.is_empty() {
        page.paragraph(text!("note-concluded-nothing-weak"));
    } else {
        page.paragraph(text!("note-concluded-weak", facts = joined("; ", weak)));
    }
}

/// A fact in a row of others.
fn sentence(fact: &Fact) -> Text {
    let place = if fact.is_constant { Text::default() } else { fact.place() };
    let sign = if matches!(fact.value, Value::Text(_)) { "—" } else { "=" };
    let told = joined(" ", [fact.what(), assur_words::name(sign), fact.with_unit()]);
    if place.is_empty() { told } else { text!("note-fact-at", fact = told, place) }
}
