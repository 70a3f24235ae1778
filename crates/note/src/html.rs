//! A note as one HTML file that reads on a screen and prints on A4.

use std::fmt::{self, Write};

use assur_book::{Block, Term};
use assur_figure::Page;
use assur_figure::svg::{self, escaped};
use assur_words::{Text, text};

use super::cover::Cover;
use super::sheet::{self, Grid, NoteSheet};

/// Time of one turn of an animation, s.
pub(super) const TURN: f64 = 6.0;

const STYLE: &str = "
@page { size: A4; margin: 20mm 15mm 20mm 25mm; @bottom-right { content: counter(page); font: 10pt 'Liberation Serif', 'Times New Roman', serif; } }
@page :first { @bottom-right { content: none; } }
body { font: 11pt/1.4 'Liberation Serif', 'Times New Roman', serif; max-width: 170mm; margin: 0 auto; padding: 5mm; color: #000; }
.cover { text-align: center; height: 250mm; display: flex; flex-direction: column; justify-content: space-between; break-after: page; }
.cover p { font-size: 12pt; margin: 2mm 0; } .cover p.what { font-size: 16pt; } .cover h1 { font-size: 18pt; }
.cover table { margin: 0 0 0 auto; border: none; width: 90mm; } .cover td { border: none; text-align: left; font-size: 12pt; }
.rule { display: inline-block; min-width: 45mm; border-bottom: 0.3mm solid #000; }
nav p { margin: 1mm 0; } nav a { color: inherit; text-decoration: none; }
nav a::after { content: leader('.') target-counter(attr(href), page); }
h2 { font-size: 15pt; margin-top: 8mm; break-after: avoid; } h3 { font-size: 12pt; break-after: avoid; }
p { orphans: 2; widows: 2; }
figure { margin: 4mm 0; text-align: center; break-inside: avoid; } figure svg { max-width: 100%; height: auto; }
figcaption, caption { font-size: 10pt; margin: 2mm 0; } caption { text-align: left; break-after: avoid; }
table { border-collapse: collapse; margin: 4mm 0; width: 100%; font-size: 9.5pt; } table.short { break-inside: avoid; }
thead { display: table-header-group; break-after: avoid; } tr { break-inside: avoid; }
th, td { overflow-wrap: anywhere; border: 0.3mm solid #666; padding: 0.6mm 1.5mm; text-align: left; } th { text-align: center; } td.n { text-align: right; white-space: nowrap; }
.eq { margin: 0.8mm 0 0.8mm 8mm; display: flex; justify-content: space-between; } .eq span { overflow-wrap: anywhere; } .eq .no { margin-left: 4mm; flex: none; white-space: nowrap; } sub, sup { font-size: 70%; line-height: 0; }
@media print { body { padding: 0; max-width: none; } }
";
/// A table of at most so many rows is not divided between pages.
pub(super) const SHORT: usize = 16;

pub(super) fn write(sheet: &NoteSheet<'_>) -> String {
    let line = |text: &Text| rich(&sheet.line(text));
    let title = line(&sheet.cover.title);
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
         </head>\n<body>\n{}",
        sheet.language.code,
        cover(&sheet.cover, &line)
    );
    let _ = write!(text, "<nav><h2>{}</h2>", line(&text!("note-contents")));
    for (number, title) in sheet.chapters() {
        let _ = write!(text, "<p><a href=\"#chapter-{number}\">{}</a></p>", line(title));
    }
    text.push_str("</nav>\n");
    let [mut chapter, mut equations] = [0_usize; 2];
    for block in &sheet.blocks {
        let _ = match block {
            Block::Title(_) => Ok(()),
            Block::Heading(title) => {
                chapter += 1;
                writeln!(text, "<h2 id=\"chapter-{chapter}\">{}</h2>", line(title))
            }
            Block::Subheading(title) => writeln!(text, "<h3>{}</h3>", line(title)),
            Block::Paragraph(words) => {
                sheet.paragraphs(words).iter().try_for_each(|words| writeln!(text, "<p>{}</p>", rich(words)))
            }
            Block::Equation(terms) => {
                equations += 1;
                let formula = equation(sheet, terms);
                writeln!(
                    text,
                    "<p class=\"eq\"><span>{formula}</span><span class=\"no\">({equations})</span></p>"
                )
            }
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

/// The cover; a row that is left out is a ruled line.
fn cover(cover: &Cover, line: &impl Fn(&Text) -> String) -> String {
    let filled = |row: Option<&Text>| row.map_or_else(|| "<span class=\"rule\"></span>".to_owned(), line);
    let mut text = "<section class=\"cover\"><div>".to_owned();
    for row in &cover.above {
        let _ = write!(text, "<p>{}</p>", filled(row.as_ref()));
    }
    let (word, discipline) = &cover.discipline;
    let _ = write!(
        text,
        "</div><div><p class=\"what\">{}</p><p>{}: {}</p><h1>{}</h1></div><table>",
        line(&cover.what),
        line(word),
        filled(discipline.as_ref()),
        line(&cover.title)
    );
    for (what, who) in &cover.people {
        let _ = write!(text, "<tr><td>{}:</td><td>{}</td></tr>", line(what), filled(who.as_ref()));
    }
    let below = cover.below.each_ref().map(|row| filled(row.as_ref())).join(" ");
    text + "</table><p>" + &below + "</p></section>\n"
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
    sheet::rich(text, escaped, |tag, part| format!("<{tag}>{}</{tag}>", escaped(part)))
}

fn equation(sheet: &NoteSheet<'_>, terms: &[Term]) -> String {
    let line = |text: &Text| escaped(&sheet.plain(text));
    let term = |term: &Term| match term {
        Term::Symbol(symbol) => {
            let below = escaped(&sheet.below(symbol));
            let below = if below.is_empty() { below } else { format!("<sub>{below}</sub>") };
            format!("<i>{}</i>{below}", line(&symbol.letter()))
        }
        Term::Function("sqrt") => "√".to_owned(),
        Term::Sign(_) | Term::Comma => line(&term.text()).replace('*', "·").replace('-', "−"),
        Term::Square => "<sup>2</sup>".to_owned(),
        Term::Words(text) => format!("\u{2003}({})", rich(&sheet.line(text))),
        Term::Function(_) | Term::Number(_) | Term::Unit(_) => line(&term.text()),
    };
    terms.iter().map(term).collect()
}
