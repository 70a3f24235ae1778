use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use assur_integrator::{AUTO, EquationOfMotion, EventKind, Reduced, Request, State, Until};
use assur_integrator_dormand_prince::DOP853;
use assur_problems::{Andrews, Example, VARIABLE};
use proptest::prelude::*;

use super::*;

/// How much greater the error of a panel may be than is allowed.
const MARGIN: f64 = 4.0;

fn assert_close(found: f64, wanted: f64, allowed: f64) {
    assert!((found - wanted).abs() <= allowed, "{found} is not {wanted}: off by {:e}", found - wanted);
}

fn from_rest(until: Until, tolerance: f64) -> Request {
    Request { tolerance, ..Request::new(State::default(), until) }
}

#[test]
fn e1_is_exact_from_rest() {
    let found =
        ENERGY.solve(&mut assur_problems::e1(), &from_rest(Until::Coordinate(10.0 * PI), 1e-9)).unwrap();
    assert_close(found.end.speed, (1000.0 * PI).sqrt(), 1e-12);
    // w² = 400 q - (300/(10 pi)) q²·... : q'' = 200 - k q, k = 30/pi: q = (200/k)(1 - cos(√k t)).
    let k = 30.0_f64 / PI;
    for sample in &found.samples {
        let phase = k.sqrt() * sample.time;
        assert_close(sample.coordinate, 200.0 / k * (1.0 - phase.cos()), 1e-10);
        assert_close(sample.speed, 200.0 / k.sqrt() * phase.sin(), 1e-10);
        assert_close(sample.acceleration, 200.0 * phase.cos(), 1e-9);
    }
}

#[test]
fn d1_rests_and_jumps_are_exact() {
    let braked =
        Request { initial: State { speed: 100.0, ..State::default() }, ..from_rest(Until::Turn, 1e-9) };
    let found = ENERGY.solve(&mut assur_problems::d1(), &braked).unwrap();
    assert_close(found.end.time, 50.0, 1e-10);
    assert_close(found.end.coordinate, 2500.0, 1e-9);
    let found =
        ENERGY.solve(&mut assur_problems::jumps(), &from_rest(Until::Coordinate(3.0), 1e-10)).unwrap();
    assert_close(found.end.time, 3.0 - SQRT_2 + (10.0_f64.sqrt() - SQRT_2) / 4.0, 1e-12);
    assert_eq!(found.events.len(), 2);
}

#[test]
fn pendulum_swings_with_its_period() {
    for amplitude in [0.01, 1.0, 3.1] {
        let period = assur_problems::pendulum_period(amplitude);
        let initial = State { coordinate: amplitude, ..State::default() };
        let request = Request { samples: 8, ..Request::new(initial, Until::Time(3.25 * period)) };
        let found = ENERGY.solve(&mut assur_problems::pendulum(), &request).unwrap();
        assert_eq!(found.events.len(), 6);
        for (index, event) in found.events.iter().enumerate() {
            assert_eq!(event.kind, EventKind::Reversal);
            assert_close(event.state.time, 0.5 * (index + 1) as f64 * period, 1e-8 * period);
        }
        assert_close(found.end.coordinate, 0.0, 1e-7);
        assert_close(found.end.speed, -2.0 * (0.5 * amplitude).sin(), 1e-8);
    }
}

#[test]
fn dry_friction_holds_at_last() {
    let initial = State { coordinate: 1.0, ..State::default() };
    let found = ENERGY
        .solve(&mut assur_problems::friction_oscillator(), &Request::new(initial, Until::Time(10.0)))
        .unwrap();
    let kinds: Vec<EventKind> = found.events.iter().map(|event| event.kind).collect();
    assert_eq!(kinds, [EventKind::Reversal, EventKind::Rest]);
    assert_close(found.events[0].state.time, PI, 1e-11);
    assert_close(found.events[1].state.time, 2.0 * PI, 1e-11);
    assert_close(found.end.coordinate, -0.2, 1e-11);
    assert_close(found.samples[100].time, 10.0, 0.0);
    assert_close(found.samples[90].coordinate, -0.2, 1e-11);
}

#[test]
fn andrews_mechanism_needs_few_evaluations() {
    let request = Request { tolerance: 1e-9, samples: 4, ..Request::new(Andrews::START, Until::Time(0.03)) };
    let found = ENERGY.solve(&mut Andrews, &request).unwrap();
    assert_close(found.end.coordinate, Andrews::END.coordinate, 1e-9 * 15.8);
    assert_close(found.end.speed, Andrews::END.speed, 1e-9 * 1140.0);
    assert!(found.statistics.evaluations < 500, "{:?}", found.statistics);
}

#[test]
fn creeping_onto_an_equilibrium_has_no_end() {
    // Just the energy that carries a pendulum to the top: w = 2 at the bottom, w = 2/cosh t.
    let initial = State { speed: 2.0, ..State::default() };
    let found =
        ENERGY.solve(&mut assur_problems::pendulum(), &Request::new(initial, Until::Time(5.0))).unwrap();
    assert_close(found.end.speed, 2.0 / 5.0_f64.cosh(), 1e-8);
    let error = ENERGY
        .solve(&mut assur_problems::pendulum(), &Request::new(initial, Until::Coordinate(PI)))
        .unwrap_err();
    assert!(error.to_string().starts_with("coordinate 3.14159"), "{error}");
}

/// The moment -k cos q lifts a pendulum to where the speed is zero for a moment only: it swings between two turning points near
/// its top, and a panel that reaches beyond both has energy left at its end and hardly any dip in between.
#[test]
fn it_turns_however_narrow_the_hill() {
    const K: f64 = 10.0;
    for exponent in 1..=24 {
        let lack = K * 0.5_f64.powi(exponent);
        let mut motion = Example::new(VARIABLE, |_, at| Reduced {
            inertia: 1.0,
            inertia_derivative: 0.0,
            moment: -K * at.coordinate.cos(),
        });
        // From the bottom, with a little less energy than at the top.
        let initial = State { coordinate: -FRAC_PI_2, speed: (2.0 * (2.0 * K - lack)).sqrt(), time: 0.0 };
        for (tolerance, offset) in [(1e-6, 0.0), (1e-9, 0.0), (1e-9, 0.7), (1e-12, 0.3)] {
            let coordinate = initial.coordinate + offset;
            let height = K * (1.0 + coordinate.sin());
            let speed = (2.0 * (2.0 * K - lack - height)).sqrt();
            let start = State { coordinate, speed, ..initial };
            let request = Request { tolerance, samples: 50, ..Request::new(start, Until::Time(40.0)) };
            let found = ENERGY.solve(&mut motion, &request).unwrap();
            for sample in found.samples {
                assert!((sample.coordinate + FRAC_PI_2).abs() < PI, "{exponent}: {sample:?}");
                let energy = 0.5 * sample.speed * sample.speed + K * (1.0 + sample.coordinate.sin());
                assert_close(energy, 2.0 * K - lack, 10.0 * tolerance * 2.0 * K);
            }
        }
    }
}

#[test]
fn a_motor_is_refused() {
    let error = ENERGY
        .solve(&mut assur_problems::motor(1.0), &from_rest(Until::Time(1.0), 1e-6))
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("depends on the coordinate alone, and here it is case 5 of D: J(q), M(q, w)"),
        "{error}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn agrees_with_steps_in_time(
        harmonics in prop::collection::vec(-1.0..1.0_f64, 8),
        q in -3.0..3.0_f64,
        w in prop_oneof![Just(0.0), -4.0..4.0_f64],
        end in 0.5..6.0_f64,
    ) {
        let h = harmonics.clone();
        let mut motion = Example::new(VARIABLE, move |_, at| {
            let q = at.coordinate;
            Reduced {
                inertia: 2.5 + h[0] * q.cos() + h[1] * (2.0 * q + h[2]).sin(),
                inertia_derivative: -h[0] * q.sin() + 2.0 * h[1] * (2.0 * q + h[2]).cos(),
                moment: 3.0 * h[3] + 4.0 * h[4] * (q + h[5]).sin() + 2.0 * h[6] * (3.0 * q + h[7]).cos(),
            }
        });
        let initial = State { time: 0.0, coordinate: q, speed: w };
        let request = Request { tolerance: 1e-11, samples: 5, ..Request::new(initial, Until::Time(end)) };
        let by_energy = ENERGY.solve(&mut motion, &request).unwrap();
        let by_steps = DOP853.solve(&mut motion, &request).unwrap();
        for (a, b) in by_energy.samples.iter().zip(&by_steps.samples) {
            // Near a top of the potential the motion itself magnifies errors.
            prop_assert!((a.coordinate - b.coordinate).abs() < 1e-6, "{a:?} {b:?}");
            prop_assert!((a.speed - b.speed).abs() < 1e-6, "{a:?} {b:?}");
        }
    }
}

#[test]
fn it_is_chosen_for_work_along_the_coordinate() {
    let chosen =
        |dependence| assur_integrator::choose(AUTO, &dependence, 1e-9).unwrap().first.integrator.name;
    assert_eq!(chosen(VARIABLE), "energy");
    assert_eq!(chosen(assur_problems::motor(1.0).dependence()), "dop853");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// A table of jumps with dry friction, on a spring that keeps the motion near.
    #[test]
    fn agrees_with_steps_in_time_over_jumps_and_friction(
        moments in prop::collection::vec(-2.0..2.0_f64, 6),
        friction in 0.05..0.5_f64,
        w in prop_oneof![Just(0.0), -4.0..4.0_f64],
        until in prop_oneof![Just(Until::Turn), (0.5..12.0_f64).prop_map(Until::Time)],
    ) {
        let mut motion = Example::new(VARIABLE, move |place, at| Reduced {
            inertia: 1.5 + at.coordinate.cos(),
            inertia_derivative: -at.coordinate.sin(),
            moment: moments[place.segment] - friction * place.direction - 0.5 * at.coordinate,
        })
        .with_breaks(vec![-1.3, -0.4, 0.2, 1.1, 2.5])
        .directed();
        let initial = State { time: 0.0, coordinate: 0.5, speed: w };
        let request = Request { tolerance: 1e-11, samples: 7, ..Request::new(initial, until) };
        let by_energy = ENERGY.solve(&mut motion, &request);
        let by_steps = DOP853.solve(&mut motion, &request);
        prop_assert!(by_energy.is_ok() && by_steps.is_ok(), "{by_energy:?} {by_steps:?}");
        for (a, b) in by_energy.unwrap().samples.iter().zip(&by_steps.unwrap().samples) {
            prop_assert!((a.coordinate - b.coordinate).abs() < 1e-6, "{a:?} {b:?}");
            prop_assert!((a.speed - b.speed).abs() < 1e-6, "{a:?} {b:?}");
        }
    }
}

/// w² = w0² + 2 e q and t = 2 q/(w0 + w), however slow the start; and back, after a reversal in w0/e.
#[test]
fn a_start_is_exact_however_slow() {
    let constant = assur_problems::CONSTANT;
    for exponent in 1..=15 {
        let w0 = 10.0_f64.powi(-exponent);
        let initial = State { speed: w0, ..State::default() };
        for (moment, target) in [(2.0, 1.0), (-2.0, -1.0)] {
            let formula = move |_: assur_problems::Place, _: &State| Reduced {
                inertia: 1.0,
                inertia_derivative: 0.0,
                moment,
            };
            let mut motion = Example::new(constant, formula);
            let request = Request { initial, ..from_rest(Until::Coordinate(target), 1e-12) };
            let end = ENERGY.solve(&mut motion, &request).unwrap().end;
            let speed = (w0 * w0 + 4.0).sqrt();
            assert_close(end.speed, speed * target, 1e-12);
            let time = if target > 0.0 { 2.0 / (w0 + speed) } else { 0.5 * (w0 + speed) };
            assert_close(end.time, time, 1e-11);
        }
    }
}

#[test]
fn rest_for_good_is_told_from_a_turning_point() {
    let initial = State { coordinate: 1.0, ..State::default() };
    let end = |until| ENERGY.solve(&mut assur_problems::friction_oscillator(), &Request::new(initial, until));
    // It turns at -0.4 after pi, and friction holds it at -0.2 after 2 pi.
    let (turn, rest) = (end(Until::Turn).unwrap(), end(Until::Rest).unwrap());
    assert_close(turn.end.coordinate, -0.4, 1e-10);
    assert_close(rest.end.coordinate, -0.2, 1e-10);
    assert_close(rest.end.time, 2.0 * PI, 1e-10);
    assert_eq!(rest.events.last().unwrap().kind, EventKind::Rest);
    let swing =
        ENERGY.solve(&mut assur_problems::pendulum(), &Request::new(initial, Until::Rest)).unwrap_err();
    assert!(swing.to_string().ends_with("swings between two turning points without end"), "{swing}");
}

#[test]
fn a_motion_held_from_its_start_has_its_samples_in_time() {
    let initial = State { coordinate: 0.2, ..State::default() };
    let request = Request { samples: 4, ..Request::new(initial, Until::Time(2.0)) };
    let found = ENERGY.solve(&mut assur_problems::friction_oscillator(), &request).unwrap();
    let times: Vec<f64> = found.samples.iter().map(|sample| sample.time).collect();
    assert_eq!(times, [0.0, 0.5, 1.0, 1.5, 2.0]);
    for sample in found.samples {
        assert_close(sample.coordinate, 0.2, 0.0);
        assert_close(sample.acceleration, 0.0, 0.0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Energy and slowness in a panel that passes against the exact ones.
    #[test]
    fn the_error_of_a_panel_that_passes_is_bounded(
        harmonics in prop::collection::vec((1..40_u32, 0.3..1.0_f64, 0.0..2.0 * PI), 1..6),
        at in -PI..PI,
        length in 0.05..6.0_f64,
        tolerance in (4.0..13.0_f64).prop_map(|digits| 10.0_f64.powf(-digits)),
        energy in 0.0..10.0_f64,
    ) {
        let (of_moment, of_inertia) = (harmonics.clone(), harmonics.clone());
        let inertia = move |q: f64| {
            8.0 + of_inertia.iter().map(|(n, a, p)| a * (f64::from(*n) * q - p).cos()).sum::<f64>()
        };
        let whole = move |q: f64| {
            of_moment.iter().map(|(n, a, p)| a / f64::from(*n) * (f64::from(*n) * q + p).sin()).sum::<f64>()
        };
        let (j, moments) = (inertia.clone(), harmonics);
        let mut motion = Example::new(VARIABLE, move |_, at| Reduced {
            inertia: j(at.coordinate),
            inertia_derivative: 0.0,
            moment: moments.iter().map(|(n, a, p)| a * (f64::from(*n) * at.coordinate + p).cos()).sum(),
        });
        let mut equation = assur_integrator::CountedEquation::new(&mut motion);
        let state = State { coordinate: at, speed: 1.0, time: 0.0 };
        let (mut length, mut factor) = (length, 1.0);
        let panel = loop {
            length *= factor;
            let panel = clock::EnergyPanel::fit(&mut equation, &state, length, None, (energy, energy)).unwrap();
            if panel.error <= tolerance {
                break panel;
            }
            factor = clock::factor(tolerance, panel.error).clamp(0.1, 0.7);
        };
        let scale = panel.most_energy();
        for k in 0..=100 {
            let x = f64::from(k) / 50.0 - 1.0;
            let q = panel.coordinate(x);
            let wanted = energy + whole(q) - whole(at);
            let missed = (panel.energy(x) - wanted).abs() / scale;
            let slow = (panel.slowness(x) / (0.5 * length * (0.5 * inertia(q)).sqrt()) - 1.0).abs();
            let most = MARGIN * tolerance + 1e-14;
            prop_assert!(missed <= most && slow <= most, "{x}: {missed:e}, {slow:e}, allowed {tolerance:e}");
        }
    }
}

#[test]
fn it_conforms() {
    assur_testkit::integrator_conformance("energy");
}
