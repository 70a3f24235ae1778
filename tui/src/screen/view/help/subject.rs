//! What the help tells of something that is chosen, and what it tells of groups.

use assur_book::glossary::{self, Entry};
use assur_group::{GroupPlugin, Pair};
use assur_words::{Text, list, text};

use crate::screen::state::Scene;

/// The words that a group is about.
pub(super) const OF_GROUP: [&str; 4] = ["word-group", "word-class", "word-determinant", "word-transmission"];

/// What is told of something: its name, lines of its own, and the words of the field that it is about.
#[derive(Debug)]
pub(super) struct Chosen {
    pub(super) title: Text,
    pub(super) lines: Vec<Text>,
    pub(super) words: Vec<&'static Entry>,
}

/// A group: what its kind is, its pairs, its angle, where it is singular, and the source of its formulas.
pub(super) fn group(scene: &Scene, index: usize) -> Option<Chosen> {
    let linkage = &scene.linkage;
    let (structure, mechanism) = (&linkage.structure, &linkage.mechanism);
    let group = structure.groups.get(index)?;
    let pairs =
        |pairs: &[Pair]| list(pairs.iter().map(|pair| Text::from(structure.pair_name(mechanism, pair.id))));
    let pairs = [
        text!("structure-inner", pairs = pairs(&group.frame.inner)),
        text!("structure-outer", pairs = pairs(&group.outer())),
    ];
    let lines = of_kind(group.plugin, pairs);
    Some(Chosen { title: structure.group_name(mechanism, index), lines, words: entries(&OF_GROUP) })
}

/// The angle that shows how well a kind of group transmits forces, and the source of its formulas.
pub(super) fn angle_and_source(plugin: &GroupPlugin) -> [Text; 2] {
    [
        text!("structure-angle", angle = &plugin.force_angle.words),
        text!("structure-source", source = &plugin.source),
    ]
}

/// What a kind of group is, with its pairs, its angle, where it is singular, and the source of its formulas.
pub(super) fn of_kind(plugin: &GroupPlugin, [inner, outer]: [Text; 2]) -> Vec<Text> {
    let [angle, source] = angle_and_source(plugin);
    let singular = text!("structure-singular", places = &plugin.singular);
    vec![plugin.summary.clone(), inner, outer, angle, singular, source]
}

/// The words of these identities.
pub(super) fn entries(ids: &[&str]) -> Vec<&'static Entry> {
    ids.iter().filter_map(|id| glossary::find(id)).collect()
}
