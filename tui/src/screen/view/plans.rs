//! Plans of the position: force polygon of a group, velocities, accelerations, the construction step by step.

use assur_force::{Construction, Drawing, StepKind};
use assur_results::PositionResult;
use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::panel::wrapped;
use super::put;
use crate::screen::draw::diagram::{Arrow, Diagram};
use crate::screen::draw::raster::short;
use crate::screen::found::Found;
use crate::screen::number::digits;
use crate::screen::plans::{bounds, corners, residual};
use crate::screen::state::{PlanKind, State};
use crate::screen::study::Study;
use crate::screen::text::fill;
use crate::screen::theme::Role;

/// Columns of the list beside the drawing.
const LIST: u16 = 40;

/// Draws the view.
pub(crate) fn draw(state: &State, study: &Study, area: Rect, buffer: &mut Buffer) {
    let Some(found) = &study.found else { return };
    let [list, drawing] = Layout::horizontal([Constraint::Length(LIST), Constraint::Min(0)]).areas(area);
    match state.plan {
        PlanKind::Forces => forces(state, study, found, list, drawing, buffer),
        PlanKind::Velocity | PlanKind::Acceleration => rates(state, study, found, list, drawing, buffer),
        PlanKind::Construction => construction(state, found, list, drawing, buffer),
    }
}

fn lines(state: &State, lines: &[(Role, String)], area: Rect, buffer: &mut Buffer) {
    let cut = Rect { width: area.width.saturating_sub(1), ..area };
    for (row, (role, line)) in lines.iter().enumerate() {
        put(buffer, cut, 1, short(row), line, state.look.theme.style(*role));
    }
}

/// The polygon of the chosen group (after the last one: of the input link), with its sides and what it leaves open.
fn forces(state: &State, study: &Study, found: &Found, list: Rect, drawing: Rect, buffer: &mut Buffer) {
    let texts = state.texts;
    let polygons = found.plans.get(state.position).map_or(&[][..], |plan| &plan.polygons);
    let Some(sides) = polygons.get(state.chosen.polygon) else { return };
    let structure = &study.linkage.structure;
    let mechanism = &study.linkage.mechanism;
    let name = if state.chosen.polygon < structure.groups.len() {
        structure.group_name(mechanism, state.chosen.polygon)
    } else {
        fill(texts.input_polygon, &[&mechanism.links[mechanism.input.link].name])
    };
    let width = usize::from(list.width.max(12)) - 2;
    let title = wrapped(&fill(texts.polygon_of, &[&name]), width);
    let mut rows: Vec<(Role, String)> = title.into_iter().map(|line| (Role::Header, line)).collect();
    rows.push((Role::Plain, String::new()));
    for (index, side) in sides.iter().enumerate() {
        let [fx, fy] = side.force;
        let kind = if side.reaction { 'R' } else { 'F' };
        let size = digits(fx.hypot(fy), 5);
        rows.push((Role::Plain, format!("{kind}{} {:<20} {size} N", index + 1, side.name)));
    }
    let [rx, ry] = residual(sides);
    rows.push((Role::Plain, String::new()));
    rows.push((Role::Header, fill(texts.residual, &[&format!("{:.1e}", rx.hypot(ry))])));
    lines(state, &rows, list, buffer);
    let ends = corners(sides);
    let arrows = sides.iter().enumerate().map(|(index, side)| Arrow {
        from: ends[index],
        to: ends[index + 1],
        name: format!("{}{}", if side.reaction { 'R' } else { 'F' }, index + 1),
        role: if side.reaction { Role::First } else { Role::Second },
    });
    Diagram { arrows: arrows.collect(), unit: "N" }.draw(state.look, drawing, buffer);
}

/// The plan of velocities or accelerations: from the pole to each point; points of one link are joined.
fn rates(state: &State, study: &Study, found: &Found, list: Rect, drawing: Rect, buffer: &mut Buffer) {
    let texts = state.texts;
    let first = state.plan == PlanKind::Velocity;
    let Some(position) = found.analysis.positions.iter().find(|p| p.index == state.position) else { return };
    let angular = found.analysis.input.angular;
    let timed = if first { &position.velocities } else { &position.accelerations };
    let unit = match (timed.is_some(), first, angular) {
        (true, true, _) => "m/s",
        (true, false, _) => "m/s2",
        (false, true, true) => "m/rad",
        (false, false, true) => "m/rad2",
        (false, true, false) => "m/m",
        (false, false, false) => "m/m2",
    };
    let title = if first { texts.velocity_plan } else { texts.acceleration_plan };
    let mut rows = vec![(Role::Header, title.to_owned()), (Role::Plain, String::new())];
    let mut arrows = Vec::new();
    for (name, vector) in vectors(position, first) {
        let size = vector[0].hypot(vector[1]);
        rows.push((Role::Plain, format!("{name:<6} {} {unit}", digits(size, 5))));
        if size > 0.0 {
            let (from, role) = ([0.0, 0.0], if first { Role::Velocity } else { Role::Acceleration });
            arrows.push(Arrow { from, to: vector, name: name.to_lowercase(), role });
        }
    }
    arrows.extend(joined(study, position, first));
    lines(state, &rows, list, buffer);
    Diagram { arrows, unit }.draw(state.look, drawing, buffer);
}

/// Velocity (acceleration) of each named point: by time with a motion, else PF1 (PF2).
fn vectors(position: &PositionResult, first: bool) -> Vec<(String, [f64; 2])> {
    let timed = if first { &position.velocities } else { &position.accelerations };
    if let Some(rates) = timed {
        return rates.points.iter().map(|(name, v)| (name.to_owned(), *v)).collect();
    }
    let of = |t: &assur_results::Transfer| if first { t.pf1 } else { t.pf2 };
    position.points.iter().map(|(name, t)| (name.to_owned(), of(t))).collect()
}

/// The relative vectors of the points of one link.
fn joined(study: &Study, position: &PositionResult, first: bool) -> Vec<Arrow> {
    let vectors = vectors(position, first);
    let mechanism = &study.linkage.mechanism;
    let mut lines = Vec::new();
    for link in 1..mechanism.links.len() {
        let on_link =
            |name: &str| mechanism.point(name).is_some_and(|id| mechanism.place_in(id, link).is_some());
        let tips: Vec<[f64; 2]> = vectors.iter().filter(|(name, _)| on_link(name)).map(|(_, v)| *v).collect();
        lines.extend(tips.windows(2).map(|two| Arrow {
            from: two[0],
            to: two[1],
            name: String::new(),
            role: Role::Trace,
        }));
    }
    lines
}

/// Length at which 1 N is drawn: in the drawing of the mechanism the largest force is as long as half of it.
fn force_size(construction: &Construction, kind: Drawing) -> f64 {
    if kind != Drawing::Mechanism {
        return 1.0;
    }
    let steps = construction.steps.iter().filter(|step| step.drawing == kind);
    let (forces, lines): (Vec<_>, Vec<_>) = steps.partition(|step| step.unit == "N");
    let most = forces.iter().map(|step| step.vector[0].hypot(step.vector[1])).fold(0.0, f64::max);
    let ends =
        lines.iter().flat_map(|step| [step.start, [0, 1].map(|axis| step.start[axis] + step.vector[axis])]);
    let [width, height] = bounds(ends).size();
    if most > 0.0 { 0.5 * width.max(height) / most } else { 1.0 }
}

/// The construction as far as the chosen step, with the sentence that explains it.
fn construction(state: &State, found: &Found, list: Rect, drawing: Rect, buffer: &mut Buffer) {
    let plan = found.plans.get(state.position);
    let Some(construction) = plan.and_then(|plan| plan.construction.as_ref()) else {
        lines(state, &[(Role::Plain, state.texts.no_construction.to_owned())], list, buffer);
        return;
    };
    let last = state.chosen.step.min(construction.steps.len().saturating_sub(1));
    let width = usize::from(list.width.max(12)) - 2;
    let mut rows: Vec<(Role, String)> =
        wrapped(&construction.title, width).into_iter().map(|line| (Role::Header, line)).collect();
    rows.push((Role::Plain, fill(state.texts.step, &[&(last + 1), &construction.steps.len()])));
    if let Some(step) = construction.steps.get(last) {
        let size = digits(step.vector[0].hypot(step.vector[1]), 5);
        rows.push((Role::Key, format!("{} ({}) {size} {}", step.name, step.kind.word(), step.unit)));
        rows.extend(wrapped(&step.note, width).into_iter().map(|line| (Role::Plain, line)));
    }
    lines(state, &rows, list, buffer);
    let kind = construction.steps.get(last).map_or(Drawing::Mechanism, |step| step.drawing);
    let shown = construction.steps.iter().take(last + 1).filter(|step| step.drawing == kind);
    let size = force_size(construction, kind);
    let arrows = shown.map(|step| Arrow {
        from: step.start,
        to: [0, 1]
            .map(|axis| step.start[axis] + step.vector[axis] * if step.unit == "N" { size } else { 1.0 }),
        name: step.name.clone(),
        role: match step.kind {
            StepKind::Line | StepKind::Point => Role::Trace,
            StepKind::Load | StepKind::Part => Role::Second,
            _ => Role::First,
        },
    });
    let unit = match kind {
        Drawing::Mechanism => "m",
        Drawing::Polygon => "N",
        Drawing::Lever => "m/rad",
    };
    Diagram { arrows: arrows.collect(), unit }.draw(state.look, drawing, buffer);
}
