//! The mechanism to scale, with names, paths and arrows.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{arrows, panel};
use crate::screen::draw::{Labels, Pen, Raster, Scale, Stroke, draw_figure, draw_ground, point_names, put};
use crate::screen::state::{Owner, Role, Scene, State, Traces};

/// Columns of the numbers next to the drawing.
const PANEL: u16 = 26;
/// Greatest length of the scale bar, in cell widths.
const BAR: f64 = 12.0;

/// Draws the view.
pub(super) fn draw(state: &State, scene: &Scene, area: Rect, buffer: &mut Buffer) {
    let [drawing, beside] = Layout::horizontal([Constraint::Min(0), Constraint::Length(PANEL)]).areas(area);
    picture(state, scene, state.position, drawing, &[], buffer);
    panel::draw(state, scene, drawing, beside, buffer);
}

/// The drawing alone; the links in `marked` are highlighted.
pub(crate) fn picture(
    state: &State,
    scene: &Scene,
    position: usize,
    area: Rect,
    marked: &[usize],
    buffer: &mut Buffer,
) {
    let scale = Scale::fit(scene.bounds, area, state.look.ratio, state.zoom);
    let mut raster = Raster::new(area, state.look.marker);
    let mut labels = Labels::new(area);
    traces(state, scene, &scale, &mut raster);
    let pose = scene.poses.get(position).and_then(Option::as_ref);
    let mut pen = Pen { scale: &scale, raster: &mut raster, labels: &mut labels, look: state.look };
    if let Some(pose) = pose {
        draw_figure(&mut pen, scene, pose, marked);
        arrows::draw(state, scene, pose, position, area, &mut pen);
        point_names(&mut pen, scene, pose);
    } else {
        draw_ground(&mut pen, scene);
    }
    raster.paint(area, buffer);
    labels.write(&raster, buffer);
    if area.height > 1 {
        let bar = scale.bar(BAR, 1e3, "mm");
        put(buffer, area, 0, area.height - 1, &bar, state.look.theme.style(Role::Dim));
    }
}

fn traces(state: &State, scene: &Scene, scale: &Scale, raster: &mut Raster) {
    let chosen = scene.transfers.get(state.chosen.transfer).map(|transfer| &transfer.owner);
    let style = state.look.theme.style(Role::Trace);
    for (id, path) in scene.paths.iter().enumerate() {
        let wanted = match state.traces {
            Traces::All => true,
            Traces::Chosen => chosen == Some(&Owner::Point(id)),
            Traces::None => false,
        };
        if wanted {
            let cells: Vec<[f64; 2]> = path.iter().map(|at| scale.cell(*at)).collect();
            raster.polyline(&cells, Stroke::Dotted(3), style);
        }
    }
}
