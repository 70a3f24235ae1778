//! The explanatory note: what was calculated, with its figures and tables, as one HTML file.
//!
//! [`write`] collects blocks (`document`) from the state of a scene, in the words of a language (`words`), and writes
//! them (`html`). Its figures are those of the views; its numbers are those of the results.

mod document;
mod dynamics;
mod forces;
mod formula;
mod html;
mod kinematics;
mod structure;
mod task;
mod words;

#[cfg(test)]
mod tests;

use assur_scene::Note;

use crate::screen::state::State;
use document::{Block, Cover};
use words::Words;

/// What every part of the note is made from.
struct Context<'a> {
    state: &'a mut State,
    words: &'a Words,
    /// Numbers of the positions that are drawn and worked out.
    positions: &'a [usize],
}

/// The note of a scene whose analysis is done.
///
/// # Errors
///
/// The language resources or the working of a position; in words.
pub(crate) fn write(state: &mut State, note: &Note) -> Result<String, String> {
    let words = Words::of(note.language)?;
    let Some(scene) = &state.scene else { return Err("there is no scene".to_owned()) };
    let cover = Cover::of(&scene.linkage.mechanism.title, note);
    let exists = |position: &usize| scene.poses.get(*position).is_some_and(Option::is_some);
    let count = scene.positions();
    // Two positions in different parts of the cycle, unless the scene chooses.
    let chosen =
        if note.positions.is_empty() { vec![count / 8, 5 * count / 8] } else { note.positions.clone() };
    let mut positions: Vec<usize> = chosen.into_iter().filter(exists).collect();
    if positions.is_empty() {
        positions.push(scene.first_position());
    }
    positions.dedup();
    let mut context = Context { state, words: &words, positions: &positions };
    let mut blocks = task::blocks(&mut context);
    blocks.extend(structure::blocks(&mut context));
    blocks.extend(kinematics::blocks(&mut context));
    blocks.extend(forces::blocks(&mut context));
    blocks.extend(dynamics::blocks(&mut context));
    blocks.extend(formula::blocks(&mut context)?);
    blocks.extend(checks(&context));
    Ok(html::write(&cover, &blocks, &words))
}

/// Every check, and what is not modelled.
fn checks(context: &Context<'_>) -> Vec<Block> {
    let words = context.words;
    let mut blocks = Vec::new();
    let found = context.state.found().filter(|found| !found.analysis.checks.is_empty());
    if let Some(found) = found {
        let rows = found.analysis.checks.iter().map(|check| {
            let verdict = match (check.failed(), check.judged) {
                (true, _) => words.get("failed"),
                (false, true) => words.get("ok"),
                (false, false) => words.get("not-judged"),
            };
            let [residual, limit] =
                [check.residual, check.limit].map(|size| words.number(&format!("{size:.2e}")));
            vec![check.name.to_owned(), residual, limit, verdict]
        });
        let rows = rows.collect();
        blocks.push(Block::Heading(words.get("checks")));
        blocks.push(Block::Text(words.get("checks-text")));
        blocks.push(Block::table(
            words,
            "checks",
            ["check", "residual", "limit", "verdict"].map(|id| words.get(id)),
            rows,
        ));
    }
    blocks.push(Block::Heading(words.get("model")));
    blocks.push(Block::Text(words.get("model-text")));
    if let Some(scene) = &context.state.scene {
        let gaps: Vec<String> = (0..scene.positions())
            .filter(|position| scene.poses[*position].is_none())
            .map(|position| position.to_string())
            .collect();
        if !gaps.is_empty() {
            blocks.push(Block::Text(words.with("no-position", &[("positions", gaps.join(", "))])));
        }
    }
    blocks
}
