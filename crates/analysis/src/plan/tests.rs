//! Which groups and stages a scene needs.

use assur_all as _;
use assur_group::Order;
use assur_mechanism::Mechanism;
use assur_structure::Structure;
use assur_words::text;

use crate::plan::Plan;

fn scene(name: &str, change: impl Fn(String) -> String) -> Mechanism {
    assur_scene::read(name, &change(assur_fixtures::scene(name).to_owned())).unwrap()
}

fn plan_by(mechanism: &Mechanism, by_groups: bool) -> Plan {
    Plan::of(mechanism, &Structure::of(mechanism).unwrap(), mechanism.output.as_ref(), by_groups)
}

fn plan(mechanism: &Mechanism) -> Plan {
    plan_by(mechanism, true)
}

fn with_output(output: &str) -> Plan {
    plan(&scene("shaper", |text| format!("{text}\n[output]\n{output}\n")))
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
    assert!(kinematic.is_partial() && !kinematic.dynamics);
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

fn shaper_with(change: impl Fn(String) -> String, output: &str) -> Plan {
    plan(&scene("shaper", |text| format!("{}\n{output}", change(text))))
}

/// Takes masses from every link but the named ones.
fn massless(text: &str, heavy: &[&str]) -> String {
    let mut kept = true;
    let lines = text.lines().filter(|line| {
        if let Some(link) = line.strip_prefix("[link.") {
            kept = heavy.iter().any(|name| link.starts_with(name));
        }
        kept || !["mass", "center", "inertia"].iter().any(|key| line.starts_with(key))
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn unloaded(text: &str) -> String {
    let start = text.find("[[force]]").unwrap();
    let end = text[start + 2..].find("\n[").map_or(text.len(), |at| start + 2 + at);
    format!("{}{}", &text[..start], &text[end..])
}

const STILL: fn(&str) -> String = |text| text.replace("[motion]\nspeed = \"60 rpm\"\n", "");

#[test]
fn loads_reach_the_groups_before_them_and_no_others() {
    let carrying = |text: &str| plan(&assur_scene::read("test", text).unwrap()).groups_carrying;
    let text = assur_fixtures::scene("shaper");
    assert_eq!(carrying(text), [true, true]);
    let light = unloaded(&massless(text, &["rocker"]));
    assert_eq!(carrying(&light), [true, false]);
    assert_eq!(carrying(&unloaded(&massless(text, &["crank"]))), [false, false]);
    // A load of the last group goes through all groups before it.
    assert_eq!(carrying(&unloaded(&massless(text, &["ram"]))), [true, true]);
    assert_eq!(carrying(&massless(text, &[])), [true, true]);
    // Mass at rest without gravity loads nothing; a weight, a spring and the balancing load do.
    let weightless = STILL(&light).replace("gravity = \"9.81 m/s^2\"", "");
    assert_eq!(carrying(&weightless), [false, false]);
    assert_eq!(carrying(&STILL(&light)), [true, false]);
    let spring = "\n[[spring]]\nbetween = [\"K\", \"O\"]\nstiffness = 5\n";
    assert_eq!(carrying(&(weightless.clone() + spring)), [true, true]);
    assert_eq!(carrying(&(weightless + "\n[balance]\nlink = \"rocker\"\n")), [true, false]);
}

#[test]
fn a_method_for_the_whole_system_needs_all_groups() {
    let mechanism =
        scene("shaper", |text| unloaded(&massless(&text, &["rocker"])) + "\n[output]\nreactions = [\"A\"]\n");
    assert_eq!(plan_by(&mechanism, true).groups_needed, [true, false]);
    assert_eq!(plan_by(&mechanism, false).groups_needed, [true, true]);
}

#[test]
fn the_order_is_what_something_needs() {
    let reactions = "[output]\nreactions = [\"A\"]\n";
    let nothing = "[output]\nreactions = []\n";
    // Statics of massless links: PF1 for the virtual power.
    let still = shaper_with(|text| STILL(&massless(&text, &[])), reactions);
    assert_eq!((still.order, still.order_for.len()), (Order::First, 2));
    // A mass on the crank alone needs no more: J is constant.
    let crank = shaper_with(|text| STILL(&massless(&text, &["crank"])), reactions);
    assert_eq!((crank.order, crank.inertia_constant), (Order::First, true));
    // Masses behind need PF2 even at rest, as dJ/dq is reported; and in motion.
    let heavy = shaper_with(|text| STILL(&text), reactions);
    assert_eq!(
        (heavy.order, heavy.order_for.clone()),
        (Order::Second, vec![text!("analysis-order-inertia")])
    );
    // A load against the motion looks at PF2 to see where its point stands.
    let against = |text: String| {
        massless(&text, &[]).replace("angle = \"0 deg\"\nvalue", "against_motion = true\nvalue")
    };
    assert_eq!(shaper_with(against, reactions).order, Order::Second);
    // Nothing that needs any.
    let none = shaper_with(|text| text, nothing);
    assert_eq!((none.order, none.groups_needed.clone()), (Order::Place, vec![false, false]));
    // Transfer functions are reported wherever a link is.
    let told = shaper_with(|text| STILL(&massless(&text, &[])), "[output]\nlinks = [\"rocker\"]\n");
    assert_eq!((told.order, told.order_for.clone()), (Order::Second, vec![text!("analysis-order-shown")]));
}

#[test]
fn constant_inertia_is_seen_in_the_structure() {
    let constant = |name: &str| plan(&scene(name, |text| text)).inertia_constant;
    assert!(constant("brake") && constant("flywheel") && constant("press"));
    assert!(!constant("shaper") && !constant("n-four-bar-2"));
    // A mass concentrated at a pin on the ground stays where it is.
    let rests =
        |text: String| massless(&text, &["crank", "rocker"]).replace("center = \"S3\"", "center = \"C\"");
    assert!(!plan(&scene("shaper", rests)).inertia_constant);
    let without = |text: String| {
        let rests = rests(text);
        let at = rests.find("[link.rocker]").unwrap();
        let (before, after) = rests.split_at(at);
        let inertia = after.find("inertia").unwrap();
        let end = inertia + after[inertia..].find('\n').unwrap();
        format!("{before}{}{}", &after[..inertia], &after[end..])
    };
    assert!(plan(&scene("shaper", without)).inertia_constant);
}
