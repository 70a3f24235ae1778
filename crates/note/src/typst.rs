//! A note as one Typst file with its figures.

use std::fmt::Write;

use assur_book::{Block, Term};
use assur_figure::{Page, svg};
use assur_words::{Text, text, unit};

use super::html::SHORT;
use super::sheet::{self, Grid, NoteSheet};

const STYLE: &str = "#set page(paper: \"a4\", margin: (left: 25mm, right: 15mm, y: 20mm), numbering: \"1\")
#set text(font: (\"Libertinus Serif\", \"Liberation Serif\"), size: 11pt)
#set math.equation(numbering: \"(1)\")
#set heading(numbering: (..n) => if n.pos().len() == 1 { numbering(\"1.\", ..n) })
#set table(stroke: 0.4pt, inset: 3pt)
#show figure.where(kind: table): set figure.caption(position: top)
";

/// A row of the cover that is to be filled in by hand.
const RULE: &str = "#box(width: 60mm, line(length: 100%, stroke: 0.3pt))";

pub(super) fn write(sheet: &NoteSheet<'_>) -> String {
    let line = |text: &Text| rich(&sheet.line(text));
    let language = sheet.language.code;
    let mut text = format!("{STYLE}#set text(lang: \"{language}\")\n#align(center)[\n");
    for (what, row) in sheet.cover.rows() {
        let what = what.map_or_else(String::new, |what| line(what) + ": ");
        let _ = writeln!(text, "  {what}{}\n\n  #v(1fr)\n", row.map_or_else(|| RULE.to_owned(), line));
    }
    let _ = writeln!(
        text,
        "]\n#pagebreak()\n\n#outline(title: [{}])\n#pagebreak()\n",
        line(&text!("note-contents"))
    );
    for block in &sheet.blocks {
        let _ = match block {
            Block::Title(_) => Ok(()),
            Block::Heading(title) => writeln!(text, "= {}\n", line(title)),
            Block::Subheading(title) => writeln!(text, "== {}\n", line(title)),
            Block::Paragraph(words) => {
                sheet.paragraphs(words).iter().try_for_each(|words| writeln!(text, "{}\n", rich(words)))
            }
            Block::Equation(terms) => writeln!(text, "$ {} $\n", equation(sheet, terms)),
            // Paper does not move.
            Block::Figure { frames, size, caption } => {
                let first = &frames[..1.min(frames.len())];
                let (drawn, [width, _]) = svg::animate(first, Page::Within(*size), 0.0, sheet.language);
                let (drawn, caption) = (quoted(&drawn), line(caption));
                writeln!(
                    text,
                    "#figure(image(bytes({drawn}), format: \"svg\", width: {width}mm), caption: [{caption}])\n"
                )
            }
            Block::Table(_) | Block::Facts { .. } => block.as_table().map_or(Ok(()), |of| {
                let grid = sheet.grid(&of);
                let figure = format!("#figure({}, caption: [{}])", table(&grid), line(&of.caption));
                match grid.rows.len() {
                    0..=SHORT => writeln!(text, "{figure}\n"),
                    _ => writeln!(text, "#[#show figure: set block(breakable: true)\n{figure}]\n"),
                }
            }),
        };
    }
    text
}

fn table(grid: &Grid) -> String {
    let cells = |cells: &[String]| {
        cells.iter().flat_map(|cell| ["[".to_owned(), rich(cell), "], ".to_owned()]).collect::<String>()
    };
    let columns: String = grid.right.iter().map(|right| if *right { "right, " } else { "left, " }).collect();
    let mut text = format!("table(columns: {}, align: ({columns}),\n", grid.head.len());
    let _ = writeln!(text, "  table.header({}),", cells(&grid.head));
    for row in &grid.rows {
        let _ = writeln!(text, "  {}", cells(row));
    }
    text + ")"
}

/// A text as a string of Typst's code.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A text in which nothing is markup but its subscripts and superscripts.
fn rich(text: &str) -> String {
    sheet::rich(text, |part| format!("#{};", quoted(part)), |tag, part| format!("#{tag}({})", quoted(part)))
}

fn equation(sheet: &NoteSheet<'_>, terms: &[Term]) -> String {
    let term = |term: &Term| match term {
        Term::Symbol(symbol) => {
            let (letters, below) = (sheet.plain(&symbol.letter()), sheet.below(symbol));
            let primes = letters.trim_start_matches(|c: char| c.is_alphabetic());
            let letters = letters.trim_end_matches(primes);
            let letters = if letters.chars().count() > 1 { quoted(letters) } else { letters.to_owned() };
            let primes = "'".repeat(primes.chars().map(|c| if c == '″' { 2 } else { 1 }).sum());
            let below = if below.is_empty() { below } else { format!("_{}", quoted(&below)) };
            format!("{letters}{primes}{below} ")
        }
        Term::Function("sqrt") => "√".to_owned(),
        Term::Function(text) => format!("op({})", quoted(text)),
        Term::Number(_) => quoted(&sheet.plain(&term.text())) + " ",
        Term::Square => "^2 ".to_owned(),
        Term::Sign(_) | Term::Comma => sheet
            .plain(&term.text())
            .replace('/', "\\/")
            .replace(['·', '*'], " dot ")
            .replace('−', "-")
            .replace('"', "\\\""),
        Term::Unit(symbol) => format!(" space {}", quoted(&sheet.plain(&unit(*symbol)))),
        Term::Words(text) => format!(" quad ({})", quoted(&sheet.plain(text))),
    };
    terms.iter().map(term).collect()
}
