//! Figures for paper, where nothing is looked at but what is drawn.

use assur_figure::{Figure, Frame, Panel};
use assur_words::{Text, list};

/// A figure without its title (the caption says what it is) and without what belongs to a position on a screen: the cursor and
/// the value at it.
pub fn on_paper(mut figure: Figure) -> Figure {
    figure.panels.iter_mut().for_each(still);
    Figure { title: Text::default(), ..figure }
}

/// Takes the cursor from a plot, and the value at it; the unit stays in its heading, which begins with a capital.
pub fn still(panel: &mut Panel) {
    if let Frame::Axes { cursor, y, .. } = &mut panel.frame {
        *cursor = None;
        if !y.label.is_empty() {
            panel.title = list([panel.title.clone(), y.label.clone()]);
        }
    }
    panel.title = std::mem::take(&mut panel.title).heading();
}
