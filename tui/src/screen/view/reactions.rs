//! Common parts of the panes of the forces: rows of tables, directions, curves of the chosen reaction.

use std::fmt::Write;

use assur_figure::Panel;

use crate::screen::state::{Found, Scene, State};

/// Columns of the table: where each ends.
const ENDS: [u16; 5] = [35, 46, 57, 69, 79];

/// A row of a table of forces: a sign, the name at the left, the other cells right-aligned in their columns.
pub(super) fn table_row(sign: char, [name, cells @ ..]: [String; 6]) -> String {
    let mut text = format!("{sign}{name}");
    for (cell, end) in cells.into_iter().zip(ENDS) {
        let width = usize::from(end).saturating_sub(text.chars().count()).max(cell.chars().count() + 1);
        let _ = write!(text, "{cell:>width$}");
    }
    text
}

/// Direction of a force in words; a dash where there is none.
pub(super) fn direction_text(fx: f64, fy: f64) -> String {
    if fx == 0.0 && fy == 0.0 { "-".to_owned() } else { format!("{:.2} deg", direction(fx, fy)) }
}

/// Direction of a force in (-180, 180], degrees; components that are rounding compared with the modulus do not change
/// it.
fn direction(fx: f64, fy: f64) -> f64 {
    let least = 1e-12 * fx.hypot(fy);
    let part = |v: f64| if v.abs() <= least { 0.0 } else { v };
    part(fy).atan2(part(fx)).to_degrees()
}

/// Curves of the chosen reaction, with the given series; for one that it does not have, the last one.
pub(super) fn curves(state: &State, scene: &Scene, found: &Found, which: &[usize]) -> Vec<Panel> {
    let Some(reaction) = found.reactions.get(state.chosen.reaction) else { return Vec::new() };
    let mut wanted: Vec<usize> =
        which.iter().map(|i| (*i).min(reaction.series.len() - 1)).map(|i| reaction.series[i]).collect();
    wanted.dedup();
    super::curves::stack(state, scene, found, scene.other.as_deref(), &wanted)
}
