//! A short fuzz run with a fixed seed: the same inputs on every machine.

use assur_tests::fuzz::{input, known, run};

/// Inputs of this run. `.ci/run` runs more of them, `docs/measured/robustness.md` tells of the long run.
const INPUTS: u64 = 1_000;

#[test]
fn nothing_breaks_the_program() {
    let known = known().unwrap();
    let mut findings = Vec::new();
    for number in 0..INPUTS {
        let (source, text) = input(number, &known);
        if let Err(finding) = run(&text) {
            findings.push(format!("input {number}, {source:?}: {finding}"));
        }
    }
    assert!(findings.is_empty(), "{} findings:\n{}", findings.len(), findings.join("\n"));
}
