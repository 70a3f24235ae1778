//! A plane on paper, to a round scale.

use assur_words::{Language, joined, name, quantity};

use super::{BORDER, EM, Element, LINE, Room, drawn, heading, text};
use crate::bounds::Bounds;
use crate::model::{Frame, Ink, Panel, Point};
use crate::number::{plain, round_up};
use crate::trace::Paper;

/// Free space around what is drawn, for names, bearings and sliders, in text sizes.
const MARGIN: f64 = 2.2;
/// Scale factors of drawings, as parts of a power of ten: those of ISO 5455 and of drawing offices.
const SCALES: [f64; 5] = [1.0, 2.0, 2.5, 4.0, 5.0];

/// The elements of a panel, and its scale: units of the plane in a millimeter.
pub(super) fn elements(panel: &Panel, room: Room, language: &Language) -> (Vec<Element>, f64) {
    let Frame::Plane { bounds, scale: (symbol, unit), .. } = &panel.frame else { return (Vec::new(), 1.0) };
    let mut elements = heading(panel, room, language);
    let above = LINE * elements.len() as f64;
    let plot = Room { top: room.top + above, height: room.height - above - LINE, ..room };
    let least = fit(bounds, plot);
    let scale = if symbol.is_empty() { least } else { round_up(least, &SCALES) };
    let center = bounds.center().map(|x| if x.is_finite() { x } else { 0.0 });
    let middle = [plot.left + 0.5 * plot.width, plot.top + 0.5 * plot.height];
    let place =
        |at: Point| [middle[0] + (at[0] - center[0]) / scale, middle[1] - (at[1] - center[1]) / scale];
    let paper = Paper { place, em: EM, gap: 0.1 * EM };
    let marks: Vec<_> = panel.items.iter().flat_map(|item| paper.marks(item)).collect();
    elements.extend(drawn(&marks, plot, language));
    // What lies in one place has no scale.
    if !symbol.is_empty() && bounds.size().iter().any(|side| *side != 0.0) {
        let symbol = name(format!("μ_{{{symbol}}}"));
        let told = joined(" = ", [symbol, quantity(plain(scale), format!("{unit}/mm"))]).render(language);
        let corner = [room.left, room.top + room.height - 0.3 * LINE];
        elements.push(text(corner, &told, Ink::Dim, "start"));
    }
    (elements, scale)
}

/// The least scale at which the bounds fit.
fn fit(bounds: &Bounds, plot: Room) -> f64 {
    let [width, height] = bounds.size();
    let free = |length: f64| (length - 2.0 * MARGIN * EM - BORDER).max(1.0);
    let least = (width / free(plot.width)).max(height / free(plot.height));
    if least.is_finite() && least > 0.0 { least } else { 1.0 }
}
