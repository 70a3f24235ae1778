//! A kind of group that nobody has foreseen: it registers itself in this program, and everything else follows. Nothing in
//! `crates/` knows of it; a new folder in `plugins/` does the same.

use assur_all as _;
use assur_check::checks;
use assur_group::PairSort::Pin;
use assur_group::{
    Assemblies, AssurGroup, Body, BuildError, Builders, ForceAngle, GroupError, GroupFrame, GroupKind,
    GroupPlugin, Number, Pattern, inventory, place_by_newton,
};
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;
use assur_number::Real;
use assur_words::Text;

/// Class III: a ternary link that three binary links join to outer bodies. Only its places are said; derivatives and
/// reactions are the defaults.
#[derive(Debug)]
struct Triad(GroupFrame);

impl<T: Real> AssurGroup<T> for Triad {
    fn frame(&self) -> &GroupFrame {
        &self.0
    }

    fn place(&self, bodies: &mut [Body<T>], _way: usize) -> Result<T, GroupError> {
        place_by_newton(&self.0, bodies)
    }
}

struct TriadKind;

impl GroupKind for TriadKind {
    type Kernel<T: Number> = Triad;

    fn build<T: Number>(frame: &GroupFrame) -> Result<Triad, BuildError> {
        Ok(Triad(frame.clone()))
    }
}

/// The words of an entry of a test.
const TEST: Text = Text::message("a test", Vec::new());

inventory::submit! {
    GroupPlugin {
        name: "triad",
        kind: "triad",
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: TEST,
        pattern: Some(Pattern {
            links: 4,
            inner: &[([0, 1], Pin), ([0, 2], Pin), ([0, 3], Pin)],
            outer: &[(1, Pin), (2, Pin), (3, Pin)],
        }),
        // Before the kind of the repository that has this pattern.
        rank: 5,
        ways: Assemblies { most: 1, varies: false, words: TEST },
        iterates: true,
        singular: TEST,
        force_angle: ForceAngle::DEFAULT,
        source: TEST,
        builders: Builders::of::<TriadKind>(),
    }
}

/// Stephenson II: driven from the ternary crank, the other links are one group of class III.
const STEPHENSON_II: &str = r#"
title = "Stephenson II"
gravity = "9.81 m/s^2"
[ground]
points = { O = [0, 0], Q = [0.55, -0.3] }
[link.crank]
points = { O = 0, A = 0.1, D = [-0.02, 0.12] }
mass = 2
center = [0.03, 0.04]
inertia = 0.01
[link.rod]
points = { A = 0, B = 0.36 }
mass = 1
center = 0.18
inertia = 0.01
[link.strut]
points = { D = 0, E = 0.43 }
mass = 1.2
center = 0.2
inertia = 0.015
[link.plate]
points = { B = 0, E = [-0.05, 0.2], F = [0.16, 0.15], T = [0.1, 0.3] }
mass = 3
center = [0.04, 0.12]
inertia = 0.03
[link.rocker]
points = { Q = 0, F = [0.05, 0.5] }
mass = 2
center = [0.02, 0.25]
inertia = 0.04
[input]
link = "crank"
from = "-20 deg"
to = "25 deg"
positions = 10
[assembly]
A = [0.094, -0.034]
D = [0.022, 0.12]
B = [0.45, 0.05]
E = [0.4, 0.25]
F = [0.61, 0.2]
[motion]
speed = 8
acceleration = 20
[[force]]
link = "plate"
at = "T"
angle = "-70 deg"
value = 150
[[spring]]
between = ["ground.O", "T"]
stiffness = 500
length = 0.3
damping = 10
"#;

fn stephenson() -> Mechanism {
    assur_scene::read("stephenson2.toml", STEPHENSON_II).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn it_is_listed_beside_the_five_types() {
    let all = assur_group::groups().unwrap_or_else(|error| panic!("{error}"));
    let names: Vec<_> = all.iter().map(|plugin| plugin.name).collect();
    for wanted in ["prp", "rpp", "rpr", "rrp", "rrr", "rr-rr-rr", "any", "triad"] {
        assert!(names.contains(&wanted), "{wanted}");
    }
}

#[test]
fn the_decomposition_uses_it_and_every_check_holds() {
    let linkage = Linkage::compile(stephenson()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(linkage.structure.formula, "I(ground,crank) -> III/3(rod,strut,plate,rocker)");
    assert_eq!((linkage.structure.class(), linkage.structure.groups[0].plugin.name), (3, "triad"));
    let all = checks(&linkage);
    for check in &all {
        assert!(
            check.finding.holds == Some(true),
            "{} at {:?}, {}: {:e} of {:e}",
            check.name,
            check.at,
            check.finding.place,
            check.finding.error,
            check.finding.bound
        );
        assert_eq!(check.left_out, 0, "{}", check.name);
    }
    for wanted in [
        "TestPf PF1",
        "TestPf PF2",
        "equilibrium of links",
        "agreement of the methods",
        "Lagrange-d'Alembert",
    ] {
        assert!(all.iter().any(|check| check.name.to_string() == wanted), "{wanted}");
    }
}

#[test]
fn places_depend_on_the_coordinate_alone() {
    let linkage = Linkage::compile(stephenson()).unwrap_or_else(|error| panic!("{error}"));
    let solved = |coordinates: &[f64]| {
        let mut position = linkage.position();
        for &q in coordinates {
            let found = linkage.solve(q, assur_group::Order::Second, &mut position);
            found.unwrap_or_else(|error| panic!("{error}"));
        }
        position.bodies
    };
    assert_eq!(solved(&[0.3]), solved(&[-0.3, 0.1, 0.3]));
}

#[test]
fn its_start_needs_only_the_points_that_nothing_else_places() {
    // A and D are points of the input link; the places of the ground's pins are known too.
    let kept = |line: &&str| !line.starts_with("A = [0.094") && !line.starts_with("D = [0.022");
    let text = STEPHENSON_II.lines().filter(kept).collect::<Vec<_>>().join("\n");
    let natural = assur_scene::read("natural.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(natural.assembly.len(), 3);
    let first = |mechanism: Mechanism| {
        let linkage = Linkage::compile(mechanism).unwrap_or_else(|error| panic!("{error}"));
        let mut position = linkage.position();
        let found = linkage.solve_index(0, assur_group::Order::Place, &mut position);
        found.unwrap_or_else(|error| panic!("{error}"));
        position.bodies
    };
    for (one, other) in first(natural).iter().zip(&first(stephenson())) {
        assert!((one.x - other.x).hypot(one.y - other.y) < 1e-14, "{one:?} {other:?}");
    }
}
