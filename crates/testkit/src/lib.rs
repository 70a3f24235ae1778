//! The conformance suite: what every registered kind of group must do, whoever wrote it.
//!
//! A plugin's test is one line, `assur_testkit::conformance("rrr")`. The suite makes random groups by construction: it
//! chooses the poses of all bodies first and reads the pairs off them, so that the place that the kind must find is
//! known. It knows no formula of a kind: it judges by the pairs, by equilibrium, by work, and by differences in 32
//! digits.

mod case;
mod checks;
mod dice;
mod sample;
pub mod specimen;

pub use case::{Case, Fault};
pub use dice::Dice;
pub use sample::{Join, Path, Sample, dyad};

use assur_group::{GroupPlugin, groups};

/// Samples that a kind must pass.
const SAMPLES: u64 = 60;

/// Holds a registered dyad to the whole suite.
///
/// # Panics
///
/// With the check, the seed and the numbers, where the kind fails; the suite is for tests.
pub fn conformance(name: &str) {
    if let Err(fault) = judge(name, |dice, plugin, singular| dyad(dice, &plugin.pattern, singular)) {
        panic!("group `{name}` does not conform: {fault}");
    }
}

/// Holds a registered kind to the suite, on samples of its own; with `true`, on samples at a singular position.
///
/// # Errors
///
/// The first [`Fault`].
pub fn judge(
    name: &str,
    sample: impl Fn(&mut Dice, &GroupPlugin, bool) -> Option<Sample>,
) -> Result<(), Fault> {
    let broken = |what: String| Fault { check: "registry", seed: 0, what };
    let all = groups().map_err(|error| broken(error.to_string()))?;
    let plugin = *all.iter().find(|plugin| plugin.name == name).ok_or_else(|| broken("not there".into()))?;
    let mut tried = checks::Tried::default();
    for seed in 0..SAMPLES {
        let mut dice = Dice::new(seed);
        if let Some(sample) = sample(&mut dice, plugin, false) {
            let case = Case::new(plugin, sample, seed)?;
            checks::regular(&case, &mut dice, &mut tried)?;
        }
    }
    for seed in SAMPLES..2 * SAMPLES {
        if let Some(sample) = sample(&mut Dice::new(seed), plugin, true) {
            checks::singular(&Case::new(plugin, sample, seed)?)?;
        }
    }
    tried.enough(plugin)
}
