//! Kinematics: positions, plans, transfer functions, velocities and accelerations.

use super::Context;
use super::document::Block;
use super::task::MECHANISM;
use crate::number::digits;
use crate::screen::state::{Part, Series, View, greatest};

/// Page of a plan, mm.
pub(super) const PLAN: [f64; 2] = [160.0, 100.0];
/// Page of three curves, mm.
pub(super) const CURVES: [f64; 2] = [160.0, 130.0];
/// Digits of a number in a table.
const DIGITS: usize = 5;

/// Heading, the mechanism and its plans in the chosen positions, curves of the last quantity, table of rates.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let mut blocks = vec![Block::Heading(words.get("kinematics")), Block::Text(words.get("kinematics-text"))];
    for &position in context.positions {
        let values = [("position", position.to_string()), ("at", context.coordinate(position))];
        let caption = words.with("mechanism-at", &values);
        blocks.extend(context.picture(View::Mechanism, position, MECHANISM, |_, _| caption, |_| {}));
        for (kind, id) in [(Part::Velocities, "velocity-plan"), (Part::Accelerations, "acceleration-plan")] {
            let caption = words.with(id, &[("position", position.to_string())]);
            blocks.extend(context.picture(
                View::Plans,
                position,
                PLAN,
                |_, _| caption,
                |state| {
                    state.parts.insert(View::Plans, kind);
                },
            ));
        }
    }
    let position = context.positions[0];
    // The last quantity is that of the last slide, or of the last link: what the mechanism is for.
    let last = context.state.scene.as_ref().map_or(0, |scene| scene.transfers.len().saturating_sub(1));
    blocks.extend(context.picture(
        View::Curves,
        position,
        CURVES,
        |words, title| words.with("transfer-functions", &[("of", words.phrase(title))]),
        |state| state.chosen.transfer = last,
    ));
    let Some(found) = context.state.found() else { return blocks };
    // What rests has no row.
    let rates = found.series.iter().filter(|series| {
        ["velocity", "acceleration"].contains(&series.kind) && greatest(&series.values) > series.floor
    });
    let rows = table(context, rates);
    if !rows.is_empty() {
        let head = head(context);
        blocks.push(Block::table(words, "velocities", head, rows));
    }
    blocks
}

/// Head of a table of quantities in the chosen positions.
pub(super) fn head(context: &Context<'_>) -> Vec<String> {
    let words = context.words;
    let positions = context
        .positions
        .iter()
        .map(|position| words.with("position", &[("position", position.to_string())]));
    [words.get("quantity"), words.get("unit")].into_iter().chain(positions).collect()
}

/// A row for each quantity: its name, its unit, its values in the chosen positions.
pub(super) fn table<'s>(context: &Context<'_>, all: impl Iterator<Item = &'s Series>) -> Vec<Vec<String>> {
    let words = context.words;
    all.map(|series| {
        let values = context.positions.iter().map(|position| {
            let value = series.at(*position);
            words.number(&if value.abs() <= series.floor { "0".to_owned() } else { digits(value, DIGITS) })
        });
        [words.phrase(&series.of), series.unit.clone()].into_iter().chain(values).collect()
    })
    .collect()
}
