//! Structure: mobility, groups, and each group in the drawing.

use super::Context;
use super::document::Block;
use super::task::MECHANISM;
use crate::screen::state::View;

/// Heading, mobility, formula, table of groups, each group marked.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let Some(scene) = &context.state.scene else { return Vec::new() };
    let linkage = scene.linkage.clone();
    let (structure, mechanism) = (&linkage.structure, &linkage.mechanism);
    let w = &structure.mobility;
    let values = [("links", w.moving_links.to_string()), ("pairs", w.pairs.to_string())];
    let class = assur_structure::roman(structure.class()).to_string();
    let mut blocks = vec![
        Block::Heading(words.get("structure")),
        Block::Text(words.with("structure-text", &values)),
        Block::Equation(format!(
            "<i>W</i> = 3<i>n</i> − 2<i>p</i><sub>5</sub> = 3·{} − 2·{} = {}",
            w.moving_links, w.pairs, w.value
        )),
        Block::Text(
            words.with("structure-class", &[("formula", structure.formula.clone()), ("class", class)]),
        ),
    ];
    let mut rows = Vec::new();
    for (index, group) in structure.groups.iter().enumerate() {
        let links: Vec<&str> =
            group.frame.links.iter().map(|link| mechanism.links[*link].name.as_str()).collect();
        let pairs = |pairs: &[assur_group::Pair]| {
            let names: Vec<&str> = pairs.iter().map(|pair| structure.pair_name(mechanism, pair.id)).collect();
            names.join(", ")
        };
        let class = assur_structure::roman(group.class);
        rows.push(vec![
            (index + 1).to_string(),
            group.plugin.name.to_uppercase(),
            format!("{class}, {}, {}", group.plugin.number, group.order),
            links.join(", "),
            pairs(&group.frame.inner),
            pairs(&group.frame.outer),
        ]);
    }
    let head = ["kind", "class-order", "links", "inner-pairs", "outer-pairs"].map(|id| words.get(id));
    let head = std::iter::once("№".to_owned()).chain(head);
    if !rows.is_empty() {
        blocks.push(Block::table(words, "groups", head, rows.clone()));
    }
    let position = context.positions[0];
    for (index, row) in rows.iter().enumerate() {
        let values = [("number", row[0].clone()), ("kind", row[1].clone()), ("links", row[3].clone())];
        let caption = words.with("group-marked", &values);
        blocks.extend(context.picture(
            View::Structure,
            position,
            MECHANISM,
            |_, _| caption,
            |state| state.chosen.group = index,
        ));
    }
    blocks
}
