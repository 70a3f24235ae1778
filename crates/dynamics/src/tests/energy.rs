//! Energy of random mechanisms, stiff motors, and what else is reported of a scene.

use approx::assert_relative_eq;
use assur_group::Order;
use assur_mechanism::{Place, ReductionPoint};
use proptest::prelude::*;

use assur_fixtures::scene;

use super::{compiled, read};
use crate::{CycleRequest, DriveRequest, Machine, Method, RegimeSolver, TorqueRequest, steady, transient};

/// A crank and rocker with weights, a spring and a constant force on the coupler.
fn four_bar(lengths: [f64; 3], masses: [f64; 3], stiffness: f64, force: [f64; 2], speed: f64) -> String {
    let [coupler, rocker, ground] = lengths;
    let [m1, m2, m3] = masses;
    let (half, third) = (0.5 * coupler, 0.3 * rocker);
    let [size, angle] = force;
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0], C = [{ground}, 0], P = [0.2, 1.5] }}\n\
         [link.crank]\npoints = {{ O = 0, A = 0.3 }}\nmass = {m1}\ncenter = 0.1\ninertia = 0.02\n\
         [link.coupler]\npoints = {{ A = 0, B = {coupler}, K = [{half}, 0.2] }}\nmass = {m2}\ncenter = [{half}, 0.05]\ninertia = 0.1\n\
         [link.rocker]\npoints = {{ C = 0, B = {rocker}, E = {third} }}\nmass = {m3}\ncenter = \"E\"\ninertia = 0.05\n\
         [[spring]]\nbetween = [\"P\", \"E\"]\nstiffness = {stiffness}\nlength = 0.5\n\
         [[force]]\nlink = \"coupler\"\nat = \"K\"\nangle = {angle}\nvalue = {size}\n\
         [input]\nlink = \"crank\"\nfrom = 1\n[assembly]\nB = [1, 1]\n\
         [motion]\nkind = \"transient\"\nspeed = {speed}\nuntil = \"1.5 s\"\nsamples = 40\nintegrator = \"dop853\"\ntolerance = 1e-10\n"
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Kinetic and potential energy less the work of the force stay what they were.
    #[test]
    fn energy_is_kept(
        lengths in [0.9..1.2_f64, 0.8..1.0, 0.9..1.1],
        masses in [0.5..5.0_f64, 0.5..5.0, 0.5..5.0],
        stiffness in 0.0..300.0_f64,
        force in [-40.0..40.0_f64, 0.0..6.0],
        speed in -12.0..12.0_f64,
    ) {
        let (linkage, loads) = compiled(&four_bar(lengths, masses, stiffness, force, speed));
        let found = transient(&linkage, &loads, &Method::default(), None).unwrap();
        let mechanism = &linkage.mechanism;
        let point = mechanism.point("K").unwrap();
        let place: Place = mechanism.points[point].places[0];
        let mut position = linkage.position();
        let mut along = |coordinate: f64| {
            linkage.solve(coordinate, Order::First, &mut position).unwrap();
            let [x, y] = linkage.place_motion(place, &position).pf0;
            force[0] * (x * force[1].cos() + y * force[1].sin())
        };
        let sums: Vec<f64> = found.trajectory.samples.iter().enumerate()
            .map(|(i, s)| found.energy.kinetic[i] + found.energy.potential[i] - along(s.coordinate))
            .collect();
        let scale = found.energy.kinetic.iter().copied().fold(1.0, f64::max);
        for sum in &sums {
            prop_assert!((sum - sums[0]).abs() < 1e-7 * scale, "{} of {scale}", sum - sums[0]);
        }
    }
}

/// A crank with a motor whose torque falls by 1e6 N m for each rad/s, on 0.06 kg m².
fn stiff() -> String {
    let text =
        scene("flywheel").replace("[motion]\nkind = \"steady\"\nmean_speed = 100\nunevenness = 0.02\n", "");
    let (machine, _) = text.split_once("[drive]").unwrap();
    format!(
        "{machine}\n[motion]\nkind = \"transient\"\nspeed = 9.9\nuntil = \"1 rev\"\ntolerance = 1e-6\n[drive]\n\
         motor = {{ power = 1000, synchronous_speed = 10, rated_speed = 9.9999 }}\ncharacteristic = \"linear\"\nflywheel = 0.06\n"
    )
}

#[test]
fn a_stiff_motor_needs_the_implicit_method() {
    let (linkage, loads) = compiled(&stiff());
    let found =
        transient(&linkage, &loads, &Method { integrator: Some("radau5"), tolerance: None }, None).unwrap();
    assert!(found.trajectory.statistics.evaluations < 500, "{:?}", found.trajectory.statistics);
    // The slope is 1e6 N m s: the speed is synchronous to 40 N m / 1e6.
    assert!((found.trajectory.end.speed - 10.0).abs() < 1e-4);
    let error = transient(&linkage, &loads, &Method { integrator: Some("dop853"), tolerance: None }, None)
        .unwrap_err();
    assert!(error.to_string().contains("radau5"), "{error}");
}

#[test]
fn settling_leads_to_the_same_regime() {
    let (linkage, loads) = compiled(scene("shaper-drive"));
    let found = steady(&linkage, &loads, None).unwrap();
    let mut machine = Machine::new(&linkage, &loads);
    let request = CycleRequest {
        start: 0.0,
        length: std::f64::consts::TAU,
        mean_speed: found.regime.figures.mean_speed,
        constant_inertia: 0.04,
    };
    let mut survey = RegimeSolver::new(&mut machine, request).unwrap();
    let motor = found.motor.as_ref().unwrap();
    let drive = DriveRequest {
        torque: TorqueRequest::Motor {
            characteristic: motor.work.characteristic,
            rotor: 0.0045,
            ratio: found.regime.figures.ratio,
            efficiency: 0.95,
        },
        flywheel: Some(found.regime.flywheel),
        flywheel_on_motor: false,
        unevenness: None,
    };
    let regime = survey.solve(&drive).unwrap();
    assert_relative_eq!(regime.figures.unevenness, 0.05, max_relative = 1e-10);
    let turns = survey.settle(&regime, 1e-12, 200).unwrap();
    let (first, last) = (turns[0], turns[turns.len() - 1]);
    assert_relative_eq!(first.speed_start, regime.figures.mean_speed, max_relative = 1e-12);
    assert_relative_eq!(last.speed_end, regime.state(0.0).speed, max_relative = 1e-10);
    assert!(turns.len() > regime.iterations.len());
}

#[test]
fn the_state_of_the_regime_obeys_the_equation() {
    let (linkage, loads) =
        compiled(&scene("shaper-drive").replace("positions = 48", "positions = 48\ndirection = \"cw\""));
    let regime = steady(&linkage, &loads, None).unwrap().regime;
    for index in 0..48 {
        let state = regime.state(linkage.mechanism.input.coordinate(index) - 1e-3);
        let inertia = state.inertia + regime.drive_inertia;
        let sum = state.load + state.drive
            - inertia * state.acceleration
            - 0.5 * state.inertia_derivative * state.speed * state.speed;
        assert!(sum.abs() < 1e-7, "{index}: {sum}");
    }
    assert_relative_eq!(regime.state(0.0).time, 0.0);
    assert!((regime.cycle_time - 1.0).abs() < 0.02);
}

#[test]
fn motor_and_places_of_the_flywheel() {
    let (linkage, loads) = compiled(&scene("shaper-drive").replace(
        "motor = { power = \"1.1 kW\", synchronous_speed = \"1500 rpm\", rated_speed = \"1410 rpm\", max_torque_ratio = 2.2, inertia = \"0.0045 kg*m^2\" }",
        "motor = \"auto\"\ncatalogue = \"4A\"\nmax_motor_speed = \"1500 rpm\"",
    ));
    let found = steady(&linkage, &loads, None).unwrap();
    let motor = found.motor.unwrap();
    let (row, motor) = (motor.motor, motor.work);
    assert!(row.rated_power >= found.regime.figures.required_power && row.synchronous_speed < 157.1);
    assert!(
        motor.speed[0] < motor.speed[1]
            && motor.torque[0] < motor.rms_torque
            && motor.rms_torque < motor.torque[1]
    );
    let ratio = found.regime.figures.ratio.unwrap();
    // The mean power of the motor is the required one but for the difference of the mean speeds over time and way.
    assert_relative_eq!(
        found.regime.resistance_work / found.regime.cycle_time / 0.95,
        found.regime.figures.required_power,
        max_relative = 0.02
    );
    let [on_input, on_motor] = found.flywheel_sizes[..] else { panic!("two places") };
    assert_relative_eq!(on_motor.inertia * ratio * ratio, found.regime.flywheel, max_relative = 1e-12);
    assert!(on_motor.mass < on_input.mass);
}

#[test]
fn loads_are_reduced_to_the_pin_of_the_crank() {
    let mechanism = read(scene("shaper-drive"));
    let point = ReductionPoint::farthest(&mechanism).unwrap();
    assert_eq!(point.point.name, "A");
    assert_relative_eq!(point.radius, 0.1, max_relative = 1e-12);
}
