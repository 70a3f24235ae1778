//! Forces of motions: what a check of them sees, and what is left at a change point.

use assur_force::Loads;
use assur_kinematics::Linkage;
use assur_mechanism::{Direction, Mechanism};

use super::{analyzed, coordinates, ends, study};
use crate::results::{Column, Owner, Quantity};
use crate::{Coverage, unwatched};

/// A slider-crank that runs down against a force over the stroke, a weight and a moment.
const TRANSIENT: &str = "gravity = 9.81\n[ground]\npoints = { O = [0, 0] }\n\
    [link.crank]\npoints = { O = 0, A = 0.1 }\ninertia = 0.5\nmass = 1\ncenter = 0.03\n\
    [link.rod]\npoints = { A = 0, B = 0.35 }\nmass = 0.7\ncenter = 0.1\ninertia = 0.01\n\
    [link.slider]\npoints = { B = 0 }\nmass = 1\n[[slide]]\nlink = \"slider\"\non = \"ground\"\n[assembly]\nB = [0.4, 0]\n\
    [[force]]\nlink = \"slider\"\nat = \"B\"\nangle = \"180 deg\"\n\
    value = { over = \"stroke\", axis = 0, forward = [[0, 0], [1, 100]], back = 0 }\n\
    [[moment]]\nlink = \"rod\"\nvalue = { over = \"time\", table = [[0, 0], [1, 30]] }\n\
    [input]\nlink = \"crank\"\nfrom = \"10 deg\"\npositions = 12\n\
    [motion]\nkind = \"transient\"\nspeed = 40\nuntil = \"0.1 s\"\n";

/// Names of the checks that fail where the loads are those of a changed mechanism.
fn failing(change: impl FnOnce(&mut Mechanism)) -> Vec<String> {
    let mut calculation = study(TRANSIENT).unwrap();
    let mut mechanism = calculation.linkage.mechanism.clone();
    change(&mut mechanism);
    calculation.loads = Some(Loads::compile(&Linkage::compile(mechanism).unwrap()).unwrap());
    let checks = calculation.checks(Coverage::Sample, &mut unwatched).unwrap().all;
    checks.iter().filter(|check| check.finding.failed()).map(|check| check.name.to_string()).collect()
}

/// A change of the scene that stands for a mistake in the compiled loads.
type Change = fn(&mut Mechanism);

#[test]
fn a_wrong_load_in_a_transient_motion_is_caught() {
    assert_eq!(failing(|_| ()), [""; 0]);
    let changes: [(&str, Change); 4] = [
        ("weights upwards", |m| m.gravity = m.gravity.map(|g| g.map(|g| -g))),
        ("force turned round", |m| m.loads[0].kind.force_mut().unwrap().direction = Direction::Ground(0.0)),
        ("mass by 1e-6", |m| m.links[2].mass *= 1.0 + 1e-6),
        ("inertia negative", |m| m.links[2].inertia *= -1.0),
    ];
    for (what, change) in changes {
        let caught = failing(change);
        assert!(caught.iter().any(|name| name == "loads"), "{what}: {caught:?}");
    }
}

#[test]
fn the_balancing_moment_at_a_change_point_follows_from_the_powers() {
    // A parallelogram lies flat at 0 and 180 degrees, where its reactions are not determined. Both masses move with the
    // crank's pin: M = (2 + 3) g r cos q.
    let scene = "gravity = 9.81\n[ground]\npoints = { O = [0, 0], C = [3, 0] }\n\
        [link.crank]\npoints = { O = 0, A = 1 }\nmass = 2\ncenter = \"A\"\n[link.coupler]\npoints = { A = 0, B = 3 }\n\
        [link.rocker]\npoints = { C = 0, B = 1 }\nmass = 3\ncenter = \"B\"\n\
        [assembly]\nB = [3.5, 0.87]\n[input]\nlink = \"crank\"\nfrom = \"60 deg\"\npositions = 12\n";
    let found = analyzed(scene);
    let positions = &found.positions;
    for force in positions.schema().select(|column| column.quantity == Quantity::Force) {
        let flat = positions.numbers().iter().zip(positions.each(force)).filter(|(_, force)| force.is_none());
        assert_eq!(flat.map(|(number, _)| *number).collect::<Vec<_>>(), [4, 10]);
    }
    for (row, coordinate) in coordinates(&found).into_iter().enumerate() {
        let wanted = 5.0 * 9.81 * coordinate.cos();
        let balancing = positions.get(row, Column::BALANCING).unwrap();
        assert!((balancing - wanted).abs() < 1e-8, "{row}: {balancing} for {wanted}");
    }
    assert!(
        found.warnings.iter().any(|note| note.to_string().starts_with("No reactions in positions 4, 10: "))
    );
}

#[test]
fn a_spring_whose_ends_meet_is_told() {
    let scene = "[ground]\npoints = { O = 0, E = [1, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
        [[spring]]\nname = \"buffer\"\nbetween = [\"A\", \"E\"]\nstiffness = 50\nlength = 0.2\n\
        [input]\nlink = \"crank\"\npositions = 8\n";
    let of = |scene: &str| {
        analyzed(scene)
            .warnings
            .into_iter()
            .filter(|note| note.to_string().contains("buffer"))
            .collect::<Vec<_>>()
    };
    let notes = of(scene);
    assert_eq!(notes.len(), 1);
    assert!(
        notes[0]
            .to_string()
            .starts_with("The ends of spring `buffer` meet in position 0: it has no direction"),
        "{notes:?}"
    );
    assert!(of(&scene.replace("length = 0.2", "length = 0")).is_empty());
    assert!(of(&scene.replace("E = [1, 0]", "E = [1.1, 0]")).is_empty());
}

/// The friction of the press is given against the sliding; turned round, or with the motion the other way, it pushes.
#[test]
fn a_friction_that_pushes_with_the_sliding_is_told() {
    let of = |text: &str| {
        let notes = analyzed(text).warnings;
        notes.iter().map(ToString::to_string).filter(|note| note.contains("slid")).collect::<Vec<_>>()
    };
    let press = super::text("press");
    let all = "The friction of `contact 1 on rod` acts in the direction of sliding in positions 0, 1, 2, ";
    assert!(of(&press).is_empty() && of(&super::text("press-compression")).is_empty());
    let turned = of(&press.replace("friction = 0.1", "friction = -0.1"));
    assert!(turned.len() == 1 && turned[0].starts_with(all), "{turned:?}");
    assert!(
        turned[0].ends_with("With `friction = { against_sliding = 0.1 }` the sign is determined."),
        "{turned:?}"
    );
    let back = of(&press.replace("direction = \"cw\"\n", ""));
    assert!(back.len() == 1 && back[0].starts_with(all), "{back:?}");
    // With R = (r2 + b) cos a the arc rolls in the middle.
    let radius = 0.8 * 4.0_f64.to_radians().cos();
    let rolls = press.replace("\"750 mm\"", &format!("{radius:?}"));
    let rolls = of(&rolls.replace("friction = 0.1", "friction = { against_sliding = 0.1 }"));
    assert_eq!(
        rolls,
        [
            "The arc of `contact 1 on rod` rolls without sliding in position 16: there its friction has the sense that it has just \
             after."
        ]
    );
}

#[test]
fn a_list_against_the_motion_is_told() {
    let press = super::text("press");
    let listed = |text: &str| {
        analyzed(text).warnings.iter().map(ToString::to_string).find(|note| note.contains("are listed"))
    };
    assert_eq!(listed(&press), None);
    assert_eq!(
        listed(&press.replace("direction = \"cw\"\n", "")).unwrap(),
        "The positions are listed from -70.000000 deg to -110.000000 deg, and the input moves the other way: velocity arrows \
         point against the order of the positions. With `direction = \"cw\"` in [input] the motion follows the list."
    );
    let upward =
        press.replace("from = \"-70 deg\"\nto = \"-110 deg\"", "from = \"-110 deg\"\nto = \"-70 deg\"");
    assert!(listed(&upward).unwrap().contains("`direction = \"ccw\"`"));
}

/// A weight does nothing over a turn: what is left of its work is rounding, and drives no machine.
#[test]
fn a_weight_drives_nothing() {
    for from in ["0.37", "1.1", "2.9", "4.4"] {
        let found = analyzed(&format!(
            "gravity = 9.81\n[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\n\
             mass = 3\ncenter = [0.07, 0.03]\ninertia = 0.08\n[input]\nlink = \"crank\"\nfrom = {from}\n\
             [motion]\nkind = \"steady\"\nmean_speed = 7\n[drive]\ntorque = \"balance\"\nflywheel = 0.5\n",
        ));
        let dynamics = found.dynamics.unwrap();
        assert!(!dynamics.loads_drive());
        assert!(found.warnings.iter().all(|note| note.text.identity() != Some("analysis-loads-drive")));
    }
}

/// Driving is what does positive work over the cycle: in E example 2 the engine is a load of the scene.
#[test]
fn who_drives_is_who_does_the_work() {
    let drives = |name: &str| analyzed(&super::text(name)).dynamics.unwrap().loads_drive();
    assert!(drives("flywheel") && !drives("shaper-drive"));
}

/// Two brakes that hold a mechanism at rest: on two links how they share is open, on one link they make a moment that is known. The ram,
/// 2 kg, lies on its guide whatever they share.
#[test]
fn what_brakes_share_is_left_open_where_it_matters() {
    let scene = include_str!("brakes-share-rest.toml");
    let on_one_link = scene.replace("link = \"rocker\"\nradius", "link = \"crank\"\nradius");
    for (scene, open) in [(scene, &["O", "A", "B", "C"][..]), (on_one_link.as_str(), &[])] {
        let analysis = analyzed(scene);
        let (found, last) = (&analysis.trajectory, analysis.trajectory.len() - 1);
        let speed = Column::of(Quantity::Velocity, Owner::Input);
        assert_eq!(found.get(last, speed), Some(0.0));
        for (pair, link) in ends(found) {
            let owner = Owner::PairOn(pair, link);
            let name = found.schema().name(owner).into_owned();
            let known =
                |row: usize| Column::vector(Quantity::Force, owner).map(|column| found.get(row, column));
            assert!(known(0).iter().all(Option::is_some), "{name}");
            match (open.contains(&&*name), known(last)) {
                (true, force) => assert_eq!(force, [None; 2], "{name}"),
                (false, [Some(x), Some(y)]) if name == "ram/ground" => {
                    assert!(x.abs() < 1e-12 && (y.abs() - 19.62).abs() < 1e-12, "{x} {y}");
                }
                (false, force) => assert!(force.iter().all(Option::is_some), "{name}"),
            }
        }
        let balancing = found.get(last, Column::BALANCING);
        assert!(balancing.is_some_and(|load| load.abs() < 1e-9), "{balancing:?}");
    }
}
