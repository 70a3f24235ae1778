//! The stages in the order of the calculation, each with its reason and method.

use assur_analysis::Methods;
use assur_analysis::plan::Plan;
use assur_book::link_name;
use assur_group::Order;
use assur_mechanism::{
    Balance, CharacteristicKind, Drive, InputPair, Mechanism, Motion, MotorChoice, Solve, Torque,
};
use assur_structure::Structure;
use assur_words::{Text, joined, list, name, text};

use super::others;

/// A stage that is run: why, and by which method.
fn run(stage: Text, reason: Text, method: Text) -> Text {
    text!("explain-run", stage, reason, method)
}

/// A stage that is not run: why not, and what would make it run.
fn left_out(stage: Text, reason: Text) -> Text {
    text!("explain-left-out", stage, reason)
}

pub(super) fn stages(
    mechanism: &Mechanism,
    structure: &Structure,
    methods: &Methods,
    equation: Option<&Text>,
    plan: &Plan,
) -> Vec<Text> {
    vec![
        structure_stage(plan),
        positions(mechanism, structure, plan),
        transfer(structure, plan),
        velocities(mechanism, plan),
        reduction(mechanism, plan),
        motion(mechanism, methods, equation),
        drive(mechanism),
        inertia(mechanism, plan),
        reactions(mechanism, structure, methods, plan),
        balancing(mechanism, plan),
        checks(plan),
    ]
}

/// Whether the scene asks for no reaction.
fn asks_for_no_reaction(mechanism: &Mechanism) -> bool {
    mechanism.output.as_ref().is_some_and(|output| output.reactions.is_empty())
}

fn structure_stage(plan: &Plan) -> Text {
    let method =
        if plan.is_partial() { text!("explain-matching") } else { text!("explain-matching-and-rank") };
    run(text!("explain-stage-structure"), text!("explain-structure"), method)
}

/// How many groups are solved.
fn solved(plan: &Plan) -> usize {
    plan.groups_needed.iter().filter(|needed| **needed).count()
}

fn positions(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Text {
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

fn transfer(structure: &Structure, plan: &Plan) -> Text {
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

fn velocities(mechanism: &Mechanism, plan: &Plan) -> Text {
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

fn reduction(mechanism: &Mechanism, plan: &Plan) -> Text {
    let stage = text!("explain-stage-reduction");
    if plan.reduction {
        return run(stage, reduction_reason(mechanism, plan), text!("explain-sums"));
    }
    if asks_for_no_reaction(mechanism) {
        return left_out(stage, text!("explain-no-reaction-asked"));
    }
    left_out(stage, text!("explain-nothing-to-reduce"))
}

fn reduction_reason(mechanism: &Mechanism, plan: &Plan) -> Text {
    if !plan.inertia_constant {
        return text!("explain-reduced");
    }
    let heavy: Vec<_> = mechanism.heavy_links().collect();
    if heavy.is_empty() {
        return text!("explain-reduced-without-mass");
    }
    text!("explain-reduced-constant", links = super::links(mechanism, &heavy))
}

fn motion(mechanism: &Mechanism, methods: &Methods, equation: Option<&Text>) -> Text {
    let stage = text!("explain-stage-motion");
    match &mechanism.motion {
        None => left_out(stage, text!("explain-no-motion")),
        Some(Motion::Prescribed { .. }) => left_out(stage, text!("explain-prescribed")),
        Some(Motion::Transient { .. }) => {
            let integrator = || text!("explain-integrator", method = name(methods.integrator.clone()));
            run(stage, text!("explain-transient"), equation.map_or_else(integrator, Clone::clone))
        }
        Some(Motion::Steady { .. }) => {
            let method = equation.cloned().into_iter().chain([text!("explain-shooting")]);
            run(stage, text!("explain-steady"), joined(": ", method))
        }
    }
}

fn drive(mechanism: &Mechanism) -> Text {
    let stage = text!("explain-stage-drive");
    let Some(drive) = &mechanism.drive else { return left_out(stage, text!("explain-no-drive")) };
    let found = mechanism.has_equation_of_motion();
    if found {
        run(stage, drive_reason(drive), drive_method(drive))
    } else {
        left_out(stage, text!("explain-drive-useless"))
    }
}

/// Which quantities of the drive are given and which are to be found.
fn drive_reason(drive: &Drive) -> Text {
    let motor = matches!(drive.torque, Torque::Motor { .. });
    let auto = matches!(drive.torque, Torque::Motor { motor: MotorChoice::Auto, .. });
    let all = [
        (matches!(drive.torque, Torque::Balance), text!("explain-wanted-moment")),
        (auto, text!("explain-wanted-motor")),
        (motor && drive.ratio == Solve::Wanted, text!("explain-wanted-ratio")),
        (drive.flywheel == Some(Solve::Wanted), text!("explain-wanted-flywheel")),
    ];
    let wanted: Vec<_> = all.into_iter().filter(|(is_wanted, _)| *is_wanted).map(|(_, what)| what).collect();
    if wanted.is_empty() {
        text!("explain-drive-given")
    } else {
        text!("explain-drive-wanted", what = list(wanted))
    }
}

fn drive_method(drive: &Drive) -> Text {
    let mut methods = Vec::new();
    match &drive.torque {
        Torque::Motor { motor, characteristic, .. } => {
            if *motor == MotorChoice::Auto {
                methods.push(text!("explain-least-motor"));
            }
            methods.push(match characteristic {
                CharacteristicKind::Kloss => text!("explain-kloss"),
                CharacteristicKind::Linear => text!("explain-linear"),
            });
        }
        Torque::Constant(_) | Torque::Balance => methods.push(text!("explain-constant-moment")),
        Torque::None => methods.push(text!("explain-no-torque")),
    }
    if drive.ratio == Solve::Wanted || drive.flywheel == Some(Solve::Wanted) {
        methods.push(text!("explain-newton-search"));
    }
    joined("; ", methods)
}

fn inertia(mechanism: &Mechanism, plan: &Plan) -> Text {
    let stage = text!("explain-stage-inertia");
    if plan.inertia_loads {
        return run(stage, text!("explain-inertia"), text!("explain-dalembert"));
    }
    left_out(
        stage,
        if mechanism.motion.is_none() {
            text!("explain-static")
        } else if plan.forces {
            text!("explain-no-mass")
        } else {
            text!("explain-no-reaction-asked")
        },
    )
}

fn reactions(mechanism: &Mechanism, structure: &Structure, methods: &Methods, plan: &Plan) -> Text {
    let stage = text!("explain-stage-reactions");
    if plan.forces {
        let reason = if mechanism.has_loads() {
            text!("explain-loads-act")
        } else if plan.inertia_loads {
            text!("explain-links-have-inertia")
        } else {
            text!("explain-reactions-zero")
        };
        let analyzer = text!("explain-analyzer", analyzer = name(methods.analyzer.clone()));
        let method = std::iter::once(analyzer).chain(idle(mechanism, structure, plan));
        return run(stage, reason, joined("; ", method));
    }
    if asks_for_no_reaction(mechanism) {
        return left_out(stage, text!("explain-no-reaction-asked"));
    }
    left_out(stage, text!("explain-no-load"))
}

/// The groups that carry no load, and the work that this saves.
fn idle(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Option<Text> {
    let (carrying, all) = (&plan.groups_carrying, structure.groups.len());
    let idle = carrying.iter().filter(|carrying| !**carrying).count();
    let names = others(mechanism, structure, carrying);
    match (idle, plan.by_groups) {
        (0, _) => None,
        (_, false) => Some(text!("explain-idle-as-one-system", groups = names)),
        (idle, true) => Some(text!("explain-idle", idle, all, groups = names)),
    }
}

fn balancing(mechanism: &Mechanism, plan: &Plan) -> Text {
    let stage = text!("explain-stage-balancing");
    if !plan.forces {
        return left_out(stage, text!("explain-with-reactions"));
    }
    let link = |id: usize| link_name(mechanism, id);
    let input = || link(mechanism.input.link);
    let reason = match (mechanism.balance, mechanism.input.pair) {
        (Some(Balance::Moment(id)), _) => text!("explain-balance-moment", link = link(id)),
        (Some(Balance::Force { at, .. }), _) => text!("explain-balance-force", link = link(at.link)),
        (None, InputPair::Pin(_)) => text!("explain-input-moment", link = input()),
        (None, InputPair::Slide(_)) => text!("explain-input-force", link = input()),
    };
    run(stage, reason, text!("explain-equilibrium-of-input"))
}

fn checks(plan: &Plan) -> Text {
    let stage = text!("explain-stage-checks");
    if plan.is_partial() {
        return left_out(stage, text!("explain-checks-need-all"));
    }
    run(stage, text!("explain-residuals"), text!("explain-checks"))
}
