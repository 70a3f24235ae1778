//! What lengths of a plane stand for.

use assur_words::{Text, joined, name, quantity};

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

    /// Of numbers in a unit of an axis, by the symbol that drawings of mechanisms have for it; `None` of a unit that has none.
    pub fn measuring(unit: &str) -> Option<Self> {
        let (symbol, unit, size) = match unit {
            "mm" => ("s", "m", 1e-3),
            "mm/rad" => ("s'", "m/rad", 1e-3),
            "mm/rad2" => ("s''", "m/rad2", 1e-3),
            "mm/s" => ("v", "m/s", 1e-3),
            "m/s" => ("v", unit, 1.0),
            "m/s2" => ("a", unit, 1.0),
            "deg" | "rad" => ("φ", unit, 1.0),
            "rad/s" => ("ω", unit, 1.0),
            "rad/s2" => ("ε", unit, 1.0),
            "s" => ("t", unit, 1.0),
            "N" => ("F", unit, 1.0),
            "N m" => ("M", unit, 1.0),
            "kg m2" => ("J", unit, 1.0),
            "kg m2/rad" => ("J'", unit, 1.0),
            "J" => ("A", unit, 1.0),
            _ => return None,
        };
        Some(Self { size, ..Self::of(symbol, unit) })
    }

    /// Of vectors in a plane of lengths, of which a meter is the next round number that is at least `least`.
    pub fn vectors(symbol: &'static str, unit: &str, least: f64) -> Self {
        Self { size: round_up(least, &SCALES), ..Self::of(symbol, unit) }
    }

    /// `μ_v = 0.05 m/s/mm` where a millimeter is so many units of the plane; nothing without a symbol.
    pub(crate) fn factor(&self, units: f64) -> Option<Text> {
        let symbol = (!self.symbol.is_empty()).then(|| name("μ").below(name(self.symbol)))?;
        // A round number without a power of ten, however small.
        let digits = plain(self.size * units);
        let digits = digits.parse::<f64>().map_or(digits, |value| value.to_string());
        Some(joined(" = ", [symbol, quantity(digits, format!("{}/mm", self.unit))]))
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
