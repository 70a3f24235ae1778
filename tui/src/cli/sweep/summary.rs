//! What a sweep was, in one line on standard error.

use assur_sweep::{Status, Sweep, Tally};
use assur_words::{Describe, Text, joined, list, number, quantity, text};
use strum::VariantArray;

use crate::cli::style::Style;

/// Tells points, how they ended, rows that conditions left out, and the time, s.
pub(super) fn tell(tally: &Tally, time: f64, sweep: &Sweep, style: Style) {
    let counted = |count: usize, what: Text| joined(" ", [number(count), what]);
    let of = |status: &Status| (tally.count(*status), status.describe());
    let by_status = Status::VARIANTS.iter().map(of);
    let unknown = (tally.unknown, text!("cli-sweep-earlier"));
    let outcomes = by_status.chain([unknown]).filter(|(count, _)| *count > 0);
    let outcomes = list(outcomes.map(|(count, what)| counted(count, what)));
    let points = number(tally.points());
    let seconds = quantity((time * 100.0).round() / 100.0, "s");
    style.tell(if sweep.has_conditions() {
        let left = tally.points() - tally.written;
        let [written, left] = [tally.written, left].map(number);
        text!("cli-sweep-summary-where", points, seconds, outcomes, written, left)
    } else {
        text!("cli-sweep-summary", points, seconds, outcomes)
    });
}
