//! The stages that place the links: positions, transfer functions, velocities.

use assur_analysis::plan::Plan;
use assur_book::link_name;
use assur_group::Order;
use assur_mechanism::{InputPair, Mechanism};
use assur_structure::Structure;
use assur_words::{Text, joined, list, name, text};

use crate::topic::explain::{Stage, left_out, others, run};

fn solved(plan: &Plan) -> usize {
    plan.groups_needed.iter().filter(|needed| **needed).count()
}

pub(super) fn positions(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Stage {
    let left = plan
        .is_partial()
        .then(|| text!("explain-not-solved", groups = others(mechanism, structure, &plan.groups_needed)));
    let reason = text!(
        "explain-positions",
        positions = mechanism.input.positions,
        over = coordinate(mechanism),
        needed = solved(plan),
        groups = structure.groups.len()
    );
    let mut kinds: Vec<&'static str> = Vec::new();
    for (group, _) in structure.groups.iter().zip(&plan.groups_needed).filter(|(_, needed)| **needed) {
        if !kinds.contains(&group.plugin.name) {
            kinds.push(group.plugin.name);
        }
    }
    let method = if kinds.is_empty() {
        text!("explain-input-alone")
    } else {
        text!("explain-group-by-group", kinds = list(kinds.into_iter().map(name)))
    };
    run(text!("explain-stage-positions"), joined("; ", std::iter::once(reason).chain(left)), method)
}

pub(super) fn transfer(structure: &Structure, plan: &Plan) -> Stage {
    let stage = text!("explain-stage-transfer");
    let needed = || structure.groups.iter().zip(&plan.groups_needed).filter(|(_, needed)| **needed);
    let iterating = needed().filter(|(group, _)| group.plugin.iterates).count();
    let method = match solved(plan) {
        0 => text!("explain-derivatives-input"),
        all if iterating == all => text!("explain-derivatives-constraints"),
        _ if iterating > 0 => text!("explain-derivatives-both"),
        _ => text!("explain-derivatives-closed"),
    };
    let needed_for = || joined("; ", plan.order_for.iter().cloned());
    match plan.order {
        Order::Place => left_out(stage, text!("explain-order-0", groups = solved(plan))),
        Order::First => {
            run(stage, text!("explain-order-1", what = needed_for(), groups = solved(plan)), method)
        }
        Order::Second => run(stage, text!("explain-order-2", what = needed_for()), method),
    }
}

pub(super) fn velocities(mechanism: &Mechanism, plan: &Plan) -> Stage {
    let stage = text!("explain-stage-velocities");
    if plan.velocities {
        return run(stage, text!("explain-has-motion"), text!("explain-rates"));
    }
    if mechanism.motion.is_none() {
        return left_out(stage, text!("explain-add-motion"));
    }
    left_out(stage, text!("explain-no-rates-asked"))
}

/// What the input coordinate is.
fn coordinate(mechanism: &Mechanism) -> Text {
    let link = link_name(mechanism, mechanism.input.link);
    match mechanism.input.pair {
        InputPair::Pin(_) => text!("explain-angle-of", link),
        InputPair::Slide(_) => text!("explain-displacement-of", link),
    }
}
