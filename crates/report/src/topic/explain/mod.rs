//! What is calculated for a scene and how, what is modeled and what is left out.

mod model;
mod stages;

use assur_analysis::{Methods, plan::Plan};
use assur_book::{Document, link_name};
use assur_mechanism::{LinkId, Mechanism};
use assur_structure::{Structure, roman};
use assur_words::{Text, joined, list, name, number, text};
use model::{modelled, not_modelled};

/// Structure, stages with their methods, what is modeled and what is not. `equation`: the equation of the motion and how it is
/// solved, where that is known ([`assur_analysis::method_of_motion`]).
pub fn explain(
    mechanism: &Mechanism,
    structure: &Structure,
    plan: &Plan,
    methods: &Methods,
    equation: Option<&Text>,
    page: &mut Document,
) {
    page.scene(&mechanism.title);
    page.heading(text!("report-structure"));
    describe_structure(mechanism, structure, plan, page);
    page.heading(text!("explain-stages"));
    for stage in stages::stages(mechanism, structure, methods, equation, plan) {
        page.paragraph(stage);
    }
    for (heading, remarks) in [
        (text!("explain-modelled"), modelled(mechanism)),
        (text!("explain-not-modelled"), not_modelled(mechanism)),
    ] {
        page.heading(heading);
        for remark in remarks {
            page.paragraph(remark);
        }
    }
}

fn describe_structure(mechanism: &Mechanism, structure: &Structure, plan: &Plan, page: &mut Document) {
    let count = &structure.mobility;
    page.paragraph(text!(
        "explain-mobility",
        links = number(count.moving_links),
        pairs = number(count.pairs),
        mobility = number(count.value)
    ));
    if !structure.passive.is_empty() {
        let parts = structure.passive.iter().map(|passive| passive.part.words(mechanism));
        page.paragraph(text!("explain-passive", parts = list(parts)));
    }
    page.paragraph(text!("report-formula", formula = &structure.formula));
    page.paragraph(text!("report-class", class = name(roman(structure.class()))));
    for (index, group) in structure.groups.iter().enumerate() {
        let left = match (plan.groups_needed[index], plan.forces && plan.by_groups) {
            (false, _) => Some(text!("explain-not-needed")),
            (true, true) if !plan.groups_carrying[index] => Some(text!("explain-carries-nothing")),
            _ => None,
        };
        let [summary, singular, source] =
            [&group.plugin.summary, &group.plugin.singular, &group.plugin.source].map(Text::from);
        let parts = [summary, text!("explain-singular-at", place = singular), source].into_iter().chain(left);
        page.paragraph(remark(structure.group_name(mechanism, index), joined("; ", parts)));
    }
}

/// Texts with commas between them, of many only the first ones.
fn first_of(all: Vec<Text>) -> Text {
    /// More names would hide the rest of the sentence.
    const MOST: usize = 6;
    let more = all.len().saturating_sub(MOST);
    let shown = list(all.into_iter().take(MOST));
    if more > 0 { text!("explain-and-more", names = shown, count = more) } else { shown }
}

fn links(mechanism: &Mechanism, ids: &[LinkId]) -> Text {
    list(ids.iter().map(|&id| link_name(mechanism, id)))
}

/// The names of the groups that are not selected; of many only the first ones.
fn others(mechanism: &Mechanism, structure: &Structure, chosen: &[bool]) -> Text {
    let left = (0..chosen.len()).filter(|index| !chosen[*index]);
    first_of(left.map(|index| structure.group_name(mechanism, index)).collect())
}

/// One thing that is or is not modeled, and how it is; or why it is not, and how it could be included.
fn remark(what: Text, how: Text) -> Text {
    text!("report-fact", what, value = how)
}

#[cfg(test)]
mod tests;
