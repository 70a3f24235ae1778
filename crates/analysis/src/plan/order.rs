//! Which order of transfer functions is needed, and for what.

use assur_group::Order;
use assur_mechanism::Mechanism;
use assur_structure::Structure;

use crate::plan::{Plan, carry};

/// The order for a plan whose stages are decided, with its reason in words.
pub(crate) fn order(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> (Order, Vec<&'static str>) {
    let shows = !plan.wanted.has_no_motion();
    let second = [
        (shows, "results show them"),
        (plan.velocities, "accelerations in the results"),
        (plan.reduction && !plan.inertia_constant, "dJ/dq"),
        (plan.inertia_loads && carry::heavy_groups(mechanism, structure), "accelerations of masses"),
        (
            (plan.reduction || plan.forces) && carry::opposed(mechanism),
            "whether a point is at rest on which a load acts against the motion",
        ),
    ];
    let first = [
        (plan.reduction, "the virtual power of loads and masses"),
        (plan.forces && plan.groups_carrying.contains(&true), "the force analysis"),
        (plan.forces && !plan.by_groups, "the force analysis"),
    ];
    let reasons = |list: &[(bool, &'static str)]| -> Vec<&'static str> {
        list.iter().filter_map(|(needs, why)| needs.then_some(*why)).collect()
    };
    match (reasons(&second), reasons(&first)) {
        (why, _) if !why.is_empty() => (Order::Second, why),
        (_, mut why) if !why.is_empty() => {
            why.dedup();
            (Order::First, why)
        }
        _ => (Order::Place, Vec::new()),
    }
}
