//! `auto` is held to the chart, by counts of evaluations.

use assur_integrator::{choose, integrators};

use super::scenes::{charted, rows, shipped};
use crate::chart::{Stage, Value};

/// At most so many times more evaluations than the best method that meets the tolerance.
const MOST: u64 = 3;

#[test]
fn auto_is_never_far_from_the_best() {
    for scene in ["andrews", "n-four-bar-2", "shaper-drive", "run-up", "brake"] {
        let linkage = shipped(scene);
        let loads = assur_force::Loads::compile(&linkage).unwrap();
        let dependence = match crate::chart::steady::Cycle::of(&linkage, &loads) {
            Some(cycle) => assur_integrator::Motion::dependence(&cycle.unwrap().task(1).motion),
            None => {
                assur_integrator::Motion::dependence(&assur_dynamics::equation(&linkage, &loads).unwrap())
            }
        };
        let data = charted(scene);
        for exponent in 3..=12 {
            let tolerance = 10.0_f64.powi(-exponent);
            let auto = choose(&dependence, tolerance, &integrators().unwrap()).unwrap();
            let is_asked = |value| match value {
                Some(Value::Number(set)) => (set / tolerance - 1.0).abs() < 1e-6,
                _ => true,
            };
            let own = rows(&data, Stage::Motion, auto.name());
            let own = own.into_iter().find(|row| is_asked(row.setting.get("tolerance"))).unwrap();
            let good = data
                .of(Stage::Motion)
                .filter(|row| row.ok && row.error.is_some_and(|error| error <= tolerance));
            let Some(best) = good.min_by_key(|row| row.evaluations) else { continue };
            assert!(
                own.evaluations.unwrap() <= MOST * best.evaluations.unwrap(),
                "{scene} at {tolerance:e}: auto takes {own:?}, the best is {best:?}"
            );
        }
    }
}
