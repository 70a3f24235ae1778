//! The plan in words.

use std::fmt::Write;

use assur_mechanism::Mechanism;
use assur_structure::{Structure, roman};

use crate::plan::{Plan, Remark, modelled, not_modelled};

/// Columns of the text.
const WIDTH: usize = 100;

/// Structure, stages with their methods, what is modelled and what is not: plain lines.
pub fn explain(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> String {
    let mut text = String::new();
    if !mechanism.title.is_empty() {
        line(&mut text, &mechanism.title);
        line(&mut text, "");
    }
    line(&mut text, "Structure");
    tell_structure(&mut text, mechanism, structure, plan);
    line(&mut text, "\nStages");
    for stage in &plan.stages {
        let sign = if stage.needed { "run" } else { "left out" };
        item(&mut text, &format!("{}: {sign}", stage.name), &stage.reason);
        if !stage.method.is_empty() {
            wrapped(&mut text, 4, &format!("method: {}", stage.method));
        }
    }
    remarks(&mut text, "\nModelled", &modelled(mechanism));
    remarks(&mut text, "\nNot modelled", &not_modelled(mechanism));
    text
}

fn tell_structure(text: &mut String, mechanism: &Mechanism, structure: &Structure, plan: &Plan) {
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
        item(text, &structure.group_name(mechanism, index), &what);
    }
}

fn remarks(text: &mut String, title: &str, remarks: &[Remark]) {
    line(text, title);
    for remark in remarks {
        item(text, &remark.what, &remark.how);
    }
}

fn item(text: &mut String, what: &str, how: &str) {
    wrapped(text, 2, &format!("{what}: {how}"));
}

fn line(text: &mut String, words: &str) {
    let _ = writeln!(text, "{words}");
}

/// Words broken into lines; what follows the first line stands two columns further in.
fn wrapped(text: &mut String, indent: usize, words: &str) {
    let mut row = " ".repeat(indent);
    let mut empty = true;
    for word in words.split_whitespace() {
        if !empty && row.chars().count() + 1 + word.chars().count() > WIDTH {
            line(text, &row);
            row = " ".repeat(indent + 2);
            empty = true;
        }
        if !empty {
            row.push(' ');
        }
        row.push_str(word);
        empty = false;
    }
    line(text, &row);
}
