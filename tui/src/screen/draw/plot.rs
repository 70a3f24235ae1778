//! Draws the figure of a mechanism into a raster: bars, blocks, pins, hatching, arrows, names.

use assur_kinematics::Position;
use assur_mechanism::GROUND;
use ratatui::style::Style;

use super::figure::{Shape, figure};
use super::label::{Labels, head};
use super::raster::{Raster, Stroke, whole};
use super::scale::Scale;
use crate::screen::state::{Look, Marker, Role, Scene};

/// Half sizes of a block, in cell widths.
const BLOCK: [f64; 2] = [2.0, 1.1];
/// Character of hatching.
const HATCH: &str = "╱";

/// The data for drawing.
#[derive(Debug)]
pub(crate) struct Pen<'a> {
    pub(crate) scale: &'a Scale,
    pub(crate) raster: &'a mut Raster,
    pub(crate) labels: &'a mut Labels,
    pub(crate) look: Look,
}

/// Draws the mechanism in one position; the links in `marked` are highlighted.
pub(crate) fn draw_figure(pen: &mut Pen<'_>, scene: &Scene, pose: &Position, marked: &[usize]) {
    let parts = figure(&scene.linkage, &pose.bodies, &scene.strokes);
    // Marked links are drawn last: where lines cross, the later one gives the cell its style.
    for round in [false, true] {
        for part in parts.iter().filter(|part| marked.contains(&part.link) == round) {
            let role = match part.link {
                GROUND => Role::Ground,
                _ if round => Role::Chosen,
                _ => Role::Link,
            };
            let style = pen.look.theme.style(role);
            draw_shape(pen, part.shape, style);
        }
    }
}

/// Draws the ground alone, for a position that does not exist.
pub(crate) fn draw_ground(pen: &mut Pen<'_>, scene: &Scene) {
    let nowhere = scene.linkage.position();
    let style = pen.look.theme.style(Role::Ground);
    for part in figure(&scene.linkage, &nowhere.bodies, &scene.strokes) {
        if part.link == GROUND && !matches!(part.shape, Shape::Block(..)) {
            draw_shape(pen, part.shape, style);
        }
    }
}

fn draw_shape(pen: &mut Pen<'_>, shape: Shape, style: Style) {
    let ground = pen.look.theme.style(Role::Ground);
    match shape {
        Shape::Bar(a, b) => {
            let (a, b) = (pen.scale.cell(a), pen.scale.cell(b));
            pen.raster.line(a, b, Stroke::Solid, style);
        }
        Shape::Block(center, along) => block(pen, center, along, style),
        Shape::GroundGuide(a, b) => guide(pen, a, b, ground),
        Shape::Pin(at) => {
            let at = pen.scale.cell(at);
            pen.labels.put(at, "o", style);
        }
        Shape::GroundPin(at) => bearing(pen, at, ground),
    }
}

fn block(pen: &mut Pen<'_>, center: [f64; 2], along: [f64; 2], style: Style) {
    let middle = pen.scale.cell(center);
    if pen.look.marker == Marker::Ascii {
        pen.labels.put([middle[0] - 1.0, middle[1]], "[#]", style);
        return;
    }
    let [half, thick] = BLOCK;
    let (u, v) = (pen.scale.arm(along, half), pen.scale.arm([-along[1], along[0]], thick));
    let corner = |a: f64, b: f64| [middle[0] + a * u[0] + b * v[0], middle[1] + a * u[1] + b * v[1]];
    let corners =
        [corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0)];
    pen.raster.polyline(&corners, Stroke::Solid, style);
}

/// A guide on the ground: a line below the block, hatched on its outer side.
fn guide(pen: &mut Pen<'_>, a: [f64; 2], b: [f64; 2], style: Style) {
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    if !(length.is_finite() && length > 0.0) {
        return;
    }
    let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    // The side below, or to the right of a vertical guide.
    let side = if along[0] > 1e-9 || (along[0].abs() <= 1e-9 && along[1] > 0.0) { 1.0 } else { -1.0 };
    let normal = [side * along[1], -side * along[0]];
    let (ca, cb) = (pen.scale.cell(a), pen.scale.cell(b));
    let out = pen.scale.arm(normal, BLOCK[1] + 0.4);
    let shift = |c: [f64; 2], d: [f64; 2]| [c[0] + d[0], c[1] + d[1]];
    pen.raster.line(shift(ca, out), shift(cb, out), Stroke::Solid, style);
    let hatch = pen.scale.arm(normal, BLOCK[1] + 1.9);
    let steps = (cb[0] - ca[0]).abs().max((cb[1] - ca[1]).abs()).ceil().clamp(1.0, 1000.0);
    for step in 0..=whole(steps) {
        let part = step as f64 / steps;
        let at = shift(shift(ca, hatch), [part * (cb[0] - ca[0]), part * (cb[1] - ca[1])]);
        pen.labels.faint(at, HATCH, style);
    }
}

/// A bearing: a pin, two struts, a hatched base.
fn bearing(pen: &mut Pen<'_>, at: [f64; 2], style: Style) {
    let [x, y] = pen.scale.cell(at);
    let row = y.floor() + 1.0;
    if pen.look.marker != Marker::Ascii {
        for side in [-1.5, 1.5] {
            pen.raster.line([x, y], [x + side, row], Stroke::Solid, style);
        }
    }
    for column in -2..=2 {
        pen.labels.faint([x + f64::from(column), row + 0.5], HATCH, style);
    }
    pen.labels.put([x, y], "o", style);
}

/// An arrow from a place along a vector; `unit` is the length in cell widths of a vector of size 1.
pub(crate) fn arrow(pen: &mut Pen<'_>, at: [f64; 2], v: [f64; 2], unit: f64, stroke: Stroke, style: Style) {
    let length = v[0].hypot(v[1]) * unit;
    if !(length.is_finite() && length >= 1.0) {
        return;
    }
    let from = pen.scale.cell(at);
    let along = [v[0] * unit / length, v[1] * unit / length];
    let arm = pen.scale.arm(along, length);
    let to = [from[0] + arm[0], from[1] + arm[1]];
    pen.raster.line(from, to, stroke, style);
    pen.labels.put(to, head([along[0], -along[1]]), style);
}

/// The names of all points.
pub(crate) fn point_names(pen: &mut Pen<'_>, scene: &Scene, pose: &Position) {
    let style = pen.look.theme.style(Role::Header);
    for (id, point) in scene.linkage.mechanism.points.iter().enumerate() {
        let at = pen.scale.cell(scene.linkage.point_motion(id, pose).pf0);
        pen.labels.beside(pen.raster, at, &point.name, style);
    }
}
