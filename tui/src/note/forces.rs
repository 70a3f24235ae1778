//! Forces: polygons of every group, reactions, the balancing load.

use super::Context;
use super::document::Block;
use super::kinematics::{PLAN, head, table};
use crate::number::digits;
use crate::screen::state::{Part, View, greatest as greatest_of};

/// Page of a curve beside its hodograph, mm.
const CURVE: [f64; 2] = [160.0, 85.0];

/// Heading, force polygons and table of reactions in the chosen positions, curves of the greatest reaction and of the
/// balancing load; nothing without forces.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let Some(found) = context.state.found().filter(|found| !found.reactions.is_empty()) else {
        return Vec::new();
    };
    let values = [("analyzer", found.analyzer.clone())];
    let mut blocks =
        vec![Block::Heading(words.get("forces")), Block::Text(words.with("forces-text", &values))];
    let all: Vec<usize> = found
        .reactions
        .iter()
        .flat_map(|reaction| reaction.series.iter().chain(&reaction.moment))
        .copied()
        .collect();
    let reactions = table(context, all.iter().map(|index| &found.series[*index]));
    let pairs = found.reactions.iter().enumerate().filter(|(_, reaction)| reaction.series.len() == 3);
    let greatest = pairs
        .map(|(index, reaction)| (index, greatest_of(&found.series[reaction.series[2]].values)))
        .max_by(|one, other| one.1.total_cmp(&other.1))
        .map(|(index, _)| index);
    let balancing = found.reactions.iter().position(|reaction| reaction.pair.is_empty());
    let name = greatest.map(|index| found.reactions[index].name()).unwrap_or_default();
    for &position in context.positions {
        let count = context
            .state
            .found()
            .and_then(|found| found.plans.at(position).sheet.as_ref().ok().map(|sheet| sheet.polygons.len()))
            .unwrap_or(0);
        for polygon in 0..count {
            blocks.extend(context.picture(
                View::Plans,
                position,
                PLAN,
                |words, title| {
                    let values = [("title", words.phrase(title)), ("position", position.to_string())];
                    words.with("force-polygon", &values)
                },
                |state| {
                    state.parts.insert(View::Plans, Part::Forces);
                    state.chosen.polygon = polygon;
                },
            ));
        }
    }
    blocks.push(Block::table(words, "reactions", head(context), reactions));
    let position = context.positions[0];
    if let Some(index) = greatest {
        let caption = words.with("reaction-curve", &[("of", words.phrase(&name))]);
        blocks.extend(context.picture(
            View::Forces,
            position,
            CURVE,
            |_, _| caption,
            |state| {
                state.parts.insert(View::Forces, Part::Overview);
                state.chosen.reaction = index;
            },
        ));
    }
    if let Some(index) = balancing {
        let caption = words.get("balancing");
        blocks.extend(context.picture(
            View::Forces,
            position,
            CURVE,
            |_, _| caption,
            |state| {
                state.parts.insert(View::Forces, Part::Curves);
                state.chosen.reaction = index;
            },
        ));
        blocks.extend(extreme(context, index));
    }
    blocks
}

/// Where the balancing load is greatest.
fn extreme(context: &Context<'_>, reaction: usize) -> Option<Block> {
    let (words, scene, found) = (context.words, context.state.scene.as_ref()?, context.state.found()?);
    let series = &found.series[*found.reactions[reaction].series.first()?];
    let finite = (0..scene.positions()).filter(|position| series.at(*position).is_finite());
    let at = finite.max_by(|one, other| series.at(*one).abs().total_cmp(&series.at(*other).abs()))?;
    let head = [
        words.get("quantity"),
        format!("{}, {}", words.get("greatest"), series.unit),
        words.with("at", &[("unit", words.phrase(&scene.series[0].unit))]),
    ];
    let row = vec![
        words.phrase(&series.of),
        words.number(&digits(series.at(at), 5)),
        words.number(&crate::number::plain(scene.series[0].at(at))),
    ];
    Some(Block::table(words, "greatest", head, vec![row]))
}
