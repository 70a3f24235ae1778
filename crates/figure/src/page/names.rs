//! Names beside their points, where they cover least.

use super::Room;
use crate::bounds::inside;
use crate::model::{Point, Sign};
use crate::trace::shifted;

/// Mean width of a letter and of a digit of a proportional font, in text sizes.
const LETTER: f64 = 0.62;
const NARROW: f64 = 0.36;
/// Widths are sums of those of letters, which differ by rounding with their order, mm: a text has room in its own width.
const ROUNDING: f64 = 1e-9;
/// Distance of a name from its point, in text sizes.
const APART: f64 = 0.35;

/// Width of a text, mm: within a tenth for the fonts that are asked for. The marks of subscripts and superscripts are not seen.
pub fn text_width(text: &str, em: f64) -> f64 {
    let of = |letter: char| match letter {
        'i' | 'j' | 'l' | 't' | 'f' | 'r' | 'I' | ' ' | '.' | ',' | ':' | ';' | '\'' | '|' | '(' | ')'
        | '/' => NARROW,
        'm' | 'w' | 'M' | 'W' | 'Ш' | 'Щ' | 'Ж' | 'Ю' => 1.5 * LETTER,
        _ => LETTER,
    };
    text.chars().filter(|letter| !"_^{}".contains(*letter)).map(of).sum::<f64>() * em
}

/// A text in lines of at most this width, divided between its words; none of an empty text.
pub(super) fn wrapped(text: &str, width: f64, em: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ').filter(|_| !text.is_empty()) {
        match lines.last_mut() {
            Some(line) if text_width(line, em) + text_width(word, em) + NARROW * em <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| fitted(line, width, em)).collect()
}

/// The beginning of a text that fits into this width, with an ellipsis where the rest is missing.
pub(super) fn fitted(text: &str, width: f64, em: f64) -> String {
    if text_width(text, em) <= width + ROUNDING {
        return text.to_owned();
    }
    let beginnings = text.char_indices().map(|(end, _)| &text[..end]);
    let kept = beginnings.take_while(|kept| kept.is_empty() || text_width(kept, em) + em <= width).last();
    kept.unwrap_or_default().to_owned() + "…"
}

/// The room of a name between its text and a line, in text sizes.
const CLEAR: f64 = 0.12;
/// Distances from its point at which a place for a name is looked for.
const RINGS: usize = 12;
/// Up to this one, a place where it covers nothing is looked for.
const NEAR: usize = 5;
/// What a line between a name and its point counts, in covered lines: the name seems to belong to that line.
const CUT: usize = 4;
/// What covering a text or a sign counts, in covered lines.
const WRITTEN: usize = 1000;

/// The places of a text of this width around a point at a distance: to the right and to the left above, below and beside it, above and
/// below it in the middle, then between these.
fn around([x, y]: Point, [width, away]: [f64; 2], em: f64) -> [[f64; 4]; 12] {
    let (right, left) = (x + away, x - away - width);
    let (above, below) = (y - away - 0.75 * em, y + away);
    let middle = [x - 0.5 * width, y - 0.4 * em];
    let corners = [
        [right, above],
        [left, above],
        [right, below],
        [left, below],
        [right, middle[1]],
        [left, middle[1]],
        [middle[0], above],
        [middle[0], below],
        [x, above],
        [x - width, above],
        [x, below],
        [x - width, below],
    ];
    corners.map(|[left, top]| [left, top, left + width, top + 0.8 * em])
}

/// Least distance of two names beside each other, in text sizes: closer, they read as one.
const BETWEEN: f64 = 0.3;

/// What is covered so far.
#[derive(Debug)]
pub(crate) struct Names {
    room: Room,
    /// Text size, mm.
    em: f64,
    lines: Vec<[Point; 2]>,
    /// Left, top, right, bottom of texts and signs.
    texts: Vec<[f64; 4]>,
}

impl Names {
    pub(crate) fn new(room: Room, em: f64) -> Self {
        Self { room, em, lines: Vec::new(), texts: Vec::new() }
    }

    /// Remembers a line that names must not cover.
    pub(crate) fn avoid(&mut self, points: &[Point]) {
        self.lines.extend(points.windows(2).map(|two| [two[0], two[1]]));
    }

    /// Remembers a sign that names must not cover.
    pub(crate) fn keep_sign(&mut self, at: Point, along: Point, sign: Sign) {
        match sign {
            Sign::Hatch => self.avoid(&[at, shifted(at, along, 0.4 * self.em)]),
            Sign::Block => self.keep(at, 0.5 * self.em),
            Sign::Bearing => self.keep_bearing(at),
            _ => self.keep(at, 0.2 * self.em),
        }
    }

    /// Remembers a square of this half side around a point.
    fn keep(&mut self, [x, y]: Point, half: f64) {
        self.texts.push([x - half, y - half, x + half, y + half]);
    }

    /// Remembers a bearing below its point.
    fn keep_bearing(&mut self, [x, y]: Point) {
        self.texts.push([x - 1.6 * self.em, y - 0.3 * self.em, x + 1.2 * self.em, y + 1.5 * self.em]);
    }

    /// The place of a name beside a point, where its baseline begins, and whether it is seen: not where it is not needed
    /// and would cover something.
    pub(crate) fn place(&mut self, at: Point, name: &str, needed: bool) -> (Point, bool) {
        let (width, away) = (text_width(name, self.em), APART * self.em);
        let rings = if needed { RINGS } else { NEAR };
        let near = self.near(at, [width, rings as f64 * away]);
        // What it covers, what lies between it and its point, and the place.
        let mut best: Option<(usize, usize, [f64; 4])> = None;
        for ring in 1..=rings {
            for spot in around(at, [width, ring as f64 * away], self.em) {
                let most = best.map_or(usize::MAX, |(least, cut, _)| least + cut);
                let Some(covered) = near.covered(spot, most) else { continue };
                let cut = if covered < WRITTEN { CUT * near.between(at, spot) } else { 0 };
                if best.is_none_or(|(least, hides, _)| covered + cut < least + hides) {
                    best = Some((covered, cut, spot));
                }
            }
            // Near the point a line may be covered rather than go far away; a text or a sign may not.
            if best.is_some_and(|(least, cut, _)| least + cut == 0 || (ring >= NEAR && least < WRITTEN)) {
                break;
            }
        }
        let seen = |(covered, ..): &(usize, usize, [f64; 4])| *covered == 0 || needed;
        match best.filter(seen) {
            Some((.., spot)) => {
                self.texts.push(spot);
                ([spot[0], spot[3]], true)
            }
            None => (at, false),
        }
    }

    /// What a text of this width up to a distance from a point may cover, or may have between itself and the point.
    fn near(&self, [x, y]: Point, [width, away]: [f64; 2]) -> Self {
        let (aside, above) = (width + away + self.em, away + 2.0 * self.em);
        let reach = [x - aside, y - above, x + aside, y + above];
        let meets = |[left, top, right, bottom]: [f64; 4]| {
            left <= reach[2] && reach[0] <= right && top <= reach[3] && reach[1] <= bottom
        };
        let box_of = |[from, to]: [Point; 2]| {
            [from[0].min(to[0]), from[1].min(to[1]), from[0].max(to[0]), from[1].max(to[1])]
        };
        Self {
            room: self.room,
            em: self.em,
            lines: self.lines.iter().copied().filter(|line| meets(box_of(*line))).collect(),
            texts: self.texts.iter().copied().filter(|text| meets(*text)).collect(),
        }
    }

    /// Number of lines between a point and a text beside it: the text seems to belong to them. The lines of the point itself don't
    /// count.
    fn between(&self, at: Point, [left, top, right, bottom]: [f64; 4]) -> usize {
        let to = [at[0].clamp(left, right), at[1].clamp(top, bottom)];
        let apart = |line: &&[Point; 2]| {
            let side = |of: Point, [from, to]: [Point; 2]| {
                (to[0] - from[0]) * (of[1] - from[1]) - (to[1] - from[1]) * (of[0] - from[0])
            };
            let own = APART * self.em * (line[1][0] - line[0][0]).hypot(line[1][1] - line[0][1]);
            // A corner of a line counts for one of its two pieces.
            let parted = |two: [Point; 2], by| (side(two[0], by) < 0.0) != (side(two[1], by) < 0.0);
            side(at, **line).abs() > 0.1 * own && parted([at, to], **line) && parted(**line, [at, to])
        };
        self.lines.iter().filter(apart).count()
    }

    /// Number of lines and texts that a text would cover; `None` outside the room, and where they are as many as `most` or more.
    fn covered(&self, spot: [f64; 4], most: usize) -> Option<usize> {
        let [left, top, right, bottom] = spot;
        let room = self.room;
        let fits = left >= room.left
            && top >= room.top
            && right <= room.left + room.width
            && bottom <= room.top + room.height;
        let clear = CLEAR * self.em;
        let apart = BETWEEN * self.em;
        let meets = |other: &&[f64; 4]| {
            other[0] < right + apart
                && left < other[2] + apart
                && other[1] < bottom + clear
                && top < other[3] + clear
        };
        // Two names over each other are unreadable, a name over a line is not.
        let written = if fits { WRITTEN * self.texts.iter().filter(meets).count() } else { most };
        let free = most.checked_sub(written).filter(|free| *free > 0)?;
        let [low, high] = [[left - clear, top - clear], [right + clear, bottom + clear]];
        let crosses = |line: &&[Point; 2]| {
            let aside = |axis: usize| {
                line[0][axis].max(line[1][axis]) < low[axis] || high[axis] < line[0][axis].min(line[1][axis])
            };
            !aside(0) && !aside(1) && inside(**line, low, high).is_some()
        };
        let crossed = self.lines.iter().filter(crosses).take(free).count();
        (crossed < free).then_some(written + crossed)
    }
}
