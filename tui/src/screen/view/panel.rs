//! The numbers next to the drawing: coordinate, speed, the chosen quantity, every link and slide.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_figure::cells::cell_width;
use assur_figure::{Figure, Ink, Sample};
use assur_geometry::Curvature;
use assur_mechanism::{Motion, Place};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::number::digits;
use crate::screen::draw::{cells, put_lines, wrapped};
use crate::screen::state::{Bounds, Probe, Role, Scene, State};

/// Longest shaft of an arrow of the legend, in columns.
const SHAFT: f64 = 12.0;

/// Draws the panel of a figure that has an area of its own.
pub(super) fn draw(
    state: &State,
    scene: &Scene,
    figure: &Figure,
    drawing: Rect,
    area: Rect,
    buffer: &mut Buffer,
) {
    let plain = |text: String| (Role::Plain, text);
    let mut lines: Vec<_> = input(state, scene).into_iter().map(plain).collect();
    lines.push(plain(String::new()));
    if let Some(Some(broken)) = scene.broken.get(state.position) {
        let rows = wrapped(&broken.why, usize::from(area.width.max(8)) - 2);
        lines.extend(rows.into_iter().map(|line| (Role::Bad, line)));
    } else {
        match &state.probe {
            Some(probe) => lines.extend(of_probe(state, scene, probe)),
            None => lines.extend(quantities(state, scene)),
        }
        // The legend and the scale of the arrows, at the foot of the panel.
        let legend = legend(state, figure, drawing);
        lines.resize(usize::from(area.height).saturating_sub(legend.len() + 1), plain(String::new()));
        lines.extend(legend);
    }
    put_lines(buffer, area, 1, state, &lines);
}

/// The legend of the arrows: what they are, then the length of a round value.
fn legend(state: &State, figure: &Figure, drawing: Rect) -> Vec<(Role, String)> {
    let Some(panel) = figure.panels.first() else { return Vec::new() };
    let Some(width) = cell_width(panel, [drawing.width, drawing.height], cells(state, state.zoom)) else {
        return Vec::new();
    };
    let mut lines = Vec::new();
    for key in &figure.legend {
        let Sample::Arrow(length, _, ink) = key.sample else { continue };
        let (role, dash) =
            if ink == Ink::Velocity { (Role::Velocity, '-') } else { (Role::Acceleration, '.') };
        let shaft = (0..).take_while(|dash| f64::from(*dash) < (length / width).clamp(1.0, SHAFT));
        let shaft: String = shaft.map(|_| dash).collect();
        let (name, value) = key.text.rsplit_once(": ").unwrap_or(("", &key.text));
        lines.extend([(role, name.to_owned()), (role, format!(" {shaft}> {value}"))]);
    }
    lines
}

/// Coordinate and speed of the input, and the balancing load.
fn input(state: &State, scene: &Scene) -> Vec<String> {
    let at = state.position;
    let mut lines = vec![format!("coordinate {}", scene.series[0].show(at))];
    let unit = if scene.linkage.angular() { "rad/s" } else { "m/s" };
    let found = scene.found.as_ref();
    // In a steady regime the speed is a result, one for each position.
    let of_input = Column::of(Quantity::Velocity, Owner::Input);
    let own = found.and_then(|found| found.series.iter().find(|series| series.column == of_input));
    let speed = match scene.linkage.mechanism.motion {
        Some(Motion::Prescribed { speed, .. }) => Some(format!("{} {unit}", digits(speed, 5))),
        _ => own.map(|series| series.show(at)),
    };
    lines.extend(speed.map(|speed| format!("speed {speed}")));
    let balancing = found.and_then(|found| found.balancing());
    lines.extend(balancing.map(|series| format!("balance {}", series.show(at))));
    lines
}

/// The moved point: its place on the link and in the plane, size and length of its path, radius of curvature.
fn of_probe(state: &State, scene: &Scene, probe: &Probe) -> Vec<(Role, String)> {
    let Some(pose) = scene.pose(state.position, state.part_way()) else { return Vec::new() };
    let linkage = &scene.linkage;
    let motion = linkage.place_motion(Place { link: probe.link, at: probe.at }, &pose);
    let path = probe.path(scene);
    let [width, height] = Bounds::around(path.iter().copied()).size();
    let pieces = path.windows(2).map(|two| (two[1][0] - two[0][0]).hypot(two[1][1] - two[0][1]));
    let length: f64 = pieces.filter(|piece| piece.is_finite()).sum();
    let mm = |value: f64| digits(1e3 * value, 5);
    let curvature = Curvature::of(&motion, motion.pf1[0].hypot(motion.pf1[1]));
    let radius = curvature.map(|found| found.curvature.abs()).filter(|curvature| *curvature > 0.0);
    let radius =
        radius.map_or_else(|| "infinite".to_owned(), |curvature| format!("{} mm", mm(1.0 / curvature)));
    let [own, here] = [probe.at, motion.pf0].map(|[x, y]| format!("{}, {}", mm(x), mm(y)));
    let name = &linkage.mechanism.links[probe.link].name;
    let rows = [
        (Role::Header, format!("P on {} {name}", probe.link)),
        (Role::Plain, " in its frame, mm:".to_owned()),
        (Role::Plain, format!("  {own}")),
        (Role::Plain, " in the plane, mm:".to_owned()),
        (Role::Plain, format!("  {here}")),
        (Role::Plain, format!(" path {} x {} mm", mm(width), mm(height))),
        (Role::Plain, format!(" about {} mm long", mm(length))),
        (Role::Plain, " radius of curvature".to_owned()),
        (Role::Plain, format!("  {radius}")),
    ];
    rows.into()
}

/// PF0, PF1, PF2 of the chosen quantity, then PF0 of the others.
fn quantities(state: &State, scene: &Scene) -> Vec<(Role, String)> {
    let Some(transfer) = scene.transfers.get(state.chosen.transfer) else { return Vec::new() };
    let show = |index: usize| scene.series[index].show(state.position);
    let mut lines = vec![(Role::Header, transfer.name.clone())];
    let orders = transfer.orders.iter().enumerate();
    lines.extend(orders.map(|(order, index)| (Role::Plain, format!(" PF{order} {}", show(*index)))));
    lines.push((Role::Plain, String::new()));
    let others = scene.transfers.iter().filter(|other| other.name != transfer.name);
    lines.extend(others.map(|other| {
        let first = other.orders[0];
        let text = format!("{} {}", scene.series[first].short, show(first));
        // A link has its number in the drawing.
        match other.owner {
            Owner::Link(number) => (Role::Link(number), format!("{number} {text}")),
            _ => (Role::Plain, text),
        }
    }));
    lines
}
