//! Building: the mechanism with what is chosen or can be chosen, the form or the task beside it, and the file as it grows.

use assur_draft::Part;
use assur_figure::cells::point_at;
use assur_figure::{Bounds, Figure, Ink, Item, Panel, Scale, Sign, Stroke};
use assur_mechanism::GROUND;
use assur_picture::mechanism::{self as picture};
use assur_picture::{Arrows, Look, following};
use assur_report::topic::About;
use assur_sketch::{Sketch, Target};
use assur_words::{Text, joined, list, name, number, quantity, text};
use ratatui::layout::{Constraint, Layout, Rect};

use super::{file, form};
use crate::number::digits;
use crate::screen::draw::{Pen, cells, short, wrapped};
use crate::screen::state::{MOVES, Role, Scene, State, Task, place, words_of};

/// Part of the width for the form and the file, per cent, and its least.
const SIDE: u16 = 42;
const LEAST_SIDE: u16 = 36;
/// Rows that the file has at least.
pub(super) const FILE: u16 = 7;
/// Rows that the curves have at least while something is moved, and the file below them.
const CURVES: u16 = 8;
const FILE_BELOW_CURVES: u16 = 4;
/// Rows of a curve beside others.
const LEAST_CURVE: u16 = 6;
/// Measures of the motion that are shown.
const MEASURES: usize = 4;
/// Around the sketch, as part of its size.
pub(super) const MARGIN: f64 = 0.15;

pub(super) fn draw(pen: &mut Pen<'_>, area: Rect) {
    let [drawing, side] = parts(area);
    let state = pen.state;
    match form::curve(state) {
        Some(curve) => pen.paint(&curve, drawing),
        None => pen.paint_zoomed(&figure(state), state.zoom, drawing),
    }
    for row in 0..side.height {
        pen.put(side, 0, row, "│", Role::Dim);
    }
    let side = Rect { x: side.x + 1, width: side.width.saturating_sub(1), ..side };
    if let Task::Form(task) = &state.build.task {
        return form::draw(pen, task, side);
    }
    let curves = if is_moved(state) { following(state) } else { Figure::default() };
    // While something is moved, what follows has the rows of the file but for its last change.
    let [for_curves, for_file] =
        if curves.panels.is_empty() { [0, FILE] } else { [CURVES, FILE_BELOW_CURVES] };
    let room = side.height.saturating_sub(for_curves + for_file);
    let lines = told(state, side.width.into(), room.into());
    let rows = short(lines.len()).min(room);
    let for_curves = if for_curves > 0 { side.height.saturating_sub(rows + 1 + for_file) } else { 0 };
    let heights = [Constraint::Length(rows + 1), Constraint::Length(for_curves), Constraint::Min(0)];
    let [top, middle, file] = Layout::vertical(heights).areas(side);
    pen.put_lines(top, 0, lines.iter().take(rows.into()));
    if for_curves > 0 {
        let panels = curves.panels.into_iter().take((middle.height / LEAST_CURVE).max(1).into()).collect();
        pen.paint(&Figure { panels, ..curves }, middle);
    }
    file::draw(pen, file);
}

fn is_moved(state: &State) -> bool {
    matches!(state.build.task, Task::Move)
}

/// What follows while the chosen thing is moved.
fn following(state: &State) -> Figure {
    let Some(scene) = shown(state) else { return Figure::default() };
    let point = match &state.build.chosen {
        Some(Part::Point(point)) => scene.linkage.mechanism.point(point),
        _ => None,
    };
    following::figure(scene, &state.pictured(), point)
}

/// The scene of the text as it is now, if something of it moves.
fn shown(state: &State) -> Option<&Scene> {
    let moves = state.build.read.as_ref().is_some_and(|read| read.readable.is_some());
    state.scene.as_ref().filter(|_| moves && state.draft.shown == *state.draft.text())
}

fn parts(area: Rect) -> [Rect; 2] {
    let side = (area.width * SIDE / 100).max(LEAST_SIDE);
    Layout::horizontal([Constraint::Min(0), Constraint::Length(side)]).areas(area)
}

/// The place of the plane (m) under a cell; `None` beside the drawing.
pub(crate) fn place_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<[f64; 2]> {
    let [drawing, _] = parts(area);
    let cell = [column.checked_sub(drawing.x)?, row.checked_sub(drawing.y)?];
    let figure = figure(state);
    point_at(figure.panels.first()?, [drawing.width, drawing.height], cells(state, state.zoom), cell)
}

/// The mechanism as far as it moves, what else is placed, and what is marked.
fn figure(state: &State) -> Figure {
    let Some(read) = &state.build.read else { return Figure::default() };
    let sketch = &read.sketch;
    let lit = match state.build.lit() {
        Some(Part::Link(link)) => sketch.mechanism.link(&link).into_iter().collect(),
        _ => Vec::new(),
    };
    let shown = shown(state);
    let look = Look { arrows: Arrows::Applied, ..state.pictured() };
    let mut figure = match shown {
        Some(scene) if state.mode_of(state.chosen.group).is_some() => {
            picture::structure(scene, &state.pictured())
        }
        Some(scene) => {
            let marked: Vec<usize> = lit
                .iter()
                .filter_map(|link| scene.linkage.mechanism.link(sketch.mechanism.links[*link].name.as_str()))
                .collect();
            picture::figure(scene, &look, &marked)
        }
        None => Figure::of(Panel::plane(bounds(sketch), Scale::of("l", "m"), Vec::new())),
    };
    figure.legend.clear();
    let in_first_position = shown.is_none() || state.at() == 0.0;
    let Some(panel) = figure.panels.first_mut() else { return figure };
    if in_first_position {
        let moves = |link: &str| shown.is_some_and(|scene| scene.linkage.mechanism.link(link).is_some());
        panel.items.extend(loose(sketch, &moves, &lit));
        panel.items.extend(marks(state, sketch));
    }
    figure
}

fn bounds(sketch: &Sketch) -> Bounds {
    let points = sketch.mechanism.points.iter().filter_map(|point| sketch.place(point.name.as_str()));
    let mut bounds = Bounds::around(points);
    if !bounds.size()[0].is_finite() {
        bounds = Bounds::around([[0.0, 0.0], [0.1, 0.1]].into_iter());
    }
    bounds.widened(MARGIN)
}

/// The links that don't move yet, where they are put.
fn loose<'a>(
    sketch: &'a Sketch,
    moves: &'a dyn Fn(&str) -> bool,
    lit: &'a [usize],
) -> impl Iterator<Item = Item> + 'a {
    let links = sketch.mechanism.links.iter().enumerate().filter(|(_, link)| !moves(link.name.as_str()));
    links.flat_map(move |(link, _)| {
        let on = sketch.mechanism.points.iter().filter(move |point| point.on(link).is_some());
        let places: Vec<_> = on
            .filter_map(|point| Some((sketch.place(point.name.as_str())?, point.is_pin(), &point.name)))
            .collect();
        let ink = if lit.contains(&link) { Ink::Marked } else { Ink::Link(link) };
        let corners: Vec<_> = places.iter().map(|(at, ..)| *at).collect();
        let line = (link != GROUND && corners.len() > 1).then(|| Item::line(corners, Stroke::Dashed, ink));
        let signs = places.into_iter().flat_map(move |(at, is_pin, own)| {
            let sign = match (link, is_pin) {
                (GROUND, _) => Sign::Bearing,
                (_, true) => Sign::Pin,
                _ => Sign::Dot,
            };
            [Item::sign(at, sign, ink), Item::name(at, own.into(), Ink::Title)]
        });
        line.into_iter().chain(signs)
    })
}

/// What is chosen, and what can be.
fn marks(state: &State, sketch: &Sketch) -> Vec<Item> {
    let mut items = Vec::new();
    let mut mark = |part: &Part, ink: Ink| {
        let Some(at) = place(sketch, part) else { return };
        items.push(Item::sign(at, Sign::Cross, ink));
        // The name of a point stands there already.
        let (Part::Link(word) | Part::Slide(word)) = part else { return };
        items.push(Item::name(at, name(word.clone()), ink));
    };
    if let Task::Join(task) = &state.build.task {
        for part in task.candidates(sketch) {
            if Some(&part) == task.chosen.as_ref() {
                mark(&part, Ink::Marked);
            }
        }
        let places = task.targets.iter().filter_map(|target| match target {
            Target::Point(point) => sketch.place(point),
            Target::New { at, .. } | Target::Guide { through: at, .. } => Some(*at),
        });
        let places: Vec<_> = places.collect();
        items.extend(places.into_iter().map(|at| Item::sign(at, Sign::Ring, Ink::Marked)));
    } else if let Some(part) = state.build.lit().filter(|part| !matches!(part, Part::Link(_))) {
        mark(&part, Ink::Marked);
    }
    items
}

/// What is told of the task, or of the chosen thing, in so many rows that the measures of the motion are whole.
fn told(state: &State, width: usize, room: usize) -> Vec<(Role, String)> {
    let mut lines = Vec::new();
    let mut tell = |role: Role, text: Text| {
        lines.extend(wrapped(&state.told(text), width).into_iter().map(|line| (role, line)));
    };
    match &state.build.task {
        Task::Join(task) => {
            tell(Role::Header, joined(" ", [task.addition.title.clone(), task.addition.about.clone()]));
            if !task.targets.is_empty() {
                tell(
                    Role::Plain,
                    text!("build-joined", targets = list(task.targets.iter().map(words_of_target))),
                );
            }
            let [at, count] = [task.targets.len() + 1, task.addition.outer().len()].map(number);
            let is_slide = task.pair() == Some(assur_group::PairSort::Slide);
            let what = text!(if is_slide { "build-join-slide" } else { "build-join-pin" }, at, count);
            tell(Role::Plain, what);
            tell(Role::Dim, text!(if is_slide { "build-join-slide-how" } else { "build-join-pin-how" }));
            let chosen = task.chosen.as_ref().map_or_else(Text::default, words_of);
            let typed = if task.entry.is_empty() { chosen } else { name((*task.entry).to_owned()) };
            tell(Role::Key, text!("build-join-to", what = typed));
        }
        Task::Delete(parts) => {
            tell(Role::Bad, text!("build-delete", parts = list(parts.iter().map(words_of))));
        }
        task => {
            if let Some(chosen) = &state.build.chosen {
                let moves = matches!(task, Task::Move);
                let step = quantity(digits(1e3 * MOVES[state.build.step % MOVES.len()], 1), "mm");
                tell(Role::Header, words_of(chosen));
                if moves {
                    tell(Role::Key, text!("build-moving", step));
                }
                of_part(state, chosen, &mut tell);
            } else {
                tell(Role::Dim, text!("build-choose"));
            }
        }
    }
    // What a mechanism consists of does not change while it is moved.
    lines.extend(
        state_of(state, width).into_iter().filter(|(role, _)| !is_moved(state) || *role != Role::Plain),
    );
    let room = room.saturating_sub(lines.len());
    lines.extend(measures(state, width, room));
    lines
}

/// What is measured of the motion, which follows each key: strokes, transmission angles; as many as have room.
fn measures(state: &State, width: usize, mut room: usize) -> Vec<(Role, String)> {
    let facts = state.found().map_or(&[][..], |found| &found.results);
    let facts = facts.iter().filter(|(about, _)| *about == About::Motion).take(MEASURES);
    let told = facts.map(|(_, fact)| {
        wrapped(&format!("{}: {}", state.told(fact.what()), state.told(fact.with_unit())), width)
    });
    let fits = |lines: &Vec<String>| {
        let left = room.checked_sub(lines.len());
        room = left.unwrap_or(0);
        left.is_some()
    };
    told.take_while(fits).flatten().map(|line| (Role::Plain, line)).collect()
}

/// The moving links on which a point is.
fn links_of(sketch: &Sketch, part: &Part) -> Vec<Text> {
    let Part::Point(point) = part else { return Vec::new() };
    let mechanism = &sketch.mechanism;
    let places = mechanism.point(point).map_or(&[][..], |point| &mechanism.points[point].places);
    let links = places.iter().filter(|place| place.link != GROUND);
    links.map(|place| Text::from(&mechanism.links[place.link].name)).collect()
}

/// What a pair is joined to: a point, or a place (mm) on a link.
fn words_of_target(target: &Target) -> Text {
    match target {
        Target::Point(point) | Target::Guide { point: Some(point), .. } => name(point.clone()),
        Target::New { link, at } | Target::Guide { link, through: at, .. } => {
            let [x, y] = at.map(|value| number(digits(1e3 * value, 6)));
            text!("build-joined-at", link = name(link.clone()), x, y)
        }
    }
}

/// Where the chosen thing is, and what its group is.
fn of_part(state: &State, part: &Part, tell: &mut impl FnMut(Role, Text)) {
    let Some(sketch) = state.build.sketch() else { return };
    let mm = |value: f64| number(digits(1e3 * value, 6));
    if let Some([x, y]) = place(sketch, part).filter(|_| matches!(part, Part::Point(_))) {
        tell(Role::Plain, text!("build-at", x = mm(x), y = mm(y)));
        let links = links_of(sketch, part);
        if links.len() > 1 {
            tell(Role::Plain, text!("build-shared", links = list(links)));
        }
    }
    let (Part::Link(link), Some(scene)) = (part, &state.scene) else { return };
    let structure = &scene.linkage.structure;
    let link = scene.linkage.mechanism.link(link);
    let of = |group: &assur_structure::Group| link.is_some_and(|link| group.frame.links.contains(&link));
    if let Some(group) = structure.groups.iter().position(of) {
        tell(Role::Plain, structure.group_name(&scene.linkage.mechanism, group));
    }
}

/// What the mechanism has become, and what it lacks.
pub(super) fn state_of(state: &State, width: usize) -> Vec<(Role, String)> {
    let Some(read) = &state.build.read else { return Vec::new() };
    let mut lines = Vec::new();
    let mut tell = |role: Role, text: Text| {
        lines.extend(wrapped(&state.told(text), width).into_iter().map(|line| (role, line)));
    };
    match &state.scene {
        Some(scene) if read.readable.is_some() => {
            tell(Role::Plain, name(state.told(&scene.linkage.structure.formula)));
        }
        _ => {}
    }
    let (first, more) = (read.faults.first(), read.faults.len());
    if read.text.trim().is_empty() {
        tell(Role::Key, text!("build-begin", key = name(state.keys.first("add-group"))));
    } else if let Some(fault) = first {
        let key = name(state.keys.first("next-fault"));
        tell(Role::Bad, fault.text.clone());
        tell(Role::Dim, text!("build-faults", count = more, key));
    } else if let Some(closings) = read.closings.as_ref().filter(|closings| !closings.is_empty()) {
        let closing = |closing: &assur_sketch::Closing| {
            let [from, to] = [closing.from, closing.to].map(|value| number(digits(1e3 * value, 5)));
            text!("build-closing", key = &closing.key, from, to)
        };
        let key = name(state.keys.first("close-gap"));
        tell(Role::Bad, text!("build-closings", all = list(closings.iter().map(closing)), key));
    }
    lines
}
