//! The moving picture in the README is what the program shows; `INSTA_UPDATE=always` writes it anew.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use assur_figure::svg::escaped;
use ratatui::buffer::{Buffer, Cell};
use ratatui::style::{Color, Modifier};

use super::{frame, opened, press};

/// The shown terminal, in cells, and a cell of it, px.
const SIZE: [u16; 2] = [80, 24];
const CELL: [u16; 2] = [8, 17];
/// From the top of a cell to the line on which its letter stands, px.
const BASE: u16 = 13;
/// Between two frames, px: letters may be wider than their cells.
const GAP: usize = 20;
const PAPER: &str = "#16181d";
const PEN: &str = "#d8dee9";
/// How long a position and a view are shown, in hundredths of a second.
const STEP: u32 = 30;
const VIEW: u32 = 250;
/// The keys before each frame, and how long it is shown.
const SCRIPT: [(&str, u32); 18] = [
    ("1", VIEW),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("Right Right Right Right", STEP),
    ("2", VIEW),
    ("3", VIEW),
    ("4", VIEW),
    ("7", VIEW),
    ("9", VIEW),
];

/// The color of a terminal as CSS; `None` for that of the terminal itself.
fn css(color: Color) -> Option<String> {
    let named = match color {
        Color::Reset => return None,
        Color::Rgb(r, g, b) => return Some(format!("#{r:02x}{g:02x}{b:02x}")),
        Color::DarkGray => "#7b8394",
        Color::Cyan | Color::LightCyan => "#6ccbdc",
        Color::Green | Color::LightGreen => "#8fc878",
        Color::Magenta | Color::LightMagenta => "#c79ae0",
        Color::Red | Color::LightRed => "#e8767f",
        Color::Yellow | Color::LightYellow => "#ebcb74",
        Color::Blue | Color::LightBlue => "#79a8f0",
        other => panic!("no color of the themes: {other:?}"),
    };
    Some(named.to_owned())
}

/// Letter, paper and weight of a cell.
fn look(cell: &Cell) -> (String, Option<String>, bool) {
    let [pen, paper] = [css(cell.fg), css(cell.bg)];
    let bold = cell.modifier.contains(Modifier::BOLD);
    if cell.modifier.contains(Modifier::REVERSED) {
        (paper.unwrap_or_else(|| PAPER.to_owned()), Some(pen.unwrap_or_else(|| PEN.to_owned())), bold)
    } else {
        (pen.unwrap_or_else(|| PEN.to_owned()), paper, bold)
    }
}

/// A row of cells: runs of one look, each as wide as its cells in any font.
fn row(cells: &[Cell]) -> String {
    let mut svg = String::new();
    let mut column = 0;
    for run in cells.chunk_by(|one, next| look(one) == look(next)) {
        let (pen, paper, bold) = look(&run[0]);
        let [x, width] = [column, run.len()].map(|count| count * usize::from(CELL[0]));
        column += run.len();
        if let Some(paper) = paper {
            let _ = write!(svg, r#"<path fill="{paper}" d="M{x} 0h{width}v{}h-{width}z"/>"#, CELL[1]);
        }
        let letters: String = run.iter().map(Cell::symbol).collect();
        let (indent, words) = (letters.len() - letters.trim_start().len(), letters.trim());
        if words.is_empty() {
            continue;
        }
        let (x, width) = (x + indent * usize::from(CELL[0]), words.chars().count() * usize::from(CELL[0]));
        let pen = if pen == PEN { String::new() } else { format!(r#" fill="{pen}""#) };
        let weight = if bold { r#" font-weight="bold""# } else { "" };
        let words = escaped(words);
        let _ = write!(svg, r#"<text x="{x}" y="{BASE}" textLength="{width}"{pen}{weight}>{words}</text>"#);
    }
    svg
}

/// Frames beside each other, before which a window goes on from one to the next. A row that several frames have stands once.
fn moving(frames: &[(Buffer, u32)]) -> String {
    let [width, height] = [0, 1].map(|axis| u32::from(SIZE[axis]) * u32::from(CELL[axis]));
    let whole: u32 = frames.iter().map(|(_, time)| time).sum();
    let (mut rows, mut used, mut steps, mut time) = (BTreeMap::new(), String::new(), String::new(), 0);
    for ((buffer, shown), x) in frames.iter().zip((0..).step_by(width as usize + GAP)) {
        let begin = 100.0 * f64::from(time) / f64::from(whole);
        let _ = write!(steps, "{begin:.3}%{{transform:translateX(-{x}px)}}");
        time += shown;
        for (cells, y) in buffer.content.chunks(SIZE[0].into()).zip((0..).step_by(CELL[1].into())) {
            let svg = row(cells);
            if !svg.is_empty() {
                let count = rows.len();
                let id: usize = *rows.entry(svg).or_insert(count);
                let _ = write!(used, r##"<use href="#r{id}" x="{x}" y="{y}"/>"##);
            }
        }
        used += "\n";
    }
    let mut rows: Vec<(usize, String)> = rows.into_iter().map(|(svg, id)| (id, svg)).collect();
    rows.sort_unstable();
    let rows: Vec<String> =
        rows.into_iter().map(|(id, svg)| format!("<g id=\"r{id}\">{svg}</g>\n")).collect();
    let rows = rows.concat();
    let seconds = f64::from(whole) / 100.0;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <style>text{{font:14px monospace;white-space:pre}}\
         .film{{animation:film {seconds}s steps(1,end) infinite}}@keyframes film{{{steps}}}</style>\n\
         <defs>\n{rows}</defs>\n<path fill=\"{PAPER}\" d=\"M0 0h{width}v{height}h-{width}z\"/>\n<g class=\"film\" fill=\"{PEN}\">\n{used}</g>\n</svg>\n"
    )
}

#[test]
fn the_moving_picture_shows_the_program() {
    let mut state = opened("shaper");
    let frames = SCRIPT.map(|(keys, time)| {
        press(&mut state, keys);
        (frame(&state, SIZE[0], SIZE[1]), time)
    });
    let svg = moving(&frames);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/screen.svg");
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        std::fs::write(path, svg).unwrap();
    } else {
        assert_eq!(std::fs::read_to_string(path).unwrap(), svg, "docs/screen.svg");
    }
}
