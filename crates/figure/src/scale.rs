//! What lengths of a plane stand for.

use assur_words::{Text, quantity};

use crate::bounds::Bounds;
use crate::model::{Frame, Panel};
use crate::number::{plain, round_length, round_up};

/// Scale factors of drawings, as parts of a power of ten: those of ISO 5455 and of drawing offices.
pub(crate) const SCALES: [f64; 5] = [1.0, 2.0, 2.5, 4.0, 5.0];

/// A scale of a plane: of its own lengths, or of what is drawn in it to another scale, as forces on a mechanism are.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// Symbol of what is drawn, the index of the scale factor: `l`, `v`, `F`. Without one, as on a screen, the drawing fills its room
    /// and tells no factor.
    pub symbol: &'static str,
    /// SI unit of what is drawn.
    pub unit: String,
    /// How many of it a unit of the plane stands for.
    pub size: f64,
}

impl Scale {
    /// Of a plane in this unit.
    pub fn of(symbol: &'static str, unit: &str) -> Self {
        Self { symbol, unit: unit.to_owned(), size: 1.0 }
    }

    /// Of vectors in a plane of lengths, of which a meter is the next round number that is at least `least`.
    pub fn vectors(symbol: &'static str, unit: &str, least: f64) -> Self {
        Self { size: round_up(least, &SCALES), ..Self::of(symbol, unit) }
    }

    /// The longest bar of a round number of units, lengths in mm, that is not longer than this: its length in units of the plane, and how
    /// it is told.
    pub(crate) fn bar(&self, most: f64) -> (f64, Text) {
        let (unit, factor) = if self.unit == "m" { ("mm", 1e3) } else { (&*self.unit, 1.0) };
        let round = round_length(most * self.size * factor);
        (round / (self.size * factor), quantity(plain(round), unit.to_owned()))
    }
}

/// Gives planes the place that all of them need, so that they have one scale, and their origin at one place.
pub fn one_scale<'a>(panels: impl Iterator<Item = &'a mut Panel>) {
    let planes = panels.filter_map(|panel| match &mut panel.frame {
        Frame::Plane { bounds, .. } => Some(bounds),
        Frame::Axes { .. } => None,
    });
    let planes: Vec<&mut Bounds> = planes.collect();
    let all = Bounds::around(planes.iter().flat_map(|own| [own.low, own.high]));
    for own in planes {
        *own = all;
    }
}
