//! A note as Markdown with formulas between `$`, its figures in files beside it.

use std::fmt::Write;

use assur_book::{Block, Term};
use assur_figure::{Page, svg};
use assur_words::{Text, text, unit};

use super::Written;
use super::html::TURN;
use super::sheet::{self, Grid, NoteSheet};

/// A row of the cover that is to be filled in by hand.
const RULE: &str = "\\_\\_\\_\\_\\_\\_\\_\\_\\_\\_\\_\\_";

/// The text, with links to files of figures in `folder`, and these files.
pub(super) fn write(sheet: &NoteSheet<'_>, folder: &str) -> Written {
    let line = |text: &Text| rich(&sheet.line(text));
    let mut text = String::new();
    for (what, row) in sheet.cover.rows() {
        let what = what.map_or_else(String::new, |what| line(what) + ": ");
        let _ = writeln!(text, "{what}{}\n", row.map_or_else(|| RULE.to_owned(), &line));
    }
    let _ = writeln!(text, "## {}\n", line(&text!("note-contents")));
    for (_, title) in sheet.chapters() {
        let _ = writeln!(text, "* {}", line(title));
    }
    text.push('\n');
    let mut equations = 0_usize;
    let mut figures = Vec::new();
    for block in &sheet.blocks {
        let _ = match block {
            Block::Title(_) => Ok(()),
            Block::Heading(title) => writeln!(text, "## {}\n", line(title)),
            Block::Subheading(title) => writeln!(text, "### {}\n", line(title)),
            Block::Paragraph(words) => {
                sheet.paragraphs(words).iter().try_for_each(|words| writeln!(text, "{}\n", rich(words)))
            }
            Block::Equation(terms) => {
                equations += 1;
                writeln!(text, "${} \\qquad ({equations})$\n", equation(sheet, terms))
            }
            Block::Figure { frames, size, caption } => {
                let name = format!("figure-{}.svg", figures.len() + 1);
                let (drawn, _) = svg::animate(frames, Page::Within(*size), TURN, sheet.language);
                let caption = line(caption);
                figures.push((name.clone(), drawn));
                writeln!(text, "![{caption}](<{folder}/{name}>)\n\n{caption}\n")
            }
            Block::Table(_) | Block::Facts { .. } => block
                .as_table()
                .map_or(Ok(()), |of| writeln!(text, "{}\n\n{}", line(&of.caption), table(&sheet.grid(&of)))),
        };
    }
    Written { text, figures }
}

fn table(grid: &Grid) -> String {
    let row = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|cell| rich(cell)).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rules: String = grid.right.iter().map(|right| if *right { " --: |" } else { " --- |" }).collect();
    row(&grid.head) + "|" + &rules + "\n" + &grid.rows.iter().map(|cells| row(cells)).collect::<String>()
}

/// A text in which nothing is markup but its subscripts and superscripts.
fn rich(text: &str) -> String {
    let escaped = |letter: char| {
        if "\\`*_[]<>|$#~".contains(letter) { format!("\\{letter}") } else { letter.to_string() }
    };
    let plain =
        |text: &str| text.chars().filter(|letter| !letter.is_control()).map(escaped).collect::<String>();
    sheet::rich(text, plain, |tag, part| format!("<{tag}>{}</{tag}>", plain(part)))
}

/// An equation in the notation of TeX, without what TeX or a reader of Markdown that knows no formulas takes for markup.
fn equation(sheet: &NoteSheet<'_>, terms: &[Term]) -> String {
    let bare = |text: String| text.replace('\\', "").replace(['{', '}', '$', '<', '>', '&', '`'], " ");
    let plain = |text: &Text| bare(sheet.plain(text));
    let word = |text: String| format!("\\text{{{text}}}");
    let line = |term: &Term| sheet.plain(&term.text());
    let term = |term: &Term| match term {
        Term::Symbol(symbol) => {
            let letters = plain(&symbol.letter()).replace('″', "''").replace('′', "'");
            let below = bare(sheet.below(symbol));
            if below.is_empty() { letters } else { format!("{letters}_{{{}}}", word(below)) }
        }
        Term::Function("sqrt") => "\\surd".to_owned(),
        Term::Function(text) => format!("\\operatorname{{{text}}}"),
        Term::Number(_) => line(term).replace(',', "{,}").replace('−', "-").replace('·', "\\cdot "),
        Term::Square => "^{2}".to_owned(),
        Term::Sign(_) | Term::Comma => line(term).replace(['·', '*'], "\\cdot ").replace('−', "-"),
        Term::Unit(symbol) => format!("\\ {}", word(plain(&unit(*symbol)))),
        Term::Words(text) => format!("\\quad ({})", word(plain(text))),
    };
    terms.iter().map(term).collect()
}
