//! From a result to its place, and back.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_report::topic::About;
use assur_words::text;

use super::whatif;
use crate::screen::state::{Role, State, View};

/// Goes to where a result that is asked for first occurs, in its view.
pub(super) fn result(state: &mut State) {
    let Some((about, fact)) = state.found().and_then(|found| found.results.get(state.chosen.result)).cloned()
    else {
        return;
    };
    if let Some(at) = fact.at.first() {
        let near = state.nearest(*at);
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

/// Shows a quantity in its view.
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

/// Back to the place that was left last.
pub(super) fn go_back(state: &mut State) {
    let Some(stop) = state.trail.pop() else { return state.say(Role::Plain, text!("say-nowhere-back")) };
    if state.scene.as_ref().is_some_and(|scene| scene.session.source == stop.source) {
        return stop.restore(state);
    }
    let count = state.effects.len();
    whatif::open(state, stop.source.clone());
    if state.effects.len() > count {
        state.going_back = Some(stop);
    } else {
        // Unsaved changes are warned of first.
        state.trail.push(stop);
    }
}
