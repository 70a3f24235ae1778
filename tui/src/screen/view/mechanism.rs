//! The mechanism to scale, with names, paths and arrows.

use assur_analysis::results::Owner;
use assur_figure::mechanism::Drawing;
use assur_figure::{Figure, Frame, Ink, Item, Key, Panel, Sample, Sign, Stroke};
use assur_kinematics::Position;
use assur_words::{Text, joined, name};
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{arrows, panel};
use crate::screen::draw::{cells, paint_zoomed};
use crate::screen::state::{Probe, Scene, State, Traces, View};
use assur_picture::Results;

/// Columns of the numbers next to the drawing.
const PANEL: u16 = 26;
/// A trail shows a path divided by this number.
const TRAIL: usize = 4;
/// Most links of a legend.
const MOST_LINKS: usize = 12;

pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let [drawing, beside] = parts(area);
    let figure = figure(state, scene, &[]);
    paint_zoomed(state, &figure, state.zoom, drawing, buffer);
    panel::draw(state, scene, &figure, drawing, beside, buffer);
}

/// The drawing and the numbers beside it.
fn parts(area: Rect) -> [Rect; 2] {
    Layout::horizontal([Constraint::Min(0), Constraint::Length(PANEL)]).areas(area)
}

/// The place of the plane (m) under a cell of the view; `None` beside the drawing.
pub(crate) fn place_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<[f64; 2]> {
    let figure = figure(state, state.scene.as_ref()?, &[]);
    let [drawing, _] = parts(area);
    let cell = [column.checked_sub(drawing.x)?, row.checked_sub(drawing.y)?];
    let size = [drawing.width, drawing.height];
    assur_figure::cells::point_at(figure.panels.first()?, size, cells(state, state.zoom), cell)
}

/// The mechanism where it is now; the links in `marked` are highlighted.
pub(super) fn figure(state: &State, scene: &Scene, marked: &[usize]) -> Figure {
    let position = state.position;
    let mut items = traces(state, scene);
    if let Some(compared) = &state.compared {
        items.extend(ghost(state, &compared.results));
    }
    // While the structure is put together, the links of the groups that are not joined yet.
    let from = state.joined.filter(|_| state.view == View::Structure);
    let hidden = from.map_or_else(Vec::new, |group| links_from(scene, group));
    let drawing = Drawing { hidden: &hidden, ..drawing(scene, marked) };
    match scene.pose(position, state.part_way()) {
        Some(pose) => {
            items.extend(drawing.items(&pose));
            items.extend(arrows::items(state, scene, &pose, position));
            items.extend(arrows::contacts(scene, &pose));
            items.extend(state.probe.iter().flat_map(|probe| of_probe(scene, probe, &pose)));
        }
        None => items.extend(broken(scene, marked, position)),
    }
    let at = scene.place(position);
    let title = match scene.linkage.mechanism.title.as_str() {
        "" => at,
        title => joined(": ", [name(title.to_owned()), at]),
    };
    let mut legend = arrows::legend(state, scene);
    legend.extend(links(&drawing));
    Figure { title, legend, ..Figure::of(plane(scene, items)) }
}

/// The first position with some links in other places: those of it that are `marked`; what follows from them is `hidden`. The
/// mechanism as it is stands behind it, faint.
pub(super) fn another(
    state: &State,
    scene: &Scene,
    (marked, hidden): (&[usize], &[usize]),
    pose: &Position,
) -> Figure {
    let mut items = ghost(state, scene);
    let drawing = Drawing { hidden, ..drawing(scene, marked) };
    items.extend(drawing.items(pose));
    let mut panel = plane(scene, items);
    if let Frame::Plane { bounds, .. } = &mut panel.frame {
        let points = scene.linkage.mechanism.points.iter();
        let marked = points.flat_map(|point| &point.places).filter(|place| marked.contains(&place.link));
        marked.for_each(|place| bounds.add(pose.bodies[place.link].point(place.at)));
    }
    Figure { title: scene.place(state.position), legend: links(&drawing).collect(), ..Figure::of(panel) }
}

/// A mechanism in its first position, for a list of mechanisms.
pub(super) fn still(scene: &Scene) -> Figure {
    let drawing = drawing(scene, &[]);
    let pose = scene.pose(scene.first_position(), 0.0);
    let mut items = paths(scene, |_| true);
    items.extend(pose.map_or_else(|| drawing.ground(), |pose| drawing.items(&pose)));
    Figure::of(plane(scene, items))
}

pub(crate) fn plane(scene: &Scene, items: Vec<Item>) -> Panel {
    let frame = Frame::Plane {
        bounds: scene.outline.bounds,
        unit: "mm".into(),
        factor: 1e3,
        scale: ("l", "m".into()),
    };
    Panel { title: Text::default(), frame, items }
}

pub(crate) fn drawing<'a>(scene: &'a Results, marked: &'a [usize]) -> Drawing<'a> {
    Drawing {
        linkage: &scene.linkage,
        strokes: &scene.outline.strokes,
        arcs: &scene.outline.arcs,
        marked,
        hidden: &[],
    }
}

/// A position that can't be assembled: what has a place, and the gap of the first group that has none.
fn broken(scene: &Scene, marked: &[usize], position: usize) -> Vec<Item> {
    let drawing = drawing(scene, marked);
    let Some(broken) = scene.broken.get(&position) else { return drawing.ground() };
    let hidden = links_from(scene, broken.group);
    let mut items = Drawing { hidden: &hidden, ..drawing }.items(&broken.pose);
    let near = scene.assembled().min_by_key(|number| number.abs_diff(position));
    let near = near.and_then(|near| scene.pose(near, 0.0));
    items.extend(drawing.gap(&broken.pose, near.as_ref(), broken.group));
    items
}

/// The links of a group and of all after it.
fn links_from(scene: &Scene, group: usize) -> Vec<usize> {
    let groups = scene.linkage.structure.groups.iter().skip(group);
    groups.flat_map(|group| group.frame.links.iter().copied()).collect()
}

/// The links of another mechanism in the same place of the motion, as faint lines.
fn ghost(state: &State, scene: &Results) -> Vec<Item> {
    let Some(pose) = scene.pose(state.position, state.part_way()) else { return Vec::new() };
    let faint = |item| match item {
        Item::Line { points, .. } => Some(Item::line(points, Stroke::Dashed, Ink::Dim)),
        Item::Area { mut outline, .. } => {
            outline.extend(outline.first().copied());
            Some(Item::line(outline, Stroke::Dashed, Ink::Dim))
        }
        _ => None,
    };
    drawing(scene, &[]).items(&pose).into_iter().filter_map(faint).collect()
}

fn of_probe(scene: &Scene, probe: &Probe, pose: &Position) -> [Item; 3] {
    let at = pose.bodies[probe.link].point(probe.at);
    [
        Item::line(probe.path(scene), Stroke::Solid, Ink::Marked),
        Item::sign(at, Sign::Cross, Ink::Marked),
        Item::name(at, name("P"), Ink::Marked),
    ]
}

/// The names of the links, which have numbers in the drawing; too many would leave no room for it.
fn links(drawing: &Drawing<'_>) -> impl Iterator<Item = Key> {
    let all = &drawing.linkage.mechanism.links;
    let links = all.iter().enumerate().skip(1).filter(|(number, _)| !drawing.hidden.contains(number));
    links.filter(|_| all.len() <= MOST_LINKS + 1).map(|(number, link)| Key {
        sample: Sample::Line(Stroke::Thick, drawing.ink(number)),
        text: joined(" ", [name(number.to_string()), (&link.name).into()]),
    })
}

/// The paths that are wanted; a trail is the part of a path that was passed last.
fn traces(state: &State, scene: &Scene) -> Vec<Item> {
    let chosen = scene.transfers.get(state.chosen.transfer).map(|transfer| &transfer.owner);
    match state.traces {
        Traces::All => paths(scene, |_| true),
        Traces::Chosen => paths(scene, |id| chosen == Some(&Owner::Point(id))),
        Traces::None => Vec::new(),
        Traces::Trail => {
            let moving = scene.outline.paths.iter().filter(|path| !path.is_empty());
            moving.map(|path| Item::line(trail(state, scene, path), Stroke::Dotted, Ink::Velocity)).collect()
        }
    }
}

fn paths(scene: &Scene, wanted: impl Fn(usize) -> bool) -> Vec<Item> {
    let paths = scene.outline.paths.iter().enumerate().filter(|(id, path)| !path.is_empty() && wanted(*id));
    paths.map(|(_, path)| Item::line(path.as_slice(), Stroke::Dotted, Ink::Trace)).collect()
}

/// The last part of a path up to the present place.
fn trail(state: &State, scene: &Scene, path: &[[f64; 2]]) -> Vec<[f64; 2]> {
    // The last point of a path is the end of the last step, which of a closed cycle is its first point again.
    let steps = path.len().saturating_sub(1);
    let positions = (state.positions() - usize::from(!scene.is_cycle())).max(1);
    let now = (state.at() / positions as f64 * steps as f64).floor();
    let now = (0..=steps).rev().find(|at| *at as f64 <= now).unwrap_or(0);
    let back = (0..=steps / TRAIL).rev();
    let points = back.filter_map(|back| match now.checked_sub(back) {
        None if scene.is_cycle() && scene.broken.is_empty() => path.get((now + steps - back) % steps),
        at => path.get(at?),
    });
    points.copied().collect()
}
