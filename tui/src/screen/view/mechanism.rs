//! The mechanism to scale, with names, paths and arrows.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;

use super::{arrows, panel};
use crate::screen::draw::label::Labels;
use crate::screen::draw::plot::{Pen, draw_figure, draw_ground, names};
use crate::screen::draw::raster::{Raster, Stroke, whole};
use crate::screen::draw::scale::Scale;
use crate::screen::number::plain;
use crate::screen::series::Key;
use crate::screen::state::{State, Traces};
use crate::screen::study::Study;
use crate::screen::theme::Role;

/// Columns of the numbers beside the drawing.
const PANEL: u16 = 26;

/// Draws the view.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let [drawing, beside] = Layout::horizontal([Constraint::Min(0), Constraint::Length(PANEL)]).areas(area);
    picture(state, study, state.position, drawing, &[], buffer);
    panel::draw(state, study, beside, buffer);
}

/// The drawing alone; the links in `marked` stand out.
pub(crate) fn picture(
    state: &State,
    study: &Study,
    position: usize,
    area: Rect,
    marked: &[usize],
    buffer: &mut Buffer,
) {
    let scale = Scale::fit(study.bounds, area, state.look.ratio, state.zoom);
    let mut raster = Raster::new(area, state.look.marker);
    let mut labels = Labels::new(area);
    traces(state, study, &scale, &mut raster);
    let pose = study.poses.get(position).and_then(Option::as_ref);
    let mut pen = Pen { scale: &scale, raster: &mut raster, labels: &mut labels, look: state.look };
    if let Some(pose) = pose {
        draw_figure(&mut pen, study, pose, marked);
        arrows::draw(state, study, pose, position, area, &mut pen);
        names(&mut pen, study, pose);
    } else {
        draw_ground(&mut pen, study);
    }
    raster.paint(area, buffer);
    labels.write(&raster, buffer);
    scale_bar(state, &scale, area, buffer);
}

fn traces(state: &State, study: &Study, scale: &Scale, raster: &mut Raster) {
    let chosen = chosen_point(state, study);
    let style = state.look.theme.style(Role::Trace);
    for (id, path) in study.paths.iter().enumerate() {
        let wanted = match state.traces {
            Traces::All => true,
            Traces::Chosen => chosen == Some(id),
            Traces::None => false,
        };
        if wanted {
            let cells: Vec<[f64; 2]> = path.iter().map(|at| scale.cell(*at)).collect();
            raster.polyline(&cells, Stroke::Dotted(3), style);
        }
    }
}

/// The point that is chosen, if a point is.
pub(crate) fn chosen_point(state: &State, study: &Study) -> Option<usize> {
    match study.transfers.get(state.chosen.transfer)?.key {
        Key::Point(id) => Some(id),
        _ => None,
    }
}

/// `|----| 100 mm` in the lower left corner.
fn scale_bar(state: &State, scale: &Scale, area: Rect, buffer: &mut Buffer) {
    if area.height < 2 {
        return;
    }
    let length = round_length(12.0 * scale.meters);
    let cells = (length / scale.meters).round();
    let dashes = "-".repeat(whole(cells.clamp(2.0, 40.0)).saturating_sub(1));
    let text = format!("|{dashes}| {} mm", plain(1e3 * length));
    let style: Style = state.look.theme.style(Role::Dim);
    super::put(buffer, area, 0, area.height - 1, &text, style);
}

/// The largest of 1, 2, 5 times a power of ten that is not above `most`.
pub(crate) fn round_length(most: f64) -> f64 {
    if !(most.is_finite() && most > 0.0) {
        return 1.0;
    }
    let power = 10.0_f64.powf(most.log10().floor());
    let times = [5.0, 2.0, 1.0].into_iter().find(|times| times * power <= most);
    times.unwrap_or(1.0) * power
}
