//! The mechanism to scale, with names, paths and arrows.

use assur_analysis::results::Owner;
use assur_figure::mechanism::Drawing;
use assur_figure::{Figure, Frame, Ink, Item, Key, Panel, Sample, Scale, Sign, Stroke};
use assur_kinematics::Position;
use assur_mechanism::{Mechanism, Slide};
use assur_words::{joined, name};

use crate::arrows::Shown;
use crate::{Look, Outline, Probe, Results, Traces};

/// A trail shows a path divided by this number.
const TRAIL: usize = 4;
const MOST_LINKS: usize = 12;

/// The mechanism where it is now; the links in `marked` are highlighted.
pub fn figure(results: &Results, look: &Look<'_>, marked: &[usize]) -> Figure {
    let position = look.position;
    let mut items = traces(results, look);
    if let Some(compared) = look.compared {
        items.extend(ghost(&compared.results, look));
    }
    // While the structure is put together, the links of the groups that are not joined yet.
    let hidden = look.joined.map_or_else(Vec::new, |group| links_from(results, group));
    let drawing = Drawing { hidden: &hidden, ..drawing(results, marked) };
    let shown = Shown::of(results, look);
    match &shown {
        Some(shown) => {
            items.extend(drawing.items(&shown.pose));
            items.extend(shown.items());
            items.extend(look.probe.iter().flat_map(|probe| of_probe(results, probe, &shown.pose)));
        }
        None => items.extend(broken(results, marked, position)),
    }
    let at = results.place(look.position);
    let title = match &results.linkage.mechanism.title {
        title if title.is_empty() => at,
        title => joined(": ", [title.into(), at]),
    };
    let mut legend = shown.as_ref().map_or_else(Vec::new, |shown| shown.legend(results));
    legend.extend(links(&drawing));
    let mut panel = plane(results, items);
    if let Some(shown) = &shown {
        shown.fit(&mut panel);
    }
    Figure { title, legend, ..Figure::of(panel) }
}

/// The first position with some links in other places: those of it that are `marked`; what follows from them is `hidden`. The
/// mechanism as it is stands behind it, faint.
fn another(results: &Results, look: &Look<'_>, [marked, hidden]: [&[usize]; 2], pose: &Position) -> Figure {
    let mut items = ghost(results, look);
    let drawing = Drawing { hidden, ..drawing(results, marked) };
    items.extend(drawing.items(pose));
    let mut panel = plane(results, items);
    if let Frame::Plane { bounds, .. } = &mut panel.frame {
        let points = results.linkage.mechanism.points.iter();
        let marked = points.flat_map(|point| &point.places).filter(|place| marked.contains(&place.link));
        marked.for_each(|place| bounds.add(pose.bodies[place.link].point(place.at)));
    }
    Figure { title: results.place(look.position), legend: links(&drawing).collect(), ..Figure::of(panel) }
}

/// A mechanism in its first position, for a list of mechanisms.
pub fn still(results: &Results) -> Figure {
    let drawing = drawing(results, &[]);
    let pose = results.pose(results.first_position(), 0.0);
    let mut items = paths(results, |_| true);
    items.extend(pose.map_or_else(|| drawing.ground(), |pose| drawing.items(&pose)));
    Figure::of(plane(results, items))
}

/// The plane in which the mechanism lies, with what is drawn in it.
pub fn plane(results: &Results, items: Vec<Item>) -> Panel {
    Panel::plane(results.outline.bounds, Scale::of("l", "m"), items)
}

/// The drawing of the mechanism; the links in `marked` are highlighted.
pub fn drawing<'a>(results: &'a Results, marked: &'a [usize]) -> Drawing<'a> {
    let Outline { strokes, arcs, .. } = &results.outline;
    Drawing { linkage: &results.linkage, strokes, arcs, marked, hidden: &[] }
}

/// A position that can't be assembled: what has a place, and the gap of the first group that has none.
fn broken(results: &Results, marked: &[usize], position: usize) -> Vec<Item> {
    let drawing = drawing(results, marked);
    let Some(broken) = results.broken.get(&position) else { return drawing.ground() };
    let hidden = links_from(results, broken.group);
    let mut items = Drawing { hidden: &hidden, ..drawing }.items(&broken.pose);
    let near = results.assembled().min_by_key(|number| number.abs_diff(position));
    let near = near.and_then(|near| results.pose(near, 0.0));
    items.extend(drawing.gap(&broken.pose, near.as_ref(), broken.group));
    items
}

fn links_from(results: &Results, group: usize) -> Vec<usize> {
    let groups = results.linkage.structure.groups.iter().skip(group);
    groups.flat_map(|group| group.frame.links.iter().copied()).collect()
}

/// The links of another mechanism in the same place of the motion, as faint lines.
fn ghost(results: &Results, look: &Look<'_>) -> Vec<Item> {
    let Some(pose) = results.pose(look.position, look.part) else { return Vec::new() };
    let faint = |item| match item {
        Item::Line { points, .. } => Some(Item::line(points, Stroke::Dashed, Ink::Dim)),
        Item::Area { mut outline, .. } => {
            outline.extend(outline.first().copied());
            Some(Item::line(outline, Stroke::Dashed, Ink::Dim))
        }
        _ => None,
    };
    drawing(results, &[]).items(&pose).into_iter().filter_map(faint).collect()
}

fn of_probe(results: &Results, probe: &Probe, pose: &Position) -> [Item; 3] {
    let at = pose.bodies[probe.link].point(probe.at);
    [
        Item::line(probe.path(results), Stroke::Solid, Ink::Marked),
        Item::sign(at, Sign::Cross, Ink::Marked),
        Item::name(at, name("P"), Ink::Marked),
    ]
}

/// The names of the links, which have numbers in the drawing; too many would leave no room for it.
pub(crate) fn links(drawing: &Drawing<'_>) -> impl Iterator<Item = Key> {
    let all = &drawing.linkage.mechanism.links;
    let links = all.iter().enumerate().skip(1).filter(|(number, _)| !drawing.hidden.contains(number));
    links.filter(|_| all.len() <= MOST_LINKS + 1).map(|(number, link)| Key {
        sample: Sample::Line(Stroke::Thick, drawing.ink(number)),
        text: joined(" ", [name(number.to_string()), (&link.name).into()]),
    })
}

/// The numbers of the links in drawings, by their names; a name that a point has too stands for the point.
pub fn numbers(mechanism: &Mechanism) -> Vec<(String, String)> {
    let is_point = |name: &str| mechanism.points.iter().any(|point| point.name == *name);
    let links = mechanism.links.iter().enumerate().filter(|(_, link)| !is_point(&link.name));
    let mut all: Vec<_> = links.map(|(number, link)| (link.name.to_string(), number.to_string())).collect();
    let pair = |slide: &Slide| (slide.name.to_string(), format!("{}/{}", slide.link, slide.on));
    all.extend(mechanism.slides.iter().map(pair));
    all
}

/// The paths that are wanted; a trail is the part of a path that was passed last.
fn traces(results: &Results, look: &Look<'_>) -> Vec<Item> {
    let chosen = results.transfers.get(look.transfer).map(|transfer| &transfer.owner);
    match look.traces {
        Traces::All => paths(results, |_| true),
        Traces::Chosen => paths(results, |id| chosen == Some(&Owner::Point(id))),
        Traces::None => Vec::new(),
        Traces::Trail => {
            let moving = results.outline.paths.iter().filter(|path| !path.is_empty());
            moving.map(|path| Item::line(trail(results, look, path), Stroke::Dotted, Ink::Velocity)).collect()
        }
    }
}

pub(crate) fn paths(results: &Results, wanted: impl Fn(usize) -> bool) -> Vec<Item> {
    let paths = results.outline.paths.iter().enumerate().filter(|(id, path)| !path.is_empty() && wanted(*id));
    paths.map(|(_, path)| Item::line(path.as_slice(), Stroke::Dotted, Ink::Trace)).collect()
}

/// The last part of a path up to the present place.
fn trail(results: &Results, look: &Look<'_>, path: &[[f64; 2]]) -> Vec<[f64; 2]> {
    // The last point of a path is the end of the last step, which of a closed cycle is its first point again.
    let steps = path.len().saturating_sub(1);
    let now = (results.part_of_cycle(look) * steps as f64).floor();
    let closes = results.linkage.mechanism.input.is_cycle() && results.broken.is_empty();
    let now = (0..=steps).rev().find(|at| *at as f64 <= now).unwrap_or(0);
    let back = (0..=steps / TRAIL).rev();
    let points = back.filter_map(|back| match now.checked_sub(back) {
        None if closes => path.get((now + steps - back) % steps),
        at => path.get(at?),
    });
    points.copied().collect()
}

/// The mechanism with the chosen group marked, or with it in the mode that is looked at.
pub fn structure(results: &Results, look: &Look<'_>) -> Figure {
    let group = results.linkage.structure.groups.get(look.group);
    let marked = group.map_or(&[][..], |group| &group.frame.links);
    let in_mode = look.mode.and_then(|mode| group_in_mode(results, look.group, mode));
    match in_mode {
        Some((pose, hidden)) => another(results, look, [marked, &hidden], &pose),
        None => figure(results, look, marked),
    }
}

/// The first position with a group in another mode, and the links that follow from it.
fn group_in_mode(results: &Results, group: usize, mode: usize) -> Option<(Position, Vec<usize>)> {
    let (linkage, modes) = (&results.linkage, results.modes(group, 0)?);
    let mut pose = results.pose(0, 0.0)?;
    let links = &linkage.structure.groups[group].frame.links;
    links.iter().zip(&modes.all.get(mode)?.bodies).for_each(|(&link, body)| pose.bodies[link] = *body);
    let later = group + 1..linkage.structure.groups.len();
    let later = later.filter(|later| linkage.ancestors(*later).contains(&group));
    Some((pose, later.flat_map(|later| linkage.structure.groups[later].frame.links.clone()).collect()))
}
