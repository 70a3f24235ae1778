//! Whatever the text, there is an answer, and its places are in the text.

use proptest::prelude::*;

use super::{fixtures, steady};
use crate::{STARTER, read};

/// Answers, and checks that the faults point into the text.
fn answers(text: &str) -> Result<(), TestCaseError> {
    let Err(errors) = read("scene.toml", text) else {
        return Ok(());
    };
    prop_assert!(!errors.errors.is_empty());
    prop_assert!(errors.to_string().starts_with("error: "));
    for error in &errors.errors {
        prop_assert!(text.get(error.span.clone()).is_some(), "{:?}", error.span);
        prop_assert!(error.line <= text.lines().count().max(1) + 1);
        prop_assert!(!error.message.to_string().contains('\n') && !error.label.to_string().contains('\n'));
    }
    Ok(())
}

/// A piece that a slip of the hand, or malice, puts into a scene.
fn piece() -> impl Strategy<Value = String> {
    prop_oneof![
        Just("nan".to_owned()),
        Just("-inf".to_owned()),
        Just("1e999".to_owned()),
        Just("[]".to_owned()),
        Just("[[]]".to_owned()),
        Just("{}".to_owned()),
        Just("\"\"".to_owned()),
        Just("\"\\u0000\"".to_owned()),
        Just("99999999999999999999999999".to_owned()),
        Just("0xffffffffffffffff".to_owned()),
        Just("1979-05-27".to_owned()),
        Just("true".to_owned()),
        Just("\u{b0}\t\u{4e2d}".to_owned()),
        "\\PC{0,6}",
        "[\\[\\]{}=,\"'.#\\n a-z0-9-]{0,8}",
    ]
}

/// Start and length, as parts of the whole, and what comes instead.
fn change() -> impl Strategy<Value = (f64, usize, String)> {
    (0.0..1.0_f64, 0..40_usize, piece())
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a place in a text of some kilobytes"
)]
fn changed(text: &str, changes: &[(f64, usize, String)]) -> String {
    let mut text: Vec<char> = text.chars().collect();
    for (place, length, piece) in changes {
        let start = (place * text.len() as f64) as usize;
        let end = (start + length).min(text.len());
        text.splice(start..end, piece.chars());
    }
    text.into_iter().collect()
}

/// The value of the `nth` key replaced: the syntax stays sound, so that the readers get it.
fn value_replaced(text: &str, nth: usize, piece: &str) -> String {
    let keys: Vec<usize> = text.match_indices(" = ").map(|found| found.0 + 3).collect();
    let start = keys[nth % keys.len()];
    let end = text[start..].find(['\n', ',', '}', ']']).map_or(text.len(), |end| start + end);
    format!("{}{piece}{}", &text[..start], &text[end..])
}

proptest! {
    #[test]
    fn changed_bytes(which in 0..64_usize, changes in prop::collection::vec(change(), 1..4)) {
        let all = fixtures();
        answers(&changed(&all[which % all.len()].1, &changes))?;
        answers(&changed(STARTER, &changes))?;
    }

    #[test]
    fn changed_values(which in 0..64_usize, nth in 0..500_usize, piece in piece()) {
        let all = fixtures();
        answers(&value_replaced(&all[which % all.len()].1, nth, &piece))?;
        answers(&value_replaced(&steady(), nth, &piece))?;
    }

    #[test]
    fn swapped_lines(which in 0..64_usize, a in 0..200_usize, b in 0..200_usize, copy in any::<bool>()) {
        let all = fixtures();
        let mut lines: Vec<&str> = all[which % all.len()].1.lines().collect();
        let (a, b) = (a % lines.len(), b % lines.len());
        if copy { lines.insert(a, lines[b]) } else { lines.swap(a, b) }
        answers(&lines.join("\n"))?;
    }

    #[test]
    fn anything(text in any::<String>()) {
        answers(&text)?;
    }
}

#[test]
fn deep_and_long_scenes() {
    let deep = format!("gravity = {}1{}", "[".repeat(5000), "]".repeat(5000));
    answers(&deep).unwrap();
    let tables = format!("[{}]\n", vec!["a"; 5000].join("."));
    answers(&tables).unwrap();
    let long = format!("title = 3 # {}", "x".repeat(100_000));
    let shown = read("scene.toml", &long).unwrap_err().to_string();
    assert!(shown.len() < 1100, "{}", shown.len());
}
