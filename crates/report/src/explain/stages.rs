//! The stages in the order of the calculation, each with its reason and method.

use assur_mechanism::{Balance, Characteristic, Drive, InputPair, Mechanism, Motion, Motor, Solve, Torque};
use assur_structure::Structure;

use super::words::{Stage, left_out, run};
use super::{kinematics, words};
use assur_analysis::Methods;
use assur_analysis::plan::Plan;

pub(super) fn stages(
    mechanism: &Mechanism,
    structure: &Structure,
    methods: &Methods,
    equation: Option<&str>,
    plan: &Plan,
) -> Vec<Stage> {
    vec![
        structure_stage(plan),
        kinematics::positions(mechanism, structure, plan),
        kinematics::transfer(structure, plan),
        kinematics::velocities(mechanism, plan),
        reduction(mechanism, plan),
        motion(mechanism, methods, equation),
        drive(mechanism),
        inertia(mechanism, plan),
        reactions(mechanism, structure, methods, plan),
        balancing(mechanism, plan),
        checks(plan),
    ]
}

fn structure_stage(plan: &Plan) -> Stage {
    let rank = if plan.is_partial() {
        "not by the rank of the constraints, for which all groups would have to be placed"
    } else {
        "and by the rank of the constraints (singular values) in the first position"
    };
    run(
        "structure",
        "groups and their order are what everything else follows",
        format!(
            "equations counted and matched to unknowns, strongly connected parts are the groups; mobility by Chebyshev's \
             formula {rank}"
        ),
    )
}

fn reduction(mechanism: &Mechanism, plan: &Plan) -> Stage {
    let name = "reduction to the input link";
    if plan.reduction {
        let method = "sums over masses and loads with the transfer functions of their points (S eqs. 1-3)";
        return run(name, reduction_reason(mechanism, plan), method);
    }
    if mechanism.output.as_ref().is_some_and(|output| output.reactions.is_empty()) {
        return left_out(name, "`[output]` asks for no reaction");
    }
    left_out(name, "no link has a mass and nothing loads the links")
}

fn reduction_reason(mechanism: &Mechanism, plan: &Plan) -> String {
    if !plan.inertia_constant {
        return "J, dJ/dq and Q of all moving links and loads make the equation of motion".to_owned();
    }
    let is_heavy = |id: &usize| mechanism.links[*id].mass > 0.0 || mechanism.links[*id].inertia > 0.0;
    let heavy: Vec<_> = (1..mechanism.links.len()).filter(is_heavy).collect();
    if heavy.is_empty() {
        return "Q of all loads; no link has a mass: J is zero, and dJ/dq is not computed".to_owned();
    }
    format!(
        "J and Q of all moving links and loads make the equation of motion; J is the same at every coordinate, as {} alone \
         has mass and turns or slides with the coordinate, or rests: dJ/dq is exactly zero and not computed",
        words::links(mechanism, &heavy)
    )
}

fn motion(mechanism: &Mechanism, methods: &Methods, equation: Option<&str>) -> Stage {
    let name = "equation of motion";
    match &mechanism.motion {
        None => left_out(name, "no motion is given"),
        Some(Motion::Prescribed { .. }) => left_out(
            name,
            "speed and acceleration are prescribed; `kind = \"transient\"` or \"steady\" would find them",
        ),
        Some(Motion::Transient { .. }) => {
            let method =
                equation.map_or_else(|| format!("integrator `{}`", methods.integrator), str::to_owned);
            run(name, "the motion follows from an initial state", method)
        }
        Some(Motion::Steady { .. }) => {
            let method = "shooting: the speed over the cycle by collocation of order 15 between all jumps of the loads, a Newton \
                          step on the speed at the start; no integrator in time";
            let method = equation.map_or_else(|| method.to_owned(), |case| format!("{case}: {method}"));
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

/// Which quantities of the drive are given and which are to be found.
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

fn reactions(mechanism: &Mechanism, structure: &Structure, methods: &Methods, plan: &Plan) -> Stage {
    let name = "reactions";
    if plan.forces {
        let reason = if mechanism.has_loads() {
            "loads act on the links"
        } else if plan.inertia_loads {
            "the links have inertia"
        } else {
            "the scene has a `[motion]`, but neither mass nor load: every reaction is zero"
        };
        let named = format!("force analyzer `{}` (`assur plugins` lists others)", methods.analyzer);
        return run(name, reason, named + &idle(mechanism, structure, plan));
    }
    if mechanism.output.as_ref().is_some_and(|output| output.reactions.is_empty()) {
        return left_out(name, "`[output]` asks for no reaction");
    }
    left_out(name, "there is neither a load nor a motion; add `gravity`, `[[force]]` or `[motion]`")
}

/// The groups that carry no load, and the work that this saves.
fn idle(mechanism: &Mechanism, structure: &Structure, plan: &Plan) -> String {
    let (carrying, all) = (&plan.groups_carrying, structure.groups.len());
    let idle = carrying.iter().filter(|carrying| !**carrying).count();
    if idle == 0 {
        return String::new();
    }
    let names = words::others(mechanism, structure, carrying);
    if !plan.by_groups {
        return format!(
            "; {names}: no load reaches it, but this method solves the mechanism as one system (`groups` would leave it out)"
        );
    }
    format!(
        "; {idle} of {all} groups not solved, as no load reaches them (no weight, mass in motion, force, moment, spring, \
         contact or balancing load on their links, nor on a group behind them), so that their reactions are exactly zero: \
         {names}"
    )
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
        "the residuals show how far the numbers can be trusted",
        "closure of every pair, derivatives against differences, equilibrium of every link, agreement of two analyzers, \
         Lagrange-d'Alembert, virtual power against the balancing load",
    )
}
