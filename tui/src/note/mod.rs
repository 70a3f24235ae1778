//! The explanatory note: what was calculated, with its figures and tables, as HTML, Markdown or Typst.
//!
//! [`write`] collects blocks (`document`) from the state of a scene, in the words of a language, and writes
//! them in a form (`html`, `markdown`, `typst`). Its figures are those of the views; its numbers are those of the results.

mod document;
mod dynamics;
mod forces;
mod formula;
mod html;
mod kinematics;
mod loads;
mod markdown;
mod structure;
mod task;
#[cfg(test)]
mod tests;
mod typst;

use assur_analysis::results::{Analysis, Failure};
use assur_book::Fact;
use assur_figure::Figure;
use assur_kinematics::Position;
use assur_report::topic::summary;
use assur_scene::Note;
use assur_words::Language;
use document::{Block, Cover};

use crate::screen::state::{State, View};
use crate::words::Words;

/// Most positions times parts of the mechanism in a note, whose figures and texts are all in memory: with eight times as many
/// they took 4 GB.
const MOST_PARTS: usize = 100_000;

/// The form of a note.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// One file with its figures, for reading and printing.
    Html,
    /// A text for editing, its figures in files beside it.
    Markdown,
    /// One file with its figures, for editing and typesetting.
    Typst,
}

impl Form {
    /// The form that the ending of a file name chooses.
    pub(crate) fn of(ending: &str) -> Option<Self> {
        let forms = [("html", Self::Html), ("md", Self::Markdown), ("typ", Self::Typst)];
        forms.into_iter().find(|(name, _)| ending.eq_ignore_ascii_case(name)).map(|(_, form)| form)
    }
}

/// A note in one form.
#[derive(Debug)]
pub(crate) struct Written {
    pub(crate) text: String,
    /// Names and contents of the files of its figures, where they are not in the text.
    pub(crate) figures: Vec<(String, String)>,
}

/// What every part of the note is made from.
struct Context<'a> {
    state: &'a mut State,
    words: &'a Words,
    /// Numbers of the positions that are drawn and worked out, at least one.
    positions: &'a [usize],
}

impl Context<'_> {
    /// The figures of a view in the chosen positions, beside each other.
    fn beside(&mut self, shown: View, set: impl Fn(&mut State)) -> Option<Figure> {
        let mut whole: Option<Figure> = None;
        for &position in self.positions {
            let Some((mut figure, _)) = self.figure(shown, position, &set) else { continue };
            let place = self.state.scene.as_ref().map(|scene| scene.place(position)).unwrap_or_default();
            let bare = figure.panels.iter_mut().filter(|panel| panel.title.is_empty());
            bare.for_each(|panel| panel.title.clone_from(&place));
            match &mut whole {
                Some(whole) => whole.panels.extend(figure.panels),
                None => whole = Some(figure),
            }
        }
        whole.map(|figure| Figure { columns: figure.panels.len().clamp(1, 2), ..figure })
    }

    /// The chosen positions in words.
    fn places(&self) -> String {
        let places: Vec<String> = self.positions.iter().map(|position| self.place(*position)).collect();
        places.join("; ")
    }
}

/// The note of a scene whose analysis is done, in a form; `folder` is where the files of figures are, seen from the note.
///
/// # Errors
///
/// Why a position has no working, or that there are too many; in words.
pub(crate) fn write(state: &mut State, note: &Note, form: Form, folder: &str) -> Result<Written, String> {
    let words = Words::of(note.language);
    let Some(scene) = &state.scene else { return Err("there is no scene".to_owned()) };
    let parts = scene.linkage.mechanism.parts();
    if scene.positions() * parts > MOST_PARTS {
        return Err(format!(
            "a note shows at most {} positions of a scene of {parts} links, points, slides and loads, and this one has {}; \
             lower `positions` in [input]",
            MOST_PARTS / parts,
            scene.positions()
        ));
    }
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
    let blocks = blocks(&mut Context { state, words, positions: &positions })?;
    Ok(match form {
        Form::Html => Written { text: html::write(&cover, &blocks, words), figures: Vec::new() },
        Form::Markdown => markdown::write(&cover, &blocks, words, folder),
        Form::Typst => Written { text: typst::write(&cover, &blocks, words), figures: Vec::new() },
    })
}

fn blocks(context: &mut Context<'_>) -> Result<Vec<Block>, String> {
    let mut blocks = main_results(context);
    for part in [task::blocks, structure::blocks, kinematics::blocks, forces::blocks, dynamics::blocks] {
        blocks.extend(part(context));
    }
    blocks.extend(formula::blocks(context)?);
    blocks.extend(checks(context));
    blocks.extend(limits(context));
    Ok(blocks)
}

/// Every check with its residual.
fn checks(context: &Context<'_>) -> Vec<Block> {
    let words = context.words;
    let Some(found) = context.state.found().filter(|found| !found.analysis.checks.is_empty()) else {
        return Vec::new();
    };
    let rows = found.analysis.checks.iter().map(|check| {
        let verdict = match check.verdict() {
            Some(false) => "failed",
            Some(true) => "ok",
            None => "not-judged",
        };
        let size =
            |size: f64| if size == 0.0 { "0".to_owned() } else { words.number(&format!("{size:.1e}")) };
        vec![words.phrase(check.name), size(check.residual), size(check.limit), words.get(verdict)]
    });
    let head = ["check", "residual", "limit", "verdict"].map(|id| words.get(id));
    vec![
        Block::Heading(words.get("checks")),
        Block::Text(words.get("checks-text")),
        Block::table(words, "checks", head, rows.collect()),
    ]
}

/// What is not modelled, and what could not be found.
fn limits(context: &Context<'_>) -> Vec<Block> {
    let words = context.words;
    let mut blocks = vec![Block::Heading(words.get("model")), Block::Text(words.get("model-text"))];
    let notes = context.state.found().map(|found| found.analysis.notes.as_slice()).unwrap_or_default();
    blocks.extend(notes.iter().map(|note| Block::Text(words.phrase(note))));
    let poses = context.state.scene.as_ref().map(|scene| scene.poses.as_slice()).unwrap_or_default();
    let missing = poses.iter().enumerate().filter(|(_, pose)| pose.is_none());
    let failed: Vec<String> = missing.map(|(position, _)| position.to_string()).collect();
    if !failed.is_empty() {
        blocks.push(Block::Text(words.with("no-position", &[("positions", failed.join(", "))])));
    }
    if let Some(found) = context.state.found() {
        blocks.extend(lost(&found.analysis, poses, words));
    }
    blocks
}

/// The positions that have a place but no forces, and the motion that is not found, each with the reason.
fn lost(analysis: &Analysis, poses: &[Option<Position>], words: &Words) -> Vec<Block> {
    let placed = |failure: &&Failure| poses.get(failure.index).is_some_and(Option::is_some);
    let failures: Vec<&Failure> = analysis.failures.iter().filter(placed).collect();
    let positions: Vec<String> = failures.iter().map(|failure| failure.index.to_string()).collect();
    let forces = failures.first().map(|first| {
        let values = [("positions", positions.join(", ")), ("reason", words.phrase(&first.message))];
        Block::Text(words.with("no-forces", &values))
    });
    let motion = analysis.no_motion.as_ref().map(|why| Block::Text(words.phrase(why)));
    forces.into_iter().chain(motion).collect()
}

/// Heading and table of the main results; nothing without an analysis.
fn main_results(context: &Context<'_>) -> Vec<Block> {
    let words = context.words;
    let (Some(scene), Some(found)) = (&context.state.scene, context.state.found()) else { return Vec::new() };
    let language = Language::find(words.language).unwrap_or(Language::english());
    let row = |one: Fact| {
        let value = one.value().render(language).replace("->", "→");
        vec![one.what().render(language), value, words.unit(one.unit.name), one.place().render(language)]
    };
    let rows = summary(&found.analysis, &scene.linkage).into_iter().map(row).collect();
    let head = ["quantity", "value", "unit", "at"].map(|id| words.get(id));
    vec![Block::Heading(words.get("results")), Block::table(words, "main-results", head, rows)]
}
