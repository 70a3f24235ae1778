use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{LoadState, Loads};
use assur_group::Order;

use super::{checks, hold, names, scene, show};
use crate::{Check, Chosen, Finding, InputLoad, Subject, methods};

#[test]
fn every_fixture_holds() {
    let folder = format!("{}/../../fixtures", env!("CARGO_MANIFEST_DIR"));
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    assert!(paths.len() > 10);
    for path in paths {
        let all = checks(&scene(&std::fs::read_to_string(&path).unwrap()));
        let name = path.file_stem().unwrap().to_string_lossy();
        println!("{name}\n{}", show(&all));
        assert!(hold(&all), "{name}\n{}", show(&all));
        let count = all.len();
        assert!(count >= 5, "{name} has only {count} checks");
    }
}

const FOUR_BAR: &str = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n\
    [link.crank]\npoints = { O = 0, A = 1 }\n[link.coupler]\npoints = { A = 0, B = 3 }\n\
    [link.rocker]\npoints = { C = 0, B = 2 }\n[input]\nlink = \"crank\"\n";

#[test]
fn checks_that_do_not_apply_are_left_out() {
    let bare = names(&scene(FOUR_BAR));
    assert_eq!(bare, ["closure PF0", "closure PF1", "closure PF2", "TestPf PF1", "TestPf PF2"]);
    let loaded = format!("{FOUR_BAR}[[moment]]\nlink = \"rocker\"\nvalue = 5\n");
    let loaded = names(&scene(&loaded));
    assert!(
        loaded.iter().any(|name| name == "Lagrange-d'Alembert")
            && loaded.iter().any(|name| name == "agreement of the methods")
    );
    assert!(
        !loaded.iter().any(|name| name == "slides push across")
            && !loaded.iter().any(|name| name == "TestPf J'")
    );
}

/// A slide of 1 kg that is pushed by a table with a jump, at coordinates that miss the jump by rounding.
#[test]
fn a_position_on_a_jump_within_rounding_holds() {
    for unit in ["mm", "m"] {
        let scene = scene(&format!(
            "[ground]\npoints = {{ G = 0 }}\n[link.m]\npoints = {{ P = 0 }}\nmass = 1\n[[slide]]\nlink = \"m\"\non = \"ground\"\n\
             [input]\nlink = \"m\"\nfrom = \"-20 {unit}\"\nto = \"180 {unit}\"\npositions = 21\n\
             [[force]]\nlink = \"m\"\nat = \"P\"\nangle = 0\n\
             value = {{ over = \"angle\", repeat = false, table = [[0, 50], [\"50 {unit}\", 10], [\"50 {unit}\", 100], [\"150 {unit}\", -20]] }}\n"
        ));
        let all = checks(&scene);
        assert!(hold(&all), "{unit}\n{}", show(&all));
    }
}

#[test]
fn a_limit_of_the_size_of_what_is_compared_judges_only_what_exceeds_it() {
    let of = |error, bound| Finding::of(assur_words::Text::default(), error, bound).holds;
    assert_eq!(of(1e-12, 1e-9), Some(true));
    assert_eq!(of(1e-3, 1e-9), Some(false));
    assert_eq!(of(0.3, 0.96), None);
    assert_eq!(of(1.2, 0.96), Some(false));
    assert_eq!(of(f64::NAN, 0.96), Some(false));
}

/// The equation of motion says which moment at the input the prescribed motion needs.
#[test]
fn a_drive_that_differs_by_a_billionth_is_caught() {
    let linkage = scene(assur_fixtures::scene("shaper"));
    let loads = Loads::compile(&linkage).unwrap();
    let input = &linkage.mechanism.input;
    let found = |factor: f64, more: f64| {
        let needed = |state: &LoadState| {
            let mut position = linkage.position();
            linkage.solve(state.coordinate, Order::Second, &mut position).unwrap();
            let found = loads.reduced(state, &position.bodies);
            let of_inertia =
                found.inertia * state.acceleration + 0.5 * found.inertia_derivative * state.speed.powi(2);
            let value = factor * (of_inertia - found.moment) + more;
            InputLoad { value, error: 0.0, accuracy: [0.0; 2] }
        };
        let subject = Subject {
            linkage: &linkage,
            loads: Some(&loads),
            positions: Chosen::all(0),
            states: Chosen::all(input.positions),
            state: &|index| Some(LoadState::prescribed(&linkage.mechanism, input.coordinate(index))),
            drive: Some(&needed),
            methods: methods(&linkage, None),
        };
        let ControlFlow::Continue((all, residuals)) =
            subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
        let check =
            all.into_iter().find(|check| check.name.to_string() == "drive against force analysis").unwrap();
        let most =
            |of: fn(&crate::ForceResiduals) -> f64| residuals.forces.iter().map(of).fold(0.0, f64::max);
        let all: Vec<f64> = residuals.forces.iter().map(|at| at.remainder).collect();
        (check, [most(|at| at.dynamics), most(|at| at.global)], all)
    };
    let (check, residuals, _) = found(1.0, 0.0);
    assert!(
        check.finding.holds == Some(true) && residuals.iter().all(|residual| *residual < 1e-14),
        "{check:?} {residuals:?}"
    );
    let (check, residuals, _) = found(1.0 + 1e-9, 0.0);
    assert!(check.finding.failed());
    // The curves of both residuals show it: those of a wrong moment of the drive, as of a wrong acceleration.
    assert!(residuals.iter().all(|residual| (1e-11..1e-9).contains(residual)), "{residuals:?}");
    // What is left of the equation of motion is what the drive gives too much, in N m and with its sign.
    for more in [0.25, -3.0] {
        let (_, _, left) = found(1.0, more);
        assert!(
            left.len() == input.positions && left.iter().all(|left| (left - more).abs() < 1e-9),
            "{left:?}"
        );
    }
}

/// A disc at rest at a coordinate, with a moment that jumps at 0.5 rad and rises over 1e-12 rad at 1 rad.
fn drive_at_rest(coordinate: f64, value: f64) -> Check {
    let linkage = scene(
        "[ground]\npoints = { O = 0 }\n[link.disc]\npoints = { O = 0 }\ninertia = 0.5\n[input]\nlink = \"disc\"\n\
         [[moment]]\nlink = \"disc\"\nvalue = { over = \"angle\", repeat = false, \
         table = [[0, 5], [0.5, 5], [0.5, -3], [1, -3], [1.000000000001, 7], [2, 7]] }\n",
    );
    let loads = Loads::compile(&linkage).unwrap();
    let state = LoadState { coordinate, ..LoadState::default() };
    let subject = Subject {
        linkage: &linkage,
        loads: Some(&loads),
        positions: Chosen::all(0),
        states: Chosen::all(1),
        state: &|_| Some(state),
        drive: Some(&move |_: &LoadState| InputLoad { value, error: 0.0, accuracy: [1e-9, 0.0] }),
        methods: methods(&linkage, None),
    };
    let ControlFlow::Continue((all, _)) = subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
    all.into_iter().find(|check| check.name.to_string() == "drive against force analysis").unwrap()
}

#[test]
fn a_drive_at_rest_is_judged_but_on_a_jump() {
    for (coordinate, needed) in [(0.3, -5.0), (0.7, 3.0), (1.5, -7.0)] {
        let check = drive_at_rest(coordinate, needed);
        assert!(check.finding.holds == Some(true) && check.finding.bound < 1e-12, "{coordinate}: {check:?}");
        assert!(drive_at_rest(coordinate, 1.0 + needed).finding.failed(), "{coordinate}");
    }
    // Within the accuracy of the motion on either side.
    for coordinate in [0.5 - 5e-10, 0.5, 0.5 + 5e-10] {
        let check = drive_at_rest(coordinate, 0.0);
        assert_eq!((check.finding.holds.is_some(), check.left_out), (false, 1), "{coordinate}: {check:?}");
    }
    assert!(drive_at_rest(0.5 + 5e-9, 0.0).finding.failed());
}
