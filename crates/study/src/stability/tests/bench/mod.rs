//! The fixed bench: mechanisms and motions that come close to failure.

mod closed;
mod jet;
mod machines;
mod motion;
mod passing;
mod places;

use super::Section;

/// Turns of a motion without a moment, whose energy must not drift: those of the page.
pub(super) const MOST_TURNS: f64 = 1e4;

/// Every walk of the bench, with motions of so many turns at most.
pub(super) fn sections(most_turns: f64) -> Vec<Section> {
    let mut sections = vec![Section { law: &passing::LAW, rows: passing::rows() }];
    sections.extend(places::sections());
    sections.push(Section { law: &motion::LAW, rows: motion::rows(most_turns) });
    sections.push(Section { law: &machines::LAW, rows: machines::rows() });
    sections
}

/// Every mechanism of the bench by its name.
fn names() -> Vec<&'static str> {
    let known = closed::KNOWN.iter().map(|known| known.name);
    known.chain(places::approaches().iter().map(|approach| approach.name)).collect()
}

/// Every row of the bench keeps its bound; and each of its mechanisms has rows, so that none is left out because it does not
/// compile.
#[test]
fn the_bench_keeps_its_bounds() {
    // Ten thousand turns take their time without optimization.
    let sections = sections(100.0);
    let empty = sections.iter().find(|section| section.rows.is_empty());
    assert!(empty.is_none(), "{:?}", empty.map(|section| section.law));
    let rows: Vec<_> = sections.iter().flat_map(|section| &section.rows).collect();
    for name in names() {
        let count = rows.iter().filter(|row| row.finding.place.to_string().starts_with(name)).count();
        assert!(count >= 15, "{name}: {count} rows");
    }
    let failed: Vec<_> = rows.iter().filter(|row| row.finding.failed()).collect();
    assert!(failed.is_empty(), "{} of {}: {:?}", failed.len(), rows.len(), failed[0]);
    assert!(rows.len() > 6000, "{}", rows.len());
}
