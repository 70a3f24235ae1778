//! Which groups and stages a scene needs.

use assur_all as _;
use assur_group::Order;
use assur_mechanism::Mechanism;
use assur_structure::Structure;

use crate::{Methods, Plan, explain, modelled, not_modelled};

fn scene(name: &str, change: impl Fn(String) -> String) -> Mechanism {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    assur_scene::read(name, &change(std::fs::read_to_string(path).unwrap())).unwrap()
}

fn plan(mechanism: &Mechanism) -> Plan {
    let methods = Methods { analyzer: "groups".into(), integrator: "auto".into() };
    Plan::of(mechanism, &Structure::of(mechanism).unwrap(), &methods)
}

fn with_output(output: &str) -> Plan {
    plan(&scene("shaper", |text| format!("{text}\n[output]\n{output}\n")))
}

fn needed(plan: &Plan, stage: &str) -> bool {
    plan.stages.iter().find(|found| found.name == stage).unwrap().needed
}

#[test]
fn everything_is_planned_where_nothing_is_asked_for() {
    let plan = plan(&scene("shaper", |text| text));
    assert_eq!(plan.groups_needed, [true, true]);
    assert_eq!(plan.order, Order::Second);
    assert!(plan.velocities && plan.reduction && plan.inertia_loads && plan.forces && !plan.dynamics);
    assert_eq!((plan.wanted.links.len(), plan.wanted.points.len(), plan.wanted.slides.len()), (5, 7, 3));
    assert_eq!(plan.wanted.reactions.len(), 4 + 3);
}

#[test]
fn groups_that_nothing_depends_on_are_left_out() {
    assert_eq!(with_output("points = [\"A\"]").groups_needed, [false, false]);
    assert_eq!(with_output("points = [\"S3\"]").groups_needed, [true, false]);
    // The pin D belongs to both groups; the first one places it.
    assert_eq!(with_output("points = [\"D\"]").groups_needed, [true, false]);
    assert_eq!(with_output("links = [\"ram\"]").groups_needed, [true, true]);
    assert_eq!(with_output("slides = [\"stone2/rocker\"]").groups_needed, [true, false]);
    // Reactions depend on every load behind them.
    assert_eq!(with_output("reactions = [\"A\"]").groups_needed, [true, true]);
}

#[test]
fn stages_that_nothing_needs_are_left_out() {
    let kinematic = with_output("points = [\"S3\"]");
    assert!(kinematic.velocities && !kinematic.forces && !kinematic.reduction && !kinematic.inertia_loads);
    for stage in ["inertia loads", "reactions", "balancing load", "checks", "equation of motion"] {
        assert!(!needed(&kinematic, stage), "{stage}");
    }
    let still = plan(&scene("shaper", |text| text.replace("[motion]\nspeed = \"60 rpm\"\n", "")));
    assert!(still.forces && still.reduction && !still.velocities && !still.inertia_loads);
}

#[test]
fn second_derivatives_are_planned_only_where_something_needs_them() {
    // Reactions of massless links without a motion: the virtual power of the loads needs PF1 only.
    let change = |text: String| {
        text.replace("[motion]\nspeed = \"10 rpm\"\n", "") + "\n[output]\nreactions = [\"A\"]\n"
    };
    assert_eq!(plan(&scene("press", change)).order, Order::First);
    assert_eq!(
        plan(&scene("press", |text| text + "\n[output]\nreactions = [\"A\"]\npoints = [\"A\"]\n")).order,
        Order::Second
    );
}

#[test]
fn what_is_not_modelled_is_told_with_the_way_to_include_it() {
    let press = scene("press", |text| text);
    let told = |what: &str| {
        not_modelled(&press).into_iter().find(|remark| remark.what.starts_with(what)).map(|remark| remark.how)
    };
    assert!(told("mass of `crank`, `rod`, `slider`").unwrap().contains("add `mass`"));
    assert!(told("weights").unwrap().contains("gravity"));
    assert!(told("friction in pairs").unwrap().contains("against_motion"));
    assert!(told("velocities").is_none());
    assert!(modelled(&press).iter().any(|remark| remark.what == "contacts"));
}

#[test]
fn explanation_names_every_stage_and_group() {
    let mechanism = scene("shaper", |text| text);
    let text = explain(&mechanism, &Structure::of(&mechanism).unwrap(), &plan(&mechanism));
    let plan = plan(&mechanism);
    for stage in &plan.stages {
        assert!(text.contains(&format!(
            "  {}: {}",
            stage.name,
            if stage.needed { "run" } else { "left out" }
        )));
    }
    for words in ["\nStructure\n", "group 1 (RPR stone2, rocker)", "\nModelled\n", "\nNot modelled\n"] {
        assert!(text.contains(words), "{words}");
    }
}
