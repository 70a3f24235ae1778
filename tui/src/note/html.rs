//! A note as one HTML file that reads on a screen and prints on A4.

use std::fmt::Write;

use assur_figure::svg::{self, escaped};

use super::document::{Block, Cover};
use super::words::Words;

/// Time of one turn of an animation, s.
const TURN: f64 = 6.0;

const STYLE: &str = "
@page { size: A4; margin: 20mm 15mm 20mm 25mm; }
body { font: 11pt/1.4 'Liberation Serif', 'Times New Roman', serif; max-width: 170mm; margin: 0 auto; padding: 5mm; color: #000; }
.cover { text-align: center; min-height: 220mm; display: flex; flex-direction: column; justify-content: center; break-after: page; }
.cover h1 { font-size: 20pt; } .cover table { margin: 20mm 0 0 auto; border: none; } .cover td { border: none; text-align: left; }
h2 { font-size: 15pt; margin-top: 10mm; break-after: avoid; } h3 { font-size: 12pt; break-after: avoid; }
figure { margin: 5mm 0; text-align: center; break-inside: avoid; } figure svg { max-width: 100%; height: auto; }
figcaption, caption { font-size: 10pt; margin: 2mm 0; } caption { text-align: left; break-after: avoid; }
table { border-collapse: collapse; margin: 5mm 0; width: 100%; font-size: 9.5pt; }
thead { display: table-header-group; break-after: avoid; } tr { break-inside: avoid; }
th, td { border: 0.3mm solid #666; padding: 0.6mm 1.5mm; text-align: right; } th:first-child, td:first-child { text-align: left; }
.eq { margin: 0.8mm 0 0.8mm 8mm; text-indent: -4mm; overflow-wrap: anywhere; } .eq i { font-family: 'Liberation Serif', serif; }
@media print { body { padding: 0; max-width: none; } }
";

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
                let _ = writeln!(text, "<h2>{parts}. {}</h2>", escaped(title));
            }
            Block::Subheading(title) => {
                let _ = writeln!(text, "<h3>{}</h3>", escaped(title));
            }
            Block::Text(paragraph) => {
                let _ = writeln!(text, "<p>{}</p>", escaped(paragraph));
            }
            Block::Equation(html) => {
                let _ = writeln!(text, "<p class=\"eq\">{html}</p>");
            }
            Block::Picture { frames, size, caption } => {
                figures += 1;
                let drawn = match frames.as_slice() {
                    [one] => svg::write_in(one, *size, &|text| words.phrase(text)),
                    many => svg::animate_in(many, *size, TURN, &|text| words.phrase(text)),
                };
                let number = format!("{} {figures}", words.get("figure"));
                let _ = writeln!(
                    text,
                    "<figure>{drawn}<figcaption>{number}. {}</figcaption></figure>",
                    escaped(caption)
                );
            }
            Block::Table { caption, head, rows } => {
                tables += 1;
                let number = format!("{} {tables}", words.get("table"));
                let _ = write!(text, "<table><caption>{number}. {}</caption><thead>", escaped(caption));
                row(&mut text, "th", head);
                text.push_str("</thead><tbody>");
                for cells in rows {
                    row(&mut text, "td", cells);
                }
                text.push_str("</tbody></table>\n");
            }
        }
    }
    text.push_str("</body>\n</html>\n");
    text
}

fn row(text: &mut String, tag: &str, cells: &[String]) {
    text.push_str("<tr>");
    for cell in cells {
        let _ = write!(text, "<{tag}>{}</{tag}>", escaped(cell));
    }
    text.push_str("</tr>");
}
