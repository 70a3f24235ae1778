//! The letters that are used: their numbers in the font, their widths, and the part of the font that has them.

use std::collections::BTreeMap;

use assur_figure::letters::levels;
use assur_figure::svg::FONT;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, Str};
use skrifa::instance::{LocationRef, Size};
use skrifa::metrics::GlyphMetrics;
use skrifa::{FontRef, MetadataProvider, charmap::Charmap};
use subsetter::GlyphRemapper;

use crate::{deflated, single};

const NAME: Name<'static> = Name(b"ASSURA+DejaVuSans");
const IDENTITY: Name<'static> = Name(b"Identity-H");
const SYSTEM: SystemInfo<'static> =
    SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
/// Thickness of an upright stroke, thousandths of the text size; what has the font uses its own.
const STEM: f32 = 80.0;

/// The letters of a file.
pub(crate) struct Letters {
    map: Charmap<'static>,
    widths: GlyphMetrics<'static>,
    font: FontRef<'static>,
    used: GlyphRemapper,
    /// By the number in the file, the letter and its width, parts of the text size.
    told: BTreeMap<u16, (char, f64)>,
}

/// Width of a text with subscripts of this size, mm, in the font that is built in; 0 without it.
pub fn text_width(words: &str, size: f64) -> f64 {
    Letters::new().map_or(0.0, |mut letters| size * letters.width(words))
}

impl Letters {
    pub(crate) fn new() -> Option<Self> {
        let font = FontRef::new(FONT).ok()?;
        let widths = font.glyph_metrics(Size::new(1.0), LocationRef::default());
        let (map, used, told) = (font.charmap(), GlyphRemapper::new(), BTreeMap::new());
        Some(Self { map, widths, font, used, told })
    }

    /// Letters as the file has them, and their width as part of the text size.
    pub(crate) fn encoded(&mut self, words: &str) -> (Vec<u8>, f64) {
        let (mut bytes, mut width) = (Vec::new(), 0.0);
        for letter in words.chars().filter(|letter| !letter.is_control()) {
            let glyph = self.map.map(letter).unwrap_or_default();
            let own = f64::from(self.widths.advance_width(glyph).unwrap_or_default());
            // A font of 38 kB has fewer letters than sixteen bits tell.
            let number = self.used.remap(u16::try_from(glyph.to_u32()).unwrap_or_default());
            self.told.insert(number, (letter, own));
            bytes.extend(number.to_be_bytes());
            width += own;
        }
        (bytes, width)
    }

    /// Width of a text with its subscripts, as part of the text size.
    pub(crate) fn width(&mut self, words: &str) -> f64 {
        levels(words).map(|(part, level)| level.size() * self.encoded(part).1).sum()
    }

    /// Writes the font with the letters that were used.
    pub(crate) fn write(&self, font: Ref, free: &mut Ref, pdf: &mut Pdf) -> Option<()> {
        let [descendant, descriptor, data, unicode] = [(); 4].map(|()| free.bump());
        pdf.type0_font(font)
            .base_font(NAME)
            .encoding_predefined(IDENTITY)
            .descendant_font(descendant)
            .to_unicode(unicode);
        let mut cid = pdf.cid_font(descendant);
        cid.subtype(CidFontType::Type2).base_font(NAME).system_info(SYSTEM);
        cid.font_descriptor(descriptor).cid_to_gid_map_predefined(Name(b"Identity"));
        let mut widths = cid.widths();
        for (number, (_, width)) in &self.told {
            widths.consecutive(*number, [single(1e3 * width)]);
        }
        widths.finish();
        cid.finish();
        let metrics = self.font.metrics(Size::new(1e3), LocationRef::default());
        let bounds = metrics.bounds.unwrap_or_default();
        pdf.font_descriptor(descriptor)
            .name(NAME)
            .flags(FontFlags::SYMBOLIC)
            .bbox(Rect::new(bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max))
            .italic_angle(0.0)
            .ascent(metrics.ascent)
            .descent(metrics.descent)
            .cap_height(metrics.cap_height.unwrap_or(metrics.ascent))
            .stem_v(STEM)
            .font_file2(data);
        let subset = subsetter::subset(FONT, 0, &self.used).ok()?;
        pdf.stream(data, &deflated(&subset)).filter(Filter::FlateDecode);
        let mut letters = UnicodeCmap::new(Name(b"Custom"), SYSTEM);
        self.told.iter().for_each(|(number, (letter, _))| letters.pair(*number, *letter));
        pdf.cmap(unicode, &deflated(&letters.finish())).filter(Filter::FlateDecode);
        Some(())
    }
}
