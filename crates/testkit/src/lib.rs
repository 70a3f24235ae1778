//! Support for tests: the conformance suite that every registered kind of group must pass, and random mechanisms.
//!
//! The test of a plugin is one line, `assur_testkit::conformance("rrr")`. The suite makes random groups of the pattern
//! that the plugin declares, of any class: it chooses the poses of all bodies first and reads the pairs off them, so
//! that the place that the kind must find is known. It knows no formula of a kind: it judges by the pairs, by
//! equilibrium, by work, and by differences in 32 digits.

mod arrangement;
mod case;
mod checks;
mod rng;
mod sample;
pub mod specimen;

pub use case::Fault;
pub use rng::Rng;

use assur_group::groups;

use case::Case;
use sample::Sample;

/// Regular samples, and as many singular ones, that a kind must pass.
const SAMPLES: u64 = 60;

/// Holds a registered kind of group to the whole suite.
///
/// # Panics
///
/// With the check, the seed and the numbers, where the kind fails; the suite is for tests.
pub fn conformance(name: &str) {
    if let Err(fault) = judge(name) {
        panic!("group `{name}` does not conform: {fault}");
    }
}

/// Holds a registered kind of group to the whole suite, for a test of the suite itself.
///
/// # Errors
///
/// The first [`Fault`].
pub fn judge(name: &str) -> Result<(), Fault> {
    let broken = |what: String| Fault { check: "registry", seed: 0, what };
    let all = groups().map_err(|error| broken(error.to_string()))?;
    let plugin = *all.iter().find(|plugin| plugin.name == name).ok_or_else(|| broken("not there".into()))?;
    let mut tried = checks::Tried::default();
    for seed in 0..SAMPLES {
        let mut rng = Rng::new(seed);
        if let Some(sample) = Sample::regular(&mut rng, &plugin.pattern) {
            let case = Case::new(plugin, sample, seed)?;
            checks::regular(&case, &mut rng, &mut tried)?;
        }
    }
    for seed in SAMPLES..2 * SAMPLES {
        if let Some(sample) = Sample::singular(&mut Rng::new(seed), &plugin.pattern) {
            checks::singular(&Case::new(plugin, sample, seed)?, &mut tried)?;
        }
    }
    tried.enough()
}
