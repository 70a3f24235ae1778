//! Figures as PNG: the SVG of the same figure, painted with a font that is built in. A crate of its own, for which nothing but
//! the program has to wait in a build.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Error, Options, Tree, fontdb};

use assur_figure::svg::FONT;
use assur_words::{Describe, Text, errors, name, number, text};

const FAMILY: &str = "DejaVu Sans";
/// Pixels in a millimeter: 254 of an inch.
pub const PIXELS: f64 = 10.0;

/// Most pixels of a picture: one takes some eight bytes while it is painted and compressed, all together half a gigabyte.
pub const MOST: f64 = 64e6;

/// Why a figure has no PNG.
pub enum PngError {
    /// The picture would be empty, or larger than memory should be taken for.
    Size(f64, f64),
    /// The painter refuses the SVG of the figure.
    Svg(Error),
    /// The picture can't be compressed.
    Write(String),
}

impl Describe for PngError {
    fn describe(&self) -> Text {
        match self {
            Self::Size(width, height) => text!(
                "picture-size",
                width = number(format_args!("{width:.0}")),
                height = number(format_args!("{height:.0}")),
                most = number(format_args!("{:.0}", MOST / 1e6)),
                side = number(format_args!("{:.0}", MOST.sqrt() / PIXELS)),
            ),
            Self::Svg(error) => text!("picture-not-painted", problem = name(error.to_string())),
            Self::Write(problem) => text!("picture-not-written", problem = name(problem.clone())),
        }
    }
}

errors!(PngError);

/// The SVG of a page of this width and height, mm, with [`PIXELS`] in a millimeter.
///
/// # Errors
///
/// If the page is empty or too large.
pub fn write(svg: &str, size: [f64; 2]) -> Result<Vec<u8>, PngError> {
    let [width, height] = size.map(|side| (side * PIXELS).round());
    if !(width >= 1.0 && height >= 1.0 && width * height <= MOST) {
        return Err(PngError::Size(width, height));
    }
    let mut fonts = fontdb::Database::new();
    fonts.load_font_data(FONT.to_vec());
    let options = Options { font_family: FAMILY.to_owned(), fontdb: Arc::new(fonts), ..Options::default() };
    let tree = Tree::from_str(svg, &options).map_err(PngError::Svg)?;
    let mut picture = Pixmap::new(pixels(width), pixels(height)).ok_or(PngError::Size(width, height))?;
    let page = tree.size();
    let (across, down) = (pixels(width) as f32 / page.width(), pixels(height) as f32 / page.height());
    resvg::render(&tree, Transform::from_scale(across, down), &mut picture.as_mut());
    picture.encode_png().map_err(|error| PngError::Write(error.to_string()))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "checked by the caller: 1 to MOST"
)]
fn pixels(side: f64) -> u32 {
    side as u32
}

assur_words::resources!();

#[cfg(test)]
mod tests;
