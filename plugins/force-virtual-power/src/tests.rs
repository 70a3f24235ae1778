use assur_force::{
    Construction, ConstructionStep, Drawing, ForceAnalyzer, LoadState, Loads, Reactions, find,
};
use assur_force_newton_euler::NewtonEuler;
use assur_group::plane::cross;
use assur_group::{Order, Wrench};
use assur_group_prp as _;
use assur_group_rpp as _;
use assur_group_rpr as _;
use assur_group_rrp as _;
use assur_group_rrr as _;
use assur_kinematics::{Linkage, Position};
use assur_testkit::specimen::Recipe;

use crate::VirtualPower;

/// The step of this short name in English in a drawing.
fn step<'a>(drawn: &'a Construction, drawing: Drawing, name: &str) -> Option<&'a ConstructionStep> {
    drawn.steps.iter().find(|step| step.drawing == drawing && step.name.to_string() == name)
}

fn compile(name: &str) -> Linkage {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let scene = std::fs::read_to_string(path).unwrap();
    Linkage::compile(assur_scene::read(name, &scene).unwrap_or_else(|errors| panic!("{errors}"))).unwrap()
}

/// A state that shows inertia as well, whatever the motion of the scene.
fn loaded(linkage: &Linkage, coordinate: f64) -> (Position, Vec<Wrench<f64>>) {
    let loads = Loads::compile(linkage).unwrap();
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::Second, &mut position).unwrap();
    let state =
        LoadState { speed: 3.0, acceleration: 2.0, ..LoadState::prescribed(&linkage.mechanism, coordinate) };
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    loads.evaluate(&state, &position.bodies, &mut wrenches);
    (position, wrenches)
}

fn solve(
    analyzer: &dyn ForceAnalyzer,
    linkage: &Linkage,
    position: &Position,
    loads: &[Wrench<f64>],
) -> Reactions {
    let mut out = Reactions::new(linkage);
    analyzer.solve(linkage, position, &mut loads.to_vec(), &mut out).unwrap();
    out
}

const SCENES: [&str; 8] =
    ["shaper", "guide-shaper", "conveyor", "stephenson3", "press", "four-bar", "boom", "leg"];

#[test]
fn agrees_with_newton_euler_on_fixtures() {
    for name in SCENES {
        let linkage = compile(name);
        for index in 0..linkage.mechanism.input.positions {
            let (position, loads) = loaded(&linkage, linkage.mechanism.input.coordinate(index));
            let whole = solve(&NewtonEuler, &linkage, &position, &loads);
            let lever = solve(&VirtualPower, &linkage, &position, &loads);
            let scale = whole.balancing.abs().max(1.0);
            assert!((lever.balancing - whole.balancing).abs() < 1e-9 * scale, "{name} {index}");
            assert!(lever.pairs.iter().all(|pair| pair.fx.is_nan() && pair.fy.is_nan() && pair.m.is_nan()));
        }
    }
}

/// The lever at a coordinate, under all loads with inertia.
fn lever(linkage: &Linkage, coordinate: f64) -> Construction {
    let (position, _) = loaded(linkage, coordinate);
    let state =
        LoadState { speed: 3.0, acceleration: 2.0, ..LoadState::prescribed(&linkage.mechanism, coordinate) };
    let loads = Loads::compile(linkage).unwrap().acting(&state, &position.bodies);
    VirtualPower.construction(linkage, &position, &loads).unwrap().unwrap()
}

/// Sum of the moments about the pole of the lever, and of their sizes.
fn moments(linkage: &Linkage, coordinate: f64) -> (f64, f64) {
    let drawn = lever(linkage, coordinate);
    let forces = drawn.steps.iter().filter(|step| step.unit == "N");
    let moments: Vec<f64> = forces.map(|step| cross(step.start, step.vector)).collect();
    (moments.iter().sum(), moments.iter().map(|m| m.abs()).sum())
}

#[test]
fn the_lever_is_in_equilibrium() {
    for name in SCENES {
        let linkage = compile(name);
        for index in 0..linkage.mechanism.input.positions {
            let (sum, size) = moments(&linkage, linkage.mechanism.input.coordinate(index));
            assert!(sum.abs() <= 1e-12 * size, "{name} {index}: {sum} of {size}");
        }
    }
}

#[test]
fn random_mechanisms_balance_and_agree() {
    let mut compared = 0;
    for seed in 0..60 {
        let groups = 1 + usize::try_from(seed % 4).unwrap();
        let Some(specimen) = Recipe::of(groups).specimen(seed) else { continue };
        let linkage = Linkage::compile(specimen.mechanism).unwrap();
        let (position, loads) = loaded(&linkage, linkage.mechanism.input.coordinate(0));
        let mut out = Reactions::new(&linkage);
        if NewtonEuler.solve(&linkage, &position, &mut loads.clone(), &mut out).is_err() {
            continue;
        }
        let lever = solve(&VirtualPower, &linkage, &position, &loads);
        let greatest =
            out.pairs.iter().fold(out.balancing.abs(), |g, pair| g.max(pair.fx.abs()).max(pair.fy.abs()));
        assert!((lever.balancing - out.balancing).abs() < 1e-9 * greatest, "{seed}");
        let (sum, size) = moments(&linkage, linkage.mechanism.input.coordinate(0));
        assert!(sum.abs() <= 1e-10 * size, "{seed}: {sum} of {size}");
        compared += 1;
    }
    assert!(compared > 40, "{compared}");
}

#[test]
fn images_are_velocities_turned_clockwise() {
    // A crank of 60 mm pointing up: A moves to the left with 0.06 m/rad; turned clockwise, its image lies upward.
    let linkage = compile("slider-crank");
    let drawn = lever(&linkage, std::f64::consts::FRAC_PI_2);
    let image = step(&drawn, Drawing::Lever, "a").unwrap();
    assert!(image.vector[0].abs() < 1e-16 && (image.vector[1] - 0.06).abs() < 1e-16);
    assert_eq!((image.unit, image.note.to_string().as_str()), ("m/rad", "velocity of A for dq = 1, turned"));
    assert_eq!(drawn.title.to_string(), "Zhukovsky's lever: velocity plan for dq = 1, turned clockwise");
}

/// L: the lever of the press is balanced by a force across the crank at A, the balancing moment over the crank; the force of
/// the contact acts in the image of K, and no force is drawn in a point at rest.
#[test]
fn the_lever_of_the_press_is_balanced_by_a_force_at_a() {
    let linkage = compile("press");
    let coordinate = linkage.mechanism.input.coordinate(16);
    let (position, loads) = loaded(&linkage, coordinate);
    let moment = solve(&NewtonEuler, &linkage, &position, &loads).balancing;
    let drawn = lever(&linkage, coordinate);
    let forces: Vec<_> = drawn.steps.iter().filter(|step| step.unit == "N").collect();
    assert_eq!(forces.len(), 2, "{forces:?}");
    let (a, balance) =
        (step(&drawn, Drawing::Lever, "a").unwrap(), step(&drawn, Drawing::Lever, "F_bal").unwrap());
    assert!((0..2).all(|i| (balance.start[i] - a.vector[i]).abs() < 1e-15), "{balance:?} {a:?}");
    let [sin, cos] = [coordinate.sin(), coordinate.cos()];
    let along = balance.vector[0] * cos + balance.vector[1] * sin;
    let across = balance.vector[1] * cos - balance.vector[0] * sin;
    assert!(along.abs() < 1e-9 && (across - moment / 0.04).abs() < 1e-9, "{balance:?} {moment}");
    // K of the rod: 4 degrees from below the center of the arc.
    let rod = &position.bodies[linkage.mechanism.link("rod").unwrap()];
    let (s, c) = 4.0_f64.to_radians().sin_cos();
    let center = rod.arm([-0.64, 0.0]);
    let first = rod.first([center[0] - 0.75 * s, center[1] - 0.75 * c]);
    let image = step(&drawn, Drawing::Lever, "k").unwrap().vector;
    assert!((0..2).all(|i| (image[i] - forces[0].start[i]).abs() < 1e-15), "{image:?} {forces:?}");
    assert!(
        (image[0] - first[1]).abs() < 1e-15 && (image[1] + first[0]).abs() < 1e-15,
        "{image:?} {first:?}"
    );
}

#[test]
fn an_idle_balancing_load_is_refused() {
    // In its dead center the piston stands still: a force on it balances nothing.
    let path = format!("{}/../../fixtures/slider-crank.toml", env!("CARGO_MANIFEST_DIR"));
    let scene = std::fs::read_to_string(path).unwrap()
        + "\n[balance]\nlink = \"piston\"\nat = \"B\"\nangle = \"90 deg\"\n";
    let linkage = Linkage::compile(assur_scene::read("x", &scene).unwrap()).unwrap();
    let (position, loads) = loaded(&linkage, std::f64::consts::FRAC_PI_2);
    let mut out = Reactions::new(&linkage);
    let error = VirtualPower.solve(&linkage, &position, &mut loads.clone(), &mut out).unwrap_err();
    let text = error.to_string();
    assert!(
        text.starts_with("coordinate 1.570796327: the balancing force on `piston` does no work there"),
        "{text}"
    );
}

#[test]
fn it_is_registered_without_reactions() {
    let plugin = find("virtual-power").unwrap();
    assert!(!plugin.gives_reactions && plugin.crate_name == "assur-force-virtual-power");
    assert_eq!(plugin.instance.supports(&compile("shaper")), Ok(()));
}

#[test]
fn it_conforms() {
    assur_testkit::analyzer_conformance("virtual-power");
}
