//! Velocities and accelerations as arrows: per unit time if the positions move, else per unit speed of the coordinate.

use ratatui::layout::Rect;

use crate::number::plain;
use crate::screen::draw::{Pen, Stroke, arrow, round_length, whole};
use crate::screen::state::{Arrows, Owner, Role, Scene, State, greatest, rates_of};

/// Longest arrow, as part of the smaller side of the drawing.
const LONGEST: f64 = 0.3;

/// The orders of derivatives to draw.
fn orders(state: &State) -> &'static [usize] {
    match state.arrows {
        Arrows::None => &[],
        Arrows::Velocity => &[1],
        Arrows::Acceleration => &[2],
        Arrows::Both => &[1, 2],
    }
}

/// Velocities are full arrows, accelerations dotted ones: distinguished without color.
fn look_of(order: usize) -> (Stroke, Role, char) {
    if order == 1 {
        (Stroke::Solid, Role::Velocity, '-')
    } else {
        (Stroke::Dotted(2), Role::Acceleration, '.')
    }
}

/// Whether the positions move.
fn moves(scene: &Scene) -> Option<[f64; 2]> {
    scene.found.as_ref().and_then(|found| found.fastest)
}

/// Draws the arrows of all points that have them.
pub(super) fn draw(
    state: &State,
    scene: &Scene,
    pose: &assur_kinematics::Position,
    position: usize,
    area: Rect,
    pen: &mut Pen<'_>,
) {
    for &order in orders(state) {
        let Some(unit) = cells(state, scene, area, order) else { continue };
        let (stroke, role, _) = look_of(order);
        let style = state.look.theme.style(role);
        for (point, vector) in vectors(scene, pose, position, order) {
            let at = scene.linkage.point_motion(point, pose).pf0;
            arrow(pen, at, vector, unit, stroke, style);
        }
    }
}

/// The vector of each point in a position: v = PF1 w, a = PF2 w² + PF1 e; without a motion PF1, PF2.
fn vectors(
    scene: &Scene,
    pose: &assur_kinematics::Position,
    position: usize,
    order: usize,
) -> Vec<(usize, [f64; 2])> {
    let mechanism = &scene.linkage.mechanism;
    if moves(scene).is_some() {
        let result = scene.found.as_ref().and_then(|found| found.position(position));
        let Some(rates) = result.and_then(|result| rates_of(result, order)) else { return Vec::new() };
        return rates.points.iter().filter_map(|(name, v)| Some((mechanism.point(name)?, *v))).collect();
    }
    let all = 0..mechanism.points.len();
    all.map(|id| {
        let motion = scene.linkage.point_motion(id, pose);
        (id, if order == 1 { motion.pf1 } else { motion.pf2 })
    })
    .collect()
}

/// Length in cell widths of an arrow of size 1; equal in all positions, so that lengths can be compared.
fn cells(state: &State, scene: &Scene, area: Rect, order: usize) -> Option<f64> {
    let most = match moves(scene) {
        Some(fastest) => fastest[order - 1],
        None => scene
            .transfers
            .iter()
            .filter(|transfer| matches!(transfer.owner, Owner::Point(_)))
            .map(|transfer| greatest(&scene.series[transfer.orders[order]].values))
            .fold(0.0, f64::max),
    };
    let side = f64::from(area.width).min(f64::from(area.height) * state.look.ratio);
    (most > 0.0).then(|| LONGEST * side / most)
}

/// The legend of the arrows and the length of a round value, two lines for each kind.
pub(crate) fn legend(state: &State, scene: &Scene, drawing: Rect) -> Vec<(Role, String)> {
    let moves = moves(scene).is_some();
    let coordinate = if scene.linkage.angular() { "rad" } else { "m" };
    let mut lines = Vec::new();
    for &order in orders(state) {
        let Some(cells) = cells(state, scene, drawing, order) else { continue };
        let (_, role, dash) = look_of(order);
        let (name, unit) = match (moves, order) {
            (true, 1) => ("velocity", "m/s".to_owned()),
            (true, _) => ("acceleration", "m/s2".to_owned()),
            (false, 1) => ("PF1: for unit speed", format!("m/{coordinate}")),
            (false, _) => ("PF2: for unit speed", format!("m/{coordinate}2")),
        };
        let round = round_length(8.0 / cells);
        let shaft: String = std::iter::repeat_n(dash, whole((round * cells).clamp(1.0, 12.0))).collect();
        lines.push((role, name.to_owned()));
        lines.push((role, format!(" {shaft}> {} {unit}", plain(round))));
    }
    lines
}
