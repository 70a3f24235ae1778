//! Figures as SVG: one page, its lengths in millimeters, the same bytes for the same figure.

use std::fmt::Write;

use assur_words::Language;

use crate::letters::{Level, levels};
use crate::model::{Figure, Point};
pub use crate::page::EM;
use crate::page::{Anchor, Element, Form, Page, Style, color, elements};

/// Letters of the Latin, Greek and Cyrillic alphabets and the signs of formulas, from `DejaVu Sans`: for who paints a figure or gives it along
/// with its letters.
pub static FONT: &[u8] = include_bytes!("../font/DejaVuSans-subset.ttf");

/// Fonts of the texts, the first that is there; their letters have nearly one width.
const FONTS: &str = "DejaVu Sans, Verdana, Arial, sans-serif";

/// A figure on a page, in the words of a language.
pub fn write(figure: &Figure, page: impl Into<Page>, language: &Language) -> String {
    sheet(std::slice::from_ref(figure), 1, page.into(), language).0
}

/// Figures on one page, row by row in so many columns, each with its own heading and legend, or each within a page of its own; and the
/// width and height of the whole, mm.
pub fn sheet(figures: &[Figure], columns: usize, page: Page, language: &Language) -> (String, [f64; 2]) {
    if let [figure] = figures {
        return animate(std::slice::from_ref(figure), page, 0.0, language);
    }
    let columns = columns.max(1);
    let cell = match page {
        Page::Of([width, height]) => {
            let rows = figures.len().div_ceil(columns).max(1);
            Page::Of([width / columns as f64, height / rows as f64])
        }
        within @ Page::Within(_) => within,
    };
    let drawn: Vec<_> = figures.iter().map(|figure| elements(figure, cell, Style::NOTE, language)).collect();
    let side = |axis: usize| drawn.iter().map(|(_, size)| size[axis]).fold(0.0, f64::max);
    let [width, height] = [side(0), side(1)];
    let placed = |(index, (elements, _)): (usize, &(Vec<Element>, [f64; 2]))| {
        let inner: String = elements.iter().map(|element| markup(element, "") + "\n").collect();
        let [x, y] = [(index % columns) as f64 * width, (index / columns) as f64 * height];
        format!("<g transform=\"translate({x} {y})\">\n{inner}</g>")
    };
    let title = figures.first().map(|figure| figure.title.render(language)).unwrap_or_default();
    let whole = [columns as f64 * width, figures.len().div_ceil(columns) as f64 * height];
    (document(&title, whole, drawn.iter().enumerate().map(placed)), whole)
}

/// A figure that moves: its frames follow each other in equal times and repeat; `seconds` is the time of all.
///
/// What is equal in all frames is written once; between two frames everything moves in straight lines. A frame that does
/// not have the elements of the first one is left out. The second value is the size of the page, mm.
pub fn animate(
    frames: &[Figure],
    page: impl Into<Page>,
    seconds: f64,
    language: &Language,
) -> (String, [f64; 2]) {
    let page = page.into();
    let drawn = frames.iter().map(|frame| elements(frame, page, Style::NOTE, language));
    let (mut all, sizes): (Vec<Vec<Element>>, Vec<[f64; 2]>) = drawn.unzip();
    let (Some(first), Some(size)) = (all.first().cloned(), sizes.first()) else { return Default::default() };
    let names = |frame: &[Element]| frame.iter().map(name).collect::<Vec<_>>();
    all.retain(|frame| names(frame) == names(&first));
    // The last frame leads back to the first one.
    all.push(first.clone());
    let parts = (0..first.len()).map(|index| {
        let of: Vec<&Element> = all.iter().map(|frame| &frame[index]).collect();
        markup(of[0], &motion(&of, seconds))
    });
    (document(&frames[0].title.render(language), *size, parts), *size)
}

fn motion(frames: &[&Element], seconds: f64) -> String {
    let mut text = String::new();
    let frames: Vec<_> = frames.iter().map(|frame| attributes(frame)).collect();
    for (at, (name, first)) in frames[0].iter().enumerate() {
        let values: Vec<&str> = frames.iter().filter_map(|frame| Some(frame.get(at)?.1.as_str())).collect();
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

/// A page of elements as a document, mm.
pub fn page(title: &str, size: [f64; 2], elements: &[Element]) -> String {
    document(title, size, elements.iter().map(|element| markup(element, "")))
}

fn name(element: &Element) -> &'static str {
    match element.form {
        Form::Line { .. } => "polyline",
        Form::Polygon { .. } => "polygon",
        Form::Circle { .. } => "circle",
        Form::Text { .. } => "text",
    }
}

fn attributes(element: &Element) -> Vec<(&'static str, String)> {
    let color = color(element.ink).to_owned();
    let mut all = Vec::new();
    match &element.form {
        Form::Line { points: line, dashes, opacity } => {
            all.extend([("points", points(line)), ("fill", "none".to_owned()), ("stroke", color)]);
            all.push(("stroke-width", mm(element.width)));
            let dashes: Vec<String> = dashes.iter().map(|length| mm(*length)).collect();
            all.extend((!dashes.is_empty()).then(|| ("stroke-dasharray", dashes.join(" "))));
            all.extend(opacity.map(|part| ("stroke-opacity", mm(part))));
        }
        Form::Polygon { corners, filled } => {
            all.push(("points", points(corners)));
            all.extend(outlined(element, *filled));
        }
        Form::Circle { at, radius, filled } => {
            all.extend([("cx", mm(at[0])), ("cy", mm(at[1])), ("r", mm(*radius))]);
            all.extend(outlined(element, *filled));
        }
        Form::Text { at, size, anchor, narrow, seen, .. } => {
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            // Narrow letters are so about their own place.
            let [x, y] = at.map(mm);
            if *narrow < 1.0 {
                all.push(("transform", format!("translate({x} {y}) scale({} 1)", mm(*narrow))));
            } else {
                all.extend([("x", x), ("y", y)]);
            }
            all.extend([("font-size", mm(*size)), ("fill", color)]);
            all.push(("text-anchor", anchor.to_owned()));
            let told = |seen| if seen { "visible" } else { "hidden" };
            all.extend(seen.map(|seen| ("visibility", told(seen).to_owned())));
        }
    }
    all
}

fn outlined(element: &Element, filled: Option<f64>) -> Vec<(&'static str, String)> {
    let color = color(element.ink).to_owned();
    let fill = match filled {
        None => "none".to_owned(),
        Some(0.0) => "#ffffff".to_owned(),
        Some(_) => color.clone(),
    };
    let mut all = vec![("stroke", color), ("stroke-width", mm(element.width)), ("fill", fill)];
    all.extend(filled.filter(|part| *part > 0.0 && *part < 1.0).map(|part| ("fill-opacity", mm(part))));
    all
}

/// A number of millimeters with two decimals: finer than any printer.
fn mm(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn points(all: &[Point]) -> String {
    let mut list = String::new();
    for at in all.iter().filter(|at| at[0].is_finite() && at[1].is_finite()) {
        let space = if list.is_empty() { "" } else { " " };
        let _ = write!(list, "{space}{},{}", mm(at[0]), mm(at[1]));
    }
    list
}

fn markup(element: &Element, inner: &str) -> String {
    let name = name(element);
    let mut text = format!("<{name}");
    for (name, value) in attributes(element) {
        let _ = write!(text, " {name}=\"{value}\"");
    }
    let letters = if let Form::Text { words: told, size, .. } = &element.form {
        words(told, *size)
    } else {
        String::new()
    };
    if letters.is_empty() && inner.is_empty() {
        return text + "/>";
    }
    format!("{text}>{letters}{inner}</{name}>")
}

fn words(text: &str, size: f64) -> String {
    let (mut markup, mut last) = (String::new(), Level::Line);
    for (part, level) in levels(text) {
        let (part, by) = (escaped(part), level.down(size) - last.down(size));
        let by = if level == last { String::new() } else { format!(" dy=\"{}\"", mm(by)) };
        last = level;
        let small = match level {
            Level::Line => String::new(),
            _ => format!(" font-size=\"{:.0}%\"", 100.0 * level.size()),
        };
        let _ = if by.is_empty() && small.is_empty() {
            write!(markup, "{part}")
        } else {
            write!(markup, "<tspan{by}{small}>{part}</tspan>")
        };
    }
    markup
}

/// A text in which nothing is markup.
pub fn escaped(text: &str) -> String {
    let visible = text.chars().filter(|letter| !letter.is_control()).collect::<String>();
    visible.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
