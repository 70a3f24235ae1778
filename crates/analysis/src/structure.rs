//! Mobility, groups and formula as results show them.

use crate::results::{GroupReport, StructureReport};
use assur_group::{Order, Pair};
use assur_kinematics::{Linkage, mobility_in};

pub(crate) fn report(linkage: &Linkage, whole: bool) -> StructureReport {
    let structure = &linkage.structure;
    let by_rank = if whole { rank(linkage) } else { None };
    StructureReport {
        mobility: structure.mobility.value,
        mobility_by_rank: by_rank,
        note: by_rank.and_then(|found| note(structure.mobility.value, found)),
        class: structure.class(),
        formula: structure.formula.clone(),
        moving_links: structure.mobility.moving_links,
        pairs: structure.mobility.pairs,
        groups: (0..structure.groups.len()).map(|index| group(linkage, index)).collect(),
    }
}

fn rank(linkage: &Linkage) -> Option<usize> {
    let mut position = linkage.position();
    linkage.solve_index(0, Order::Place, &mut position).ok()?;
    Some(mobility_in(linkage, &position))
}

fn note(counted: i64, found: usize) -> Option<String> {
    if i64::try_from(found) == Ok(counted) {
        return None;
    }
    Some(format!(
        "Chebyshev's formula counts mobility {counted}, but in the first position the constraints leave {found}: it is a \
         singular position (links in one line, or parallel guides), or some constraints repeat others there"
    ))
}

fn group(linkage: &Linkage, index: usize) -> GroupReport {
    let (mechanism, structure) = (&linkage.mechanism, &linkage.structure);
    let found = &structure.groups[index];
    let pairs = |list: &[Pair]| {
        list.iter().map(|pair| structure.pair_name(mechanism, pair.id).to_owned()).collect::<Vec<_>>()
    };
    GroupReport {
        kind: found.plugin.kind.to_owned(),
        class: found.class,
        number: found.plugin.number,
        order: found.order,
        links: found.frame.links.iter().map(|&link| mechanism.links[link].name.clone()).collect(),
        inner: pairs(&found.frame.inner),
        outer: pairs(&found.outer()),
        way: linkage.ways.at(mechanism.input.from)[index],
        ways: linkage.groups()[index].ways(),
    }
}
