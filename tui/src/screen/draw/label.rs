//! Names next to their places, without overlaps.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::raster::{Raster, short, whole};

/// The occupied cells of one area.
#[derive(Debug)]
pub(crate) struct Labels {
    area: Rect,
    texts: Vec<(Rect, String, Style)>,
    /// Texts that are dropped if anything else is drawn in their cell.
    faint: Vec<(Rect, &'static str, Style)>,
}

impl Labels {
    pub(crate) fn new(area: Rect) -> Self {
        Self { area, texts: Vec::new(), faint: Vec::new() }
    }

    /// Occupies exactly a cell; does nothing outside the area.
    pub(crate) fn put(&mut self, at: [f64; 2], text: &str, style: Style) {
        if let Some(spot) = self.spot([at[0].floor(), at[1].floor()], text.width()) {
            self.texts.push((spot, text.to_owned(), style));
        }
    }

    /// Occupies a cell unless something is drawn there.
    pub(crate) fn faint(&mut self, at: [f64; 2], text: &'static str, style: Style) {
        if let Some(spot) = self.spot([at[0].floor(), at[1].floor()], text.width()) {
            self.faint.push((spot, text, style));
        }
    }

    /// Writes next to a cell: where nothing is drawn if there is such a place, else where no other name is.
    pub(crate) fn beside(&mut self, raster: &Raster, at: [f64; 2], text: &str, style: Style) {
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
        let spots: Vec<Rect> = offers
            .into_iter()
            .filter_map(|offer| self.spot(offer, text.width()))
            .filter(|spot| self.texts.iter().all(|(other, ..)| !other.intersects(*spot)))
            .collect();
        let free = |spot: &&Rect| {
            (spot.x..spot.right())
                .all(|x| raster.is_free(usize::from(x - self.area.x), usize::from(spot.y - self.area.y)))
        };
        if let Some(spot) = spots.iter().find(free).or(spots.first()) {
            self.texts.push((*spot, text.to_owned(), style));
        }
    }

    /// Writes all texts over the drawing.
    pub(crate) fn write(&self, raster: &Raster, buffer: &mut Buffer) {
        for (spot, text, style) in &self.faint {
            if raster.is_free(usize::from(spot.x - self.area.x), usize::from(spot.y - self.area.y)) {
                buffer.set_stringn(spot.x, spot.y, text, usize::from(spot.width), *style);
            }
        }
        for (spot, text, style) in &self.texts {
            buffer.set_stringn(spot.x, spot.y, text, usize::from(spot.width), *style);
        }
    }

    fn spot(&self, [x, y]: [f64; 2], width: usize) -> Option<Rect> {
        let inside = x >= 0.0
            && y >= 0.0
            && x + width as f64 <= f64::from(self.area.width)
            && y < f64::from(self.area.height);
        inside.then(|| {
            let (x, y) = (whole(x), whole(y));
            Rect::new(self.area.x + short(x), self.area.y + short(y), short(width), 1)
        })
    }
}

/// The character of an arrow's head; the direction is right and down on the screen, in cell widths.
pub(super) fn head([right, down]: [f64; 2]) -> &'static str {
    match (right.abs() >= down.abs(), right > 0.0, down > 0.0) {
        (true, true, _) => ">",
        (true, false, _) => "<",
        (false, _, true) => "v",
        (false, _, false) => "^",
    }
}
