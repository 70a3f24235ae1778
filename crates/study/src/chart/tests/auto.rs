//! `auto` is held to the chart, by counts of evaluations.

use super::scenes::charted;
use crate::chart::{Stage, Value};

/// At most so many times more evaluations than the best method that meets the tolerance.
const MOST: u64 = 3;

#[test]
fn auto_is_never_far_from_the_best() {
    for scene in ["andrews", "n-four-bar-2", "shaper-drive", "run-up", "brake"] {
        let data = charted(scene);
        for exponent in 3..=12 {
            let tolerance = 10.0_f64.powi(-exponent);
            let is_asked = |value| match value {
                Some(Value::Number(set)) => (set / tolerance - 1.0).abs() < 1e-6,
                _ => true,
            };
            let mut own = data.of(Stage::Motion).filter(|row| row.auto);
            let own = own.find(|row| is_asked(row.setting.get("tolerance"))).unwrap();
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
