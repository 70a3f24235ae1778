//! The mechanism to scale, with the numbers of the position beside it: coordinate, speed, the chosen quantity, every link and slide.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_book::catalogue;
use assur_figure::cells::point_at;
use assur_figure::{Figure, Ink, Sample, Stroke};
use assur_mechanism::Motion;
use assur_picture::curves::in_radians;
use assur_picture::mechanism::figure;
use assur_picture::{Arrows, Transfer, missing};
use assur_words::{self as words, Text, joined, name, quantity, text};
use ratatui::layout::{Constraint, Layout, Rect};

use crate::number::digits;
use crate::screen::draw::{Pen, cells, short, wrapped};
use crate::screen::state::{Probe, Role, Scene, Series, State};

/// Columns of the numbers next to the drawing.
const PANEL: u16 = 26;

pub(super) fn draw(pen: &mut Pen<'_>, scene: &Scene, area: Rect) {
    let [drawing, beside] = parts(area);
    let figure = figure(scene, &pen.state.pictured(), &[]);
    pen.paint_zoomed(&figure, pen.state.zoom, drawing);
    draw_numbers(pen, scene, &figure, beside);
}

fn parts(area: Rect) -> [Rect; 2] {
    Layout::horizontal([Constraint::Min(0), Constraint::Length(PANEL)]).areas(area)
}

/// The place of the plane (m) under a cell of the view; `None` beside the drawing.
pub(crate) fn place_at(state: &State, area: Rect, [column, row]: [u16; 2]) -> Option<[f64; 2]> {
    let figure = figure(state.scene.as_ref()?, &state.pictured(), &[]);
    let [drawing, _] = parts(area);
    let cell = [column.checked_sub(drawing.x)?, row.checked_sub(drawing.y)?];
    let size = [drawing.width, drawing.height];
    point_at(figure.panels.first()?, size, cells(state, state.zoom), cell)
}

/// The numbers beside the drawing of a figure.
fn draw_numbers(pen: &mut Pen<'_>, scene: &Scene, figure: &Figure, area: Rect) {
    let state = pen.state;
    let plain = |text: String| (Role::Plain, text);
    let mut lines: Vec<_> = input(state, scene).into_iter().map(|text| plain(state.told(text))).collect();
    lines.push(plain(String::new()));
    if let Some(broken) = scene.broken.get(&state.position) {
        let rows = wrapped(&state.told(&broken.why), usize::from(area.width.max(8)) - 2);
        lines.extend(rows.into_iter().map(|line| (Role::Bad, line)));
        return list_from(pen, &lines, 0, area);
    }
    // What the arrows are, at the foot of the panel; loads and reactions, which are many, in the list.
    let width = usize::from(area.width.max(8)) - 2;
    let mut legend = legend(state, figure, width);
    let mut others = match (&state.probe, state.arrows) {
        (Some(probe), _) => {
            lines.extend(of_probe(state, scene, probe));
            Vec::new()
        }
        (None, Arrows::Applied | Arrows::Loads | Arrows::Reactions) => {
            let why = missing(scene, &state.pictured()).map_or_else(String::new, |why| state.told(why));
            lines.extend(wrapped(&why, width).into_iter().map(plain));
            std::mem::take(&mut legend)
        }
        (None, _) => {
            lines.extend(chosen(state, scene));
            others(state, scene)
        }
    };
    if usize::from(area.height) < lines.len() + legend.len() + 1 {
        // In a low area all is one list.
        lines.extend(std::mem::take(&mut others).into_iter().chain(std::mem::take(&mut legend)));
        return list_from(pen, &lines, state.chosen.transfer, area);
    }
    let [top, list, foot] = Layout::vertical([
        Constraint::Length(short(lines.len())),
        Constraint::Min(0),
        Constraint::Length(short(legend.len()) + 1),
    ])
    .areas(area);
    pen.put_lines(top, 1, &lines);
    pen.put_lines(foot, 1, &legend);
    // From the chosen quantity on: so all come in sight.
    list_from(pen, &others, state.chosen.transfer, list);
}

/// Draws a list from one of its lines on, as far as that fills the area.
fn list_from(pen: &mut Pen<'_>, lines: &[(Role, String)], from: usize, area: Rect) {
    let room = usize::from(area.height);
    let skip = from.min(lines.len().saturating_sub(room));
    pen.put_lines(area, 1, lines.iter().skip(skip).take(room));
    pen.mark_rows(area, skip..lines.len().min(skip + room), lines.len());
}

/// What the vectors of a figure are; a size that has no room beside its name has a row of its own.
fn legend(state: &State, figure: &Figure, width: usize) -> Vec<(Role, String)> {
    let mut rows = Vec::new();
    for key in &figure.legend {
        let Sample::Line(Stroke::Solid | Stroke::Dashed, ink) = key.sample else { continue };
        let told = state.told(&key.text);
        let parts = if told.chars().count() <= width { vec![&*told] } else { told.split("  ").collect() };
        let parts = parts.into_iter().flat_map(|part| wrapped(part, width));
        rows.extend(parts.map(|part| (Role::Drawn(ink), part)));
    }
    rows
}

fn input(state: &State, scene: &Scene) -> Vec<Text> {
    let at = state.position;
    let found = scene.found.as_ref();
    if scene.linkage.kind().is_time() {
        return drives(scene, at);
    }
    let mut lines = vec![text!("panel-coordinate", value = scene.series[0].show(at))];
    let unit = if scene.linkage.kind().is_angle() { "rad/s" } else { "m/s" };
    // In a steady regime the speed is a result, one for each position.
    let of_input = Column::of(Quantity::Velocity, Owner::Input);
    let own = found.and_then(|found| found.series.iter().find(|series| series.column == of_input));
    let speed = match scene.linkage.mechanism.motion {
        Some(Motion::Prescribed { speed, .. }) => Some(quantity(digits(speed, 5), unit)),
        _ => own.map(|series| series.show(at)),
    };
    lines.extend(speed.map(|speed| text!("panel-speed", value = speed)));
    let balancing = found.and_then(|found| found.balancing());
    lines.extend(balancing.map(|series| text!("panel-balance", value = series.show(at))));
    lines
}

/// Over time the coordinate of each drive and its load.
fn drives(scene: &Scene, at: usize) -> Vec<Text> {
    let mut lines = vec![text!("panel-time", value = scene.series[0].show(at))];
    let Some(found) = &scene.found else { return lines };
    for drive in 0..scene.linkage.mechanism.input.drivers.len() {
        for quantity in [Quantity::Transfer(0), Quantity::Balancing] {
            let column = Column::of(quantity, Owner::Drive(drive));
            let series = found.series.iter().find(|series| series.column == column);
            let row = series.map(|series| {
                text!("panel-drive", name = name(series.short.clone()), value = series.show(at))
            });
            lines.extend(row);
        }
    }
    lines
}

/// The moved point: its place on the link and in the plane, size and length of its path, radius of curvature.
fn of_probe(state: &State, scene: &Scene, probe: &Probe) -> Vec<(Role, String)> {
    let Some(pose) = scene.pose(state.position, state.part_way()) else { return Vec::new() };
    let found = probe.measured(scene, &pose);
    let [width, height] = found.size;
    let mm = |value: f64, unit| quantity(digits(1e3 * value, 5), unit);
    let radius = found.radius.map_or_else(|| text!("panel-infinite"), |radius| mm(radius, "mm"));
    let separator = if state.language().code == "en" { ", " } else { "; " };
    let [own, here] = [probe.at, found.place].map(|[x, y]| joined(separator, [mm(x, ""), mm(y, "")]));
    let (number, link) = (words::number(probe.link), &scene.linkage.mechanism.links[probe.link].name);
    let rows = [
        (1, text!("panel-in-frame")),
        (2, own),
        (1, text!("panel-in-plane")),
        (2, here),
        (1, text!("panel-path", width = mm(width, ""), height = mm(height, "mm"))),
        (1, text!("panel-path-length", length = mm(found.length, "mm"))),
        (1, text!("panel-radius")),
        (2, radius),
    ];
    let rows = rows.map(|(indent, text)| (Role::Plain, " ".repeat(indent) + &state.told(text)));
    let title = state.told(text!("panel-point-on", number = number, link = link));
    std::iter::once((Role::Header, title)).chain(rows).collect()
}

/// PF0, PF1, PF2 of the chosen quantity.
fn chosen(state: &State, scene: &Scene) -> Vec<(Role, String)> {
    let Some(transfer) = scene.transfers.get(state.chosen.transfer) else { return Vec::new() };
    let show = |series: &Series| state.told(series.show(state.position));
    let mut lines = vec![(Role::Header, state.told(&transfer.name))];
    lines.extend(transfer.orders.iter().map(|index| {
        let order = catalogue::kind(scene.series[*index].column);
        (Role::Plain, format!(" {} {}", state.told(order), show(&in_radians(&scene.series[*index]))))
    }));
    lines.push((Role::Plain, String::new()));
    lines
}

/// PF0 of the other quantities.
fn others(state: &State, scene: &Scene) -> Vec<(Role, String)> {
    let others = scene.transfers.iter().enumerate().filter(|(index, _)| *index != state.chosen.transfer);
    let line = |(_, other): (usize, &Transfer)| {
        let first = &scene.series[other.orders[0]];
        let text = format!("{} {}", state.told(&first.head), state.told(first.show(state.position)));
        // A link has its number in the drawing.
        match other.owner {
            Owner::Link(number) => (Role::Drawn(Ink::Link(number)), format!("{number} {text}")),
            _ => (Role::Plain, text),
        }
    };
    others.map(line).collect()
}
