//! The groups of the mechanism apart from each other, and the mechanism in many positions over each other.

use std::collections::HashMap;

use assur_figure::mechanism::Drawing;
use assur_figure::{Bounds, Figure, Frame, Ink, Item, Panel, Scale, Stroke};
use assur_geometry::overview;
use assur_group::Order;
use assur_group::plane::{length, minus};
use assur_kinematics::Position;
use assur_mechanism::{Driver, GROUND, InputPair, LinkId};
use assur_words::{Text, joined, name, text};

use crate::arrows::Shown;
use crate::plans::{largest, too_small};
use crate::{Results, mechanism, plots};

/// Groups in one figure.
const MOST: usize = 6;

/// The input links with what holds them, then each group apart from the others, as schemes without a scale.
pub fn groups(results: &Results, position: usize) -> Figure {
    let Some(pose) = results.pose(position, 0.0) else { return Figure::default() };
    let linkage = &results.linkage;
    let inputs: Vec<LinkId> = linkage.mechanism.input.placed().collect();
    let numbers = |links: &[LinkId]| links.iter().map(ToString::to_string).collect::<Vec<_>>().join(",");
    let mut panels = Vec::new();
    if !inputs.is_empty() {
        let formula = name(format!("I({GROUND},{})", numbers(&inputs)));
        let mut panel = apart(results, &pose, &inputs, true, text!("assembly-input-link", formula));
        panel.items.extend(turning(results, position));
        if let Frame::Plane { bounds, .. } = &mut panel.frame {
            *bounds = Bounds::around(panel.items.iter().flat_map(Item::points));
        }
        panels.push(panel);
    }
    let groups = linkage.structure.groups.iter().filter(|group| !group.frame.links.is_empty());
    for group in groups.take(MOST - panels.len()) {
        let links = &group.frame.links;
        let formula = name(format!("{}({})", group.sort(), numbers(links)));
        panels.push(apart(results, &pose, links, false, text!("assembly-group", formula)));
    }
    let count = panels.len();
    let columns = if count <= 3 { count } else { count.div_ceil(2) };
    Figure { panels, columns, ..Figure::default() }
}

/// An arrow around the pin of each input link that turns about the ground, in the sense of its speed in a position; none at rest.
fn turning(results: &Results, position: usize) -> Vec<Item> {
    /// Radius of the arc as part of the link, and where it begins beside the link and how far it goes, rad.
    const RADIUS: f64 = 0.4;
    const FROM: f64 = 0.35;
    const ALONG: f64 = 1.2;
    let Some((pose, state)) = results.moving(position, 0.0) else { return Vec::new() };
    let mechanism = &results.linkage.mechanism;
    let arc = |driver: &Driver| {
        let InputPair::Pin(pin) = driver.pair else { return None };
        let (link, body) = (driver.link, &pose.bodies[driver.link]);
        let speed = body.w1 * state.speed;
        let center = mechanism.points[pin].on(GROUND)?;
        let arms =
            mechanism.points.iter().filter_map(|point| Some(minus(body.point(point.on(link)?), center)));
        let arm = arms.max_by(|one, other| length(*one).total_cmp(&length(*other)))?;
        let is_seen = !driver.is_relative() && speed != 0.0 && length(arm) > 0.0;
        let from = arm[1].atan2(arm[0]) + FROM * speed.signum();
        let (arc, middle) =
            plots::arc(center, RADIUS * length(arm), [from, ALONG * speed.signum()], Ink::Velocity);
        let symbol = Item::name(middle, name("ω").below(name(link.to_string())), Ink::Velocity);
        is_seen.then(|| arc.into_iter().chain([symbol]))
    };
    mechanism.input.drivers.iter().filter_map(arc).flatten().collect()
}

/// Some links apart from the rest of the mechanism, or with what the ground holds of them.
fn apart(results: &Results, pose: &Position, links: &[LinkId], grounded: bool, title: Text) -> Panel {
    /// How far from its center a circle of straight pieces may lie, as part of its size.
    const ROUND: f64 = 0.05;
    let mechanism = &results.linkage.mechanism;
    let is_shown = |link: &LinkId| links.contains(link) || grounded && *link == GROUND;
    let others: Vec<LinkId> = (0..mechanism.links.len()).filter(|link| !is_shown(link)).collect();
    let drawing = Drawing { hidden: &others, ..mechanism::drawing(results, &[]) };
    let mut items = drawing.items(pose);
    let slides = mechanism.slides.iter().any(|slide| slide.on == GROUND && links.contains(&slide.link));
    // Other places of the ground are not those of these links.
    let is_own = |point: &assur_mechanism::Point| links.iter().any(|link| point.on(*link).is_some());
    let others = mechanism.points.iter().filter(|point| !is_own(point));
    let foreign: Vec<[f64; 2]> = others.filter_map(|point| point.on(GROUND)).collect();
    let is_foreign = |at: &[f64; 2]| foreign.iter().any(|own| length(minus(*own, *at)) == 0.0);
    items.retain(|item| match item {
        Item::Ground { .. } => grounded && slides,
        Item::Sign { at, .. } | Item::Name { at, .. } => !is_foreign(at),
        // A circle of friction around such a place.
        Item::Line { points, .. } => {
            let own = Bounds::around(points.iter().copied());
            let near = |at: &[f64; 2]| length(minus(*at, own.center())) < ROUND * length(own.size());
            !foreign.iter().any(near)
        }
        _ => true,
    });
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    Panel { title, frame: Frame::Plane { bounds, scales: Vec::new() }, items }
}

/// The mechanism in one position, in these others behind it as fine lines and in the dead points of its output as dashed ones, with the paths
/// of its points; the points of the input link and of what slides on the ground have the numbers of the positions, in dead points strokes.
pub fn positions(results: &Results, others: &[usize], chosen: usize) -> Figure {
    let Some(pose) = results.pose(chosen, 0.0) else { return Figure::default() };
    let drawing = mechanism::drawing(results, &[]);
    let mut items = mechanism::paths(results, |_| true);
    let points = numbered(results);
    // Where they lie close to each other, only those numbers stand that have room.
    let wide: HashMap<usize, bool> =
        points.iter().map(|(point, _)| (*point, is_wide(results, *point))).collect();
    let mut numbers = Vec::new();
    for &position in others {
        let Some(pose) = results.pose(position, 0.0).filter(|_| position != chosen) else { continue };
        items.extend(drawing.items(&pose).into_iter().filter_map(|item| behind(item, Stroke::Fine)));
        for &(point, link) in &points {
            let own = &results.linkage.mechanism.points[point];
            let Some(at) = own.on(link) else { continue };
            let text = Text::from(&own.name).below(name(position.to_string()));
            let needed = wide[&point] && results.linkage.mechanism.input.placed().any(|input| input == link);
            numbers.push(Item::Name { at: pose.bodies[link].point(at), text, ink: Ink::Text, needed });
        }
    }
    for (index, pose) in dead(results).iter().enumerate() {
        let faint = drawing.items(pose).into_iter().filter_map(|item| behind(item, Stroke::Dashed));
        items.extend(faint);
        for &(point, link) in &points {
            let own = &results.linkage.mechanism.points[point];
            let Some(at) = own.on(link) else { continue };
            let text = joined("", [Text::from(&own.name), name("'".repeat(index + 1))]);
            numbers.push(Item::name(pose.bodies[link].point(at), text, Ink::Title));
        }
    }
    items.extend(drawing.items(&pose));
    items.extend(turning(results, chosen));
    items.extend(numbers);
    let legend = mechanism::links(&drawing).collect();
    Figure { legend, ..Figure::of(mechanism::plane(results, items)) }
}

/// Some links taken out of the mechanism in a position, with their loads and the reactions of the bodies that stay.
pub fn loaded(results: &Results, position: usize, links: &[LinkId]) -> Figure {
    let Some(shown) = Shown::on_links(results, position, links) else { return Figure::default() };
    let others: Vec<LinkId> =
        (0..results.linkage.mechanism.links.len()).filter(|link| !links.contains(link)).collect();
    let drawing = Drawing { hidden: &others, ..mechanism::drawing(results, &[]) };
    let mut items = drawing.items(&shown.pose);
    items.retain(|item| !matches!(item, Item::Ground { .. }));
    let (vectors, small) = shown.items_apart(largest(items.iter().flat_map(Item::points)));
    if vectors.is_empty() {
        return Figure::default();
    }
    items.extend(vectors);
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    let mut panel = Panel::plane(bounds, Scale::of("l", "m"), items);
    shown.fit(&mut panel);
    Figure { legend: too_small(&small), ..Figure::of(panel) }
}

/// The positions in which the output, the first slide or link of the ground that goes to and fro, turns back.
fn dead(results: &Results) -> Vec<Position> {
    let Ok(found) = overview(&results.linkage) else { return Vec::new() };
    let mut courses =
        found.slides.iter().map(|(_, course)| course).chain(found.links.iter().map(|(_, course)| course));
    let stroke = courses.find_map(|course| course.stroke.as_ref());
    let solved = |at: &f64| {
        let mut pose = results.linkage.position();
        results.linkage.solve(*at, Order::Place, &mut pose).ok().map(|()| pose)
    };
    stroke.map_or_else(Vec::new, |stroke| stroke.dead_points.iter().filter_map(solved).collect())
}

/// Whether the path of a point is so large in the drawing of the mechanism that its places can be told apart.
fn is_wide(results: &Results, point: usize) -> bool {
    /// As part of the size of the drawing.
    const LEAST: f64 = 0.25;
    let size = |bounds: &Bounds| bounds.size().into_iter().fold(0.0, f64::max);
    let path = results.outline.paths.get(point).map_or(&[][..], Vec::as_slice);
    size(&Bounds::around(path.iter().copied())) >= LEAST * size(&results.outline.bounds)
}

/// What of an item stands behind the chosen position.
fn behind(item: Item, stroke: Stroke) -> Option<Item> {
    match item {
        // The outline of the ground is the same in all of them.
        Item::Line { ink: Ink::Ground, .. } => None,
        Item::Line { points, .. } => Some(Item::line(points, stroke, Ink::Text)),
        Item::Area { mut outline, .. } => {
            outline.extend(outline.first().copied());
            Some(Item::line(outline, stroke, Ink::Text))
        }
        _ => None,
    }
}

/// The moving points that are numbered, each with its link.
fn numbered(results: &Results) -> Vec<(usize, LinkId)> {
    let mechanism = &results.linkage.mechanism;
    let inputs: Vec<LinkId> = mechanism.input.placed().collect();
    let sliding = mechanism.slides.iter().filter(|slide| slide.on == GROUND).map(|slide| slide.link);
    let links: Vec<LinkId> = inputs.into_iter().chain(sliding).collect();
    let on = |link: &LinkId| {
        let points = mechanism.points.iter().enumerate();
        let own = points.filter(|(_, point)| point.on(GROUND).is_none());
        own.filter_map(|(id, point)| point.on(*link).map(|_| (id, *link))).take(1).collect::<Vec<_>>()
    };
    links.iter().flat_map(on).collect()
}
