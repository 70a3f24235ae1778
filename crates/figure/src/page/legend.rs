//! The legend below a figure.

use super::{Anchor, Element, Print, sign_elements, stroked};
use crate::model::{Figure, Key, Point, Sample};

/// Distance between two entries, in text sizes.
const APART: f64 = 1.5;

/// Entries with their texts in rows.
pub(super) type Rows<'a> = Vec<Vec<(&'a Key, String)>>;

/// The entries, each with its text, in rows that fit into this width.
pub(super) fn rows<'a>(figure: &'a Figure, width: f64, print: &Print<'_>) -> Rows<'a> {
    let mut rows: Rows<'_> = Vec::new();
    let mut used = f64::INFINITY;
    for key in &figure.legend {
        let text = key.text.typeset(print.language);
        let wide = wide(key, &text, print);
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
fn wide(key: &Key, text: &str, print: &Print<'_>) -> f64 {
    let sample = if key.sample == Sample::None { 0.0 } else { print.style.sample };
    (sample + APART) * print.style.em + print.width(text)
}

/// Width of the widest row.
pub(super) fn width(rows: &Rows<'_>, print: &Print<'_>) -> f64 {
    rows.iter().map(|row| row.iter().map(|(key, text)| wide(key, text, print)).sum()).fold(0.0, f64::max)
}

/// The elements of the rows from a corner on.
pub(super) fn elements(rows: &Rows<'_>, [left, top]: Point, print: &Print<'_>) -> Vec<Element> {
    let (style, em, line) = (&print.style, print.style.em, print.style.row());
    let mut elements = Vec::new();
    for (row, keys) in rows.iter().enumerate() {
        let (mut x, y) = (left, top + row as f64 * line - 0.3 * line);
        for (key, told) in keys {
            let middle = y - 0.35 * em;
            let width = match key.sample {
                Sample::Sign(sign, ink) => {
                    elements.extend(sign_elements([x + 0.5 * em, middle], [1.0, 0.0], sign, ink, style));
                    em
                }
                Sample::Line(stroke, ink) => {
                    elements.extend(stroked(
                        &[[x, middle], [x + style.sample * em, middle]],
                        stroke,
                        ink,
                        style,
                    ));
                    style.sample * em
                }
                Sample::None => -0.5 * em,
            };
            elements.push(print.text([x + width + 0.5 * em, y], told, crate::Ink::Text, Anchor::Start));
            x += width + print.width(told) + APART * em;
        }
    }
    elements
}
