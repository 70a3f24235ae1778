//! Figures as SVG: one page, its lengths in millimeters, the same bytes for the same figure.

use std::fmt::Write;

use assur_words::Language;

use crate::model::Figure;
pub use crate::page::EM;
use crate::page::{Element, elements};

/// Fonts of the texts, the first that is there; their letters have nearly one width.
const FONTS: &str = "DejaVu Sans, Verdana, Arial, sans-serif";

/// A figure on a page of this width and height, mm, in the words of a language.
pub fn write(figure: &Figure, size: [f64; 2], language: &Language) -> String {
    animate(std::slice::from_ref(figure), size, 0.0, language)
}

/// Figures on one page of this width and height, mm, row by row in so many columns, each with its own heading and legend.
pub fn sheet(figures: &[Figure], columns: usize, [width, height]: [f64; 2], language: &Language) -> String {
    if let [figure] = figures {
        return write(figure, [width, height], language);
    }
    let columns = columns.max(1);
    let cell = [width / columns as f64, height / figures.len().div_ceil(columns).max(1) as f64];
    let placed = |(index, figure): (usize, &Figure)| {
        let elements = elements(figure, cell, language);
        let inner: String = elements.iter().map(|element| markup(element, "") + "\n").collect();
        let [x, y] = [(index % columns) as f64 * cell[0], (index / columns) as f64 * cell[1]];
        format!("<g transform=\"translate({x} {y})\">\n{inner}</g>")
    };
    let title = figures.first().map(|figure| figure.title.render(language)).unwrap_or_default();
    document(&title, [width, height], figures.iter().enumerate().map(placed))
}

/// A figure that moves: its frames follow each other in equal times and repeat; `seconds` is the time of all.
///
/// What is equal in all frames is written once; between two frames everything moves in straight lines. A frame that does
/// not have the elements of the first one is left out.
pub fn animate(frames: &[Figure], size: [f64; 2], seconds: f64, language: &Language) -> String {
    let mut all: Vec<Vec<Element>> = frames.iter().map(|frame| elements(frame, size, language)).collect();
    let Some(first) = all.first().cloned() else { return String::new() };
    let names = |frame: &[Element]| frame.iter().map(|element| element.name).collect::<Vec<_>>();
    all.retain(|frame| names(frame) == names(&first));
    // The last frame leads back to the first one.
    all.push(first.clone());
    let parts = (0..first.len()).map(|index| {
        let of: Vec<&Element> = all.iter().map(|frame| &frame[index]).collect();
        markup(of[0], &motion(&of, seconds))
    });
    document(&frames[0].title.render(language), size, parts)
}

fn motion(frames: &[&Element], seconds: f64) -> String {
    let mut text = String::new();
    for (at, (name, first)) in frames[0].attributes.iter().enumerate() {
        let values: Vec<&str> =
            frames.iter().filter_map(|frame| Some(frame.attributes.get(at)?.1.as_str())).collect();
        if values.iter().any(|value| value != first) {
            let _ = write!(
                text,
                "<animate attributeName=\"{name}\" dur=\"{seconds}s\" repeatCount=\"indefinite\" values=\"{}\"/>",
                values.join(";")
            );
        }
    }
    text
}

fn document(title: &str, [width, height]: [f64; 2], parts: impl Iterator<Item = String>) -> String {
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"{FONTS}\" stroke-linecap=\"round\" \
         stroke-linejoin=\"round\">\n<title>{}</title>\n<rect width=\"{width}\" height=\"{height}\" \
         fill=\"#ffffff\"/>\n",
        escaped(title)
    );
    for part in parts {
        text.push_str(&part);
        text.push('\n');
    }
    text.push_str("</svg>\n");
    text
}

fn markup(element: &Element, inner: &str) -> String {
    let mut text = format!("<{}", element.name);
    for (name, value) in &element.attributes {
        let _ = write!(text, " {name}=\"{value}\"");
    }
    if element.text.is_empty() && inner.is_empty() {
        return text + "/>";
    }
    format!("{text}>{}{inner}</{}>", words(&element.text), element.name)
}

/// Height of a subscript below its line, mm.
const BELOW: f64 = 0.8;

fn words(text: &str) -> String {
    let mut markup = String::new();
    for (index, (part, low)) in lowered(text).enumerate() {
        let part = escaped(part);
        let _ = match index {
            0 => write!(markup, "{part}"),
            _ => write!(markup, "<tspan dy=\"-{BELOW}\">{part}</tspan>"),
        };
        if !low.is_empty() {
            let _ = write!(markup, "<tspan dy=\"{BELOW}\" font-size=\"70%\">{}</tspan>", escaped(low));
        }
    }
    markup
}

/// The parts of a text, each with the subscript behind it, `_{...}` in the text; the last one has none.
pub fn lowered(text: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let Some((part, behind)) = rest?.split_once("_{") else { return rest.take().map(|part| (part, "")) };
        let (low, behind) = behind.split_once('}').unwrap_or((behind, ""));
        rest = Some(behind);
        Some((part, low))
    })
}

/// A text in which nothing is markup.
pub fn escaped(text: &str) -> String {
    let visible = text.chars().filter(|letter| !letter.is_control()).collect::<String>();
    visible.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
