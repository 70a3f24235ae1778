//! Support for tests and benches: the conformance suites that every registered plugin must pass (kinds of groups, force analyzers,
//! integrators, catalogues), random mechanisms, and formulas written by hand as yardsticks.
//!
//! The test of a plugin is one line, `assur_testkit::conformance("rrr")`. The suite constructs random groups of the
//! pattern that the plugin declares, of any class: it draws the poses of all bodies first and fits the pairs to them,
//! so the correct poses are known. The suite contains no formula of a kind: it checks the constraints of the pairs,
//! equilibrium, virtual power, and differences in 32 digits.

mod analyzers;
mod arrangement;
mod case;
mod catalogues;
mod checks;
pub mod guard;
mod integrators;
mod pattern;
#[cfg(test)]
mod planted;
mod rng;
mod sample;
pub mod specimen;
pub mod yardstick;

pub use analyzers::{judge_analyzer, judge_forces};
pub use case::Fault;
pub use catalogues::{judge_catalogue, judge_table};
pub use integrators::{judge_integrator, judge_method};
pub use rng::Rng;

use assur_group::{
    Assemblies, Body, Builders, ForceAngle, GroupFrame, GroupPlugin, Iterated, Number, Pattern, Wrench,
    groups,
};
use assur_number::Dd;
use assur_words::Text;

use case::Case;
use sample::Sample;

/// Number of regular samples, and of singular ones, in the suite.
const SAMPLES: u64 = 60;

/// Tests a registered kind of group with the whole suite.
///
/// # Panics
///
/// If the kind fails, with the check, the seed and the numbers; the suite is for tests.
pub fn conformance(name: &str) {
    if let Err(fault) = judge(name) {
        panic!("group `{name}` does not conform: {fault}");
    }
}

/// Tests a registered force analyzer with the whole suite.
///
/// # Panics
///
/// If it fails, with the check, the seed and the numbers; the suite is for tests.
pub fn analyzer_conformance(name: &str) {
    judge_analyzer(name).unwrap_or_else(|fault| panic!("force analyzer `{name}` does not conform: {fault}"));
}

/// Tests a registered integrator with the whole suite.
///
/// # Panics
///
/// If it fails, with the check and the numbers; the suite is for tests.
pub fn integrator_conformance(name: &str) {
    judge_integrator(name).unwrap_or_else(|fault| panic!("integrator `{name}` does not conform: {fault}"));
}

/// Tests a registered motor catalogue with the whole suite.
///
/// # Panics
///
/// If it fails, with the check and the motor; the suite is for tests.
pub fn catalogue_conformance(name: &str) {
    judge_catalogue(name).unwrap_or_else(|fault| panic!("catalogue `{name}` does not conform: {fault}"));
}

/// Tests a registered kind of group with the whole suite, and returns a failure as a value.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge(name: &str) -> Result<(), Fault> {
    let broken = |check: &'static str, what: String| Fault { check, seed: None, what };
    let all = groups().map_err(|error| broken("registry", error.to_string()))?;
    let plugin = *all.iter().find(|plugin| plugin.name == name).ok_or_else(|| {
        let names: Vec<_> = all.iter().map(|plugin| plugin.name).collect();
        let what = format!(
            "no kind `{name}` is registered; registered are {}; is `use your_crate as _;` in the test?",
            names.join(", ")
        );
        broken("registry", what)
    })?;
    match plugin.pattern {
        Some(pattern) => judge_on(plugin, &pattern),
        None => {
            Err(broken("pattern", "a kind for any group is tested with patterns of your choice".to_owned()))
        }
    }
}

/// Tests a registered kind for any group with the whole suite, on groups of a pattern.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge_with(name: &str, pattern: &Pattern) -> Result<(), Fault> {
    let broken =
        |error: assur_group::RegistryError| Fault { check: "registry", seed: None, what: error.to_string() };
    let all = groups().map_err(broken)?;
    let found = all.into_iter().find(|plugin| plugin.name == name);
    let plugin = found.ok_or_else(|| {
        broken(assur_group::RegistryError::Unknown {
            what: assur_words::text!("group-sort"),
            name: name.to_owned(),
            known: Vec::new(),
        })
    })?;
    judge_on(plugin, pattern)
}

fn judge_on(plugin: &'static GroupPlugin, pattern: &Pattern) -> Result<(), Fault> {
    let broken = |check: &'static str, what: String| Fault { check, seed: None, what };
    pattern::is_assur_group(pattern).map_err(|what| broken("pattern", what))?;
    let mut tried = checks::Tried::default();
    for seed in 0..SAMPLES {
        let mut rng = Rng::new(seed);
        if let Some(sample) = Sample::regular(&mut rng, pattern) {
            let case = Case::new(plugin, sample, seed)?;
            checks::regular(&case, &mut rng, &mut tried)?;
        }
    }
    for seed in SAMPLES..2 * SAMPLES {
        if let Some(sample) = Sample::singular(&mut Rng::new(seed), pattern) {
            checks::singular(&Case::new(plugin, sample, seed)?, &mut tried)?;
        }
    }
    tried.enough()
}

/// Random groups of a pattern, well away from singular positions, each with all bodies (the ground first) in the poses to which
/// its pairs were fitted; the same ones for one seed everywhere.
pub fn random_groups(pattern: &Pattern, seeds: std::ops::Range<u64>) -> Vec<(GroupFrame, Vec<Body<f64>>)> {
    let drawn = seeds.filter_map(|seed| Sample::regular(&mut Rng::new(seed), pattern));
    drawn.map(|sample| (sample.frame.clone(), sample.built())).collect()
}

/// The words of a kind of a test.
const TEST: Text = Text::message("test", Vec::new());

/// The entry of a kind that has nothing but its pattern: it iterates, and finds the assembly near its start.
pub const fn iterated(name: &'static str, pattern: Pattern) -> GroupPlugin {
    GroupPlugin {
        name,
        kind: name,
        number: 0,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: TEST,
        pattern: Some(pattern),
        // Before the kinds of the repository.
        rank: 1,
        ways: Assemblies { most: 1, varies: false, words: TEST },
        iterates: true,
        singular: TEST,
        force_angle: ForceAngle::DEFAULT,
        source: TEST,
        builders: Builders::of::<Iterated>(),
    }
}

/// Reactions of a group of a registered kind under these loads, by the kernel in f64 and in 32 digits (rounded), with
/// the same poses of the outer bodies, in the first way of assembly.
///
/// # Panics
///
/// If the kind is not registered or refuses the group; the function is for tests.
pub fn reactions(
    name: &str,
    frame: &GroupFrame,
    bodies: &[Body<f64>],
    loads: &[Wrench<f64>],
) -> [Vec<Wrench<f64>>; 2] {
    [reactions_in::<f64>(name, frame, bodies, loads), reactions_in::<Dd>(name, frame, bodies, loads)]
}

fn reactions_in<T: Number>(
    name: &str,
    frame: &GroupFrame,
    bodies: &[Body<f64>],
    loads: &[Wrench<f64>],
) -> Vec<Wrench<f64>> {
    let solve = || -> Result<Vec<Wrench<T>>, Box<dyn std::error::Error>> {
        let plugin = groups()?.into_iter().find(|plugin| plugin.name == name).ok_or("not registered")?;
        let kernel = T::build(&plugin.builders, frame)?;
        let mut bodies: Vec<Body<T>> = bodies.iter().map(|body| body.map(T::from_f64)).collect();
        kernel.place(&mut bodies, 0)?;
        let mut loads: Vec<Wrench<T>> = loads.iter().map(|load| load.map(T::from_f64)).collect();
        let mut found = vec![Wrench::ZERO; frame.pairs().count()];
        kernel.reactions(&bodies, &mut loads, &mut found)?;
        Ok(found)
    };
    let found = solve().unwrap_or_else(|error| panic!("group `{name}`: {error}"));
    found.iter().map(|wrench| wrench.map(T::to_f64)).collect()
}
