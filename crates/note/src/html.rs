//! A note as one HTML file that reads on a screen and prints on A4.

use std::fmt::{self, Write};

use assur_book::{Block, Term};
use assur_figure::Page;
use assur_figure::svg::{self, escaped};
use assur_words::{Text, text};

use super::sheet::{self, Grid, NoteSheet};

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

pub(super) fn write(sheet: &NoteSheet<'_>) -> String {
    let line = |text: &Text| rich(&sheet.line(text));
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n<style>{STYLE}</style>\n\
         </head>\n<body>\n<section class=\"cover\"><p>{}</p><h1>{}</h1><table>",
        sheet.language.code,
        escaped(sheet.title),
        line(&text!("note-title")),
        escaped(sheet.title)
    );
    for (what, who) in &sheet.author {
        let _ = write!(text, "<tr><td>{}:</td><td>{}</td></tr>", line(what), escaped(who));
    }
    text.push_str("</table></section>\n");
    for block in &sheet.blocks {
        let _ = match block {
            Block::Title(_) => Ok(()),
            Block::Heading(title) => writeln!(text, "<h2>{}</h2>", line(title)),
            Block::Subheading(title) => writeln!(text, "<h3>{}</h3>", line(title)),
            Block::Paragraph(words) => writeln!(text, "<p>{}</p>", line(words)),
            Block::Equation(terms) => writeln!(text, "<p class=\"eq\">{}</p>", equation(sheet, terms)),
            Block::Figure { frames, size, caption } => {
                let (drawn, _) = svg::animate(frames, Page::Within(*size), TURN, sheet.language);
                writeln!(text, "<figure>{drawn}<figcaption>{}</figcaption></figure>", line(caption))
            }
            Block::Table(_) | Block::Facts { .. } => {
                block.as_table().map_or(Ok(()), |of| table(&mut text, &line(&of.caption), &sheet.grid(&of)))
            }
        };
    }
    text.push_str("</body>\n</html>\n");
    text
}

fn table(text: &mut String, caption: &str, grid: &Grid) -> fmt::Result {
    let class = if grid.rows.len() <= SHORT { " class=\"short\"" } else { "" };
    write!(text, "<table{class}><caption>{caption}</caption><thead><tr>")?;
    for cell in &grid.head {
        write!(text, "<th>{}</th>", rich(cell))?;
    }
    text.push_str("</tr></thead><tbody>");
    for cells in &grid.rows {
        text.push_str("<tr>");
        for (cell, right) in cells.iter().zip(&grid.right) {
            let class = if *right { " class=\"n\"" } else { "" };
            write!(text, "<td{class}>{}</td>", rich(cell))?;
        }
        text.push_str("</tr>");
    }
    text.push_str("</tbody></table>\n");
    Ok(())
}

fn rich(text: &str) -> String {
    sheet::rich(text, escaped, |low| format!("<sub>{}</sub>", escaped(low)))
}

fn equation(sheet: &NoteSheet<'_>, terms: &[Term]) -> String {
    let line = |text: &Text| escaped(&sheet.line(text));
    let term = |term: &Term| match term {
        Term::Symbol(symbol) => {
            let below = symbol.subscript();
            let below = if below.is_empty() { String::new() } else { format!("<sub>{}</sub>", line(&below)) };
            format!("<i>{}</i>{below}", line(&symbol.letter()))
        }
        Term::Function("sqrt") => "√".to_owned(),
        Term::Sign(_) | Term::Comma => line(&term.text()).replace('*', "·").replace('-', "−"),
        Term::Square => "<sup>2</sup>".to_owned(),
        Term::Words(text) => format!("\u{2003}({})", line(text)),
        Term::Function(_) | Term::Number(_) | Term::Unit(_) => line(&term.text()),
    };
    terms.iter().map(term).collect()
}
