//! The stages in the order in which data goes through them, each with its reason and method.

use assur_group::Order;
use assur_mechanism::{Balance, Characteristic, Drive, InputPair, Mechanism, Motion, Motor, Solve, Torque};
use assur_structure::Structure;

use crate::{Methods, Plan, Stage, needs};

pub(crate) fn stages(
    mechanism: &Mechanism,
    structure: &Structure,
    methods: &Methods,
    plan: &Plan,
) -> Vec<Stage> {
    vec![
        run(
            "structure",
            "groups and their order are what everything else follows",
            "equations counted and matched to unknowns, strongly connected parts are the groups; mobility by Chebyshev's \
             formula and by the rank of the constraints (singular values) in the first position",
        ),
        positions(mechanism, structure, plan),
        transfer(plan),
        velocities(mechanism, plan),
        reduction(mechanism, plan),
        motion(mechanism, methods, plan),
        drive(mechanism),
        inertia(mechanism, plan),
        reactions(mechanism, methods, plan),
        balancing(mechanism, plan),
        checks(plan),
    ]
}

fn run(name: &'static str, reason: impl Into<String>, method: impl Into<String>) -> Stage {
    Stage { name, needed: true, reason: reason.into(), method: method.into() }
}

fn left_out(name: &'static str, reason: impl Into<String>) -> Stage {
    Stage { name, needed: false, reason: reason.into(), method: String::new() }
}

fn positions(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> Stage {
    let needed = plan.groups_needed.iter().filter(|needed| **needed).count();
    let reason = format!(
        "{} positions over {}; {} of {} groups are needed for what is asked for",
        mechanism.input.positions,
        needs::coordinate_words(mechanism),
        needed,
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

fn transfer(plan: &Plan) -> Stage {
    let name = "transfer functions (PF1, PF2)";
    let method = "derivatives of the closed forms of each group by the input coordinate, not by differences";
    match plan.order {
        Order::Place => left_out(name, "nothing that is asked for needs derivatives"),
        Order::First => run(name, "PF1: the loads' virtual power needs it; nothing needs PF2", method),
        Order::Second => run(name, "results tell them; accelerations and the reduction need them", method),
    }
}

fn velocities(mechanism: &Mechanism, plan: &Plan) -> Stage {
    let name = "velocities and accelerations";
    if plan.velocities {
        return run(name, "the scene has a `[motion]`", "v = PF1 w, a = PF2 w^2 + PF1 e");
    }
    if mechanism.motion.is_none() {
        return left_out(name, "no motion is given; add `[motion]` with a speed");
    }
    left_out(name, "`[output]` asks for no link, point or slide")
}

fn reduction(mechanism: &Mechanism, plan: &Plan) -> Stage {
    let name = "reduction to the input link";
    if plan.reduction {
        let reason = "J, dJ/dq and Q of all moving links and loads make the equation of motion";
        return run(
            name,
            reason,
            "sums over masses and loads with the transfer functions of their points (S eqs. 1-3)",
        );
    }
    if mechanism.output.as_ref().is_some_and(|output| output.reactions.is_empty()) {
        return left_out(name, "`[output]` asks for no reaction");
    }
    left_out(name, "no link has a mass and nothing loads the links")
}

fn motion(mechanism: &Mechanism, methods: &Methods, plan: &Plan) -> Stage {
    let name = "equation of motion";
    match &mechanism.motion {
        None => left_out(name, "no motion is given"),
        Some(Motion::Prescribed { .. }) => left_out(
            name,
            "speed and acceleration are prescribed; `kind = \"transient\"` or \"steady\" would find them",
        ),
        Some(Motion::Transient { .. }) => {
            debug_assert!(plan.dynamics);
            run(
                name,
                "the motion follows from an initial state",
                format!("integrator `{}`", methods.integrator),
            )
        }
        Some(Motion::Steady { .. }) => {
            let method = "shooting: the speed over the cycle by collocation of order 15 between all jumps of the loads, a Newton \
                          step on the speed at the start; no integrator in time";
            run(name, "the periodic regime is wanted: J w dw/dq + J' w^2/2 = Q + M over one cycle", method)
        }
    }
}

fn drive(mechanism: &Mechanism) -> Stage {
    if let Some(drive) = &mechanism.drive {
        let found = matches!(mechanism.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }));
        if !found {
            return left_out(
                "drive and flywheel",
                "`[drive]` has no use where the motion is prescribed or absent",
            );
        }
        return run("drive and flywheel", drive_reason(drive), drive_method(drive));
    }
    left_out("drive and flywheel", "no motor, reducer or flywheel is given; add `[drive]`")
}

/// What of the drive is given and what is wanted.
fn drive_reason(drive: &Drive) -> String {
    let mut wanted = Vec::new();
    if matches!(drive.torque, Torque::Balance) {
        wanted.push("the constant moment that makes the work of a cycle zero");
    }
    if matches!(drive.torque, Torque::Motor { motor: Motor::Auto, .. }) {
        wanted.push("the motor");
    }
    if matches!(drive.torque, Torque::Motor { .. }) && drive.ratio == Solve::Wanted {
        wanted.push("the gear ratio");
    }
    if drive.flywheel == Some(Solve::Wanted) {
        wanted.push("the flywheel");
    }
    if wanted.is_empty() {
        return "the scene has a `[drive]`, all of it given".to_owned();
    }
    format!("the scene has a `[drive]`; wanted: {}", wanted.join(", "))
}

fn drive_method(drive: &Drive) -> String {
    let mut methods = Vec::new();
    match &drive.torque {
        Torque::Motor { motor, characteristic, .. } => {
            if *motor == Motor::Auto {
                methods.push(
                    "the least rated power that suffices and keeps the greatest motor speed (S stage 5)",
                );
            }
            methods.push(match characteristic {
                Characteristic::Kloss => "torque over speed by Kloss's formula",
                Characteristic::Linear => {
                    "torque over speed as the straight line through synchronous and rated speed"
                }
            });
        }
        Torque::Constant(_) | Torque::Balance => methods.push("a constant moment on the input link"),
        Torque::None => methods.push("no torque"),
    }
    if drive.ratio == Solve::Wanted || drive.flywheel == Some(Solve::Wanted) {
        methods.push(
            "ratio and flywheel by a Newton search in which every trial has its own periodic regime (S stage 6); beside it the \
             flywheel by E eqs. 9 and 10, Mertsalov and the energy-mass diagram",
        );
    }
    methods.join("; ")
}

fn inertia(mechanism: &Mechanism, plan: &Plan) -> Stage {
    let name = "inertia loads";
    if plan.inertia_loads {
        return run(
            name,
            "links with mass move at a known speed",
            "-m a at the center of mass and -I e (d'Alembert)",
        );
    }
    if mechanism.motion.is_none() {
        return left_out(name, "no motion is given: the force analysis is static");
    }
    if !plan.forces {
        return left_out(name, "`[output]` asks for no reaction");
    }
    left_out(name, "no link has a mass")
}

fn reactions(mechanism: &Mechanism, methods: &Methods, plan: &Plan) -> Stage {
    let name = "reactions";
    if plan.forces {
        let reason = if mechanism.has_loads() { "loads act on the links" } else { "the links have inertia" };
        return run(
            name,
            reason,
            format!("force analyzer `{}` (`assur plugins` lists others)", methods.analyzer),
        );
    }
    if mechanism.output.as_ref().is_some_and(|output| output.reactions.is_empty()) {
        return left_out(name, "`[output]` asks for no reaction");
    }
    left_out(name, "there is neither a load nor a motion; add `gravity`, `[[force]]` or `[motion]`")
}

fn balancing(mechanism: &Mechanism, plan: &Plan) -> Stage {
    if !plan.forces {
        return left_out("balancing load", "it is found together with the reactions");
    }
    let link = |id: usize| &mechanism.links[id].name;
    let reason = match (mechanism.balance, mechanism.input.pair) {
        (Some(Balance::Moment(id)), _) => format!("a moment on `{}`, from `[balance]`", link(id)),
        (Some(Balance::Force { at, .. }), _) => format!("a force on `{}`, from `[balance]`", link(at.link)),
        (None, InputPair::Pin(_)) => format!("a moment on the input link `{}`", link(mechanism.input.link)),
        (None, InputPair::Slide(_)) => format!("a force on the input link `{}`", link(mechanism.input.link)),
    };
    run("balancing load", reason, "equilibrium of the input link, which comes last")
}

fn checks(plan: &Plan) -> Stage {
    if plan.is_partial() {
        return left_out(
            "checks",
            "`[output]` leaves groups out; the checks need the whole mechanism (`assur check`)",
        );
    }
    run(
        "checks",
        "numbers are worth as much as their residuals",
        "closure of every pair, derivatives against differences, equilibrium of every link, agreement of two analyzers, \
         Lagrange-d'Alembert, virtual power against the balancing load",
    )
}
