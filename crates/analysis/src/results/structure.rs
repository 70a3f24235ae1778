//! Mobility, groups and formula as results show them.

use assur_group::{Order, Pair};
use assur_kinematics::{Linkage, mobility_in};
use assur_mechanism::Name;
use assur_words::{Text, number, text};
use serde::Serialize;

/// Mobility, groups and formula.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StructureReport {
    /// Mobility by Chebyshev's formula.
    pub mobility: i64,
    /// Mobility by the rank of the constraints in the first position, where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mobility_by_rank: Option<usize>,
    /// What a difference of the two means, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<Text>,
    /// Class of the mechanism.
    pub class: u8,
    /// `I(ground,crank) -> II3(stone2,rocker)`.
    pub formula: Name,
    /// Number of moving links.
    pub moving_links: usize,
    /// Number of pairs (a joint of k links counts k - 1).
    pub pairs: usize,
    /// The groups in solving order.
    pub groups: Vec<GroupReport>,
}

/// One group.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct GroupReport {
    /// The registered kind: `RPR`.
    pub kind: String,
    /// Class.
    pub class: u8,
    /// Type within the class; 0 where the class has no numbered types.
    #[serde(rename = "type")]
    pub number: u8,
    /// Order.
    pub order: u8,
    /// Its links.
    pub links: Vec<String>,
    /// Pairs between its links.
    pub inner: Vec<String>,
    /// Pairs to links solved before.
    pub outer: Vec<String>,
    /// The assembly in the first position, counted as the kind documents.
    pub way: u8,
    /// In how many ways it can be assembled.
    pub ways: usize,
}

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

fn note(counted: i64, found: usize) -> Option<Text> {
    if i64::try_from(found) == Ok(counted) {
        return None;
    }
    Some(text!("analysis-other-mobility", counted = number(counted), found = found))
}

fn group(linkage: &Linkage, index: usize) -> GroupReport {
    let (mechanism, structure) = (&linkage.mechanism, &linkage.structure);
    let found = &structure.groups[index];
    let pairs = |list: &[Pair]| {
        list.iter().map(|pair| structure.pair_name(mechanism, pair.id).to_string()).collect::<Vec<_>>()
    };
    GroupReport {
        kind: found.plugin.kind.to_owned(),
        class: found.class,
        number: found.plugin.number,
        order: found.order,
        links: found.frame.links.iter().map(|&link| mechanism.links[link].name.to_string()).collect(),
        inner: pairs(&found.frame.inner),
        outer: pairs(&found.outer()),
        way: linkage.ways.at(mechanism.input.from)[index],
        ways: linkage.groups()[index].ways(),
    }
}
