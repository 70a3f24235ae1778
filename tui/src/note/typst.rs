//! A note as one Typst file with its figures.

use std::fmt::Write;

use assur_figure::svg;

use super::document::{self, Block, Cover, Term};
use super::html::{SHORT, is_of_numbers};
use crate::words::Words;

const STYLE: &str = "#set page(paper: \"a4\", margin: (left: 25mm, right: 15mm, y: 20mm), numbering: \"1\")
#set text(font: (\"Libertinus Serif\", \"Liberation Serif\"), size: 11pt)
#set heading(numbering: (..n) => if n.pos().len() == 1 { numbering(\"1.\", ..n) })
#set table(stroke: 0.4pt, inset: 3pt)
#show figure.where(kind: table): set figure.caption(position: top)
";

/// The file.
pub(super) fn write(cover: &Cover, blocks: &[Block], words: &Words) -> String {
    let (language, title) = (words.language, rich(&cover.title));
    let mut text = format!("{STYLE}#set text(lang: \"{language}\")\n#align(center + horizon)[\n");
    let _ = writeln!(
        text,
        "  #text(16pt)[{}]\n\n  #text(20pt, weight: \"bold\")[{title}]\n]",
        rich(&words.get("explanatory-note"))
    );
    for (id, value) in &cover.rows {
        let _ = writeln!(text, "#align(right)[{}: {}]", rich(&words.get(id)), rich(value));
    }
    text.push_str("#pagebreak()\n\n");
    for block in blocks {
        let _ = match block {
            Block::Heading(title) => writeln!(text, "= {}\n", rich(title)),
            Block::Subheading(title) => writeln!(text, "== {}\n", rich(title)),
            Block::Text(paragraph) => writeln!(text, "{}\n", rich(paragraph)),
            Block::Equation(terms) => writeln!(text, "#h(8mm)${}$\n", equation(terms)),
            // Paper does not move.
            Block::Picture { frames, size, caption } => {
                let first = svg::animate(&frames[..1.min(frames.len())], *size, 0.0, words.spoken());
                let drawn = quoted(&first);
                writeln!(
                    text,
                    "#figure(image(bytes({drawn}), format: \"svg\", width: {}mm), caption: [{}])\n",
                    size[0],
                    rich(caption)
                )
            }
            Block::Table { caption, head, rows } => {
                let figure = format!("#figure({}, caption: [{}])", table(head, rows), rich(caption));
                match rows.len() {
                    0..=SHORT => writeln!(text, "{figure}\n"),
                    _ => writeln!(text, "#[#show figure: set block(breakable: true)\n{figure}]\n"),
                }
            }
        };
    }
    text
}

fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let cells = |cells: &[String]| {
        cells.iter().flat_map(|cell| ["[".to_owned(), rich(cell), "], ".to_owned()]).collect::<String>()
    };
    let columns =
        (0..head.len()).map(|column| if is_of_numbers(rows, column) { "right, " } else { "left, " });
    let mut text = format!("table(columns: {}, align: ({}),\n", head.len(), columns.collect::<String>());
    let _ = writeln!(text, "  table.header({}),", cells(head));
    for row in rows {
        let _ = writeln!(text, "  {}", cells(row));
    }
    text + ")"
}

/// A text as a string of Typst's code.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A text in which nothing is markup but its subscripts.
fn rich(text: &str) -> String {
    document::rich(text, |part| format!("#{};", quoted(part)), |low| format!("#sub({})", quoted(low)))
}

fn equation(terms: &[Term]) -> String {
    let term = |term: &Term| match term {
        Term::Name(letters, below) => {
            let primes = letters.trim_start_matches(|c: char| c.is_alphabetic());
            let letters = letters.trim_end_matches(primes);
            let letters = if letters.chars().count() > 1 { quoted(letters) } else { letters.to_owned() };
            let primes = "'".repeat(primes.chars().map(|c| if c == '″' { 2 } else { 1 }).sum());
            let below = if below.is_empty() { String::new() } else { format!("_{}", quoted(below)) };
            format!("{letters}{primes}{below} ")
        }
        Term::Function(text) if text == "√" => "√".to_owned(),
        Term::Function(text) => format!("op({})", quoted(text)),
        Term::Number(text) => quoted(text) + " ",
        Term::Power(power) => format!("^{power} "),
        Term::Sign(text) => {
            text.replace('/', "\\/").replace('·', " dot ").replace('−', "-").replace('"', "\\\"")
        }
        Term::Unit(unit) => format!(" space {}", quoted(unit)),
    };
    terms.iter().map(term).collect()
}
