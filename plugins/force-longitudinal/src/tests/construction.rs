use assur_force::{Construction, ConstructionStep, Drawing, ForceAnalyzer, LoadState, Loads};
use assur_group::plane::{cross, dot, minus, plus};
use assur_kinematics::Linkage;

use super::{compile, fixture, loaded};
use crate::Longitudinal;

/// The step of this short name in English in a drawing.
fn step<'a>(drawn: &'a Construction, drawing: Drawing, name: &str) -> Option<&'a ConstructionStep> {
    drawn.steps.iter().find(|step| step.drawing == drawing && step.name.to_string() == name)
}

const STABLE: Longitudinal = Longitudinal::Stable;

fn drawn(linkage: &Linkage, q: f64) -> Construction {
    let (position, _) = loaded(linkage, q);
    let state = LoadState::prescribed(&linkage.mechanism, q);
    let loads = Loads::compile(linkage).unwrap().acting(&state, &position.bodies);
    STABLE.construction(linkage, &position, &loads).unwrap().unwrap()
}

fn vector(drawn: &Construction, drawing: Drawing, name: &str) -> [f64; 2] {
    step(drawn, drawing, name).unwrap_or_else(|| panic!("{name}")).vector
}

fn length(v: [f64; 2]) -> f64 {
    v[0].hypot(v[1])
}

#[test]
fn the_polygon_closes_in_the_pole() {
    for name in ["press.toml", "slider-crank.toml", "four-bar.toml"] {
        let linkage = compile(&fixture(name));
        for index in 0..linkage.mechanism.input.positions {
            let drawn = drawn(&linkage, linkage.mechanism.input.coordinate(index));
            let side = |name| vector(&drawn, Drawing::Polygon, name);
            let size = length(side("F"));
            let closed = plus(plus(side("F"), side("Fb")), side("RP"));
            assert!(length(closed) <= 1e-10 * size);
            let split = minus(side("RP"), plus(side("R1"), side("R3")));
            assert!(length(split) <= 1e-10 * length(side("RP")), "{name} {index}");
            let last = step(&drawn, Drawing::Polygon, "R3").unwrap();
            assert!(length(plus(last.start, last.vector)) <= 1e-10 * length(side("RP")));
        }
    }
}

#[test]
fn the_graphical_way_gives_the_same_balancing_force() {
    // Fb was found from moments about A; on paper it is the component of F(KA) across the crank, found with the pole.
    for name in ["press.toml", "slider-crank.toml", "four-bar.toml"] {
        let linkage = compile(&fixture(name));
        for index in 0..linkage.mechanism.input.positions {
            let drawn = drawn(&linkage, linkage.mechanism.input.coordinate(index));
            let part = |name| vector(&drawn, Drawing::Mechanism, name);
            let sum = plus(part("Fb"), part("FA across"));
            assert!(length(sum) < 1e-9 * length(part("F")), "{name} {index} {sum:?}");
            let whole = minus(part("F"), plus(part("FA"), part("FP")));
            assert!(length(whole) < 1e-9 * length(part("F")));
        }
    }
}

#[test]
fn the_pole_is_the_instant_center_and_k_the_contact() {
    let linkage = compile(&fixture("press.toml"));
    let q = linkage.mechanism.input.coordinate(5);
    let drawn = drawn(&linkage, q);
    let pole = step(&drawn, Drawing::Mechanism, "P").unwrap().start;
    assert!(length(minus(drawn.corner, pole)) < 1e-15);
    let (position, _) = loaded(&linkage, q);
    let rod = &position.bodies[linkage.mechanism.link("rod").unwrap()];
    let velocity = rod.first(minus(pole, [rod.x, rod.y]));
    assert!(length(velocity) < 1e-14);
    let angle = 4.0_f64.to_radians();
    let center = rod.point([-0.64, 0.0]);
    let contact = [center[0] - 0.75 * angle.sin(), center[1] - 0.75 * angle.cos()];
    let k = step(&drawn, Drawing::Mechanism, "K").unwrap().start;
    assert!(length(minus(k, contact)) < 1e-15);
}

#[test]
fn a_pole_at_infinity_is_a_direction() {
    let text = fixture("press.toml").replace(
        "from = \"-70 deg\"\nto = \"-110 deg\"\npositions = 33\ndirection = \"cw\"",
        "positions = 4",
    );
    let drawn = drawn(&compile(&text), 0.0);
    assert!(step(&drawn, Drawing::Mechanism, "P").is_none());
    assert_eq!(
        step(&drawn, Drawing::Mechanism, "OP").unwrap().note.to_string(),
        "the line of the crank; it is parallel to the other line, so that the pole P is at infinity"
    );
    let part = |name| vector(&drawn, Drawing::Mechanism, name);
    assert!(length(plus(part("Fb"), part("FA across"))) < 1e-9 * length(part("F")));
    // The crank lies along x: R1 along it, Fb across, R3 along x as well.
    assert!(cross(part("R1"), [1.0, 0.0]).abs() < 1e-9 && dot(part("Fb"), [1.0, 0.0]).abs() < 1e-9);
    assert!(length(minus(drawn.corner, [0.04, 0.0])) < 1e-15);
}

#[test]
fn the_steps_come_in_the_order_of_the_paper() {
    let linkage = compile(&fixture("press.toml"));
    let drawn = drawn(&linkage, -1.9);
    let names: Vec<_> = drawn.steps.iter().map(|step| step.name.to_string()).collect();
    assert_eq!(
        names,
        [
            "K",
            "F",
            "OP",
            "BP",
            "P",
            "KA",
            "KP",
            "along KP",
            "along KA",
            "FP",
            "FA",
            "FA",
            "across OP",
            "along OP",
            "FA across",
            "Fb",
            "F",
            "Fb",
            "RP",
            "R1",
            "R3",
            "R1",
            "R3",
            "RA",
            "RB",
            "RO",
            "RG"
        ]
    );
}

#[test]
fn the_parallels_end_where_the_construction_says() {
    for name in ["press.toml", "slider-crank.toml", "four-bar.toml"] {
        let linkage = compile(&fixture(name));
        for index in 0..linkage.mechanism.input.positions {
            let drawn = drawn(&linkage, linkage.mechanism.input.coordinate(index));
            let of = |name| step(&drawn, Drawing::Mechanism, name).unwrap();
            let [force, part] = ["F", "FA"].map(|name| of(name).vector);
            let least = 1e-9 * length(force);
            // The parallelogram at K: from the end of F to the ends of both parts.
            for (side, end) in [("along KP", "FA"), ("along KA", "FP")] {
                let end = minus(plus(of(side).after, of(side).vector), of(end).vector);
                assert!(
                    length(minus(of(side).after, force)) < least && length(end) < least,
                    "{name} {index}"
                );
            }
            // The parallel to the crank through the end of FA meets the normal at A at the end of -Fb.
            let parallel = of("along OP");
            let end = plus(plus(parallel.after, parallel.vector), of("Fb").vector);
            assert!(length(minus(parallel.after, part)) < least && length(end) < least, "{name} {index}");
            assert!(cross(parallel.vector, of("OP").vector).abs() < least * length(of("OP").vector));
        }
    }
}

/// APK is Zhukovsky's lever: KP over AP is the velocity of K over that of A.
#[test]
fn the_line_to_the_pole_is_the_velocity_analog_of_k() {
    let linkage = compile(&fixture("press.toml"));
    let q = linkage.mechanism.input.coordinate(3);
    let drawn = drawn(&linkage, q);
    let (position, _) = loaded(&linkage, q);
    let rod = &position.bodies[linkage.mechanism.link("rod").unwrap()];
    let k = step(&drawn, Drawing::Mechanism, "K").unwrap().start;
    let velocity = length(rod.first(minus(k, [rod.x, rod.y])));
    let told = step(&drawn, Drawing::Mechanism, "KP").unwrap().note.to_string();
    assert!(told.contains(&format!("{:.6}", velocity / 0.04)), "{told} {velocity}");
}

/// Fb, R1 and R3 of the middle of the way (eqs. 5, 10, 11 with P in B), and their sizes in the polygon everywhere.
#[test]
fn the_longitudinal_reactions_are_quantities() {
    let linkage = compile(&fixture("press.toml"));
    let found = super::reactions(&STABLE, &linkage, linkage.mechanism.input.coordinate(16)).unwrap();
    for (found, wanted) in found.further.iter().zip([7576.29, 19811.8, -4186.03]) {
        assert!((found - wanted).abs() < 0.05, "{found} {wanted}");
    }
    for name in ["press.toml", "slider-crank.toml", "four-bar.toml"] {
        let linkage = compile(&fixture(name));
        let q = linkage.mechanism.input.coordinate(5);
        let found = super::reactions(&STABLE, &linkage, q).unwrap().further;
        let drawn = drawn(&linkage, q);
        for (found, name) in found.iter().zip(["Fb", "R1", "R3"]) {
            let drawn = length(vector(&drawn, Drawing::Polygon, name));
            assert!((found.abs() - drawn).abs() < 1e-9 * drawn.max(1.0), "{name}: {found} {drawn}");
        }
    }
}
