//! The text where a view has nothing to show: why, and what to add to the scene.

use assur_words::{Text, joined, name, text};
use ratatui::layout::Rect;

use super::footer::calculating;
use crate::screen::draw::{Pen, short, wrapped};
use crate::screen::state::{Role, Scene, State, View};

/// In rows that fit; an example is shown exactly as it is to be written.
pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, view: View, area: Rect) {
    let width = usize::from(area.width.max(12)) - 4;
    let told = pen.state.told(text(pen.state, scene, view));
    let of_line =
        |line: &str| if line.starts_with(' ') { vec![line.to_owned()] } else { wrapped(line, width) };
    for (row, line) in told.lines().flat_map(of_line).enumerate() {
        pen.put(area, 2, short(row) + 1, &line, Role::Plain);
    }
}

fn text(state: &State, scene: &Scene, view: View) -> Text {
    if let Some(fault) = &scene.fault {
        let lost = scene.lost(state.position);
        let barely = lost.filter(|lost| lost.is_change_point).map(|_| text!("failure-barely"));
        let lost = lost.map(|lost| lost.why.clone()).into_iter().chain(barely);
        return joined("\n\n", lost.chain([text!("no-analysis", reason = fault)]));
    }
    if let Some(running) = state.analyzing() {
        return calculating(state, running);
    }
    let Some(picture) = view.picture() else { return text!("nothing-here") };
    let (why, can_be_added) = picture.missing(scene, &state.pictured(), state.part(view));
    let key = |command: &str| name(state.keys.first(command));
    let how = || {
        let again = text!("advice-reread", key = key("reload"));
        let build = text!("advice-build", build = key("build"), tables = key("tables"));
        joined(" ", [again, build])
    };
    joined("\n\n", std::iter::once(why).chain(can_be_added.then(how)))
}
