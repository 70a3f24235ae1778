//! The mechanism to scale, with names, paths and arrows.

use assur_figure::mechanism::Drawing;
use assur_figure::{Figure, Frame, Ink, Item, Key, Panel, Sample, Stroke};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{arrows, panel};
use crate::number::plain;
use crate::screen::draw::paint;
use crate::screen::state::{Owner, Scene, State, Traces};

/// Columns of the numbers next to the drawing.
const PANEL: u16 = 26;
/// Most links of a legend.
const MOST_LINKS: usize = 12;

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let [drawing, beside] = Layout::horizontal([Constraint::Min(0), Constraint::Length(PANEL)]).areas(area);
    let figure = figure(state, scene, state.position, &[]);
    paint(state, &figure, drawing, buffer);
    panel::draw(state, scene, &figure, drawing, beside, buffer);
}

/// The mechanism in a position; the links in `marked` are highlighted.
pub(super) fn figure(state: &State, scene: &Scene, position: usize, marked: &[usize]) -> Figure {
    let drawing = Drawing { linkage: &scene.linkage, strokes: &scene.strokes, marked };
    let mut items = traces(state, scene);
    match scene.poses.get(position).and_then(Option::as_ref) {
        Some(pose) => {
            items.extend(drawing.items(pose));
            items.extend(arrows::items(state, scene, pose, position));
        }
        None => items.extend(drawing.ground()),
    }
    let frame =
        Frame::Plane { bounds: scene.bounds, unit: "mm".into(), factor: 1e3, scale: ("l", "m".into()) };
    let coordinate = &scene.series[0];
    let at = format!("position {position}, {} {}", plain(coordinate.at(position)), coordinate.unit);
    let title = match scene.linkage.mechanism.title.as_str() {
        "" => at,
        title => format!("{title}: {at}"),
    };
    let mut legend = arrows::legend(state, scene);
    legend.extend(links(scene));
    Figure { title, legend, ..Figure::of(Panel { title: String::new(), frame, items }) }
}

/// The names of the links, which have numbers in the drawing; too many would leave no room for it.
fn links(scene: &Scene) -> impl Iterator<Item = Key> {
    let links = scene.linkage.mechanism.links.iter().enumerate().skip(1);
    links.filter(|_| scene.linkage.mechanism.links.len() <= MOST_LINKS + 1).map(|(number, link)| Key {
        sample: Sample::Line(Stroke::Thick, Ink::Link(number)),
        text: format!("{number} {}", link.name),
    })
}

fn traces(state: &State, scene: &Scene) -> Vec<Item> {
    let chosen = scene.transfers.get(state.chosen.transfer).map(|transfer| &transfer.owner);
    let wanted = |id: usize| match state.traces {
        Traces::All => true,
        Traces::Chosen => chosen == Some(&Owner::Point(id)),
        Traces::None => false,
    };
    let paths = scene.paths.iter().enumerate().filter(|(id, path)| !path.is_empty() && wanted(*id));
    paths.map(|(_, path)| Item::line(path.as_slice(), Stroke::Dotted, Ink::Trace)).collect()
}
