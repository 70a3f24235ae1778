//! The legend below a figure.

use assur_words::Language;

use super::names::text_width;
use super::{EM, Element, LINE, sign_elements, stroked, text};
use crate::model::{Figure, Key, Point, Sample};

/// Length of the sample of a stroke, mm.
const SAMPLE: f64 = 2.5 * EM;
/// Distance between two entries, mm.
const APART: f64 = 1.5 * EM;

/// Entries with their texts in rows.
pub(super) type Rows<'a> = Vec<Vec<(&'a Key, String)>>;

/// The entries, each with its text, in rows that fit into this width.
pub(super) fn rows<'a>(figure: &'a Figure, width: f64, language: &Language) -> Rows<'a> {
    let mut rows: Rows<'_> = Vec::new();
    let mut used = f64::INFINITY;
    for key in &figure.legend {
        let text = key.text.render(language);
        let wide = wide(&text);
        if used + wide > width {
            rows.push(Vec::new());
            used = 0.0;
        }
        used += wide;
        rows.last_mut().into_iter().for_each(|row| row.push((key, text.clone())));
    }
    rows
}

/// Width of an entry with this text.
fn wide(text: &str) -> f64 {
    SAMPLE + text_width(text) + APART
}

/// Width of the widest row.
pub(super) fn width(rows: &Rows<'_>) -> f64 {
    rows.iter().map(|row| row.iter().map(|(_, text)| wide(text)).sum()).fold(0.0, f64::max)
}

/// The elements of the rows from a corner on.
pub(super) fn elements(rows: &Rows<'_>, [left, top]: Point) -> Vec<Element> {
    let mut elements = Vec::new();
    for (row, keys) in rows.iter().enumerate() {
        let (mut x, y) = (left, top + row as f64 * LINE - 0.3 * LINE);
        for (key, told) in keys {
            let middle = y - 0.35 * EM;
            let width = match key.sample {
                Sample::Sign(sign, ink) => {
                    elements.extend(sign_elements([x + 0.5 * EM, middle], [1.0, 0.0], sign, ink));
                    EM
                }
                Sample::Line(stroke, ink) => {
                    elements.extend(stroked(&[[x, middle], [x + SAMPLE, middle]], stroke, ink));
                    SAMPLE
                }
            };
            elements.push(text([x + width + 0.5 * EM, y], told, crate::Ink::Text, "start"));
            x += width + text_width(told) + APART;
        }
    }
    elements
}
