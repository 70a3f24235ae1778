//! Planes of one kind on a page: to one scale, so that they can be compared.

use super::{Print, Room, plane};
use crate::model::{Figure, Panel};
use crate::number::round_up;
use crate::scale::SCALES;

/// Steps of the series of scales that are tried: to the hundredfold and more.
const STEPS: usize = 16;
/// A drawing that would be smaller than this, in text sizes, needs a scale of its own.
const LEAST: f64 = 5.0;

/// The rooms of the panels with the width and height of all, in the columns of the figure or below each other, whichever gives the finer
/// scale; `None` where they are not of one kind, alone, or too different in size.
pub(super) fn placed(figure: &Figure, size: [f64; 2], print: &Print<'_>) -> Option<(Vec<Room>, [f64; 2])> {
    let panels = &figure.panels;
    let first = plane::kind(panels.first()?)?;
    if panels.len() < 2 || panels.iter().any(|panel| plane::kind(panel) != Some(first)) {
        return None;
    }
    let ways =
        [figure.columns.max(1), 1].map(|columns| Some((columns, finest(panels, columns, size, print)?)));
    let (columns, scale) =
        ways.into_iter().flatten().reduce(|one, other| if other.1 < one.1 { other } else { one })?;
    let is_seen = |panel: &Panel| plane::largest(panel) >= LEAST * print.style.em * scale;
    panels.iter().all(is_seen).then(|| rooms(panels, columns, scale, size[0], print))
}

/// The finest round scale in which the panels have room in so many columns.
fn finest(panels: &[Panel], columns: usize, [width, height]: [f64; 2], print: &Print<'_>) -> Option<f64> {
    let whole = Room { left: 0.0, top: 0.0, width, height, scale: 0.0 };
    let least = panels.iter().filter_map(|panel| plane::scale_in(panel, whole, print)).fold(0.0, f64::max);
    let next = |scale: &f64| Some(round_up(scale * 1.01, &SCALES));
    let fits = |scale: &f64| {
        let (_, used) = rooms(panels, columns, *scale, width, print);
        used[0] <= width && used[1] <= height
    };
    std::iter::successors(Some(least), next).take(STEPS).find(fits)
}

/// The rooms of the panels at a scale, row by row, each row in the middle; and the width and height of all.
fn rooms(
    panels: &[Panel],
    columns: usize,
    scale: f64,
    width: f64,
    print: &Print<'_>,
) -> (Vec<Room>, [f64; 2]) {
    let mut all: Vec<Vec<Room>> = Vec::new();
    let mut used = [0.0_f64; 2];
    for row in panels.chunks(columns) {
        let share = Room { left: 0.0, top: 0.0, width: width / row.len() as f64, height: 0.0, scale };
        let needed: Vec<Room> = row.iter().map(|panel| plane::at_scale(panel, share, scale, print)).collect();
        let high = needed.iter().map(|room| room.height).fold(0.0, f64::max);
        let mut left = 0.0;
        let place = |room: Room| {
            let own = Room { left, top: used[1], height: high, ..room };
            left += room.width;
            own
        };
        all.push(needed.into_iter().map(place).collect());
        used = [used[0].max(left), used[1] + high];
    }
    let centered = |row: Vec<Room>| {
        let aside = 0.5 * (used[0] - row.iter().map(|room| room.width).sum::<f64>());
        row.into_iter().map(move |room| Room { left: room.left + aside, ..room })
    };
    (all.into_iter().flat_map(centered).collect(), used)
}
