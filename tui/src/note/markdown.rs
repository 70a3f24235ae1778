//! A note as Markdown with formulas between `$`, its figures in files beside it.

use std::fmt::Write;

use assur_figure::svg;

use super::Written;
use super::document::{self, Block, Cover, Term};
use super::html::{TURN, is_of_numbers};
use crate::words::Words;

/// The text, with links to files of figures in `folder`, and these files.
pub(super) fn write(cover: &Cover, blocks: &[Block], words: &Words, folder: &str) -> Written {
    let mut text = format!("# {}\n\n{}\n\n", rich(&cover.title), words.get("explanatory-note"));
    for (id, value) in &cover.rows {
        let _ = writeln!(text, "{}: {}\n", words.get(id), rich(value));
    }
    let [mut parts, mut tables] = [0_usize; 2];
    let mut figures = Vec::new();
    for block in blocks {
        let _ = match block {
            Block::Heading(title) => {
                parts += 1;
                writeln!(text, "## {parts}. {}\n", rich(title))
            }
            Block::Subheading(title) => writeln!(text, "### {}\n", rich(title)),
            Block::Text(paragraph) => writeln!(text, "{}\n", rich(paragraph)),
            Block::Equation(terms) => writeln!(text, "${}$\n", equation(terms)),
            Block::Picture { frames, size, caption } => {
                let name = format!("figure-{}.svg", figures.len() + 1);
                let drawn = svg::animate(frames, *size, TURN, words.spoken());
                figures.push((name.clone(), drawn));
                let caption = format!("{} {}. {}", words.get("figure"), figures.len(), rich(caption));
                writeln!(text, "![{caption}](<{folder}/{name}>)\n\n{caption}\n")
            }
            Block::Table { caption, head, rows } => {
                tables += 1;
                let caption = format!("{} {tables}. {}", words.get("table"), rich(caption));
                writeln!(text, "{caption}\n\n{}", table(head, rows))
            }
        };
    }
    Written { text, figures }
}

fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let row = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|cell| rich(cell)).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let rules: String =
        (0..head.len()).map(|column| if is_of_numbers(rows, column) { " --: |" } else { " --- |" }).collect();
    row(head) + "|" + &rules + "\n" + &rows.iter().map(|cells| row(cells)).collect::<String>()
}

/// A text in which nothing is markup but its subscripts.
fn rich(text: &str) -> String {
    let escaped = |letter: char| {
        if "\\`*_[]<>|$#~".contains(letter) { format!("\\{letter}") } else { letter.to_string() }
    };
    let plain =
        |text: &str| text.chars().filter(|letter| !letter.is_control()).map(escaped).collect::<String>();
    document::rich(text, plain, |low| format!("<sub>{}</sub>", plain(low)))
}

/// An equation in the notation of TeX.
fn equation(terms: &[Term]) -> String {
    let word = |text: &str| format!("\\text{{{}}}", text.replace('\\', "").replace(['{', '}', '$'], " "));
    let term = |term: &Term| match term {
        Term::Name(letters, below) => {
            let letters = letters.replace('″', "''").replace('′', "'");
            if below.is_empty() { letters } else { format!("{letters}_{{{}}}", word(below)) }
        }
        Term::Function(text) if text == "√" => "\\surd".to_owned(),
        Term::Function(text) => format!("\\operatorname{{{text}}}"),
        Term::Number(text) => text.replace(',', "{,}").replace('−', "-").replace('·', "\\cdot "),
        Term::Power(power) => format!("^{{{power}}}"),
        Term::Sign(text) => text.replace('·', "\\cdot ").replace('−', "-"),
        Term::Unit(unit) => format!("\\ {}", word(unit)),
    };
    terms.iter().map(term).collect()
}
