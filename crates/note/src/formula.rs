//! The working of a position as equations.

use assur_book::{Block, Document, Term};
use assur_words::{Describe, Text, number, text};
use assur_working::WorkingError;
use assur_worksheet::{Entry, Section};

use super::context::Context;
use crate::working;

pub(super) fn working(context: &Context<'_>, page: &mut Document) -> Result<(), Text> {
    let position = context.positions[0];
    let working = working::of_position(context.found.plans.calculation(), position);
    page.heading(text!("note-working", position = number(position)));
    let sections = match working {
        Ok(working) => working.sections,
        Err(error @ (WorkingError::Load { .. } | WorkingError::OverTime)) => {
            page.paragraph(error.describe());
            return Ok(());
        }
        Err(error) => return Err(error.describe()),
    };
    // The first section repeats title and structure.
    sections.iter().skip(1).for_each(|section| add(section, page));
    Ok(())
}

/// The energy form of the motion, step by step; nothing where the motion is prescribed.
pub(super) fn energy(context: &Context<'_>, page: &mut Document) {
    let sections = working::energy(&context.found.analysis, &context.results.linkage.mechanism);
    if !sections.is_empty() {
        page.heading(text!("note-energy-form"));
        for section in &sections {
            add(section, page);
        }
    }
}

fn add(section: &Section, page: &mut Document) {
    page.blocks.push(Block::Subheading(section.title.clone()));
    page.blocks.extend(section.entries.iter().map(|entry| match entry {
        Entry::Note(text) => Block::Paragraph(text.clone()),
        equation => Block::Equation(equation.sides().join(&Term::Sign(" = "))),
    }));
}
