//! Commands that choose what is shown of the scene, and how; long texts are scrolled.

use assur_diagram::PlanSheet;
use assur_picture::{Found, Plans, Results, find};
use assur_words::{name, number, text};

use super::{build, draft, jobs};
use crate::screen::state::{
    FRAMES, PACES, Pictures, Purpose, Role, Source, State, View, ViewPart, Wanted, following, next_kind,
    round,
};
use crate::screen::view::{plans, report, room, structure};

/// Rows of the list of values in the smallest terminal.
const VALUES: isize = 6;

/// An eighth of the positions forward or back.
pub(super) fn jump(state: &mut State, sense: isize) {
    let eighth = (state.positions() / 8).max(1);
    state.step(sense * isize::try_from(eighth).unwrap_or(1));
}

/// Chooses the next (1) or previous (-1) item of the list in a view.
pub(super) fn choose(state: &mut State, view: View, by: isize) {
    let (chosen, count) = list(state, view);
    *chosen = round(*chosen, by, count);
}

/// Goes on (1) or back (-1) in the list of a plan, of force polygons at its ends to that of the next group.
pub(super) fn plan(state: &mut State, by: isize) {
    let hidden = plans::hidden(state);
    match state.part(View::Plans) {
        ViewPart::Construction => choose(state, View::Plans, by),
        ViewPart::Velocities | ViewPart::Accelerations => {
            state.chosen.row = next_row(state, by, hidden).unwrap_or(state.chosen.row.min(hidden));
        }
        _ => choose_beyond(state, View::Plans, by, hidden),
    }
}

/// Goes on (1) or back (-1) in what is told of the chosen group, at its ends to the next one; or in the events of the cycle.
pub(super) fn group(state: &mut State, by: isize) {
    if state.part(View::Structure) == ViewPart::Events {
        return choose(state, View::Structure, by);
    }
    let hidden = state.scene.as_ref().map_or(0, |scene| structure::hidden(state, scene));
    choose_beyond(state, View::Structure, by, hidden);
}

/// The row that is the first one in sight after a step, while so many rows are out of sight; `None` beyond the ends.
fn next_row(state: &State, by: isize, hidden: usize) -> Option<usize> {
    state.chosen.row.min(hidden).checked_add_signed(by).filter(|next| *next <= hidden)
}

/// Shows the rows of the chosen item that are out of sight, and beyond them chooses the next item of the list.
fn choose_beyond(state: &mut State, view: View, by: isize, hidden: usize) {
    let next = next_row(state, by, hidden);
    if next.is_none() {
        choose(state, view, by);
    }
    state.chosen.row = next.unwrap_or(0);
}

/// The chosen item of the list in a view, and how many there are.
pub(super) fn list(state: &mut State, view: View) -> (&mut usize, usize) {
    let part = state.part(view);
    let State { scene, chosen, draft, position, .. } = state;
    let scene = scene.as_ref().map(|scene| &scene.results);
    let found = scene.and_then(|scene| scene.found.as_deref());
    let of_scene = |count: fn(&Results) -> usize| scene.map_or(0, count);
    let of_found = |count: fn(&Found) -> usize| found.map_or(0, count);
    let of_plans = |count: fn(&Plans) -> usize| found.map_or(0, |found| count(&found.plans.at(*position)));
    let of_sheet = |count: fn(&PlanSheet) -> usize| {
        found.map_or(0, |found| found.plans.at(*position).sheet.as_ref().map_or(0, count))
    };
    match (view, part) {
        (View::Structure, ViewPart::Events) => (&mut chosen.event, of_found(|found| found.events.len())),
        (View::Structure, _) => (&mut chosen.group, of_scene(|scene| scene.linkage.structure.groups.len())),
        (View::Forces, _) => (&mut chosen.reaction, of_found(|found| found.reactions.len())),
        (View::Motion, _) => (&mut chosen.motion, of_found(|found| found.motion.len())),
        (View::Checks, _) => (&mut chosen.check, of_found(|found| found.analysis.checks.len())),
        (View::Results, _) => (&mut chosen.result, of_found(|found| found.results.len())),
        (View::Table, _) => (&mut chosen.column, of_scene(Results::column_count)),
        (View::Values, _) => (&mut draft.chosen, draft.values.len()),
        (View::Plans, ViewPart::Construction) => (&mut chosen.step, of_plans(Plans::step_count)),
        (View::Plans, _) => (&mut chosen.polygon, of_sheet(|sheet| sheet.polygons.len())),
        _ => (&mut chosen.transfer, of_scene(|scene| scene.transfers.len())),
    }
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

pub(super) fn pace(state: &mut State, by: isize) {
    state.pace = state.pace.saturating_add_signed(by).min(PACES.len() - 1);
    let pace = f64::from(PACES[state.pace]) / f64::from(FRAMES);
    state.say(Role::Plain, text!("say-pace", pace = number(pace * f64::from(state.look.fps))));
}

/// Shows the structure with one group more; after the last one, from the input link on.
pub(super) fn join(state: &mut State) {
    let Some(scene) = &state.scene else { return };
    let count = scene.linkage.structure.groups.len();
    let next = state.joined.map_or(0, |joined| joined + 1);
    state.joined = Some(next).filter(|next| *next < count);
    if let Some(group) = state.joined.and_then(|joined| joined.checked_sub(1)) {
        state.chosen.group = group;
    }
}

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

/// Goes to the position at which the chosen group is nearest to a singular one; or to the chosen event, from its beginning to its end.
pub(super) fn nearest(state: &mut State) {
    if state.part(View::Structure) == ViewPart::Events {
        return event(state);
    }
    let least = state.scene.as_ref().and_then(|scene| scene.least_health(state.chosen.group));
    match least {
        Some((_, at)) => state.go_to(at),
        None => state.say(Role::Plain, text!("say-group-nowhere")),
    }
}

fn event(state: &mut State) {
    let ends = state.found().and_then(|found| found.events.get(state.chosen.event)).map(|event| event.ends);
    let Some((scene, ends)) = state.scene.as_ref().zip(ends) else { return };
    let [from, to] = ends.map(|end| scene.nearest_in_cycle(end));
    state.go_to(if state.position == from { to } else { from });
}

pub(super) fn worst(state: &mut State) {
    match state.found().and_then(|found| found.analysis.checks.get(state.chosen.check)?.at) {
        Some(at) => state.go_to(at),
        None => state.say(Role::Plain, text!("say-check-nowhere")),
    }
}

pub(super) fn part(state: &mut State) {
    let (view, parts) = (state.view, state.available_parts(state.view));
    let next = following(&parts, state.part(view));
    state.parts.insert(view, next);
}

/// Shows a part of the view, or the first part again.
pub(super) fn turn(state: &mut State, part: ViewPart) {
    if !state.has_part(part) {
        return state.say(Role::Plain, text!("say-no-part"));
    }
    let next = if state.part(state.view) == part { ViewPart::Overview } else { part };
    state.parts.insert(state.view, next);
}

/// The registered force analyzer that supports the open scene and follows the one that is asked for; `None` where there is no
/// other one.
fn next_analyzer(state: &State) -> Option<String> {
    let scene = state.scene.as_ref()?;
    let plugins = assur_force::applicable(&scene.linkage).into_iter();
    let names: Vec<&str> =
        plugins.filter(|plugin| plugin.gives_reactions).map(|plugin| plugin.name).collect();
    // The results that are shown may be those of the one before.
    let asked = state.options.analyzer.as_deref().or(state.found().map(|found| found.analyzer.as_str()));
    let now = names.iter().position(|name| asked == Some(name)).unwrap_or(0);
    let next = names.get((now + 1) % names.len().max(1));
    next.filter(|next| asked != Some(**next)).map(|name| (*name).to_owned())
}

pub(super) fn analyzer(state: &mut State) {
    let Some(next) = next_analyzer(state) else { return state.say(Role::Plain, text!("say-one-analyzer")) };
    state.options.analyzer = Some(next);
    if let Some(scene) = &mut state.scene {
        scene.other = None;
    }
    jobs::ask(state, Purpose::Main);
}

pub(super) fn difference(state: &mut State) {
    if state.scene.as_mut().is_some_and(|scene| scene.other.take().is_some()) {
        return;
    }
    match next_analyzer(state) {
        Some(next) => jobs::ask_difference(state, Some(next)),
        None => state.say(Role::Plain, text!("say-one-analyzer")),
    }
}

pub(super) fn theme(state: &mut State) {
    state.look.theme = next_kind(state.look.theme);
    state.say(Role::Plain, name(<&str>::from(state.look.theme)));
}

/// Drawings as pixels, or as characters again; the terminal is asked anew.
pub(super) fn pixels(state: &mut State) {
    state.look.pixels = !state.look.pixels;
    if state.pictures == Pictures::None {
        state.pictures = Pictures::Unknown;
    }
}

pub(super) fn zoom(state: &mut State, by: f64) {
    state.zoom.factor = (state.zoom.factor * by).clamp(0.25, 64.0);
}

/// Shifts the drawing by an eighth of the visible part.
pub(super) fn pan(state: &mut State, axis: usize, sense: f64) {
    state.zoom.shift[axis] -= 0.125 * sense / state.zoom.factor;
}

pub(super) fn reload(state: &mut State) {
    let Some(scene) = &mut state.scene else { return };
    match &state.draft.source {
        // Nothing is to be read, but an analysis that was stopped may continue.
        Source::Shipped(_) if scene.found.is_none() => {
            scene.fault = None;
            jobs::ask(state, Purpose::Main);
        }
        Source::File(_) => {
            let source = state.draft.source.clone();
            state.read(Wanted::Open(source));
        }
        Source::Shipped(_) | Source::New => state.say(Role::Plain, text!("say-no-file")),
    }
}

/// Closes what is open, the last opened first; where nothing is, stops the calculation in progress.
pub(super) fn close(state: &mut State) {
    state.message = None;
    if state.question.take().is_some() {
        return state.say(Role::Plain, text!("say-nothing-written"));
    }
    if state.prompt.take().is_some() || state.help.take().is_some() {
        return;
    }
    if state.picker.is_some() {
        // Without a scene there is nothing behind the list of scenes.
        match &state.scene {
            None if state.view != View::Build => draft::quit(state),
            _ => state.picker = None,
        }
    } else if state.fault.is_some() {
        state.fault = None;
    } else if state.view == View::Build && build::close_task(state) {
    } else if state.values_open() {
        draft::toggle(state);
    } else if state.probe.take().is_none() && !opened_in_view(state) {
        jobs::stop_measuring(state);
        jobs::stop(state);
    }
}

/// Closes what was opened within the view; returns whether there was anything.
fn opened_in_view(state: &mut State) -> bool {
    match state.view {
        View::Curves => !std::mem::take(&mut state.picked).is_empty(),
        View::Plans => state.held.take().is_some(),
        View::Structure => state.joined.take().is_some(),
        _ => false,
    }
}

/// Keeps the plan of this position beside that of the position that is shown, or removes it.
pub(super) fn beside(state: &mut State) {
    state.held = if state.held.is_some() { None } else { Some(state.position) };
}

pub(super) fn measure(state: &mut State) {
    if state.measuring().is_some() {
        jobs::stop_measuring(state);
    } else {
        jobs::ask(state, Purpose::Measurement);
    }
}

pub(super) fn scroll(state: &mut State, by: isize) {
    let last = report::last_line(state);
    let line = state.line();
    *line = (*line).min(last).saturating_add_signed(by).min(last);
}

/// The next or previous quantity of the motion, or line of its page.
pub(super) fn motion(state: &mut State, by: isize) {
    if state.part(View::Motion) == ViewPart::Iteration {
        scroll(state, by);
    } else {
        choose(state, View::Motion, by);
    }
}

pub(super) fn page(state: &mut State, sense: isize) {
    if state.values_open() {
        return choose(state, View::Values, sense * VALUES);
    }
    let page = isize::from(i16::try_from(report::page(state)).unwrap_or(i16::MAX));
    scroll(state, sense * (page - 1).max(1));
}

/// Scrolls to the next line that begins with a text, as a heading does, or if none does, that contains it; `None` if there is none.
pub(super) fn find_line(state: &mut State, wanted: &str) -> Option<()> {
    let lines = report::lines(state, state.view, room(state).width);
    let now = *state.line();
    let line = |index: usize| lines[index].to_lowercase();
    let begins = |index: usize| line(index).trim_start_matches(['=', ' ']).starts_with(wanted);
    let is_heading = (0..lines.len()).any(begins);
    let fits = |index| if is_heading { begins(index) } else { line(index).contains(wanted) };
    *state.line() = find::next(now, lines.len(), fits)?;
    Some(())
}
