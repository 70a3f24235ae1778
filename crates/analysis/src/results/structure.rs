//! Mobility, groups and formula as results show them.

use assur_group::{Mode, Order, Pair};
use assur_kinematics::{Linkage, Misfit, Modes, Position, mobility_in};
use assur_mechanism::{LinkId, Name, Named, PairId, Point};
use assur_words::{Text, number, text};
use indexmap::IndexMap;
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
    /// What repeats constraints of others, in the order in which it was left out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub passive: Vec<Misfit>,
}

/// One group.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
    pub links: Vec<Named<LinkId>>,
    /// Pairs between its links.
    pub inner: Vec<Named<PairId>>,
    /// Pairs to links solved before.
    pub outer: Vec<Named<PairId>>,
    /// Pairs between its links that are driven, so that both links are one of the kind.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub driven: Vec<Named<PairId>>,
    /// Of several inputs those that determine its motion; empty otherwise.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<Name>,
    /// The assembly mode in the first position, counted as the kind documents; `None` where the kind can't list them, or the first
    /// position can't be assembled. Results call it `way`.
    #[serde(rename = "way")]
    pub mode: Option<usize>,
    /// How many modes there are in the first position; results call it `ways`.
    #[serde(rename = "ways")]
    pub mode_count: Option<usize>,
    /// All of them, in the first position.
    pub modes: Option<Vec<ModeReport>>,
}

/// One real assembly of a group.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModeReport {
    /// Its number, from 0; results call it `way`.
    #[serde(rename = "way")]
    pub mode: usize,
    /// Places of the points of the group's links but the outer pins, m.
    pub points: IndexMap<String, [f64; 2]>,
    /// 1 / determinant: how near it is to a singular position; `None` in one.
    pub condition: Option<f64>,
}

pub(crate) fn report(linkage: &Linkage, whole: bool) -> StructureReport {
    let structure = &linkage.structure;
    let mut position = linkage.position();
    let first = linkage.solve_index(0, Order::Place, &mut position).is_ok().then_some(&position);
    let by_rank = first.filter(|_| whole).map(|position| mobility_in(linkage, position));
    StructureReport {
        mobility: structure.mobility.value,
        mobility_by_rank: by_rank,
        note: by_rank.and_then(|found| note(structure.mobility.value, found)),
        class: structure.class(),
        formula: structure.formula.clone(),
        moving_links: structure.mobility.moving_links,
        pairs: structure.mobility.pairs,
        groups: groups(linkage, first),
        passive: linkage.misfits.clone(),
    }
}

fn note(counted: i64, found: usize) -> Option<Text> {
    if i64::try_from(found) == Ok(counted) || counted < 1 && found == 1 {
        return None;
    }
    Some(text!("analysis-other-mobility", counted = number(counted), found))
}

/// All groups, with their modes in the first position.
fn groups(linkage: &Linkage, first: Option<&Position>) -> Vec<GroupReport> {
    let modes = |index: usize| {
        let position = first.filter(|_| linkage.chain.needed[index])?;
        linkage.modes(index, position).ok().flatten()
    };
    (0..linkage.structure.groups.len()).map(|index| group(linkage, index, modes(index))).collect()
}

/// The points of a group's links but its outer pins, with their places in a mode, m.
fn points(linkage: &Linkage, index: usize, mode: &Mode<f64>) -> IndexMap<String, [f64; 2]> {
    let (mechanism, frame) = (&linkage.mechanism, &linkage.structure.groups[index].frame);
    let is_outer =
        |point: &Point| point.is_pin() && point.places.iter().any(|place| frame.column(place.link).is_none());
    let placed = |point: &Point| {
        let of = point.places.iter().find_map(|place| Some((frame.column(place.link)?, place.at)))?;
        Some((point.name.to_string(), mode.bodies[of.0].point(of.1)))
    };
    mechanism.points.iter().filter(|point| !is_outer(point)).filter_map(placed).collect()
}

fn group(linkage: &Linkage, index: usize, modes: Option<Modes>) -> GroupReport {
    let (mechanism, structure) = (&linkage.mechanism, &linkage.structure);
    let found = &structure.groups[index];
    let pair = |pair: &Pair| mechanism.named_pair(structure.pairs[pair.id].source);
    GroupReport {
        kind: found.plugin.kind.to_owned(),
        class: found.class,
        number: found.plugin.number,
        order: found.order,
        links: found.frame.links.iter().map(|&link| mechanism.named_link(link)).collect(),
        inner: found.frame.inner.iter().map(pair).collect(),
        outer: found.outer().iter().map(pair).collect(),
        driven: found.frame.driven.iter().map(|driven| pair(&driven.pair)).collect(),
        inputs: linkage
            .drives_of(index)
            .into_iter()
            .filter(|_| mechanism.input.is_list)
            .map(|drive| mechanism.input.drivers[drive].label.clone())
            .collect(),
        mode: modes.as_ref().filter(|modes| !modes.all.is_empty()).map(|modes| modes.number(modes.present)),
        mode_count: modes.as_ref().map(|modes| modes.all.len()),
        modes: modes.map(|modes| {
            let told = |(number, mode): (usize, &Mode<f64>)| ModeReport {
                mode: modes.number(number),
                points: points(linkage, index, mode),
                condition: (mode.health > f64::MIN_POSITIVE).then(|| 1.0 / mode.health),
            };
            modes.all.iter().enumerate().map(told).collect()
        }),
    }
}
