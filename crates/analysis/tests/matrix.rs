//! Every shipped scene under every kind of motion, with every kind of load, in both directions: the checks hold, and a load of
//! the wrong sign is caught. A spread of all combinations runs with the other tests; all of them with
//! `cargo test --release -p assur-analysis --test matrix -- --ignored`.

use assur_all as _;
use assur_analysis::{Calculation, Coverage, Options, unwatched};
use assur_force::Loads;
use assur_formula::Formula;
use assur_kinematics::Linkage;
use assur_mechanism::{
    Brake, Contact, Direction, Drive, FlywheelPlace, Force, GROUND, LawTable, Load, LoadKind, Mechanism,
    Moment, Motion, Over, Place, Sense, Shape, Solve, Spring, Torque, Until, Value,
};

/// Every so many combinations one runs.
const SPREAD: usize = 24;

/// Positions and samples of each; of mechanisms with many links fewer.
const POSITIONS: usize = 4;
const SAMPLES: usize = 12;
const MANY_LINKS: usize = 20;

const MOTIONS: [&str; 4] = ["none", "prescribed", "transient", "steady"];

const LOADS: [&str; 11] = [
    "weights",
    "constant force",
    "force over the coordinate",
    "force against the motion",
    "force over a stroke",
    "moment over the speed",
    "moment over time",
    "spring with a damper",
    "contact",
    "brake",
    "force by a formula",
];

fn table(rows: &[[f64; 2]]) -> LawTable {
    LawTable { rows: rows.to_vec(), shape: Shape::Linear }
}

fn over(over: Over, rows: &[[f64; 2]]) -> Value {
    Value::Table { over, table: table(rows), repeat: over == Over::Coordinate }
}

/// The mechanism of a scene, with masses, in a few positions, and with nothing that acts.
fn bare(text: &str) -> Mechanism {
    let mut mechanism = assur_scene::read("scene.toml", text).expect("a shipped scene");
    mechanism.input.positions = fewer(&mechanism, POSITIONS);
    for link in mechanism.links.iter_mut().skip(1) {
        (link.mass, link.inertia) = (1.0 + link.mass, (0.01 + link.inertia.constant()).into());
    }
    (mechanism.gravity, mechanism.output, mechanism.drive, mechanism.balance) = (None, None, None, None);
    mechanism.loads.clear();
    mechanism
}

/// A number of positions or samples, fewer where there are many links.
fn fewer(mechanism: &Mechanism, count: usize) -> usize {
    if mechanism.links.len() > MANY_LINKS { count / 4 } else { count }
}

fn set_motion(mechanism: &mut Mechanism, kind: &str) {
    let speed = 2.0 * mechanism.input.sign();
    mechanism.motion = match kind {
        "prescribed" => Some(Motion::Prescribed { speed, acceleration: 0.5 * speed }),
        "transient" => {
            let integrator = "auto".to_owned();
            Some(Motion::Transient {
                speed,
                until: Until::Time(0.1),
                samples: fewer(mechanism, SAMPLES),
                integrator,
                tolerance: 1e-9,
                step: None,
                max_steps: None,
            })
        }
        "steady" => {
            let (ratio, flywheel) = (Solve::Given(1.0), Some(Solve::Given(50.0)));
            let flywheel_on = FlywheelPlace::Crank;
            mechanism.drive =
                Some(Drive { torque: Torque::Balance, ratio, efficiency: 1.0, flywheel, flywheel_on });
            Some(Motion::Steady { mean_speed: 10.0 * speed, unevenness: None })
        }
        _ => None,
    };
}

/// A place of the link that is placed last.
fn last_place(mechanism: &Mechanism) -> Place {
    let moving = mechanism.points.iter().flat_map(|point| &point.places).filter(|place| place.link != GROUND);
    *moving.max_by_key(|place| place.link).expect("a moving point")
}

fn add_load(mechanism: &mut Mechanism, kind: &str) {
    let at = last_place(mechanism);
    let force = |direction, value| LoadKind::from(Force { at, direction, value });
    let moment = |value| LoadKind::from(Moment { link: at.link, value, against_motion: false });
    let load = match kind {
        "weights" => return mechanism.gravity = Some([1.0, -9.81]),
        "constant force" => force(Direction::Link(0.4), Value::Constant(80.0)),
        "force over the coordinate" => {
            let value = over(Over::Coordinate, &[[0.0, 50.0], [1.5, 120.0], [1.5, 80.0], [4.0, 60.0]]);
            force(Direction::Ground(0.7), value)
        }
        "force against the motion" => force(Direction::AgainstMotion, Value::Constant(30.0)),
        "force over a stroke" => {
            let forward = table(&[[0.0, 100.0], [0.5, 100.0], [0.5, 200.0], [1.0, 150.0]]);
            let value = Value::Stroke { axis: 0.3, forward, back: LawTable::constant(50.0) };
            force(Direction::Ground(3.0), value)
        }
        "moment over the speed" => moment(over(Over::Speed, &[[-10.0, 9.0], [0.0, 6.0], [30.0, 4.0]])),
        "moment over time" => {
            let rows = [[0.0, 3.0], [0.03, 6.0], [0.03, 5.0], [1.0, 8.0]];
            moment(over(Over::Time, &rows))
        }
        "contact" => {
            let force = over(Over::Coordinate, &[[0.0, 40.0], [2.0, 90.0]]);
            let (center, radius, friction, against_sliding, during) =
                (at, 0.02, 0.15, true, Some([-2.0, 4.0]));
            let angle = Value::Constant(0.6);
            Contact { center, radius, angle, force, friction, against_sliding, during }.into()
        }
        "brake" => {
            // The link that is placed last may slide and never turn.
            let link = mechanism.input.first().link;
            Brake { link, force: Value::Constant(60.0), radius: 0.05, friction: 0.3, lever: 1.0 }.into()
        }
        "force by a formula" => {
            let formula = Formula::read("70 + 20*sin(3*q) + 15*step(q - 1) - 4*w").expect("a formula");
            let value = Value::Formula { formula, factor: 1.0, axis: None };
            force(Direction::Ground(1.9), value)
        }
        _ => {
            let ends = [Place { link: GROUND, at: [-1.3, 2.1] }, at];
            Spring { ends, stiffness: 100.0, length: 0.1, damping: 5.0 }.into()
        }
    };
    mechanism.loads.push(Load { name: "load".into(), kind: load });
}

/// Turns the load round, which is the mistake that is planted.
fn turn(mechanism: &mut Mechanism) {
    let negate = |table: &mut LawTable| table.rows.iter_mut().for_each(|row| row[1] *= -1.0);
    for value in mechanism.loads.iter_mut().filter_map(|load| load.kind.law_mut()) {
        match value {
            Value::Constant(value) => *value *= -1.0,
            Value::Table { table, .. } => negate(table),
            Value::Stroke { forward, back, .. } => [forward, back].into_iter().for_each(negate),
            Value::Formula { factor, .. } => *factor *= -1.0,
        }
    }
    mechanism.gravity = mechanism.gravity.map(|g| g.map(|g| -g));
    for spring in mechanism.loads.iter_mut().filter_map(|load| load.kind.spring_mut()) {
        (spring.stiffness, spring.damping) = (-spring.stiffness, -spring.damping);
    }
}

/// The checks that fail.
fn failing(calculation: &Calculation) -> Vec<String> {
    let checks = calculation.checks(Coverage::Sample, &mut unwatched).expect("nobody stops them").all;
    assert!(checks.len() > 8, "only {} checks", checks.len());
    let failed = checks.iter().filter(|check| check.finding.failed());
    let words = failed.map(|check| {
        let (name, residual, limit) = (&check.name, check.finding.error, check.finding.bound);
        format!("{name} {residual:.1e}/{limit:.1e} {:?} {}", check.at, check.finding.place)
    });
    words.collect()
}

/// The checks that fail for a mechanism, and those that fail with its load turned round; `None` where it has no such motion
/// or load.
fn sound_and_planted(mechanism: Mechanism) -> Option<[Vec<String>; 2]> {
    let mut changed = mechanism.clone();
    turn(&mut changed);
    let mut calculation = Calculation::of(mechanism, &Options::default(), &mut unwatched).ok()?;
    if calculation.no_motion.is_some() {
        return None;
    }
    let sound = failing(&calculation);
    calculation.loads = Some(Loads::compile(&Linkage::compile(changed).ok()?).ok()?);
    Some([sound, failing(&calculation)])
}

/// Every `spread`-th combination: how many of them have such a motion, and what is wrong.
fn combinations(spread: usize) -> (usize, Vec<String>) {
    let (mut count, mut wrong) = (0, Vec::new());
    for (number, (name, text)) in assur_fixtures::SCENES.iter().enumerate() {
        for (m, motion) in MOTIONS.iter().enumerate() {
            for (l, load) in LOADS.iter().enumerate() {
                for (d, direction) in [Sense::Ccw, Sense::Cw].into_iter().enumerate() {
                    if !(3 * m + 5 * l + 7 * d + number).is_multiple_of(spread) {
                        continue;
                    }
                    let mut mechanism = bare(text);
                    mechanism.input.direction = direction;
                    set_motion(&mut mechanism, motion);
                    add_load(&mut mechanism, load);
                    let what = format!("{name}, motion {motion}, {load}, {direction:?}");
                    let Some([sound, planted]) = sound_and_planted(mechanism) else { continue };
                    if !sound.is_empty() {
                        wrong.push(format!("{what}: {sound:?}"));
                    }
                    if !planted.iter().any(|name| name.starts_with("loads ")) {
                        wrong.push(format!("{what}: the planted mistake is not caught"));
                    }
                    count += 1;
                }
            }
        }
    }
    (count, wrong)
}

#[test]
fn checks_hold_and_a_load_of_the_wrong_sign_is_caught() {
    let (count, wrong) = combinations(SPREAD);
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(count > 40, "only {count} combinations have a motion");
}

#[test]
#[ignore = "takes minutes"]
fn checks_hold_in_every_combination() {
    let (count, wrong) = combinations(1);
    println!("{count} combinations");
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
}
