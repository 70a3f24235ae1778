use assur_all as _;
use assur_kinematics::Linkage;

use crate::{Check, checks, verdict};

mod coverage;
mod differences;
mod double;
mod fixtures;
mod formulas;
mod many;
mod mutants;
mod mutations;
mod near;
mod random;
mod redriven;
mod several;
mod singular;
mod switches;
mod twice;
mod units;

/// The report of a failure.
fn show(all: &[Check]) -> String {
    let line = |c: &Check| {
        let verdict = verdict(c.finding.holds);
        let at = c.at;
        format!(
            "{:26} {:10.3e} {:10.3e} {at:?} {} {verdict}",
            c.name, c.finding.error, c.finding.bound, c.finding.place
        )
    };
    all.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn hold(all: &[Check]) -> bool {
    all.iter().all(|check| check.finding.holds == Some(true))
}

fn scene(text: &str) -> Linkage {
    Linkage::compile(assur_scene::read("scene.toml", text).unwrap()).unwrap()
}

fn names(linkage: &Linkage) -> Vec<String> {
    checks(linkage).into_iter().map(|check| check.name.to_string()).collect()
}
