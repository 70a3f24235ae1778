//! Structure: mobility, groups, the mechanism assembled group by group.

use assur_figure::mechanism::Drawing;
use assur_figure::{Figure, Panel};
use assur_group::Pair;
use assur_mechanism::LinkId;
use assur_structure::roman;

use super::Context;
use super::document::{Block, Term};
use crate::screen::view::mechanism;

/// Width of a figure and height of a row of its panels, mm.
const PANELS: [f64; 2] = [165.0, 78.0];
/// Panels beside each other, and in one figure.
const COLUMNS: usize = 2;
const MOST: usize = 6;

/// Heading, mobility, table of the groups, and the assembly of the mechanism.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let Some(scene) = &context.state.scene else { return Vec::new() };
    let structure = &scene.linkage.structure;
    let mobility = &structure.mobility;
    let values = [("links", mobility.moving_links.to_string()), ("pairs", mobility.pairs.to_string())];
    let formula = [
        ("formula", words.name(&structure.formula).replace("->", "→")),
        ("class", roman(structure.class()).to_owned()),
    ];
    let mut blocks = vec![
        Block::Heading(words.get("structure")),
        Block::Text(words.with("structure-text", &values)),
        Block::Equation(chebyshev(mobility.moving_links, mobility.pairs, &mobility.value.to_string())),
        Block::Text(words.with("structure-class", &formula)),
    ];
    let rows = groups(context);
    if !rows.is_empty() {
        let head = ["kind", "class-order", "links", "inner-pairs", "outer-pairs"].map(|id| words.get(id));
        blocks.push(Block::table(words, "groups", std::iter::once("№".to_owned()).chain(head), rows));
    }
    blocks.extend(assembly(context));
    blocks
}

/// W = 3 n - 2 p5.
fn chebyshev(links: usize, pairs: usize, value: &str) -> Vec<Term> {
    let name = |letter: &str, below: &str| Term::Name(letter.to_owned(), below.to_owned());
    let sign = |text: &str| Term::Sign(text.to_owned());
    let number = |text: &str| Term::Number(text.replace('-', "−"));
    vec![
        name("W", ""),
        sign(" = "),
        number("3"),
        name("n", ""),
        sign(" − "),
        number("2"),
        name("p", "5"),
        sign(" = "),
        number("3"),
        sign("·"),
        number(&links.to_string()),
        sign(" − "),
        number("2"),
        sign("·"),
        number(&pairs.to_string()),
        sign(" = "),
        number(value),
    ]
}

fn groups(context: &Context<'_>) -> Vec<Vec<String>> {
    let words = context.words;
    let Some(scene) = &context.state.scene else { return Vec::new() };
    let (mechanism, structure) = (&scene.linkage.mechanism, &scene.linkage.structure);
    let row = |(index, group): (usize, &assur_structure::Group)| {
        let links: Vec<_> =
            group.frame.links.iter().map(|link| mechanism.links[*link].name.as_str()).collect();
        let pairs = |pairs: &[Pair]| {
            let names = pairs.iter().map(|pair| words.name(structure.pair_name(mechanism, pair.id)));
            names.collect::<Vec<_>>().join(", ")
        };
        vec![
            (index + 1).to_string(),
            group.plugin.name.to_uppercase(),
            format!("{}, {}, {}", roman(group.class), group.plugin.number, group.order),
            links.join(", "),
            pairs(&group.frame.inner),
            pairs(&group.frame.outer),
        ]
    };
    structure.groups.iter().enumerate().map(row).collect()
}

/// The input link alone, then with the first group, with the second one, and so on; the new links are marked.
fn assembly(context: &Context<'_>) -> Vec<Block> {
    let (words, position) = (context.words, context.positions[0]);
    let Some(scene) = &context.state.scene else { return Vec::new() };
    let Some(pose) = &scene.poses[position] else { return Vec::new() };
    let linkage = &scene.linkage;
    let input = linkage.mechanism.input.link;
    let mut hidden: Vec<LinkId> = (1..linkage.mechanism.links.len()).filter(|link| *link != input).collect();
    let mut panel = |title: String, marked: &[LinkId]| {
        hidden.retain(|link| !marked.contains(link));
        let drawing = Drawing { hidden: &hidden, ..mechanism::drawing(scene, marked) };
        Panel { title: assur_words::name(title), ..mechanism::plane(scene, drawing.items(pose)) }
    };
    let named = |link: LinkId| ("link", linkage.mechanism.links[link].name.to_string());
    let mut panels = vec![panel(words.with("input-link-alone", &[named(input)]), &[input])];
    for (index, group) in linkage.structure.groups.iter().enumerate().take(MOST - 1) {
        let values = [("number", (index + 1).to_string()), ("kind", group.plugin.name.to_uppercase())];
        panels.push(panel(words.with("with-group", &values), &group.frame.links));
    }
    let columns = COLUMNS.min(panels.len());
    let figure = Figure { panels, columns, ..Figure::default() };
    let size = [PANELS[0], PANELS[1] * figure.rows() as f64];
    let caption = words.with("assembly", &[("place", context.place(position))]);
    vec![Block::picture(figure, size, caption)]
}
