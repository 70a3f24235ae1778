//! Frame and title block.

use assur_figure::{Anchor, Element, Ink, Style};
use assur_pdf::text_width;
use assur_scene::{Note, SheetField};
use assur_words::{Language, Text, measured, text};

use crate::format::{Area, Standard};

/// Size of the small letters of a title block, mm.
const SMALL: f64 = 3.5;
/// Space beside the letters of a cell, mm.
const BESIDE: f64 = 0.8;

/// What a title block is filled with.
pub(crate) struct Filling<'a> {
    pub(crate) title: &'a str,
    /// What the drawing is of.
    pub(crate) drawing: Text,
    pub(crate) note: &'a Note,
    pub(crate) language: &'a Language,
    /// Number of the sheet, from 1, and of all.
    pub(crate) sheet: [usize; 2],
    /// Mass of the links, kg.
    pub(crate) mass: f64,
    /// How many meters of the mechanism a millimeter of its field stands for, where this sheet has it.
    pub(crate) scale: Option<f64>,
}

impl Filling<'_> {
    /// A field of the note; empty where it is left out.
    fn of(&self, text: Option<&Text>) -> String {
        text.map(|text| text.render(self.language)).unwrap_or_default()
    }
}

/// What a sheet with these fields is of.
pub(crate) fn drawing(fields: &[SheetField]) -> Text {
    use SheetField::{Accelerations, Diagrams, Dynamics, Forces, Lever, Mechanism, Velocities};
    let has = |any: &[SheetField]| fields.iter().any(|field| any.contains(field));
    let motion = has(&[Mechanism, Diagrams, Velocities, Accelerations]);
    match (motion, has(&[Forces, Lever]), has(&[Dynamics])) {
        (true, true, true) => text!("sheet-drawing-all"),
        (true, true, false) => text!("sheet-drawing"),
        (true, false, true) => text!("sheet-drawing-motion-dynamics"),
        (true, false, false) => text!("sheet-drawing-motion"),
        (false, true, true) => text!("sheet-drawing-forces-dynamics"),
        (false, true, false) => text!("sheet-drawing-forces"),
        (false, false, true) => text!("sheet-drawing-dynamics"),
        (false, false, false) => text!("sheet-results"),
    }
}

/// The edge of the sheet, its frame and the title block.
pub(crate) fn elements(standard: Standard, [width, height]: [f64; 2], filling: &Filling<'_>) -> Vec<Element> {
    let frame = standard.frame([width, height]);
    let mut block = Block { corner: [0.0; 2], all: Vec::new() };
    block.rectangle([0.0, 0.0, width, height], Style::SHEET.fine);
    block.rectangle(frame, Style::SHEET.thick);
    let [left, top, ..] = standard.title(frame);
    block.corner = [left, top];
    let [width, height] = standard.block();
    block.rectangle([0.0, 0.0, width, height], Style::SHEET.thick);
    match standard {
        Standard::Iso => iso(&mut block, filling),
        Standard::Gost => gost(&mut block, filling),
    }
    block.all
}

struct Block {
    corner: [f64; 2],
    all: Vec<Element>,
}

impl Block {
    fn rectangle(&mut self, [left, top, right, bottom]: Area, width: f64) {
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
        self.line(&corners, width);
    }

    fn line(&mut self, points: &[[f64; 2]], width: f64) {
        let [x, y] = self.corner;
        let points: Vec<_> = points.iter().map(|at| [at[0] + x, at[1] + y]).collect();
        self.all.push(Element::line(points, width, Ink::Text));
    }

    fn text(&mut self, [x, y]: [f64; 2], words: &str, size: f64, anchor: Anchor, room: f64) {
        let [left, top] = self.corner;
        let mut text = Element::text([left + x, top + y], words, size, anchor, Ink::Text);
        text.narrowed(text_width(words, size), room - 2.0 * BESIDE);
        if !words.is_empty() {
            self.all.push(text);
        }
    }

    /// A text in a cell, in the middle of its height.
    fn cell(&mut self, [left, top, right, bottom]: Area, words: &str, size: f64, anchor: Anchor) {
        let x = match anchor {
            Anchor::Start => left + BESIDE,
            Anchor::Middle => 0.5 * (left + right),
            Anchor::End => right - BESIDE,
        };
        let room = right - left;
        // What would be much narrower than it is stands in several lines.
        let fits = |count: usize| count as f64 * 1.4 * size <= bottom - top;
        let is_wide = |count: usize| text_width(words, size) > count as f64 * 1.1 * room;
        let mut count = 1;
        while is_wide(count) && fits(count + 1) {
            count += 1;
        }
        let lines = divided(words, count, size);
        let first = 0.5 * (top + bottom) + 0.365 * size - 0.65 * size * lines.len().saturating_sub(1) as f64;
        for (row, line) in lines.into_iter().enumerate() {
            self.text([x, first + 1.3 * size * row as f64], &line, size, anchor, room);
        }
    }

    /// A cell of ISO 7200: what it is above, and its value below.
    fn field(&mut self, area: Area, told: &Text, value: &str, language: &Language) {
        let [left, top, right, bottom] = area;
        self.rectangle(area, Style::SHEET.line);
        self.text([left + BESIDE, top + 3.4], &told.render(language), SMALL, Anchor::Start, right - left);
        self.cell(
            [left, top + 3.6, right, bottom],
            value,
            Style::SHEET.em.min(bottom - top - 4.4),
            Anchor::Start,
        );
    }
}

/// A text in at most so many lines, about equally long, divided between its words.
fn divided(words: &str, count: usize, size: f64) -> Vec<String> {
    /// By how much lines grow until there are few enough.
    const MORE: f64 = 1.1;
    let mut width = text_width(words, size) / count.max(1) as f64;
    loop {
        let lines = wrapped(words, width, size);
        if lines.len() <= count.max(1) {
            return lines;
        }
        width *= MORE;
    }
}

/// A text in lines of this width, of a word at least.
fn wrapped(words: &str, width: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), size) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn iso(block: &mut Block, filling: &Filling<'_>) {
    let (note, language) = (filling.note, filling.language);
    let of = |text: &Option<Text>| filling.of(text.as_ref());
    let [sheet, sheets] = filling.sheet;
    let rows = [
        ([0.0, 0.0, 45.0, 9.0], text!("sheet-department"), of(&note.department)),
        ([45.0, 0.0, 90.0, 9.0], text!("sheet-technical-reference"), of(&note.supervisor)),
        ([90.0, 0.0, 140.0, 9.0], text!("sheet-creator"), of(&note.author)),
        ([140.0, 0.0, 180.0, 9.0], text!("sheet-approval"), String::new()),
        ([0.0, 9.0, 45.0, 36.0], text!("sheet-owner"), owner(note, language)),
        ([45.0, 9.0, 120.0, 18.0], text!("sheet-document-type"), filling.drawing.render(language)),
        ([45.0, 18.0, 120.0, 36.0], text!("sheet-title"), filling.title.to_owned()),
        ([120.0, 9.0, 180.0, 18.0], text!("sheet-status"), String::new()),
        ([120.0, 18.0, 180.0, 27.0], text!("sheet-number"), of(&note.sheet.number)),
        ([120.0, 27.0, 132.0, 36.0], text!("sheet-revision"), String::new()),
        ([132.0, 27.0, 155.0, 36.0], text!("sheet-date"), String::new()),
        ([155.0, 27.0, 167.0, 36.0], text!("sheet-language"), language.code.to_owned()),
        ([167.0, 27.0, 180.0, 36.0], text!("sheet-sheet"), format!("{sheet}/{sheets}")),
    ];
    for (area, told, value) in rows {
        block.field(area, &told, &value, language);
    }
}

/// ГОСТ 2.104, form 1: 185 x 55 mm.
fn gost(block: &mut Block, filling: &Filling<'_>) {
    gost_changes(block, filling);
    gost_signatures(block, filling);
    gost_rules(block);
    gost_names(block, filling);
    gost_numbers(block, filling);
}

/// The table of changes at the left: its rules, and its heads below it.
fn gost_changes(block: &mut Block, filling: &Filling<'_>) {
    let (thick, fine) = (Style::SHEET.thick, Style::SHEET.fine);
    for row in 1..11 {
        let y = 5.0 * f64::from(row);
        block.line(&[[0.0, y], [65.0, y]], if row == 4 || row == 5 { thick } else { fine });
    }
    block.line(&[[7.0, 0.0], [7.0, 25.0]], thick);
    for x in [17.0, 40.0, 55.0, 65.0] {
        block.line(&[[x, 0.0], [x, 55.0]], thick);
    }
    let heads = [
        ([0.0, 20.0, 7.0, 25.0], text!("sheet-change")),
        ([7.0, 20.0, 17.0, 25.0], text!("sheet-sheet")),
        ([17.0, 20.0, 40.0, 25.0], text!("sheet-document")),
        ([40.0, 20.0, 55.0, 25.0], text!("sheet-signature")),
        ([55.0, 20.0, 65.0, 25.0], text!("sheet-date")),
    ];
    for (area, head) in heads {
        block.cell(area, &head.render(filling.language), SMALL, Anchor::Middle);
    }
}

/// Who made the drawing and who checks it, below the changes.
fn gost_signatures(block: &mut Block, filling: &Filling<'_>) {
    let signed = [
        (text!("sheet-made"), filling.of(filling.note.author.as_ref())),
        (text!("sheet-checked"), filling.of(filling.note.supervisor.as_ref())),
        (text!("sheet-technical-control"), String::new()),
        (Text::default(), String::new()),
        (text!("sheet-norm-control"), String::new()),
        (text!("sheet-approved"), String::new()),
    ];
    for (row, (what, who)) in signed.into_iter().enumerate() {
        let (top, bottom) = (25.0 + 5.0 * row as f64, 30.0 + 5.0 * row as f64);
        block.cell([0.0, top, 17.0, bottom], &what.render(filling.language), SMALL, Anchor::Start);
        block.cell([17.0, top, 40.0, bottom], &who, SMALL, Anchor::Start);
    }
}

/// The rules of the middle and the right part.
fn gost_rules(block: &mut Block) {
    let (thick, fine) = (Style::SHEET.thick, Style::SHEET.fine);
    block.line(&[[65.0, 15.0], [185.0, 15.0]], thick);
    block.line(&[[65.0, 40.0], [185.0, 40.0]], thick);
    block.line(&[[135.0, 15.0], [135.0, 55.0]], thick);
    for y in [20.0, 35.0] {
        block.line(&[[135.0, y], [185.0, y]], thick);
    }
    for x in [150.0, 167.0] {
        block.line(&[[x, 15.0], [x, 35.0]], thick);
    }
    for x in [140.0, 145.0] {
        block.line(&[[x, 20.0], [x, 35.0]], fine);
    }
    block.line(&[[155.0, 35.0], [155.0, 40.0]], thick);
}

/// Designation and title, what the drawing is of, the organization.
fn gost_names(block: &mut Block, filling: &Filling<'_>) {
    let (note, language, large) = (filling.note, filling.language, Style::SHEET.em);
    let drawing = filling.drawing.render(language);
    block.cell(
        [65.0, 0.0, 185.0, 15.0],
        &filling.of(note.sheet.number.as_ref()),
        1.4 * large,
        Anchor::Middle,
    );
    block.cell([65.0, 15.0, 135.0, 40.0], filling.title, large, Anchor::Middle);
    block.cell([65.0, 40.0, 135.0, 55.0], &drawing, large, Anchor::Middle);
    block.cell([135.0, 40.0, 185.0, 55.0], &owner(note, language), large, Anchor::Middle);
}

/// Letter, mass, scale, and the number of the sheet.
fn gost_numbers(block: &mut Block, filling: &Filling<'_>) {
    let (language, large) = (filling.language, Style::SHEET.em);
    let told = |text: Text| text.render(language);
    let heads = [
        ([135.0, 15.0, 150.0, 20.0], text!("sheet-letter")),
        ([150.0, 15.0, 167.0, 20.0], text!("sheet-mass")),
        ([167.0, 15.0, 185.0, 20.0], text!("sheet-scale")),
    ];
    for (area, head) in heads {
        block.cell(area, &told(head), SMALL, Anchor::Middle);
    }
    block.cell([135.0, 20.0, 140.0, 35.0], &told(text!("sheet-letter-of-study")), large, Anchor::Middle);
    let none = || "–".to_owned();
    let mass = if filling.mass > 0.0 { told(measured(filling.mass, 4, "")) } else { none() };
    block.cell([150.0, 20.0, 167.0, 35.0], &mass, large, Anchor::Middle);
    let scale = filling.scale.map_or_else(none, |scale| ratio(scale, language));
    block.cell([167.0, 20.0, 185.0, 35.0], &scale, large, Anchor::Middle);
    let [sheet, sheets] = filling.sheet;
    let number = |what: Text, number: usize| format!("{} {number}", told(what));
    block.cell([135.0, 35.0, 155.0, 40.0], &number(text!("sheet-sheet"), sheet), SMALL, Anchor::Start);
    block.cell([155.0, 35.0, 185.0, 40.0], &number(text!("sheet-sheets"), sheets), SMALL, Anchor::Start);
}

/// `1:2.5`, `2:1`: a length on the sheet to the true one, where a millimeter stands for so many meters.
fn ratio(scale: f64, language: &Language) -> String {
    let times = |value: f64| measured(value, 4, "").render(language);
    let smaller = 1e3 * scale;
    if smaller >= 1.0 { format!("1:{}", times(smaller)) } else { format!("{}:1", times(1.0 / smaller)) }
}

/// The university, or the department, and the group of the author.
fn owner(note: &Note, language: &Language) -> String {
    let house = note.university.as_ref().or(note.department.as_ref());
    assur_words::list(house.into_iter().chain(&note.group).cloned()).render(language)
}
