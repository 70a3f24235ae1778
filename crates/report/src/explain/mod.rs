//! What is calculated for a scene and how, what is modelled and what is left out, in words.

mod kinematics;
mod missing;
mod model;
mod stages;
mod words;

use assur_analysis::Methods;
use assur_analysis::plan::Plan;
use assur_mechanism::Mechanism;
use assur_structure::{Structure, roman};

use crate::text::wrap;
use missing::not_modelled;
use model::{Remark, modelled};

/// Structure, stages with their methods, what is modelled and what is not: plain lines. `equation`: the equation of the
/// motion and how it is solved, where that is known ([`assur_analysis::method_of_motion`]).
pub fn explain(
    mechanism: &Mechanism,
    structure: &Structure,
    plan: &Plan,
    methods: &Methods,
    equation: Option<&str>,
) -> String {
    let mut text = String::new();
    if !mechanism.title.is_empty() {
        text.push_str(&mechanism.title);
        text += "\n\n";
    }
    text += "Structure\n";
    describe_structure(&mut text, mechanism, structure, plan);
    text += "\nStages\n";
    for stage in stages::stages(mechanism, structure, methods, equation, plan) {
        let sign = if stage.method.is_some() { "run" } else { "left out" };
        item(&mut text, &format!("{}: {sign}", stage.name), &stage.reason);
        if let Some(method) = stage.method {
            text += &wrap(&format!("method: {method}"), 4, 6);
        }
    }
    remarks(&mut text, "\nModelled\n", &modelled(mechanism));
    remarks(&mut text, "\nNot modelled\n", &not_modelled(mechanism));
    text
}

fn describe_structure(text: &mut String, mechanism: &Mechanism, structure: &Structure, plan: &Plan) {
    let count = &structure.mobility;
    let chebyshev = format!("W = 3*{} - 2*{} = {}", count.moving_links, count.pairs, count.value);
    item(text, "mobility by Chebyshev's formula", &chebyshev);
    item(text, "formula", &structure.formula);
    item(text, "class of the mechanism", roman(structure.class()));
    for (index, group) in structure.groups.iter().enumerate() {
        let left = match (plan.groups_needed[index], plan.forces && plan.by_groups) {
            (false, _) => "; not needed for what is asked for",
            (true, true) if !plan.groups_carrying[index] => "; carries no load: its reactions are zero",
            _ => "",
        };
        let what = format!(
            "{}; singular at: {}; {}{left}",
            group.plugin.summary, group.plugin.singular, group.plugin.source
        );
        item(text, &structure.group_name(mechanism, index).to_string(), &what);
    }
}

fn remarks(text: &mut String, title: &str, remarks: &[Remark]) {
    *text += title;
    for remark in remarks {
        item(text, &remark.what, &remark.how);
    }
}

fn item(text: &mut String, what: &str, how: &str) {
    *text += &wrap(&format!("{what}: {how}"), 2, 4);
}

#[cfg(test)]
mod tests;
