//! The working of a position as equations.

use assur_words::{Describe, Language};
use assur_working::WorkingError;
use assur_worksheet::{Entry, Term as Part};

use super::Context;
use super::document::{Block, Term};

/// The equations of the first chosen position.
pub(super) fn blocks(context: &mut Context<'_>) -> Result<Vec<Block>, String> {
    let words = context.words;
    let language = Language::find(words.language).unwrap_or_else(Language::english);
    let (Some(found), Some(&position)) = (context.state.found(), context.positions.first()) else {
        return Ok(Vec::new());
    };
    let plans = found.plans.at(position);
    let mut blocks = vec![Block::Heading(words.with("working", &[("position", position.to_string())]))];
    let sections = match plans.working() {
        Ok(sections) => sections,
        Err(error @ WorkingError::Load { .. }) => {
            blocks.push(Block::Text(error.describe().render(language)));
            return Ok(blocks);
        }
        Err(error) => return Err(error.to_string()),
    };
    // The first section repeats title and structure.
    for section in sections.iter().skip(1) {
        blocks.push(Block::Subheading(section.title.render(language)));
        blocks.extend(section.entries.iter().map(|entry| match entry {
            Entry::Note(text) => Block::Text(text.render(language)),
            equation => Block::Equation(terms(equation, language)),
        }));
    }
    Ok(blocks)
}

/// An equation with the signs of print.
fn terms(equation: &Entry, language: &Language) -> Vec<Term> {
    let term = |part: &Part| match part {
        Part::Symbol(symbol) => {
            Term::Name(symbol.letter().render(language), symbol.subscript().render(language))
        }
        Part::Function("sqrt") => Term::Function("√".to_owned()),
        Part::Function(name) => Term::Function((*name).to_owned()),
        Part::Number(_) => Term::Number(part.text().render(language)),
        Part::Sign(sign) => Term::Sign(sign.replace('*', "·").replace('-', "−")),
        Part::Comma => Term::Sign(part.text().render(language)),
        Part::Square => Term::Power("2".to_owned()),
        Part::Unit(unit) => Term::Unit(assur_words::unit(*unit).render(language)),
    };
    let sides = equation.sides();
    let sides: Vec<Vec<Term>> = sides.iter().map(|side| side.iter().map(term).collect()).collect();
    sides.join(&Term::Sign(" = ".to_owned()))
}
