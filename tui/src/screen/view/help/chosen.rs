//! What is chosen now, with which the help begins: a number of the scene, a group, a row, a quantity; else the view itself.

use assur_analysis::results::Owner;
use assur_book::glossary;
use assur_mechanism::PairId;
use assur_scene::reference::key_of;
use assur_words::{Text, joined, name, text};

use super::built;
use super::subject::{Chosen, angle_and_source, entries, group};
use crate::explained;
use crate::screen::state::{Found, Scene, State, View, ViewPart};

/// What is chosen now; `None` where no scene is open.
pub(super) fn chosen(state: &State) -> Option<Chosen> {
    if state.view == View::Build {
        return Some(built::chosen(state).unwrap_or_else(|| view(state, View::Build)));
    }
    let scene = state.scene.as_ref()?;
    if state.values_open()
        && let Some(value) = value(state)
    {
        return Some(value);
    }
    let shown = state.inset().unwrap_or(state.view);
    Some(of_view(state, scene, shown).unwrap_or_else(|| view(state, shown)))
}

/// What is chosen in a view; `None` where it has nothing of its own.
fn of_view(state: &State, scene: &Scene, view: View) -> Option<Chosen> {
    let found = state.found();
    match view {
        View::Structure if state.part(View::Structure) == ViewPart::Events => event(state, found?),
        View::Structure => group(scene, state.chosen.group),
        View::Results => fact(state, scene, found?),
        View::Checks => check(state, found?),
        View::Forces => Some(with_friction(state, scene, found?, quantity(state)?)),
        View::Mechanism | View::Curves | View::Motion | View::Table if state.has(view) => quantity(state),
        _ => None,
    }
}

/// A number of the list of values, as the reference has it.
fn value(state: &State) -> Option<Chosen> {
    let index = state.draft.chosen;
    let key = &state.draft.values.get(index)?.key;
    let known = key_of(key)?;
    let title = joined(": ", [Text::from(key), name(state.draft.shown_value(index))]);
    let lines = vec![text!(known.about), explained::values(known)];
    Some(Chosen { title, lines, words: glossary::of_key(known.about) })
}

/// Something that happens over the cycle.
fn event(state: &State, found: &Found) -> Option<Chosen> {
    let event = found.events.get(state.chosen.event)?;
    let words = event.what.identity().map(|id| glossary::of_fact(id, None)).unwrap_or_default();
    Some(Chosen { title: event.what.clone(), lines: Vec::new(), words })
}

/// A result that is asked for first; of the transmission angle the group that has it, too.
fn fact(state: &State, scene: &Scene, found: &Found) -> Option<Chosen> {
    let (_, fact) = found.results.get(state.chosen.result)?;
    let words = glossary::of_fact(fact.id, fact.column);
    let group = fact.column.and_then(|column| match column.owner {
        Owner::Group(group) => scene.linkage.structure.groups.get(group),
        _ => None,
    });
    let lines = group.map_or_else(Vec::new, |group| angle_and_source(group.plugin).to_vec());
    (!words.is_empty()).then(|| Chosen { title: fact.what(), lines, words })
}

/// A check: what it compares.
fn check(state: &State, found: &Found) -> Option<Chosen> {
    let check = found.analysis.checks.get(state.chosen.check)?;
    let words = check.name.identity().map(glossary::of_check).unwrap_or_default();
    Some(Chosen { title: check.name.clone(), lines: vec![check.reason.clone()], words })
}

/// The quantity that a view is about.
fn quantity(state: &State) -> Option<Chosen> {
    let series = state.main_series()?;
    let whole = [&series.of, &series.kind].into_iter().filter(|part| !part.is_empty()).cloned();
    let title = joined(": ", [series.head.clone(), joined(" ", whole)]);
    Some(Chosen { title, lines: Vec::new(), words: glossary::of_column(series.column) })
}

/// A reaction, with what its friction is where its pair has friction.
fn with_friction(state: &State, scene: &Scene, found: &Found, reaction: Chosen) -> Chosen {
    let pair = found.reactions.get(state.chosen.reaction).and_then(|reaction| reaction.of.as_ref());
    let rubs = |id: PairId| scene.linkage.mechanism.frictions.iter().any(|friction| friction.pair == id);
    let word = pair.map(|(pair, _)| pair.id).filter(|id| rubs(*id)).map(|id| match id {
        PairId::Slide(_) => "word-friction-angle",
        PairId::Pin(_) => "word-friction-circle",
    });
    let words = reaction.words.iter().copied().chain(word.and_then(glossary::find)).collect();
    Chosen { words, ..reaction }
}

/// A view: what it shows.
fn view(state: &State, view: View) -> Chosen {
    let words: &[&str] = match (view, state.part(view)) {
        (View::Results, _) => &["word-stroke", "word-transmission"],
        (View::Mechanism | View::Curves | View::Table, _) => &["word-pf0", "word-pf1"],
        (View::Forces, ViewPart::Hodograph) => &["word-hodograph", "word-reaction"],
        (View::Forces, _) => &["word-reaction", "word-kinetostatics"],
        (View::Plans, ViewPart::Velocities | ViewPart::Accelerations) => &["word-plan", "word-center"],
        (View::Plans, ViewPart::Construction) => &["word-longitudinal", "word-lever"],
        (View::Plans, _) => &["word-polygon"],
        (View::Motion, _) => &["word-motion", "word-regime"],
        (View::Drive, ViewPart::EnergyMass) => &["word-energy-mass", "word-excess"],
        (View::Drive, ViewPart::Inertia | ViewPart::Reduction) => &["word-inertia", "word-moment"],
        (View::Drive, _) => &["word-flywheel", "word-kloss", "word-gear-ratio"],
        (View::Checks, _) => &["word-residual"],
        (View::Accuracy, _) => &["word-residual", "word-condition"],
        (View::Structure, _) => &["word-formula", "word-group"],
        (View::Working, _) => &["word-kinetostatics", "word-pf1"],
        (View::Build, _) => &["word-group", "word-mobility", "word-mode", "word-dyad"],
        (View::Values | View::Sheet, _) => &[],
        (View::Probe, _) => &["word-coupler-curve"],
    };
    let lines = state.named(view.command()).map(|command| text!(command.text)).into_iter().collect();
    Chosen { title: view.name(), lines, words: entries(words) }
}
