//! Dynamics: the regime, its iteration, motor and flywheel.

use assur_analysis::results::Dynamics;

use super::Context;
use super::document::Block;
use super::kinematics::CURVES;
use crate::number::digits;
use crate::screen::state::{Part, View};

/// Digits of a number in a table.
const DIGITS: usize = 6;

/// Numbers, iteration and curves of the regime; curves of the motion where there is no regime.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let position = context.positions[0];
    let Some(dynamics) = context.state.found().and_then(|found| found.analysis.dynamics.clone()) else {
        let caption = words.get("motion-curves");
        let motion = context.picture(View::Motion, position, CURVES, |_, _| caption, |_| {});
        return motion.into_iter().flat_map(|motion| [Block::Heading(words.get("motion")), motion]).collect();
    };
    let mut blocks = vec![
        Block::Heading(words.get("dynamics")),
        Block::Text(words.get("dynamics-text")),
        Block::table(words, "regime", [words.get("quantity"), String::new()], numbers(context, &dynamics)),
    ];
    let number = |value: f64| words.number(&digits(value, DIGITS));
    let rows = dynamics.regime.iteration.iter().map(|turn| {
        let difference = words.number(&format!("{:.2e}", turn.residual));
        vec![turn.number.to_string(), number(turn.speed_start), number(turn.speed_end), difference]
    });
    let rows: Vec<_> = rows.collect();
    if !rows.is_empty() {
        let head = ["turn", "start-speed", "end-speed", "difference"].map(|id| words.get(id));
        blocks.push(Block::table(words, "iteration", head, rows));
    }
    let methods = dynamics.flywheel_methods.iter().map(|row| {
        let off =
            row.difference.map_or_else(String::new, |part| words.number(&format!("{:+.2} %", 1e2 * part)));
        vec![row.method.to_string(), number(row.flywheel), off]
    });
    let methods: Vec<_> = methods.collect();
    if !methods.is_empty() {
        let head = ["method", "flywheel", "deviation"].map(|id| words.get(id));
        blocks.push(Block::table(words, "flywheel-methods", head, methods));
    }
    let caption = words.get("speed-and-moments");
    blocks.extend(context.picture(
        View::Motion,
        position,
        CURVES,
        |_, _| caption,
        |state| {
            state.parts.insert(View::Motion, Part::Course);
        },
    ));
    let caption = words.get("characteristic-and-moments");
    blocks.extend(context.picture(View::Drive, position, CURVES, |_, _| caption, |_| {}));
    blocks
}

fn numbers(context: &Context<'_>, dynamics: &Dynamics) -> Vec<Vec<String>> {
    let words = context.words;
    let all = [
        ("mean-speed", Some(dynamics.mean_speed)),
        ("unevenness", Some(dynamics.unevenness)),
        ("least-speed", Some(dynamics.speed_min)),
        ("greatest-speed", Some(dynamics.speed_max)),
        ("excess-work", Some(dynamics.excess_work)),
        ("required-power", Some(dynamics.required_power)),
        ("motor-power", dynamics.motor.as_ref().map(|motor| motor.rated.power)),
        ("ratio", dynamics.ratio),
        ("flywheel", dynamics.flywheel),
    ];
    let told = all
        .into_iter()
        .filter_map(|(id, value)| Some(vec![words.get(id), words.number(&digits(value?, DIGITS))]));
    let motor = dynamics.motor.as_ref().map(|motor| vec![words.get("motor"), motor.designation.clone()]);
    told.chain(motor).collect()
}
