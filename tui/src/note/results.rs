//! The first page: what is asked for first.

use assur_report::text::{Finding, summary};

use super::Context;
use super::document::Block;

/// Heading and table of the main results; nothing without an analysis.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let (Some(scene), Some(found)) = (&context.state.scene, context.state.found()) else { return Vec::new() };
    let row = |one: Finding| {
        let is_number = one.value.parse::<f64>().is_ok();
        let value =
            if is_number { words.number(&one.value) } else { words.name(&one.value).replace("->", "→") };
        vec![words.phrase(&one.what), value, words.unit(one.unit), words.phrase(&one.at)]
    };
    let rows = summary(&found.analysis, &scene.linkage).into_iter().map(row).collect();
    let head = ["quantity", "value", "unit", "at"].map(|id| words.get(id));
    vec![Block::Heading(words.get("results")), Block::table(words, "main-results", head, rows)]
}
