//! The same motion as by steps in time.

use assur_integrator_dormand_prince::DOP853;
use proptest::prelude::*;

use super::pieces::Rows;
use super::*;

/// A motor by Kloss's formula against a load that grows with the square of the speed.
fn run_up(load: f64, fan: f64) -> impl EquationOfMotion {
    let (synchronous, critical, breakdown) = (157.0, 0.24, 900.0);
    speed_law(move |w| {
        let s = 1.0 - w / synchronous;
        // 2 Mmax/(s/sk + sk/s) without 0/0 at the synchronous speed.
        2.0 * breakdown * s * critical / (s * s + critical * critical) - load - fan * w * w
    })
}

#[test]
fn a_run_up_through_the_breakdown_point_is_that_of_tight_steps() {
    for (load, fan, w0) in [(0.0, 0.0, 0.0), (300.0, 0.0, 0.0), (100.0, 0.02, 0.0), (100.0, 0.02, 200.0)] {
        for until in [Until::Time(1.3), Until::Time(4.0), Until::Coordinate(60.0)] {
            let exact = DOP853.solve(&mut run_up(load, fan), &request(w0, until, 1e-13)).unwrap();
            for tolerance in [1e-4, 1e-8, 1e-11] {
                let found = solve(&mut run_up(load, fan), &request(w0, until, tolerance));
                let allowed = 3e-12 + tolerance * found.statistics.steps as f64;
                for (a, b) in found.samples.iter().zip(&exact.samples) {
                    assert!((a.speed - b.speed).abs() < allowed * 200.0, "{tolerance:e}: {a:?} {b:?}");
                    assert!(
                        (a.coordinate - b.coordinate).abs() < allowed * 600.0,
                        "{tolerance:e}: {a:?} {b:?}"
                    );
                }
                assert!((found.end.time - exact.end.time).abs() < allowed * 4.0);
            }
        }
    }
}

fn assert_same(found: &Trajectory, steps: &Trajectory, allowed: f64) -> Result<(), TestCaseError> {
    let fastest = steps.samples.iter().fold(0.0_f64, |most, sample| most.max(sample.speed.abs()));
    for (a, b) in found.samples.iter().zip(&steps.samples) {
        let size = b.coordinate.abs().max(1.0);
        prop_assert!((a.coordinate - b.coordinate).abs() < allowed * size.max(fastest), "{a:?} {b:?}");
        prop_assert!((a.speed - b.speed).abs() < allowed * fastest.max(1.0), "{a:?} {b:?}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Smooth moments: several speeds at which they vanish, that attract and repel.
    #[test]
    fn agrees_with_steps_in_time(h in prop::array::uniform6(-3.0..3.0_f64), w in -5.0..5.0_f64, end in 0.1..20.0_f64) {
        let law = || speed_law(move |w| h[0] - 0.3 * w + h[1] * (h[2] * w + h[3]).sin() + 0.1 * h[4] * (0.5 * w + h[5]).cos());
        let request = request(w, Until::Time(1.0 + end), 1e-10);
        let found = solve(&mut law(), &request);
        let steps = DOP853.solve(&mut law(), &Request { tolerance: 1e-12, ..request }).unwrap();
        // Speeds that repel magnify errors.
        assert_same(&found, &steps, 1e-6)?;
    }

    /// Tables over the speed with jumps, so that speeds may be held.
    #[test]
    fn agrees_over_tables(values in prop::collection::vec(prop::array::uniform2(-3.0..3.0_f64), 6), w in -5.0..5.0_f64, end in 0.1..20.0_f64) {
        let rows = || Rows { speeds: vec![-3.0, -1.0, 0.0, 0.8, 2.5], ends: values.clone(), segment: 0 };
        let request = request(w, Until::Time(1.0 + end), 1e-10);
        let found = solve(&mut rows(), &request);
        let steps = DOP853.solve(&mut rows(), &Request { tolerance: 1e-12, ..request }).unwrap();
        assert_same(&found, &steps, 1e-6)?;
    }
}
