//! The stages that place the links: positions, transfer functions, velocities.

use assur_group::Order;
use assur_mechanism::{InputPair, Mechanism};
use assur_structure::Structure;

use super::words::{Stage, left_out, run};
use super::words::{count, others};
use assur_analysis::plan::Plan;

fn solved(plan: &Plan) -> usize {
    plan.groups_needed.iter().filter(|needed| **needed).count()
}

pub(super) fn positions(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Stage {
    let left = if plan.is_partial() {
        let names = others(mechanism, structure, &plan.groups_needed);
        format!("; not solved, nor looked at whether they can be assembled: {names}")
    } else {
        String::new()
    };
    let reason = format!(
        "{} over {}; {} of {} groups are needed for what is asked for{left}",
        count(mechanism.input.positions, "position"),
        coordinate(mechanism),
        solved(plan),
        structure.groups.len()
    );
    let mut kinds: Vec<&str> = Vec::new();
    for (group, _) in structure.groups.iter().zip(&plan.groups_needed).filter(|(_, needed)| **needed) {
        if !kinds.contains(&group.plugin.name) {
            kinds.push(group.plugin.name);
        }
    }
    let method = if kinds.is_empty() {
        "the input link alone".to_owned()
    } else {
        format!(
            "group after group by the registered kinds ({}); the assembly is followed by continuity from the first position",
            kinds.join(", ")
        )
    };
    run("positions (PF0)", reason, method)
}

pub(super) fn transfer(structure: &Structure, plan: &Plan) -> Stage {
    let name = "transfer functions (PF1, PF2)";
    let needed = || structure.groups.iter().zip(&plan.groups_needed).filter(|(_, needed)| **needed);
    let iterating = needed().filter(|(group, _)| group.plugin.iterates).count();
    let method = match solved(plan) {
        0 => "of the input link, exact",
        all if iterating == all => {
            "derivatives of the constraints of each group by the input coordinate, not by differences"
        }
        _ if iterating > 0 => {
            "derivatives of the closed forms of each group by the input coordinate, of the constraints where a kind \
             iterates, not by differences"
        }
        _ => "derivatives of the closed forms of each group by the input coordinate, not by differences",
    };
    let groups = match solved(plan) {
        0 => String::new(),
        number => format!(" of {}", count(number, "group")),
    };
    let needed_for = assur_words::joined("; ", plan.order_for.clone()).to_string();
    match plan.order {
        Order::Place => left_out(
            name,
            format!("orders up to 0: nothing that is asked for needs derivatives; saves PF1 and PF2{groups}"),
        ),
        Order::First => run(
            name,
            format!("orders up to 1, for: {needed_for}; nothing needs PF2; saves PF2{groups}"),
            method,
        ),
        Order::Second => run(name, format!("orders up to 2, for: {needed_for}"), method),
    }
}

pub(super) fn velocities(mechanism: &Mechanism, plan: &Plan) -> Stage {
    let name = "velocities and accelerations";
    if plan.velocities {
        return run(name, "the scene has a `[motion]`", "v = PF1 w, a = PF2 w^2 + PF1 e");
    }
    if mechanism.motion.is_none() {
        return left_out(name, "no motion is given; add `[motion]` with a speed");
    }
    left_out(name, "`[output]` asks for no link, point or slide")
}

/// What the input coordinate is.
fn coordinate(mechanism: &Mechanism) -> String {
    let link = &mechanism.links[mechanism.input.link].name;
    match mechanism.input.pair {
        InputPair::Pin(_) => format!("the angle of `{link}`"),
        InputPair::Slide(_) => format!("the displacement of `{link}`"),
    }
}
