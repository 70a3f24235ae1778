//! Numbers of small machines that are known by hand.

use assur_force::Side;
use assur_integrator::Sample;

use super::{compiled, read};
use crate::{CycleRequest, Machine, Method, RegimeSolver, equation, section_margin, steady, transient};

/// A disc on which nothing acts.
#[test]
fn what_nothing_acts_on_rests_without_being_held() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.disc]\npoints = { O = 0 }\ninertia = 0.5\n\
        [input]\nlink = \"disc\"\n[motion]\nkind = \"transient\"\nspeed = 0\nuntil = \"1 s\"\n";
    let (linkage, loads) = compiled(scene);
    let mut motion = equation(&linkage, &loads).unwrap();
    let instant =
        motion.instant(&Sample { time: 0.0, coordinate: 0.3, speed: 0.0, acceleration: 0.0 }, false).unwrap();
    // Nothing jumps there: the formulas above and below the speed count alike.
    assert_eq!((instant.state.side, instant.holding), (Side::Held { upper: 0.5 }, None));
}

/// 2 kg at 3 m on a crank that lies level, in a gravity of 10 m/s².
#[test]
fn the_rounding_of_the_potential_energy_is_that_of_its_terms() {
    let scene = "gravity = 10\n[ground]\npoints = { O = 0 }\n[link.arm]\npoints = { O = 0 }\nmass = 2\ncenter = 3\n\
        [input]\nlink = \"arm\"\nfrom = 0\n[motion]\nkind = \"transient\"\nspeed = 1\nuntil = \"0.05 s\"\nsamples = 4\n";
    let (linkage, loads) = compiled(scene);
    let energy = transient(&linkage, &loads, &Method::default(), None).unwrap().energy;
    // Eight rounding units of a weight of 20 N at 3 m, and that of the coordinate, at most 0.05 rad, by 60 N m.
    let greatest = energy.kinetic.iter().copied().fold(0.0, f64::max);
    let units = energy.rounding * greatest / f64::EPSILON;
    assert!((480.0..=483.0).contains(&units), "{units}");
    // T = 18/2 at 1 rad/s at the start, which is the greatest.
    assert!((greatest - 9.0).abs() < 1e-12, "{greatest}");
}

#[test]
fn the_excess_work_of_example_2_needs_the_flywheel_of_the_textbook() {
    let (linkage, loads) = compiled(assur_fixtures::scene("flywheel"));
    let regime = steady(&linkage, &loads, None).unwrap().regime;
    let by = &regime.flywheel_by_method;
    let [first, exact] = [by.first().unwrap(), by.last().unwrap()];
    assert_eq!((first.method, exact.method, by.len()), ("excess-work", "exact", 5));
    // E example 2: A/(w² δ) with A = 10 pi J, 100 rad/s and 0.02; the triangle is symmetric, so that it is exact.
    let wanted = std::f64::consts::PI / 20.0;
    assert!((first.flywheel / wanted - 1.0).abs() < 1e-9, "{}", first.flywheel);
}

/// The methods of the textbooks neglect something; by how much they miss is given in parts of the exact flywheel.
#[test]
fn methods_for_a_flywheel_tell_their_distance_from_the_exact_one() {
    let (linkage, loads) = compiled(assur_fixtures::scene("shaper-drive"));
    let by = steady(&linkage, &loads, None).unwrap().regime.flywheel_by_method;
    let exact = by.last().unwrap().flywheel;
    let mut apart = 0;
    for row in &by {
        let difference = row.flywheel / exact - 1.0;
        assert!((row.difference.unwrap() - difference).abs() < 1e-12, "{row:?}");
        apart += usize::from(difference.abs() > 1e-3);
    }
    assert!(apart > 1, "{by:?}");
}

#[test]
fn loads_are_reduced_to_the_farthest_point_of_the_crank() {
    let scene = |points: &str| {
        read(&format!(
            "[ground]\npoints = {{ O = 0 }}\n[link.arm]\npoints = {{ {points} }}\n[input]\nlink = \"arm\"\n"
        ))
    };
    let mechanism = scene("O = 0, A = 0.2, B = [0.3, -0.4], C = 0.3");
    let found = assur_mechanism::ReductionPoint::farthest(&mechanism).unwrap();
    assert_eq!(found.point.name, "B");
    assert!((found.radius - 0.5).abs() < 1e-15, "{found:?}");
    // Of equal ones the first.
    let mechanism = scene("O = 0, A = 0.2, B = [0, 0.2]");
    assert_eq!(assur_mechanism::ReductionPoint::farthest(&mechanism).unwrap().point.name, "A");
    assert_eq!(assur_mechanism::ReductionPoint::farthest(&scene("O = 0")), None);
}

#[test]
fn the_margin_of_a_section_is_a_part_of_the_section() {
    let (linkage, loads) = compiled(assur_fixtures::scene("shaper-drive"));
    let found = steady(&linkage, &loads, None).unwrap();
    let (figures, motor) = (&found.regime.figures, found.motor.unwrap().work.characteristic);
    let [low, high] = motor.stable_section();
    // Where the least and the greatest speed of the motor lie on the section, from 0 to 1.
    let part = |speed: f64| (figures.ratio.unwrap() * speed.abs() - low) / (high - low);
    let wanted = part(figures.speed_min).min(1.0 - part(figures.speed_max));
    let margin = section_margin(&found.regime, &motor);
    assert!((margin - wanted).abs() < 1e-12 && margin < 0.5, "{margin} instead of {wanted}");
}

#[test]
fn times_and_ways_of_a_cycle_add_up() {
    let (linkage, loads) = compiled(assur_fixtures::scene("shaper-drive"));
    let regime = steady(&linkage, &loads, None).unwrap().regime;
    let shares = regime.solution.weighted_speeds();
    let time: f64 = shares.iter().map(|(_, time)| time).sum();
    let way: f64 = shares.iter().map(|(speed, time)| speed * time).sum();
    assert!((time / regime.cycle_time - 1.0).abs() < 1e-9, "{time} of {}", regime.cycle_time);
    assert!((way / std::f64::consts::TAU - 1.0).abs() < 1e-12, "{way}");
    // The first cycle begins at the mean speed, and the regime has one speed at one place.
    let from = linkage.mechanism.input.from;
    let first = regime.first_cycle_speed(from).unwrap();
    assert!((first / regime.figures.mean_speed - 1.0).abs() < 1e-12, "{first}");
    for x in [0.0, 1.0, 4.5] {
        let [speed, wanted] = [regime.solution.speed_at(x), regime.state(from + x).speed];
        assert!((speed - wanted).abs() < 1e-12 * wanted, "{x}: {speed} {wanted}");
    }
}

#[test]
fn a_flywheel_on_the_motor_counts_with_the_square_of_the_ratio() {
    let text = assur_fixtures::scene("shaper-drive");
    let methods = |place: &str| {
        let mut mechanism = read(text);
        mechanism.drive.as_mut().unwrap().flywheel_on = if place == "motor" {
            assur_mechanism::FlywheelPlace::Motor
        } else {
            assur_mechanism::FlywheelPlace::Crank
        };
        let linkage = assur_kinematics::Linkage::compile(mechanism).unwrap();
        let loads = assur_force::Loads::compile(&linkage).unwrap();
        let regime = steady(&linkage, &loads, None).unwrap().regime;
        (regime.figures.ratio.unwrap(), regime.flywheel_by_method)
    };
    let ((ratio, on_crank), (same, on_motor)) = (methods("crank"), methods("motor"));
    assert!((ratio / same - 1.0).abs() < 1e-8, "{ratio} {same}");
    for (crank, motor) in on_crank.iter().zip(&on_motor) {
        let apart = (motor.flywheel * ratio * ratio / crank.flywheel - 1.0).abs();
        assert!(apart < 1e-7, "{}: {apart:e}", crank.method);
    }
}

#[test]
fn the_greatest_resistance_is_that_of_the_loads() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.disc]\npoints = { O = 0 }\ninertia = 0.5\n[input]\nlink = \"disc\"\n\
        [[moment]]\nlink = \"disc\"\nvalue = { over = \"angle\", table = [[0, -5], [3, -15], [\"360 deg\", -5]] }\n";
    let (linkage, loads) = compiled(scene);
    let mut machine = Machine::new(&linkage, &loads);
    let request =
        CycleRequest { start: 0.0, length: std::f64::consts::TAU, mean_speed: 10.0, constant_inertia: 0.5 };
    let solver = RegimeSolver::new(&mut machine, request).unwrap();
    assert!((solver.greatest_resistance() - 15.0).abs() < 1e-12, "{}", solver.greatest_resistance());
    // 10 N m on average, at 10 rad/s.
    assert!(
        (solver.mean_resistance() - 10.0).abs() < 1e-12 && (solver.required_power(0.8) - 125.0).abs() < 1e-9
    );
}
