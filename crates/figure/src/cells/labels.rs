//! Signs, and names next to their places, without overlaps.

use unicode_width::UnicodeWidthStr;

use super::Spot;
use super::raster::{Raster, short, whole};
use crate::model::Ink;

#[derive(Debug)]
pub(crate) struct Labels {
    size: [u16; 2],
    texts: Vec<Spot>,
    /// Rows and columns of the names among them, with a free column on each side, so that two names don't read as one.
    names: Vec<(u16, std::ops::Range<u16>)>,
}

impl Labels {
    pub(crate) fn new(size: [u16; 2]) -> Self {
        Self { size, texts: Vec::new(), names: Vec::new() }
    }

    /// Occupies exactly a cell; does nothing outside the area.
    pub(crate) fn put(&mut self, at: [f64; 2], text: &str, ink: Ink) {
        self.texts.extend(self.spot([at[0].floor(), at[1].floor()], text, ink));
    }

    /// Occupies a cell unless something is written there.
    pub(crate) fn fill(&mut self, at: [f64; 2], text: &str, ink: Ink) {
        let spot = self.spot([at[0].floor(), at[1].floor()], text, ink);
        self.texts.extend(spot.filter(|spot| !self.is_taken(spot)));
    }

    /// Occupies a cell unless something is drawn or written there.
    pub(crate) fn faint(&mut self, raster: &Raster, at: [f64; 2], text: &str, ink: Ink) {
        let spot = self.spot([at[0].floor(), at[1].floor()], text, ink);
        self.texts.extend(spot.filter(|spot| is_blank(raster, spot) && !self.is_taken(spot)));
    }

    /// Writes next to a cell: where nothing is drawn if there is such a place, else, if it is needed, where no other
    /// text is.
    pub(crate) fn beside(&mut self, raster: &Raster, at: [f64; 2], text: &str, ink: Ink, needed: bool) {
        let width = text.width() as f64;
        let (x, y) = (at[0].floor(), at[1].floor());
        let left = x - width;
        let offers = [
            [x + 1.0, y - 1.0],
            [left, y - 1.0],
            [x + 1.0, y + 1.0],
            [left, y + 1.0],
            [x + 2.0, y],
            [left - 1.0, y],
        ];
        let offers = offers.into_iter().filter_map(|offer| self.spot(offer, text, ink));
        let mut spots: Vec<Spot> =
            offers.filter(|spot| !self.is_taken(spot) && !self.meets_name(spot)).collect();
        let free = spots.iter().position(|spot| is_blank(raster, spot));
        let chosen = free.or((needed && !spots.is_empty()).then_some(0));
        if let Some(spot) = chosen.map(|index| spots.swap_remove(index)) {
            let end = spot.column + short(spot.text.width());
            self.names.push((spot.row, spot.column.saturating_sub(1)..end + 1));
            self.texts.push(spot);
        }
    }

    /// All texts, over the drawing.
    pub(crate) fn into_spots(self) -> Vec<Spot> {
        self.texts
    }

    fn is_taken(&self, spot: &Spot) -> bool {
        let end = |spot: &Spot| spot.column + short(spot.text.width());
        let meets =
            |other: &Spot| other.row == spot.row && other.column < end(spot) && spot.column < end(other);
        self.texts.iter().any(meets)
    }

    fn meets_name(&self, spot: &Spot) -> bool {
        let end = spot.column + short(spot.text.width());
        let meets = |(row, columns): &(u16, std::ops::Range<u16>)| {
            *row == spot.row && columns.start < end && spot.column < columns.end
        };
        self.names.iter().any(meets)
    }

    fn spot(&self, [x, y]: [f64; 2], text: &str, ink: Ink) -> Option<Spot> {
        let [columns, rows] = self.size.map(f64::from);
        let inside = x >= 0.0 && y >= 0.0 && x + text.width() as f64 <= columns && y < rows;
        inside.then(|| Spot { column: short(whole(x)), row: short(whole(y)), text: text.to_owned(), ink })
    }
}

fn is_blank(raster: &Raster, spot: &Spot) -> bool {
    (0..spot.text.width())
        .all(|ahead| raster.is_free(usize::from(spot.column) + ahead, usize::from(spot.row)))
}

/// The character of an arrow's head; the direction is right and down on the screen, in cell widths.
pub(crate) fn head([right, down]: [f64; 2]) -> &'static str {
    match (right.abs() >= down.abs(), right > 0.0, down > 0.0) {
        (true, true, _) => ">",
        (true, false, _) => "<",
        (false, _, true) => "v",
        (false, _, false) => "^",
    }
}
