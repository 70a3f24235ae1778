//! Commands that choose what is shown of the scene, and how.

use super::{jobs, report, whatif};
use crate::screen::state::{
    Arrows, FRAMES, Help, Job, Marker, PACES, Part, Purpose, Role, Scene, Source, State, Theme, Traces, View,
    Wish, Zoom, following, round,
};

/// An eighth of the positions forward or back.
pub(super) fn jump(state: &mut State, sense: isize) {
    let eighth = (state.positions() / 8).max(1);
    state.step(sense * isize::try_from(eighth).unwrap_or(1));
}

/// Chooses the next (1) or previous (-1) item of the list in a view.
pub(super) fn choose(state: &mut State, view: View, by: isize) {
    let found = state.found();
    let of_scene = |count: fn(&Scene) -> usize| state.scene.as_ref().map_or(0, count);
    let count = match view {
        View::Structure => of_scene(|scene| scene.linkage.structure.groups.len()),
        View::Forces => found.map_or(0, |found| found.reactions.len()),
        View::Motion => found.map_or(0, |found| found.motion.len()),
        View::Checks => found.map_or(0, |found| found.analysis.checks.len()),
        View::Table => of_scene(Scene::column_count),
        View::Values => state.what_if.values.len(),
        _ => of_scene(|scene| scene.transfers.len()),
    };
    let chosen = match view {
        View::Structure => &mut state.chosen.group,
        View::Forces => &mut state.chosen.reaction,
        View::Motion => &mut state.chosen.motion,
        View::Checks => &mut state.chosen.check,
        View::Table => &mut state.chosen.column,
        View::Values => &mut state.what_if.chosen,
        _ => &mut state.chosen.transfer,
    };
    *chosen = round(*chosen, by, count);
}

/// The next quantity: of the chart, of whatever there is if one was picked, otherwise a point, link or slide.
pub(super) fn quantity(state: &mut State, by: isize) {
    let Some(scene) = state.scene.as_ref().filter(|_| state.view == View::Curves) else {
        return choose(state, View::Mechanism, by);
    };
    let count = scene.column_count();
    let is_last = |index: &usize| scene.column(*index).map(|series| &series.short) == state.picked.last();
    match (0..count).find(is_last) {
        Some(index) => {
            let next = scene.column(round(index, by, count)).map(|series| series.short.clone());
            state.picked.pop();
            state.picked.extend(next);
        }
        None => choose(state, View::Mechanism, by),
    }
}

/// Goes to the greatest (1) or least (-1) value of the quantity that the view is about.
pub(super) fn extreme(state: &mut State, sense: isize) {
    let of_series = |series: &crate::screen::state::Series| {
        let summary = series.summary()?;
        let (word, (_, at)) =
            if sense > 0 { ("greatest", summary.greatest) } else { ("least", summary.least) };
        Some((at, format!("{word} {}: {} in position {at}", series.of, series.show(at))))
    };
    match state.main_series().and_then(of_series) {
        Some((at, text)) => {
            state.go_to(at);
            state.say(Role::Plain, text);
        }
        None => state.say(Role::Plain, "this view has no quantity with a greatest and a least value"),
    }
}

/// A faster (1) or slower (-1) motion.
pub(super) fn pace(state: &mut State, by: isize) {
    state.pace = state.pace.saturating_add_signed(by).min(PACES.len() - 1);
    let pace = f64::from(PACES[state.pace]) / f64::from(FRAMES);
    let text = format!("{} positions a second", pace * f64::from(state.look.fps));
    state.say(Role::Plain, text);
}

/// Shows the structure with one group more; after the last one, from the input link on.
pub(super) fn join(state: &mut State) {
    let Some(scene) = &state.scene else { return };
    let count = scene.linkage.structure.groups.len();
    state.joined = match state.joined {
        None => Some(0),
        Some(joined) if joined + 1 < count => Some(joined + 1),
        Some(_) => None,
    };
    if let Some(group) = state.joined.and_then(|joined| joined.checked_sub(1)) {
        state.chosen.group = group;
    }
}

/// The next or previous row of the table in its present order.
pub(super) fn row(state: &mut State, by: isize) {
    let order = state.order();
    let row = order.iter().position(|position| *position == state.position).unwrap_or(0);
    state.position = order.get(round(row, by, order.len())).copied().unwrap_or(0);
}

/// Sorts the table by the chosen column: ascending, descending, by number again.
pub(super) fn sort(state: &mut State) {
    let column = state.chosen.column;
    state.sorted = match state.sorted {
        Some((sorted, true)) if sorted == column => Some((column, false)),
        Some((sorted, false)) if sorted == column => None,
        _ => Some((column, true)),
    };
}

/// Goes to the position at which the chosen group is nearest to a singular one.
pub(super) fn nearest(state: &mut State) {
    let least = state.scene.as_ref().and_then(|scene| scene.least_health(state.chosen.group));
    match least {
        Some((_, at)) => state.go_to(at),
        None => state.say(Role::Plain, "this group is placed in no position"),
    }
}

/// Goes to the position of the chosen check's largest residual.
pub(super) fn worst(state: &mut State) {
    match state.found().and_then(|found| found.analysis.checks.get(state.chosen.check)?.at) {
        Some(at) => state.go_to(at),
        None => state.say(Role::Plain, "this check belongs to no position"),
    }
}

/// The next part of the view in which there is something to show.
pub(super) fn part(state: &mut State) {
    let (view, parts) = (state.view, state.available_parts(state.view));
    let next = following(&parts, state.part(view));
    state.parts.insert(view, next);
}

/// Reactions by cause, or the table of all again.
pub(super) fn causes(state: &mut State) {
    let next = if state.part(View::Forces) == Part::Causes { Part::Overview } else { Part::Causes };
    state.parts.insert(View::Forces, next);
}

/// The next registered force analyzer that supports the open scene.
fn next_analyzer(state: &State) -> Option<String> {
    let scene = state.scene.as_ref()?;
    let plugins = assur_force::applicable(&scene.linkage).into_iter();
    let names: Vec<&str> =
        plugins.filter(|plugin| plugin.gives_reactions).map(|plugin| plugin.name).collect();
    let now = names.iter().position(|name| state.found().is_some_and(|found| found.analyzer == *name));
    names.get((now.unwrap_or(0) + 1) % names.len().max(1)).map(|name| (*name).to_owned())
}

/// Calculates again with the next force analyzer.
pub(super) fn analyzer(state: &mut State) {
    state.analyzer = next_analyzer(state);
    if let Some(scene) = &mut state.scene {
        scene.other = None;
    }
    jobs::ask(state, Purpose::Main);
}

/// Shows the difference to the next force analyzer, or stops that.
pub(super) fn difference(state: &mut State) {
    if state.scene.as_mut().is_some_and(|scene| scene.other.take().is_some()) {
        return;
    }
    let now = state.analyzer.clone();
    state.analyzer = next_analyzer(state);
    jobs::ask(state, Purpose::Difference);
    state.analyzer = now;
}

/// The next kind of arrows.
pub(super) fn arrows(state: &mut State) {
    let all = [Arrows::None, Arrows::Velocity, Arrows::Acceleration, Arrows::Both];
    state.arrows = following(&all, state.arrows);
}

/// The next kind of paths.
pub(super) fn traces(state: &mut State) {
    state.traces = following(&[Traces::All, Traces::Chosen, Traces::Trail, Traces::None], state.traces);
}

/// The next kind of dots.
pub(super) fn marker(state: &mut State) {
    state.look.marker = following(&Marker::ALL, state.look.marker);
}

/// The next theme.
pub(super) fn theme(state: &mut State) {
    state.look.theme = following(&Theme::ALL, state.look.theme);
    state.say(Role::Plain, state.look.theme.name());
}

/// Larger or smaller, within limits.
pub(super) fn zoom(state: &mut State, by: f64) {
    state.zoom.factor = (state.zoom.factor * by).clamp(0.25, 64.0);
}

/// Shifts the drawing by an eighth of the visible part.
pub(super) fn pan(state: &mut State, axis: usize, sense: f64) {
    state.zoom.shift[axis] -= 0.125 * sense / state.zoom.factor;
}

/// Shows the whole drawing again.
pub(super) fn whole(state: &mut State) {
    state.zoom = Zoom::WHOLE;
}

/// Opens the help.
pub(super) fn help(state: &mut State) {
    state.help = Some(Help::default());
}

/// Reads the scene again.
pub(super) fn reload(state: &mut State) {
    let Some(scene) = &mut state.scene else { return };
    match &scene.source {
        // Nothing is to be read, but an analysis that was stopped may continue.
        Source::Shipped(_) if scene.found.is_none() => {
            scene.fault = None;
            jobs::ask(state, Purpose::Main);
        }
        Source::File(_) => state.wishes.push(Wish::Work(Job::Open(scene.source.clone()))),
        Source::Shipped(_) => state.say(Role::Plain, "a shipped scene has no file to read again"),
    }
}

/// Closes what is open, the last opened first; where nothing is, stops the calculation in progress.
pub(super) fn close(state: &mut State) {
    state.message = None;
    let open = [
        state.question.take().is_some(),
        state.prompt.is_some(),
        state.help.is_some(),
        state.picker.is_some(),
        state.fault.is_some(),
        state.values_open(),
        state.probe.is_some(),
        state.view == View::Curves && !state.picked.is_empty(),
        state.view == View::Structure && state.joined.is_some(),
    ];
    match open.iter().position(|open| *open) {
        Some(0) => state.say(Role::Plain, "no file was written"),
        Some(1) => state.prompt = None,
        Some(2) => state.help = None,
        // Without a scene there is nothing behind the list of scenes.
        Some(3) if state.scene.is_none() => {}
        Some(3) => state.picker = None,
        Some(4) => state.fault = None,
        Some(5) => whatif::toggle(state),
        Some(6) => state.probe = None,
        Some(7) => state.picked.clear(),
        Some(8) => state.joined = None,
        _ => {
            report::stop(state);
            jobs::stop(state);
        }
    }
}
