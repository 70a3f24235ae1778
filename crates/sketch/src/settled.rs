//! `[assembly]` with the places that its points have once their lengths are known.

use assur_draft::set;
use assur_mechanism::Key;
use assur_number::elementary;
use assur_words::Text;

use crate::number::{place_like, written};
use crate::sketch::Sketch;

/// Part of the size of a mechanism by which a place in `[assembly]` may differ from that of its point.
const NEAR: f64 = 0.01;

/// The text with the places in `[assembly]` that are far from their points put where the points are in the first position; the same text
/// where that position is not assembled. `sketch` is of this text.
///
/// # Errors
///
/// A text with faults can't be edited.
pub fn settled(text: &str, sketch: &Sketch) -> Result<String, Text> {
    if !sketch.is_assembled() {
        return Ok(text.to_owned());
    }
    let near = NEAR * sketch.size();
    sketch.mechanism.assembly.iter().try_fold(text.to_owned(), |text, (point, wanted)| {
        let name = &sketch.mechanism.points[*point].name;
        let Some([x, y]) = sketch.place(name.as_str()) else { return Ok(text) };
        if elementary::hypot(x - wanted[0], y - wanted[1]) <= near {
            return Ok(text);
        }
        let key = Key::of("assembly").at(name);
        set(&text, &key, &place_like(&written(&text, &key), [x, y], false))
    })
}
