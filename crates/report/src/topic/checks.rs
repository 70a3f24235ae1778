//! The checks of the numbers.

use assur_analysis::results::{Check, verdict};
use assur_book::{Column, Digits, Document, Table};
use assur_words::{Text, list, number, text};

/// The checks, one row each: name, largest residual, where, limit, whether it holds, or that nothing could be checked;
/// below, how many positions were checked where not all were, and in which of them checks were not possible, and why.
pub fn checks(checks: &[Check], page: &mut Document) {
    let size = |head| Column::of(head).with(Digits::Exponent);
    let place = |check: &Check| {
        let place = &check.finding.place;
        (!place.is_empty()).then(|| place.clone())
    };
    let table = Table::each(Text::default(), checks)
        .column(text!("head-check"), |check| check.name.clone())
        .add(size(text!("head-residual")), |check| check.finding.error)
        .column(text!("head-position"), |check| check.at.map(number))
        .column(text!("head-place"), |check| place(check))
        .add(size(text!("head-limit")), |check| check.finding.bound)
        .column(text!("head-result"), |check| verdict(check.finding.holds));
    page.table(table.table());
    sampled(checks).into_iter().chain(not_judged(checks)).for_each(|line| page.paragraph(line));
}

/// Of how many positions a sample was checked: one sentence for the checks that have it in common.
fn sampled(checks: &[Check]) -> Vec<Text> {
    let sentence = |([checked, of], names): ([usize; 2], Vec<Text>)| {
        text!(
            "report-checked-in",
            checked = number(checked),
            of = number(thousands(of)),
            checks = list(names)
        )
    };
    alike(checks, |check| check.sample).into_iter().map(sentence).collect()
}

/// The names of the checks that have something in common, with what that is.
fn alike<T: PartialEq>(checks: &[Check], common: impl Fn(&Check) -> Option<T>) -> Vec<(T, Vec<Text>)> {
    let mut kinds: Vec<(T, Vec<Text>)> = Vec::new();
    for (check, common) in checks.iter().filter_map(|check| Some((check, common(check)?))) {
        match kinds.iter_mut().find(|kind| kind.0 == common) {
            Some((_, names)) => names.push(check.name.clone()),
            None => kinds.push((common, vec![check.name.clone()])),
        }
    }
    kinds
}

/// A number with a comma after every third digit: 1,000,000.
fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let from_the_end = digits.chars().rev().enumerate();
    let grouped =
        from_the_end.flat_map(|(i, digit)| (i > 0 && i % 3 == 0).then_some(',').into_iter().chain([digit]));
    grouped.collect::<String>().chars().rev().collect()
}

/// In how many positions which checks were not possible, and why: one sentence for those that have both in common.
fn not_judged(checks: &[Check]) -> Vec<Text> {
    let common = |check: &Check| (check.left_out > 0).then(|| (check.left_out, check.finding.why.clone()));
    let sentence = |((count, why), names): ((usize, Text), Vec<Text>)| {
        text!("report-not-judged-in", count, checks = list(names), reason = why)
    };
    let alone = checks.iter().filter(|check| check.finding.holds.is_none() && check.left_out == 0);
    let alone = alone.map(|check| {
        text!("report-not-judged", check = check.name.clone(), reason = check.finding.why.clone())
    });
    alike(checks, common).into_iter().map(sentence).chain(alone).collect()
}
