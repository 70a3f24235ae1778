//! A note as one HTML file that reads on a screen and prints on A4.

use std::fmt::Write;

use assur_figure::svg::{self, escaped};

use super::document::{self, Block, Cover, Term};
use crate::words::Words;

/// Time of one turn of an animation, s.
pub(super) const TURN: f64 = 6.0;

const STYLE: &str = "
@page { size: A4; margin: 20mm 15mm 20mm 25mm; }
body { font: 11pt/1.4 'Liberation Serif', 'Times New Roman', serif; max-width: 170mm; margin: 0 auto; padding: 5mm; color: #000; }
.cover { text-align: center; min-height: 220mm; display: flex; flex-direction: column; justify-content: center; break-after: page; }
.cover p { font-size: 16pt; } .cover h1 { font-size: 20pt; }
.cover table { margin: 20mm 0 0 auto; border: none; width: auto; } .cover td { border: none; text-align: left; font-size: 12pt; }
h2 { font-size: 15pt; margin-top: 8mm; break-after: avoid; } h2:nth-of-type(2) { break-before: page; } h3 { font-size: 12pt; break-after: avoid; }
p { orphans: 2; widows: 2; }
figure { margin: 4mm 0; text-align: center; break-inside: avoid; } figure svg { max-width: 100%; height: auto; }
figcaption, caption { font-size: 10pt; margin: 2mm 0; } caption { text-align: left; break-after: avoid; }
table { border-collapse: collapse; margin: 4mm 0; width: 100%; font-size: 9.5pt; } table.short { break-inside: avoid; }
thead { display: table-header-group; break-after: avoid; } tr { break-inside: avoid; }
th, td { border: 0.3mm solid #666; padding: 0.6mm 1.5mm; text-align: left; } th { text-align: center; } td.n { text-align: right; white-space: nowrap; }
.eq { margin: 0.8mm 0 0.8mm 8mm; text-indent: -4mm; overflow-wrap: anywhere; } sub, sup { font-size: 70%; line-height: 0; }
@media print { body { padding: 0; max-width: none; } }
";
/// A table of at most so many rows is not divided between pages.
pub(super) const SHORT: usize = 16;

/// The file.
pub(super) fn write(cover: &Cover, blocks: &[Block], words: &Words) -> String {
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n<style>{STYLE}</style>\n\
         </head>\n<body>\n<section class=\"cover\"><p>{}</p><h1>{}</h1><table>",
        words.language,
        escaped(&cover.title),
        escaped(&words.get("explanatory-note")),
        escaped(&cover.title)
    );
    for (id, value) in &cover.rows {
        let _ = write!(text, "<tr><td>{}:</td><td>{}</td></tr>", escaped(&words.get(id)), escaped(value));
    }
    text.push_str("</table></section>\n");
    let [mut parts, mut figures, mut tables] = [0_usize; 3];
    for block in blocks {
        match block {
            Block::Heading(title) => {
                parts += 1;
                let _ = writeln!(text, "<h2>{parts}. {}</h2>", rich(title));
            }
            Block::Subheading(title) => {
                let _ = writeln!(text, "<h3>{}</h3>", rich(title));
            }
            Block::Text(paragraph) => {
                let _ = writeln!(text, "<p>{}</p>", rich(paragraph));
            }
            Block::Equation(terms) => {
                let _ = writeln!(text, "<p class=\"eq\">{}</p>", equation(terms));
            }
            Block::Picture { frames, size, caption } => {
                figures += 1;
                let drawn = svg::animate(frames, *size, TURN, words.spoken());
                let number = format!("{} {figures}", words.get("figure"));
                let caption = rich(caption);
                let _ =
                    writeln!(text, "<figure>{drawn}<figcaption>{number}. {caption}</figcaption></figure>");
            }
            Block::Table { caption, head, rows } => {
                tables += 1;
                let caption = format!("{} {tables}. {}", words.get("table"), rich(caption));
                table(&mut text, &caption, head, rows);
            }
        }
    }
    text.push_str("</body>\n</html>\n");
    text
}

fn table(text: &mut String, caption: &str, head: &[String], rows: &[Vec<String>]) {
    let class = if rows.len() <= SHORT { " class=\"short\"" } else { "" };
    let _ = write!(text, "<table{class}><caption>{caption}</caption><thead><tr>");
    for cell in head {
        let _ = write!(text, "<th>{}</th>", rich(cell));
    }
    text.push_str("</tr></thead><tbody>");
    for cells in rows {
        text.push_str("<tr>");
        for (column, cell) in cells.iter().enumerate() {
            let class = if is_of_numbers(rows, column) { " class=\"n\"" } else { "" };
            let _ = write!(text, "<td{class}>{}</td>", rich(cell));
        }
        text.push_str("</tr>");
    }
    text.push_str("</tbody></table>\n");
}

/// Whether a column has numbers and dashes alone, so that it stands at the right.
pub(super) fn is_of_numbers(rows: &[Vec<String>], column: usize) -> bool {
    rows.iter().all(|cells| cells.get(column).is_some_and(|cell| is_number(cell)))
}

fn is_number(cell: &str) -> bool {
    let mut signs = cell.chars();
    signs.next().is_some_and(|c| c.is_ascii_digit() || "+−–".contains(c))
        && signs.all(|c| c.is_ascii_digit() || ".,·−⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c))
}

/// A text with subscripts.
fn rich(text: &str) -> String {
    document::rich(text, escaped, |low| format!("<sub>{}</sub>", escaped(low)))
}

fn equation(terms: &[Term]) -> String {
    let term = |term: &Term| match term {
        Term::Name(letters, below) if below.is_empty() => format!("<i>{}</i>", escaped(letters)),
        Term::Name(letters, below) => format!("<i>{}</i><sub>{}</sub>", escaped(letters), escaped(below)),
        Term::Function(text) | Term::Number(text) | Term::Sign(text) => escaped(text),
        Term::Power(power) => format!("<sup>{}</sup>", escaped(power)),
        Term::Unit(unit) => format!(" {}", escaped(unit)),
    };
    terms.iter().map(term).collect()
}
