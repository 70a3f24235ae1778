//! The legend below a figure.

use assur_words::Language;

use super::names::text_width;
use super::{EM, Element, LINE, sign_elements, stroked, text};
use crate::model::{Figure, Key, Point, Sample, Sign};

/// Length of the sample of a stroke, mm.
const SAMPLE: f64 = 2.5 * EM;
/// Distance between two entries, mm.
const APART: f64 = 1.5 * EM;

/// The entries, each with its text, in rows that fit into this width.
pub(super) fn rows<'a>(figure: &'a Figure, width: f64, language: &Language) -> Vec<Vec<(&'a Key, String)>> {
    let mut rows: Vec<Vec<(&Key, String)>> = Vec::new();
    let mut used = f64::INFINITY;
    for key in &figure.legend {
        let text = key.text.render(language);
        let wide = SAMPLE + text_width(&text) + APART;
        if used + wide > width {
            rows.push(Vec::new());
            used = 0.0;
        }
        used += wide;
        rows.last_mut().into_iter().for_each(|row| row.push((key, text.clone())));
    }
    rows
}

/// The elements of the rows from a corner on; `unit` is a millimeter in the units of the first plane.
pub(super) fn elements(rows: &[Vec<(&Key, String)>], [left, top]: Point, unit: f64) -> Vec<Element> {
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
                Sample::Arrow(length, stroke, ink) => {
                    let tip = [x + length / unit, middle];
                    elements.extend(stroked(&[[x, middle], tip], stroke, ink));
                    elements.extend(sign_elements(tip, [1.0, 0.0], Sign::Head, ink));
                    length / unit
                }
            };
            elements.push(text([x + width + 0.5 * EM, y], told, crate::Ink::Text, "start"));
            x += width + text_width(told) + APART;
        }
    }
    elements
}
