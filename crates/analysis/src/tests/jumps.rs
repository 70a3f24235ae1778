//! States on jumps of the loads, at rest and held at a speed: acceleration and loads belong to one side, so that nothing is left
//! to balance where nothing drives.

use super::analyzed;
use crate::results::{Analysis, Column, Owner, Quantity};

/// A disc of 0.5 kg m² with a moment on it.
fn disc(moment: &str, motion: &str) -> Analysis {
    analyzed(&format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.disc]\npoints = {{ O = 0 }}\ninertia = 0.5\nmass = 1\n[input]\nlink = \"disc\"\n\
         {moment}[motion]\nkind = \"transient\"\n{motion}"
    ))
}

fn moment(value: &str) -> String {
    format!("[[moment]]\nlink = \"disc\"\nvalue = {value}\n")
}

/// A sample of a motion.
#[derive(Debug, Clone, Copy)]
struct Sample {
    time: f64,
    coordinate: f64,
    speed: f64,
    acceleration: f64,
    balancing: Option<f64>,
    /// Moment and bound.
    holding: Option<[f64; 2]>,
}

fn samples(found: &Analysis) -> Vec<Sample> {
    let table = &found.trajectory;
    let of = |row: usize, quantity| table.get(row, Column::of(quantity, Owner::Input));
    let sample = |row: usize| Sample {
        time: of(row, Quantity::Time).unwrap(),
        coordinate: of(row, Quantity::Transfer(0)).unwrap(),
        speed: of(row, Quantity::Velocity).unwrap(),
        acceleration: of(row, Quantity::Acceleration).unwrap(),
        balancing: of(row, Quantity::Balancing),
        holding: of(row, Quantity::Holding).map(|moment| [moment, of(row, Quantity::HoldingBound).unwrap()]),
    };
    (0..table.len()).map(sample).collect()
}

fn assert_balanced(found: &Analysis, scale: f64) {
    assert!(!found.trajectory.is_empty(), "{:?}", found.no_motion);
    for sample in samples(found) {
        let (time, balancing) = (sample.time, sample.balancing.unwrap_or(f64::NAN));
        assert!(balancing.abs() <= 1e-11 * scale, "{time} s: {balancing}");
    }
}

#[test]
fn a_sample_on_a_jump_is_of_the_side_after_it() {
    let table = "{ over = \"time\", table = [[0, 5], [0.5, 5], [0.5, -3], [1, -3]] }";
    let found = disc(&moment(table), "speed = 0\nuntil = \"1 s\"\nsamples = 10\n");
    assert_balanced(&found, 5.0);
    let accelerations: Vec<f64> = samples(&found).iter().map(|sample| sample.acceleration).collect();
    // M/J before 0.5 s and from there on.
    assert_eq!(accelerations, [vec![10.0; 5], vec![-6.0; 6]].concat());
}

#[test]
fn the_last_sample_is_of_the_side_before_a_jump() {
    let table = "{ over = \"angle\", table = [[0, 1], [\"180 deg\", 1], [\"360 deg\", 4]] }";
    for (speed, last) in [(2.0, 4.0), (-8.0, 1.0)] {
        let found = disc(&moment(table), &format!("speed = {speed}\nuntil = \"1 rev\"\nsamples = 7\n"));
        assert_balanced(&found, 4.0);
        let end = *samples(&found).last().unwrap();
        assert!((end.acceleration - 2.0 * last).abs() < 1e-6, "{}", end.acceleration);
    }
}

#[test]
fn a_brake_holds_with_what_is_needed() {
    // The brake gives 2 N m either way; 1.2 N m drive the disc forward, which is stopped from 1.5 rad/s backward.
    let brake = moment("{ over = \"speed\", table = [[-10, 2], [0, 2], [0, -2], [10, -2]] }");
    let found = disc(&(brake + &moment("1.2")), "speed = -1.5\nuntil = \"1 s\"\nsamples = 10\n");
    assert_balanced(&found, 2.0);
    for sample in samples(&found) {
        // 3.2 N m on 0.5 kg m² stop it after 0.234 s.
        assert_eq!(sample.holding.is_some(), sample.time > 0.234_375, "{}", sample.time);
        if let Some([moment, bound]) = sample.holding {
            assert_eq!((sample.speed, sample.acceleration), (0.0, 0.0));
            assert!((moment + 1.2).abs() < 1e-12 && (bound - 2.0).abs() < 1e-12);
        }
    }
}

#[test]
fn a_speed_is_held_by_a_jump_of_a_table() {
    let governor = moment("{ over = \"speed\", table = [[-10, 5], [3, 5], [3, -5], [10, -5]] }");
    let found = disc(&(governor + &moment("-2")), "speed = 0\nuntil = \"1 s\"\nsamples = 8\n");
    assert_balanced(&found, 5.0);
    // 3 N m on 0.5 kg m² bring it to 3 rad/s in 0.5 s.
    for sample in samples(&found) {
        assert_eq!(sample.holding.is_some(), sample.time >= 0.5);
        if let Some([moment, bound]) = sample.holding {
            assert!((sample.speed - 3.0).abs() < 1e-12 && sample.acceleration == 0.0);
            assert!((moment - 2.0).abs() < 1e-12 && (bound - 5.0).abs() < 1e-12);
        }
    }
}

/// A pendulum of 1 kg on 1 m that swings against dry friction of 0.7 N m from 60 degrees below the horizontal.
fn pendulum(until: &str) -> Analysis {
    let friction = "{ over = \"speed\", table = [[-10, 0.7], [0, 0.7], [0, -0.7], [10, -0.7]] }";
    analyzed(&format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = 0 }}\n[link.bob]\npoints = {{ O = 0, A = 1 }}\nmass = 1\ncenter = \"A\"\n\
         [input]\nlink = \"bob\"\nfrom = \"-60 deg\"\n[[moment]]\nlink = \"bob\"\nvalue = {friction}\n\
         [motion]\nkind = \"transient\"\nuntil = \"{until}\"\nsamples = 20\n"
    ))
}

#[test]
fn a_turn_is_the_first_reversal_and_rest_is_for_good() {
    let turn = pendulum("turn");
    assert_balanced(&turn, 10.0);
    let samples_of_turn = samples(&turn);
    let (start, end) = (samples_of_turn.first().unwrap(), samples_of_turn.last().unwrap());
    // From rest to rest the weight does the work that friction takes.
    let fall = 9.81 * (start.coordinate.sin() - end.coordinate.sin());
    assert!((fall - 0.7 * (start.coordinate - end.coordinate)).abs() < 1e-7);
    // It still comes from the side that it moved on: friction and weight push it back together.
    assert!((end.acceleration - (0.7 - 9.81 * end.coordinate.cos())).abs() < 1e-6);
    assert_eq!((end.speed, end.holding), (0.0, None));
    let rest = pendulum("rest");
    assert_balanced(&rest, 10.0);
    let turned = end.time;
    let end = *samples(&rest).last().unwrap();
    let [moment, _] = end.holding.unwrap();
    assert!(end.time > 2.0 * turned && end.acceleration == 0.0);
    assert!((moment - 9.81 * end.coordinate.cos()).abs() < 1e-9 && moment.abs() < 0.7);
}

/// A slider-crank with a load.
fn slider_crank(direction: &str, load: &str, motion: &str) -> String {
    format!(
        "gravity = [0.7, -9.6]\n[ground]\npoints = {{ O = [0, 0], W = [0.7, 0.3] }}\n\
         [link.crank]\npoints = {{ O = 0, A = 0.1 }}\nmass = 2\ncenter = [0.04, 0.01]\ninertia = 0.01\n\
         [link.rod]\npoints = {{ A = 0, B = 0.35, D = [0.1, 0.02] }}\nmass = 1.2\ncenter = [0.12, 0.01]\ninertia = 0.015\n\
         [link.slider]\npoints = {{ B = 0 }}\nmass = 1.5\n[[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = [0, 0.02]\n\
         [assembly]\nB = [0.4, 0.02]\n[input]\nlink = \"crank\"\npositions = 24\ndirection = \"{direction}\"\n{load}[motion]\n{motion}"
    )
}

#[test]
fn a_resistance_holds_a_linkage_at_rest() {
    let load = "[[force]]\nlink = \"slider\"\nat = \"B\"\nagainst_motion = true\nvalue = 12\n\
        [[spring]]\nbetween = [\"D\", \"W\"]\nstiffness = 80\nlength = 0.3\ndamping = 6\n";
    let motion = "kind = \"transient\"\nspeed = 11\nuntil = \"2 s\"\nsamples = 40\ntolerance = 1e-10\n";
    let found = analyzed(&slider_crank("ccw", load, motion));
    assert_balanced(&found, 100.0);
    // By an independent computation of 40 digits the motion sticks from 0.86893598 s on at this coordinate.
    for sample in samples(&found).into_iter().filter(|sample| sample.time > 0.868_936) {
        assert!((sample.coordinate + 0.482_164_1).abs() < 1e-7, "{}", sample.coordinate);
        let [moment, bound] = sample.holding.unwrap();
        assert!(moment.abs() < bound);
    }
}

#[test]
fn nothing_is_left_to_balance_under_any_load_in_either_direction() {
    let loads = [
        "[[moment]]\nlink = \"crank\"\nvalue = { over = \"angle\", shape = \"step\", table = [[0, 9], [\"90 deg\", -7], [\"180 deg\", 3], [\"360 deg\", 0]] }\n",
        "[[moment]]\nlink = \"crank\"\nvalue = { over = \"speed\", table = [[-20, 3], [-20, 2], [0, 2], [0, -2], [20, -2], [20, -3]] }\n",
        "[[moment]]\nlink = \"rod\"\nvalue = { over = \"time\", shape = \"step\", table = [[0, 4], [0.1, -4], [0.2, 4], [0.3, 0]] }\n",
        "[[force]]\nlink = \"slider\"\nat = \"B\"\nangle = 0\nvalue = { over = \"stroke\", axis = 0, forward = [[0.3, 0], [0.3, -60], [0.9, -60], [0.9, 0]], back = 5 }\n",
        "[[force]]\nlink = \"slider\"\nat = \"B\"\nagainst_motion = true\nvalue = 12\n",
        "[[contact]]\nlink = \"rod\"\ncenter = \"D\"\nradius = 0.1\nangle = 0.1\nforce = 30\nduring = [\"-30 deg\", \"60 deg\"]\n",
        "[[spring]]\nbetween = [\"D\", \"W\"]\nstiffness = 80\nlength = 0.3\ndamping = 6\n",
    ];
    for load in loads {
        for (direction, speed) in [("ccw", 25.0), ("cw", -25.0)] {
            for until in ["\"0.4 s\"", "\"0.25 rev\""] {
                let motion = format!(
                    "kind = \"transient\"\nspeed = {speed}\nuntil = {until}\nsamples = 40\ntolerance = 1e-10\n"
                );
                assert_balanced(&analyzed(&slider_crank(direction, load, &motion)), 100.0);
            }
        }
    }
}

#[test]
fn a_steady_regime_is_of_the_side_after_a_jump_in_the_direction_of_motion() {
    let load = "[[force]]\nlink = \"slider\"\nat = \"B\"\nangle = \"180 deg\"\n\
        value = { over = \"angle\", shape = \"step\", table = [[0, 900], [\"180 deg\", 0], [\"360 deg\", 0]] }\n";
    let drive = "kind = \"steady\"\nmean_speed = \"120 rpm\"\nunevenness = 0.02\n[drive]\n\
        motor = { power = \"1.1 kW\", synchronous_speed = \"1500 rpm\", rated_speed = \"1410 rpm\", max_torque_ratio = 2.2, \
        inertia = \"0.0045 kg*m^2\" }\ncharacteristic = \"linear\"\nratio = \"solve\"\nefficiency = 0.9\nflywheel = \"solve\"\n";
    let found = analyzed(&slider_crank("cw", load, drive));
    // By an independent computation: at 180 degrees the force of 900 N begins.
    let row = found.positions.row_of(12).unwrap();
    let balancing = found.positions.get(row, Column::BALANCING).unwrap();
    assert!((balancing + 6.857).abs() < 1e-3, "{balancing}");
}
