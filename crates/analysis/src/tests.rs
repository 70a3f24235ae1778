//! The plan is obeyed, and failures are reported.

use std::sync::Arc;

use crate::results::{Analysis, Column, Owner, Part, Quantity, Residual, Table};
use assur_all as _;
use assur_mechanism::{LinkId, PairId};

use crate::{AnalysisError, Calculation, Coverage, Options, unwatched};

mod driven;
mod energies;
mod forces;
mod friction;
mod friction_cycle;
mod jumps;
mod told;
mod watched;

fn text(name: &str) -> String {
    assur_fixtures::scene(name).to_owned()
}

fn study(text: &str) -> Result<Calculation, AnalysisError> {
    Calculation::of(assur_scene::read("test", text).unwrap(), &Options::default(), &mut unwatched)
}

fn analyzed(text: &str) -> Analysis {
    let mut study = study(text).unwrap();
    study.tells_poles = true;
    study.analyze(&mut unwatched).unwrap()
}

/// A column that has a number in every row, by the name of what it belongs to.
fn values_of(table: &Table, quantity: Quantity, name: &str, part: Part) -> Vec<f64> {
    let schema = table.schema();
    let owner = schema.owners(quantity).into_iter().find(|owner| schema.name(*owner) == name).unwrap();
    let column = schema.find(Column::of(quantity, owner).part(part)).unwrap();
    table.each(column).map(Option::unwrap).collect()
}

fn values(found: &Analysis, quantity: Quantity, name: &str) -> Vec<f64> {
    values_of(&found.positions, quantity, name, Part::Whole)
}

/// The coordinates of the positions.
fn coordinates(found: &Analysis) -> Vec<f64> {
    values(found, Quantity::Transfer(0), "")
}

/// The pins and slides, with each link that they join.
fn ends(table: &Table) -> Vec<(PairId, LinkId)> {
    let owners = table.schema().owners(Quantity::Force).into_iter();
    owners
        .filter_map(|owner| if let Owner::PairOn(pair, link) = owner { Some((pair, link)) } else { None })
        .collect()
}

fn force(table: &Table, row: usize, pair: PairId, link: LinkId) -> [f64; 2] {
    Column::vector(Quantity::Force, Owner::PairOn(pair, link)).map(|column| table.get(row, column).unwrap())
}

#[test]
fn a_limited_scene_tells_the_same_numbers() {
    let (whole, part) =
        (analyzed(&text("shaper")), analyzed(&(text("shaper") + "\n[output]\nlinks = [\"rocker\"]\n")));
    assert_eq!(part.positions.len(), whole.positions.len());
    for order in 0..3 {
        let angle = |found: &Analysis| values(found, Quantity::Transfer(order), "rocker");
        assert_eq!(angle(&part), angle(&whole));
    }
    let owners = |quantity| part.positions.schema().owners(quantity).len();
    // The input and the rocker.
    assert_eq!((owners(Quantity::Transfer(0)), owners(Quantity::Condition)), (2, 1));
}

#[test]
fn a_group_that_is_not_needed_may_be_impossible() {
    // The second dyad is far too short to reach its pin on the ground.
    let impossible = "[ground]\npoints = { O = [0, 0], C = [3, 0], F = [90, 0] }\n\
        [link.crank]\npoints = { O = 0, A = 1 }\n[link.coupler]\npoints = { A = 0, B = 3 }\n\
        [link.rocker]\npoints = { C = 0, B = 2, D = 1 }\n[link.rod]\npoints = { D = 0, E = 1 }\n\
        [link.arm]\npoints = { F = 0, E = 1 }\n[input]\nlink = \"crank\"\n";
    let whole = analyzed(impossible);
    assert_eq!((whole.positions.len(), whole.failures.len()), (0, 12));
    assert!(
        whole.failures[3].message.to_string().contains("position 3, coordinate 90.0000 deg: no assembly"),
        "{}",
        whole.failures[3].message
    );
    let part = analyzed(&format!("{impossible}[output]\npoints = [\"B\"]\n"));
    assert_eq!((part.positions.len(), part.failures.len()), (12, 0));
    let place = |part_of| values_of(&part.positions, Quantity::Transfer(0), "B", part_of);
    for ((q, x), y) in coordinates(&part).into_iter().zip(place(Part::X)).zip(place(Part::Y)) {
        // |AB| = 3 and |CB| = 2 whatever the position.
        let (a, b) = ([q.cos(), q.sin()], [x, y]);
        assert!(((b[0] - a[0]).hypot(b[1] - a[1]) - 3.0).abs() < 1e-14);
        assert!(((b[0] - 3.0).hypot(b[1]) - 2.0).abs() < 1e-14);
    }
}

#[test]
fn angles_follow_the_links_over_far_positions() {
    // A parallelogram turns with its crank: three positions over three turns are a turn apart.
    let scene = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
        [link.coupler]\npoints = { A = 0, B = 3 }\n[link.rocker]\npoints = { C = 0, B = 1 }\n\
        [input]\nlink = \"crank\"\nfrom = 2\ncycle = \"1080 deg\"\npositions = 3\n\
        [assembly]\nB = [2.6, 0.9]\n";
    let found = analyzed(scene);
    for link in ["crank", "rocker"] {
        for (i, angle) in values(&found, Quantity::Transfer(0), link).into_iter().enumerate() {
            assert!((angle - (2.0 + i as f64 * std::f64::consts::TAU)).abs() < 1e-9, "{link} {i}: {angle}");
        }
    }
    assert!(values(&found, Quantity::Transfer(0), "coupler").iter().all(|angle| angle.abs() < 1e-9));
}

#[test]
fn the_first_angle_lies_in_the_first_turn() {
    let scene = text("shaper").replace("positions = 48", "positions = 48\nfrom = \"180 deg\"");
    let found = analyzed(&scene);
    assert!((values(&found, Quantity::Transfer(0), "crank")[0] - std::f64::consts::PI).abs() < 1e-15);
    let turned = analyzed(&text("shaper").replace("positions = 48", "positions = 48\nfrom = \"200 deg\""));
    assert!((values(&turned, Quantity::Transfer(0), "crank")[0] + 160_f64.to_radians()).abs() < 1e-14);
}

#[test]
fn the_force_at_its_offset_does_what_force_and_moment_do() {
    let positions = analyzed(&text("guide-shaper")).positions;
    let mut compared = 0;
    for (pair, link) in ends(&positions) {
        for row in 0..positions.len() {
            let of = |quantity| positions.get(row, Column::of(quantity, Owner::Pair(pair)));
            // A slide pushes across its guide, so the arm of the force is the offset itself.
            if let (Some(moment), Some(offset)) = (of(Quantity::Moment), of(Quantity::Offset)) {
                let [x, y] = force(&positions, row, pair, link);
                let modulus = x.hypot(y);
                assert!(((offset * modulus).abs() - moment.abs()).abs() < 1e-9 * modulus, "{pair:?}");
                compared += 1;
            }
        }
    }
    assert!(compared > 48);
}

#[test]
fn forces_of_a_pair_sum_to_zero() {
    for scene in ["shaper", "conveyor", "stephenson3"] {
        let positions = analyzed(&text(scene)).positions;
        for joint in ends(&positions).chunk_by(|a, b| a.0 == b.0) {
            for row in 0..positions.len() {
                for axis in 0..2 {
                    let parts = joint.iter().map(|(pair, link)| force(&positions, row, *pair, *link)[axis]);
                    let largest = parts.clone().fold(1.0, |a: f64, b| a.max(b.abs()));
                    assert!(parts.sum::<f64>().abs() < 1e-12 * largest, "{scene}: {joint:?}");
                }
            }
        }
    }
}

#[test]
fn checks_hold_and_belong_to_the_whole() {
    let study_whole = study(&text("shaper")).unwrap();
    let checks = study_whole.checks(Coverage::Sample, &mut unwatched).unwrap().all;
    assert!(checks.len() > 5 && checks.iter().all(|check| check.finding.holds == Some(true)));
    assert!(
        study(&(text("shaper") + "\n[output]\nlinks = [\"rocker\"]\n"))
            .unwrap()
            .checks(Coverage::Sample, &mut unwatched)
            .unwrap()
            .all
            .is_empty()
    );
}

/// The largest residual of every check of forces is that of its position, in a table whose sampled rows alone have any.
#[test]
fn residuals_belong_to_their_positions() {
    for (count, sampled) in [("48", 48), ("5000", 360)] {
        let text = text("shaper").replace("positions = 48", &format!("positions = {count}"));
        let calculation = study(&text).unwrap();
        let mut analysis = calculation.analyze(&mut unwatched).unwrap();
        analysis.add_checks(calculation.checks(Coverage::Sample, &mut unwatched).unwrap());
        let mut all = Table::new(Arc::clone(analysis.positions.schema()));
        let add = |table: Table| {
            all.append(&table, |_| true);
            Ok::<_, ()>(())
        };
        calculation.each_block(&analysis, &mut unwatched, Table::clone, add).unwrap().unwrap();
        for (name, residual, owner) in [
            ("virtual power", Residual::Global, Owner::Input),
            ("Lagrange-d'Alembert", Residual::Dynamics, Owner::Input),
            ("TestPf PF2", Residual::TestPf, Owner::Input),
        ] {
            let column = Column::of(Quantity::Residual(residual), owner);
            let check = analysis.checks.iter().find(|check| check.name.to_string() == name).unwrap();
            let found = all.get(all.row_of(check.at.unwrap()).unwrap(), column).unwrap();
            let same = found.to_bits() == check.finding.error.to_bits();
            assert!(
                same || name.starts_with("TestPf") && found > 0.0,
                "{name}: {found} {}",
                check.finding.error
            );
            let numbers = all.each(all.schema().find(column).unwrap()).flatten();
            assert_eq!(numbers.count(), sampled, "{name}");
        }
        let group = Column::of(Quantity::Residual(Residual::Equilibrium), Owner::Group(1));
        assert_eq!(all.each(all.schema().find(group).unwrap()).flatten().count(), sampled);
    }
}

#[test]
fn an_unknown_analyzer_is_refused() {
    let mechanism = assur_scene::read("test", &text("shaper")).unwrap();
    let options = Options { analyzer: Some("magic".to_owned()), ..Options::default() };
    assert!(matches!(Calculation::of(mechanism, &options, &mut unwatched), Err(AnalysisError::Analyzer(_))));
}

/// A piston alone has mass, so that the machine has no inertia where it turns back.
#[test]
fn a_regime_that_is_not_finite_is_no_motion() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[link.rod]\npoints = { A = 0, B = 0.4 }\n\
        [link.piston]\npoints = { B = 0 }\nmass = 1\n[[slide]]\nlink = \"piston\"\non = \"ground\"\n\
        [input]\nlink = \"crank\"\nfrom = \"START\"\n[motion]\nkind = \"steady\"\nmean_speed = 10\n";
    for start in ["0 deg", "30 deg", "-77 deg"] {
        let found = analyzed(&scene.replace("START", start));
        assert!(found.no_motion.is_some() && found.dynamics.is_none(), "{start}");
        assert_eq!(found.positions.len(), 12, "{start}: what does not depend on the motion is calculated");
    }
}

/// The ground takes the weights, the applied loads and the shaking force.
#[test]
fn loads_and_shaking_force_are_what_the_ground_takes() {
    let found = analyzed(&text("shaper"));
    let table = &found.positions;
    let shaking = Column::vector(Quantity::ShakingForce, Owner::Input);
    let cutting = Column::of(Quantity::Load, Owner::Load(0));
    let weight = 9.81 * (4.0 + 1.5 + 12.0 + 1.2 + 30.0);
    let mut working = 0;
    for row in 0..table.len() {
        let taken = ends(table).into_iter().filter(|(_, link)| *link == 0);
        let sum = taken.map(|(pair, link)| force(table, row, pair, link));
        let sum = sum.fold([0.0; 2], |sum, force| [sum[0] + force[0], sum[1] + force[1]]);
        let [x, y] = shaking.map(|column| table.get(row, column).unwrap());
        let load = table.get(row, cutting).unwrap();
        assert!((sum[0] - x - load).abs() < 1e-9 && (sum[1] - y + weight).abs() < 1e-9, "row {row}");
        assert!(load == 0.0 || (load - 1500.0).abs() < 1e-9);
        working += usize::from(load > 0.0);
    }
    assert!((20..30).contains(&working), "{working} positions under load");
    // The ram translates: its inertia load is the mass times the acceleration of the slide.
    let ram = table.schema().owners(Quantity::InertiaForce).pop().unwrap();
    let forces = table.schema().find(Column::vector(Quantity::InertiaForce, ram)[0]).unwrap();
    let forces: Vec<f64> = table.each(forces).flatten().collect();
    for (force, acceleration) in forces.iter().zip(values(&found, Quantity::Acceleration, "ram/ground")) {
        assert!((force + 30.0 * acceleration).abs() < 1e-9);
    }
}

/// A load that never acts is said, and so is a time that a prescribed motion does not have.
#[test]
fn idle_loads_and_missing_times_are_noted() {
    let scene = |load: &str, motion: &str| {
        let scene = format!(
            "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\n[link.rod]\npoints = {{ A = 0, B = 0.3 }}\n\
             [link.slider]\npoints = {{ B = 0 }}\nmass = 2\n[[slide]]\nlink = 'slider'\non = 'ground'\n\
             [input]\nlink = 'crank'\npositions = 8\n[motion]\n{motion}\n{load}\n[assembly]\nB = [0.4, 0]"
        );
        analyzed(&scene).warnings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    let told = |load: &str| scene(load, "speed = 3");
    assert_eq!(told("[[moment]]\nlink = 'rod'\nvalue = 5"), "");
    let still = "[[force]]\nname = 'drag'\nlink = 'crank'\nat = 'O'\nagainst_motion = true\nvalue = 5";
    assert!(told(still).contains("Load `drag` never acts"), "{}", told(still));
    let zero =
        "[[moment]]\nname = 'idle'\nlink = 'rod'\nvalue = { over = 'angle', table = [[0, 0], [1, 0]] }";
    assert!(told(zero).contains("Load `idle` never acts"));
    let carried = "[[moment]]\nname = 'tilt'\nlink = 'slider'\nvalue = 5";
    assert!(told(carried).contains("Load `tilt` never does work"));
    let timed = "[[moment]]\nlink = 'rod'\nvalue = { over = 'time', table = [[0, -1], [1, -2]] }";
    assert_eq!(scene(timed, "speed = 3\nacceleration = 2"), "");
    // 3 rad/s against 1 rad/s² reach 4.5 rad: positions 0 to 5 of 8.
    assert!(scene(timed, "speed = 3\nacceleration = -1").contains("never reaches 2 positions"));
}

/// A formula that divides by zero: its load is named, and all other positions are calculated.
#[test]
fn a_load_without_a_value_is_named() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\ncenter = 0\ninertia = 0.1\n\
        [link.rod]\npoints = { A = 0, B = 0.3 }\n[link.slider]\npoints = { B = 0 }\nmass = 2\n[[slide]]\nlink = 'slider'\non = 'ground'\n\
        [input]\nlink = 'crank'\npositions = 8\n[[moment]]\nname = 'pull'\nlink = 'crank'\n\
        value = { formula = '10/q', unit = 'N*m' }\n[assembly]\nB = [0.4, 0]\n[motion]\n";
    for motion in ["speed = 10", "kind = 'transient'\nspeed = 10\nuntil = '1 rev'"] {
        let found = analyzed(&format!("{scene}{motion}\n"));
        assert_eq!((found.positions.len(), found.failures.len()), (7, 1), "{motion}");
        let message = &found.failures[0].message;
        assert!(
            message.to_string().contains("position 0: load `pull` has no finite value at coordinate 0"),
            "{message}"
        );
        assert!(
            found.no_motion.is_none_or(|message| message.to_string().contains("load `pull`")),
            "{motion}"
        );
    }
}

#[test]
fn the_first_turn_ends_with_the_speed_after_it() {
    let analysis = analyzed(&text("shaper-drive"));
    let regime = &analysis.dynamics.as_ref().unwrap().regime;
    let first = &regime.found.iterations[0];
    let ends = [regime.course.first(), regime.course.last()].map(|row| row.unwrap().first_turn.unwrap());
    assert!(first.speed_end - first.speed_start > 0.1, "{first:?}");
    assert!((ends[0] - first.speed_start).abs() < 1e-9, "{ends:?} {first:?}");
    assert!((ends[1] - first.speed_end).abs() < 1e-9, "{ends:?} {first:?}");
}

/// A motion that begins at rest where the line of a table bends is judged there; on a jump the load may have any value.
#[test]
fn a_drive_at_rest_is_judged_at_a_bend_but_not_on_a_jump() {
    let left_out = |table: &str| {
        let scene = format!(
            "[ground]\npoints = {{ O = 0 }}\n[link.arm]\npoints = {{ O = 0, A = 0.1 }}\ncenter = 0\ninertia = 0.1\n\
             [input]\nlink = 'arm'\n[[moment]]\nlink = 'arm'\n\
             value = {{ over = 'angle', table = [{table}], repeat = false }}\n\
             [motion]\nkind = 'transient'\nspeed = 0\nuntil = '0.2 s'\n"
        );
        let checks = study(&scene).unwrap().checks(Coverage::Sample, &mut unwatched).unwrap().all;
        let check =
            checks.iter().find(|check| check.name.to_string() == "drive against force analysis").unwrap();
        assert!(check.finding.holds == Some(true), "{check:?}");
        check.left_out
    };
    for bend in ["[-1, 5], [0, 5], [1, 90]", "[-1, 90], [0, 5], [1, 5]"] {
        assert_eq!(left_out(bend), 0, "{bend}");
    }
    assert_eq!(left_out("[-1, 2], [0, 2], [0, 5], [1, 5]"), 1);
}
