//! What methods are judged by.

use std::rc::Rc;

use assur_force::Loads;
use assur_integrator::{Request, Until};

use super::scenes::{charted, rows, shipped};
use crate::chart::motion::{Task, reference::References};
use crate::chart::{Stage, work::Work};

fn with_task<R>(scene: &str, run: impl FnOnce(&Task<'_>) -> R) -> R {
    let linkage = shipped(scene);
    let loads = Loads::compile(&linkage).unwrap();
    let mut motion = assur_dynamics::equation(&linkage, &loads).unwrap();
    let request = assur_dynamics::request(&linkage.mechanism, &mut motion).unwrap();
    run(&Task { motion, request })
}

#[test]
fn no_method_judges_itself() {
    with_task("andrews", |task| {
        let found = References::find(task).unwrap();
        let (energy, dop853) = (found.judge_of("energy").unwrap(), found.judge_of("dop853").unwrap());
        assert!(!Rc::ptr_eq(&energy, &dop853));
        // A method that is no judge is judged by the first.
        assert!(Rc::ptr_eq(&dop853, &found.judge_of("rk4").unwrap()));
    });
    // If dop853 judged itself, its tightest run would be far nearer than the two judges are to each other.
    let data = charted("n-four-bar-2");
    let own = data.reference_error[&Stage::Motion];
    for row in rows(&data, Stage::Motion, "dop853") {
        assert!(row.error.unwrap() >= own, "{row:?}");
    }
}

#[test]
fn both_judges_of_andrews_agree_with_the_energy_integral() {
    // t = integral of sqrt(J / 2 W) over beta, by quadrature in 45 digits from the data of the Test Set for IVP Solvers: beta
    // at 0.03 s.
    const BETA: f64 = 15.810_771_195_153_71;
    // The same as published there, computed with a looser tolerance.
    const PUBLISHED: f64 = 15.810_771_196_299_04;
    with_task("andrews", |task| {
        let found = References::find(task).unwrap();
        for method in ["energy", "dop853"] {
            let end = found.judge_of(method).unwrap().end;
            assert!((end.coordinate / BETA - 1.0).abs() < 1e-13, "{method}: {}", end.coordinate);
            assert!((end.coordinate / PUBLISHED - 1.0).abs() < 1e-10, "{method}: {}", end.coordinate);
        }
    });
}

#[test]
fn a_brake_is_judged_by_the_formula() {
    with_task("brake", |task| {
        // The moment would turn the disc back: it rests at its turning point only.
        let request = Request { until: Until::Turn, ..task.request };
        let found = References::find(&Task { request, ..task.clone() }).unwrap();
        // D 3.22: rest after 50 s and 2500 rad.
        let end = found.judge_of("rk4").unwrap().end;
        assert!((end.time - 50.0).abs() < 1e-12 && (end.coordinate - 2500.0).abs() < 1e-10, "{end:?}");
    });
}

#[test]
fn the_reference_of_positions_is_better_than_rounding() {
    for scene in ["shaper", "press", "slider-crank", "andrews", "conveyor", "stephenson3"] {
        let linkage = shipped(scene);
        let work = Work::new(&linkage).unwrap();
        assert!(work.reference.error < f64::EPSILON, "{scene}: {:e}", work.reference.error);
    }
}

#[test]
fn change_points_are_left_out_and_told() {
    let linkage = shipped("n-four-bar-2");
    let work = Work::new(&linkage).unwrap();
    // 24 positions from 90 degrees: two of them are flat.
    assert_eq!(work.coordinates.len(), 22);
    assert!(work.reference.how.to_string().contains("2 positions are left out"), "{}", work.reference.how);
}
