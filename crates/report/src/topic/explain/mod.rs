//! What is calculated for a scene and how, what is modelled and what is left out.

mod kinematics;
mod missing;
mod model;
mod stages;

use assur_analysis::Methods;
use assur_analysis::plan::Plan;
use assur_book::{Document, link_name};
use assur_mechanism::{LinkId, Mechanism};
use assur_structure::{Structure, roman};
use assur_words::{Text, joined, list, name, number, text};
use missing::not_modelled;
use model::modelled;

/// Structure, stages with their methods, what is modelled and what is not. `equation`: the equation of the motion and how it is
/// solved, where that is known ([`assur_analysis::method_of_motion`]).
pub fn explain(
    mechanism: &Mechanism,
    structure: &Structure,
    plan: &Plan,
    methods: &Methods,
    equation: Option<&Text>,
    page: &mut Document,
) {
    if !mechanism.title.is_empty() {
        page.title(name(mechanism.title.clone()));
    }
    page.heading(text!("report-structure"));
    describe_structure(mechanism, structure, plan, page);
    page.heading(text!("explain-stages"));
    for stage in stages::stages(mechanism, structure, methods, equation, plan) {
        let (what, why) = (stage.name, stage.reason);
        page.paragraph(match stage.method {
            Some(method) => text!("explain-run", stage = what, reason = why, method),
            None => text!("explain-left-out", stage = what, reason = why),
        });
    }
    for (heading, remarks) in [
        (text!("explain-modelled"), modelled(mechanism)),
        (text!("explain-not-modelled"), not_modelled(mechanism)),
    ] {
        page.heading(heading);
        for Remark { what, how } in remarks {
            item(page, what, how);
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
        item(page, structure.group_name(mechanism, index), joined("; ", parts));
    }
}

fn item(page: &mut Document, what: Text, how: Text) {
    page.paragraph(text!("report-fact", what, value = how));
}

/// Texts with commas between them, of many only the first ones.
fn first_of(all: Vec<Text>) -> Text {
    /// More names would hide the rest of the sentence.
    const MOST: usize = 6;
    let more = all.len().saturating_sub(MOST);
    let shown = list(all.into_iter().take(MOST));
    if more > 0 { text!("explain-and-more", names = shown, count = more) } else { shown }
}

/// Names of links.
pub(super) fn links(mechanism: &Mechanism, ids: &[LinkId]) -> Text {
    list(ids.iter().map(|&id| link_name(mechanism, id)))
}

/// The names of the groups that are not selected; of many only the first ones.
pub(super) fn others(mechanism: &Mechanism, structure: &Structure, chosen: &[bool]) -> Text {
    let left = (0..chosen.len()).filter(|index| !chosen[*index]);
    first_of(left.map(|index| structure.group_name(mechanism, index)).collect())
}

/// One stage of the calculation.
pub(super) struct Stage {
    /// The result of the stage.
    pub(super) name: Text,
    /// Why it is run; or why not, and what would make it run.
    pub(super) reason: Text,
    /// The method; `None` for a stage that is not run.
    pub(super) method: Option<Text>,
}

pub(super) fn run(name: Text, reason: Text, method: Text) -> Stage {
    Stage { name, reason, method: Some(method) }
}

pub(super) fn left_out(name: Text, reason: Text) -> Stage {
    Stage { name, reason, method: None }
}

/// One thing that is or is not modelled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Remark {
    /// The thing.
    pub(super) what: Text,
    /// How it is modelled; or why it is not, and how it could be included.
    pub(super) how: Text,
}

pub(super) fn remark(what: Text, how: Text) -> Remark {
    Remark { what, how }
}

#[cfg(test)]
mod tests;
