//! To the place of a result, to the extremes of a quantity, between the positions too, and back.

use assur_analysis::results::{Column, Owner, Quantity, Turn};
use assur_report::topic::About;
use assur_words::{Text, number, quantity, text};

use super::draft;
use crate::number::{digits, number as plain};
use crate::screen::state::{Role, Scene, State, View};

/// Goes to where a result that is asked for first occurs, in its view.
pub(super) fn result(state: &mut State) {
    let Some((about, fact)) = state.found().and_then(|found| found.results.get(state.chosen.result)).cloned()
    else {
        return;
    };
    // What is told of a motion over time may be told by its coordinate.
    let is_on_axis = |scene: &Scene| scene.samples().is_none() || fact.at_unit.name == "s";
    if let Some(at) = fact.at.first().filter(|_| state.scene.as_ref().is_some_and(is_on_axis)) {
        let near = state.scene.as_ref().map_or(0, |scene| scene.nearest(*at));
        state.go_to(near);
    }
    match fact.column {
        Some(column) => to_quantity(state, column),
        None => {
            state.view = match about {
                About::Structure => View::Structure,
                About::Motion => View::Curves,
                About::Forces => View::Forces,
                About::Regime if state.has(View::Drive) => View::Drive,
                About::Regime => View::Motion,
                About::Checks => View::Checks,
            }
        }
    }
}

fn to_quantity(state: &mut State, column: Column) {
    let Some(scene) = &state.scene else { return };
    let reaction = state.found().and_then(|found| {
        found.reactions.iter().position(|reaction| match (&reaction.of, column.owner) {
            (Some((pair, link)), Owner::PairOn(of, on)) => pair.id == of && link.id == on,
            (Some((pair, _)), Owner::Pair(of)) => pair.id == of,
            (None, _) => column == Column::BALANCING,
            _ => false,
        })
    });
    let transfer = scene.transfers.iter().position(|transfer| transfer.owner == column.owner);
    let short = scene.columns().find(|series| series.column == column).map(|series| series.short.clone());
    match (column.quantity, column.owner, reaction, transfer) {
        (Quantity::Condition, Owner::Group(group), ..) => {
            (state.view, state.chosen.group) = (View::Structure, group);
        }
        (.., Some(reaction), _) => (state.view, state.chosen.reaction) = (View::Forces, reaction),
        (Quantity::Transfer(_), _, _, Some(transfer)) => {
            (state.view, state.chosen.transfer) = (View::Curves, transfer);
            state.picked.clear();
        }
        _ => {
            state.view = View::Curves;
            state.picked = short.into_iter().collect();
        }
    }
}

pub(super) fn go_back(state: &mut State) {
    let Some(stop) = state.trail.pop() else { return state.say(Role::Plain, text!("say-nowhere-back")) };
    if state.scene.as_ref().is_some_and(|scene| scene.session.source == stop.source) {
        return stop.restore(state);
    }
    let count = state.effects.len();
    draft::open(state, stop.source.clone());
    if state.effects.len() > count {
        state.going_back = Some(stop);
    } else {
        // Unsaved changes are warned of first.
        state.trail.push(stop);
    }
}

/// Goes to the greatest value of the quantity that the view is about, between the positions too; of one whose sign is a sense to that
/// of greatest modulus.
pub(super) fn greatest(state: &mut State) {
    let Some((series, scene)) = state.main_series().zip(state.scene.as_ref()) else {
        return state.say(Role::Plain, text!("say-no-extreme"));
    };
    let is_sense = assur_book::catalogue::sign_is_sense(series.column);
    let turns = series.course.turns();
    let range = scene.found.as_ref().and_then(|found| found.range(series));
    let reached = range.map_or_else(|| turns.clone(), |range| vec![range.greatest, range.least]);
    let all = Turn::statistic(&reached);
    let found = if is_sense { all.farthest() } else { all.greatest() };
    let told = if is_sense { "say-extreme-farthest" } else { "say-extreme-greatest" };
    let best = found.map(|best| reached[best.number]);
    let away = |turn: &Turn, best: Turn| (turn.at - best.at).abs();
    let nearest = |best| turns.iter().min_by(|a, b| away(a, best).total_cmp(&away(b, best))).copied();
    to_extreme(state, told, best.and_then(|best| Some((nearest(best)?, best))));
}

/// Goes on to the next extreme of the quantity that the view is about, after the last one the first.
pub(super) fn next_extreme(state: &mut State) {
    let Some((series, scene)) = state.main_series().zip(state.scene.as_ref()) else {
        return state.say(Role::Plain, text!("say-no-extreme"));
    };
    let place = |position: usize| scene.on_axis(position as f64) / scene.axis_unit().1;
    let sense = (place(1) - place(0)).signum();
    let shown = state.extreme.filter(|shown| (shown.0, shown.1) == (series.column, state.position));
    let from = shown.map_or_else(|| place(state.position), |(_, _, at)| at);
    let turns = series.course.turns();
    let next = turns.iter().find(|turn| sense * (turn.at - from) > 0.0).or(turns.first()).copied();
    let refined = |turn| scene.found.as_ref().map_or(turn, |found| found.extreme(series, turn));
    to_extreme(state, "say-extreme-next", next.map(|turn| (turn, refined(turn))));
}

/// Goes to the position nearest to a local extreme, given as it is at the positions and as it is found between them, and says where it is
/// and how great.
fn to_extreme(state: &mut State, told: &'static str, turns: Option<(Turn, Turn)>) {
    let Some(((turn, found), (series, scene))) = turns.zip(state.main_series().zip(state.scene.as_ref()))
    else {
        return state.say(Role::Plain, text!("say-no-extreme"));
    };
    let near = scene.nearest(turn.at);
    let (own, factor) = scene.axis_unit();
    let at = || quantity(digits(factor * found.at, 6), own);
    let (value, place) = if found.value.is_finite() {
        // The end of a cycle is its first position only where the course closes there.
        let place = match scene.among(found.at, series.course.closes() != Some(false)) {
            _ if scene.samples().is_some() => text!("place-sampled", sample = number(near), at = at()),
            [one, other] if one == other => text!("place-in", position = number(one)),
            [one, other] => {
                text!("place-between", at = at(), one = number(one), other = number(other))
            }
        };
        (quantity(plain(series.unit.factor * found.value), series.unit.name), place)
    } else {
        (text!("say-unlimited", at = at()), Text::default())
    };
    let text = Text::message(told, vec![("quantity", series.of.clone()), ("value", value), ("place", place)]);
    state.extreme = Some((series.column, near, turn.at));
    state.go_to(near);
    state.say(Role::Plain, text);
}
