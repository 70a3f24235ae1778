//! Reactions by cause.

use super::Source;
use super::forces::shown;
use super::layout::{Column, Page};
use super::motion::{column, keys};
use super::units::{FORCE, MOMENT};
use assur_analysis::results::{ByCause, PairReaction, PositionResult};

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let positions = &source.analysis.positions;
    let Some((position, found)) =
        positions.iter().find_map(|position| Some((position, position.by_cause.as_ref()?)))
    else {
        return;
    };
    page.section("Reactions by cause");
    page.paragraph(
        "What each cause alone would do in the same position: projections and modulus of the force on the named link. \
         Projections sum to those of the whole; moduli do not.",
    );
    let causes: Vec<&str> = found.reactions_by_cause.iter().map(|(name, _)| name).collect();
    for (pair, (name, reaction)) in
        position.reactions.iter().flat_map(assur_analysis::results::Named::iter).enumerate()
    {
        for link in shown(source, reaction) {
            page.caption(&format!("{name} on {}", reaction.forces[link].0));
            let mut groups: Vec<_> = causes.iter().map(|cause| share(source, cause, pair, link)).collect();
            groups.push(whole(source, pair, link));
            page.table(&keys(source), groups);
        }
    }
    let unit = if source.analysis.input.balancing_is_moment { MOMENT } else { FORCE };
    page.caption("Balancing load");
    let mut columns: Vec<_> = causes
        .iter()
        .map(|cause| {
            let cause = (*cause).to_owned();
            column(source, &*cause.clone(), unit, move |p| {
                p.by_cause.as_ref()?.balancing_by_cause.get(&cause).copied()
            })
        })
        .collect();
    columns.push(column(source, "whole", unit, |p| p.balancing));
    page.table(&keys(source), columns.into_iter().map(|column| vec![column]).collect());
}

fn share(source: &Source<'_>, cause: &str, pair: usize, link: usize) -> Vec<Column> {
    let of = |found: &ByCause| {
        let (_, reaction) = found.reactions_by_cause.get(cause)?.0.get(pair)?;
        force(reaction, link)
    };
    three(source, cause, |p| of(p.by_cause.as_ref()?))
}

fn whole(source: &Source<'_>, pair: usize, link: usize) -> Vec<Column> {
    three(source, "whole", |p| force(&p.reactions.as_ref()?.0.get(pair)?.1, link))
}

fn force(reaction: &PairReaction, link: usize) -> Option<[f64; 2]> {
    reaction.forces.get(link).map(|(_, force)| *force)
}

/// Projections and modulus.
fn three(
    source: &Source<'_>,
    name: &str,
    force: impl Fn(&PositionResult) -> Option<[f64; 2]>,
) -> Vec<Column> {
    vec![
        column(source, format!("{name} Rx"), FORCE, |p| force(p).map(|f| f[0])),
        column(source, "Ry", FORCE, |p| force(p).map(|f| f[1])),
        column(source, "R", FORCE, |p| force(p).map(|f| f[0].hypot(f[1]))),
    ]
}
