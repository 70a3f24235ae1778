//! The most important results before and after the numbers of the scene were changed.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Borders, Widget};

use crate::number::digits;
use crate::screen::draw::{cut, put_lines};
use crate::screen::state::{Role, Scene, Series, State, greatest};

/// Columns of the name of a result.
const NAME: usize = 13;
/// Digits of a result.
const DIGITS: usize = 4;

/// One result: its name with its unit, and its value in a scene.
type Result = (String, f64);

/// The results of a scene, of which those with the same name belong together.
fn of(state: &State, scene: &Scene) -> Vec<Result> {
    let mut results = Vec::new();
    let named = |what: &str, series: &Series| format!("{what} {}, {}", series.short, series.unit);
    if let Some(series) = state.main_series().and_then(|series| scene.named(&series.short))
        && let Some(summary) = series.summary()
    {
        results.push((named("most", series), summary.greatest.0));
        results.push((named("least", series), summary.least.0));
    }
    let Some(found) = &scene.found else { return results };
    if let Some(series) = found.balancing() {
        results.push((format!("balance, {}", series.unit), greatest(&series.values)));
    }
    let forces = found.reactions.iter().filter(|reaction| reaction.series.len() == 3);
    let force = forces.map(|reaction| greatest(&found.series[reaction.series[2]].values)).reduce(f64::max);
    results.extend(force.map(|force| ("reaction, N".to_owned(), force)));
    if let Some(dynamics) = &found.analysis.dynamics {
        results.push(("unevenness".to_owned(), dynamics.figures.unevenness));
        results.extend(dynamics.flywheel.map(|flywheel| ("flywheel, kg m2".to_owned(), flywheel)));
        results.push(("power, W".to_owned(), dynamics.figures.required_power));
    }
    results.extend(scene.nearest_group().map(|(_, least, _)| ("determinant".to_owned(), least)));
    results
}

/// The results before and after; none unless there is a scene before the changes.
pub(super) fn rows(state: &State) -> Vec<String> {
    let before = state.compared.as_ref().filter(|compared| compared.before);
    let (Some(scene), Some(before)) = (&state.scene, before) else { return Vec::new() };
    let old = of(state, &before.scene);
    let row = |(name, new): Result| {
        let (_, old) = old.iter().find(|(known, _)| *known == name)?;
        let change =
            if *old == 0.0 { String::new() } else { format!("{:+.1} %", 1e2 * (new - old) / old.abs()) };
        let [old, new] = [*old, new].map(|value| digits(value, DIGITS));
        Some(format!("{:<NAME$}{old:>8} -> {new:<8}{change:>7}", cut(&name, NAME)))
    };
    of(state, scene).into_iter().filter_map(row).collect()
}

/// Draws them under a title.
pub(super) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    if area.width == 0 {
        return;
    }
    let block = Block::new().borders(Borders::TOP | Borders::LEFT).title(" greatest values, before -> now ");
    let inner = block.inner(area);
    block.render(area, buffer);
    let lines: Vec<_> = rows(state).into_iter().map(|row| (Role::Plain, row)).collect();
    let rows = usize::from(inner.height);
    put_lines(buffer, inner, 0, state, lines.iter().take(rows));
}
