//! The stages in the order of the calculation, each with its reason and method.

use std::collections::HashSet;

use assur_analysis::{Methods, Options, plan::Plan};
use assur_book::{driven_link, link_name};
use assur_group::Order;
use assur_mechanism::{
    Balance, CharacteristicKind, CoordinateKind, Drive, Mechanism, Motion, MotorChoice, Solve, Torque,
};
use assur_structure::Structure;
use assur_words::{Text, joined, list, name, text};

use super::others;

/// Why a stage is run, and by which method; or why not, and what would make it run.
type Stage = Result<[Text; 2], Text>;

pub(super) fn stages(
    mechanism: &Mechanism,
    structure: &Structure,
    methods: &Methods,
    equation: Option<&Text>,
    plan: &Plan,
) -> Vec<Text> {
    let all = [
        (text!("explain-stage-structure"), Ok(structure_stage(plan))),
        (text!("explain-stage-positions"), Ok(positions(mechanism, structure, plan))),
        (text!("explain-stage-transfer"), transfer(structure, plan)),
        (text!("explain-stage-velocities"), velocities(mechanism, plan)),
        (text!("explain-stage-reduction"), reduction(mechanism, plan)),
        (text!("explain-stage-motion"), motion(mechanism, methods, equation)),
        (text!("explain-stage-drive"), drive(mechanism)),
        (text!("explain-stage-inertia"), inertia(mechanism, plan)),
        (text!("explain-stage-reactions"), reactions(mechanism, structure, methods, plan)),
        (text!("explain-stage-balancing"), balancing(mechanism, plan)),
        (text!("explain-stage-checks"), checks(plan)),
    ];
    let told = |(stage, how): (Text, Stage)| match how {
        Ok([reason, method]) => text!("explain-run", stage, reason, method),
        Err(reason) => text!("explain-left-out", stage, reason),
    };
    all.into_iter().map(told).collect()
}

/// A stage that is left out because the scene asks for no reaction, or for another reason.
fn no_reaction_or(other: Text, mechanism: &Mechanism) -> Stage {
    let asks_for_none = mechanism.output.as_ref().is_some_and(|output| output.reactions.is_empty());
    Err(if asks_for_none { text!("explain-no-reaction-asked") } else { other })
}

fn structure_stage(plan: &Plan) -> [Text; 2] {
    let method =
        if plan.is_partial() { text!("explain-matching") } else { text!("explain-matching-and-rank") };
    [text!("explain-structure"), method]
}

/// How many groups are solved.
fn solved(plan: &Plan) -> usize {
    plan.groups_needed.iter().filter(|needed| **needed).count()
}

fn positions(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> [Text; 2] {
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
    let (needed, mut seen) = (structure.groups.iter().zip(&plan.groups_needed), HashSet::new());
    let needed = needed.filter(|(group, needed)| **needed && seen.insert(group.plugin.name));
    let kinds = list(needed.map(|(group, _)| name(group.plugin.name)));
    let method =
        if kinds.is_empty() { text!("explain-input-alone") } else { text!("explain-group-by-group", kinds) };
    [joined("; ", std::iter::once(reason).chain(left)), method]
}

fn transfer(structure: &Structure, plan: &Plan) -> Stage {
    let needed = structure.groups.iter().zip(&plan.groups_needed).filter(|(_, needed)| **needed);
    let iterating = needed.filter(|(group, _)| group.plugin.iterates).count();
    let groups = solved(plan);
    let method = match groups {
        0 => text!("explain-derivatives-input"),
        all if iterating == all => text!("explain-derivatives-constraints"),
        _ if iterating > 0 => text!("explain-derivatives-both"),
        _ => text!("explain-derivatives-closed"),
    };
    let what = joined("; ", plan.order_for.iter().cloned());
    match plan.order {
        Order::Place => Err(text!("explain-order-0", groups)),
        Order::First => Ok([text!("explain-order-1", what, groups), method]),
        Order::Second => Ok([text!("explain-order-2", what), method]),
    }
}

fn velocities(mechanism: &Mechanism, plan: &Plan) -> Stage {
    match (plan.velocities, &mechanism.motion) {
        (true, _) => {
            let is_timed = mechanism.input.kind().is_time();
            let method = if is_timed { "explain-rates-over-time" } else { "explain-rates" };
            Ok([text!("explain-has-motion"), text!(method)])
        }
        (_, None) => Err(text!("explain-add-motion")),
        _ => Err(text!("explain-no-rates-asked")),
    }
}

/// What the input coordinate is.
fn coordinate(mechanism: &Mechanism) -> Text {
    let link = driven_link(mechanism);
    match mechanism.input.kind() {
        CoordinateKind::Angle => text!("explain-angle-of", link),
        CoordinateKind::Length => text!("explain-displacement-of", link),
        CoordinateKind::Time => text!("explain-time-of", link),
    }
}

fn reduction(mechanism: &Mechanism, plan: &Plan) -> Stage {
    if mechanism.input.is_list {
        return Err(text!("explain-no-common-coordinate"));
    }
    if plan.reduction {
        return Ok([reduction_reason(mechanism, plan), text!("explain-sums")]);
    }
    no_reaction_or(text!("explain-nothing-to-reduce"), mechanism)
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

fn motion(mechanism: &Mechanism, methods: &Methods, equation: Option<&Text>) -> Stage {
    match &mechanism.motion {
        None => Err(text!("explain-no-motion")),
        Some(_) if mechanism.input.kind().is_time() => Err(text!("explain-given-over-time")),
        Some(Motion::Prescribed { .. }) => Err(text!("explain-prescribed")),
        Some(Motion::Transient { .. }) => {
            let integrator = || text!("explain-integrator", method = name(methods.integrator.clone()));
            Ok([text!("explain-transient"), equation.map_or_else(integrator, Clone::clone)])
        }
        Some(Motion::Steady { .. }) => {
            let method = equation.cloned().into_iter().chain([text!("explain-shooting")]);
            Ok([text!("explain-steady"), joined(": ", method)])
        }
    }
}

fn drive(mechanism: &Mechanism) -> Stage {
    match &mechanism.drive {
        None => Err(text!("explain-no-drive")),
        Some(_) if !mechanism.has_equation_of_motion() => Err(text!("explain-drive-useless")),
        Some(drive) => Ok([drive_reason(drive), drive_method(drive)]),
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

fn inertia(mechanism: &Mechanism, plan: &Plan) -> Stage {
    if plan.inertia_loads {
        return Ok([text!("explain-inertia"), text!("explain-dalembert")]);
    }
    Err(if mechanism.motion.is_none() {
        text!("explain-static")
    } else if plan.forces {
        text!("explain-no-mass")
    } else {
        text!("explain-no-reaction-asked")
    })
}

fn reactions(mechanism: &Mechanism, structure: &Structure, methods: &Methods, plan: &Plan) -> Stage {
    if !plan.forces {
        return no_reaction_or(text!("explain-no-load"), mechanism);
    }
    let reason = if mechanism.has_loads() {
        text!("explain-loads-act")
    } else if plan.inertia_loads {
        text!("explain-links-have-inertia")
    } else {
        text!("explain-reactions-zero")
    };
    let analyzer = text!("explain-analyzer", analyzer = name(methods.analyzer.clone()));
    let method = std::iter::once(analyzer).chain(idle(mechanism, structure, plan));
    Ok([reason, joined("; ", method)])
}

/// The groups that carry no load, and the work that this saves.
fn idle(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Option<Text> {
    let (carrying, all) = (&plan.groups_carrying, structure.groups.len());
    let idle = carrying.iter().filter(|carrying| !**carrying).count();
    let names = others(mechanism, structure, carrying);
    match (idle, plan.by_groups) {
        (0, _) => None,
        (_, false) => {
            let hint = hint(mechanism, structure);
            Some(text!("explain-idle-as-one-system", groups = names, hint = hint))
        }
        (idle, true) => Some(text!("explain-idle", idle, all, groups = names)),
    }
}

/// The method that would leave out groups without a load, where the one that is used by itself does.
fn hint(mechanism: &Mechanism, structure: &Structure) -> Text {
    let own = assur_analysis::methods(mechanism, structure, &Options::default());
    if own.by_groups { text!("explain-leaves-out", method = name(own.analyzer)) } else { Text::default() }
}

fn balancing(mechanism: &Mechanism, plan: &Plan) -> Stage {
    if !plan.forces {
        return Err(text!("explain-with-reactions"));
    }
    let link = |id: usize| link_name(mechanism, id);
    let input = || driven_link(mechanism);
    let reason = match (mechanism.balance, mechanism.input.kind()) {
        (Some(Balance::Moment(id)), _) => text!("explain-balance-moment", link = link(id)),
        (Some(Balance::Force { at, .. }), _) => text!("explain-balance-force", link = link(at.link)),
        (None, CoordinateKind::Angle) => text!("explain-input-moment", link = input()),
        (None, CoordinateKind::Length) => text!("explain-input-force", link = input()),
        (None, CoordinateKind::Time) => text!("explain-input-loads", link = input()),
    };
    let is_timed = mechanism.input.kind().is_time() && mechanism.balance.is_none();
    let of = if is_timed { "explain-equilibrium-of-driven" } else { "explain-equilibrium-of-input" };
    Ok([reason, text!(of)])
}

fn checks(plan: &Plan) -> Stage {
    if plan.is_partial() {
        return Err(text!("explain-checks-need-all"));
    }
    Ok([text!("explain-residuals"), text!("explain-checks")])
}
