//! Formats, frames and what is free inside them.

use assur_scene::SheetFormat;
use assur_words::Language;

/// A rectangle of the sheet: left, top, right, bottom, mm.
pub type Area = [f64; 4];

/// By which standards a sheet is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Standard {
    /// ISO 5457 and ISO 7200.
    Iso,
    /// ГОСТ 2.301 and ГОСТ 2.104, form 1.
    Gost,
}

impl Standard {
    /// That of a language.
    pub(crate) fn of(language: &Language) -> Self {
        if language.code == "en" { Self::Iso } else { Self::Gost }
    }

    /// Width and height of the title block, mm.
    pub(crate) fn block(self) -> [f64; 2] {
        match self {
            Self::Iso => [180.0, 36.0],
            Self::Gost => [185.0, 55.0],
        }
    }

    /// The inside of the frame of a sheet.
    pub(crate) fn frame(self, [width, height]: [f64; 2]) -> Area {
        /// Room for filing, mm.
        const LEFT: f64 = 20.0;
        let other = if self == Self::Iso { 10.0 } else { 5.0 };
        [LEFT, other, width - other, height - other]
    }

    /// The place of the title block in a frame.
    pub(crate) fn title(self, frame: Area) -> Area {
        let [width, height] = self.block();
        [frame[2] - width, frame[3] - height, frame[2], frame[3]]
    }
}

/// The usual formats from the smallest: two sheets of A1 rather than one of A0, which a school has no board for.
pub(crate) const USUAL: [SheetFormat; 4] =
    [SheetFormat::A4, SheetFormat::A3, SheetFormat::A2, SheetFormat::A1];

/// Width and height of a format, mm: the smallest one stands upright.
pub(crate) fn size(format: SheetFormat) -> [f64; 2] {
    match format {
        SheetFormat::A4 => [210.0, 297.0],
        SheetFormat::A3 => [420.0, 297.0],
        SheetFormat::A2 => [594.0, 420.0],
        SheetFormat::A1 => [841.0, 594.0],
        SheetFormat::A0 => [1189.0, 841.0],
    }
}
