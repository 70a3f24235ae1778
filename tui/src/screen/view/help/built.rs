//! What is chosen while a mechanism is built: a field, a kind of group, a link with its group, a point, a slide.

use assur_book::glossary;
use assur_draft::Part;
use assur_mechanism::{LinkId, Mechanism};
use assur_sketch::{Addition, additions};
use assur_words::{Text, joined, list, name, text};

use super::subject::{Chosen, OF_GROUP, entries, group, of_kind};
use crate::screen::state::{FormTask, PickerKind, State, Task, words_of};
use crate::screen::view::pattern::pairs_of;

/// What is chosen; `None` where nothing is.
pub(super) fn chosen(state: &State) -> Option<Chosen> {
    if let Some(picker) = state.picker.as_ref().filter(|picker| picker.kind == PickerKind::Additions) {
        let name = &picker.choice()?.name;
        return additions().unwrap_or_default().iter().find(|one| one.name == name).map(kind);
    }
    if let Task::Join(join) = &state.build.task {
        return Some(kind(&join.addition));
    }
    state.build.form().and_then(field).or_else(|| part(state, &state.build.lit()?))
}

/// A field: why what is typed is not taken, what it is, what it may be.
fn field(form: &FormTask) -> Option<Chosen> {
    let field = form.field()?;
    let values = [&field.values, &field.limits].into_iter().filter(|text| !text.is_empty()).cloned();
    let lines = form.fault.iter().cloned().chain([field.about.clone(), joined("; ", values)]);
    let words = field.about.identity().map(glossary::of_key).unwrap_or_default();
    let title = joined(": ", [Text::from(&field.key), name(form.row()?.value.clone())]);
    Some(Chosen { title, lines: lines.filter(|line| !line.is_empty()).collect(), words })
}

/// A kind of group, or another thing that can be added, with the sorts of its pairs.
fn kind(addition: &Addition) -> Chosen {
    let lines = match addition.plugin {
        Some(plugin) => of_kind(plugin, pairs_of(addition)),
        None => vec![addition.about.clone()],
    };
    Chosen { title: addition.title.clone(), lines, words: entries(&OF_GROUP[..2]) }
}

fn part(state: &State, part: &Part) -> Option<Chosen> {
    let mechanism = &state.build.sketch()?.mechanism;
    let links = |ids: &[LinkId]| list(ids.iter().map(|id| Text::from(&mechanism.links[*id].name)));
    let (lines, words) = match part {
        Part::Link(link) => of_link(state, mechanism, link),
        Part::Point(point) => {
            let point = mechanism.points.iter().find(|own| own.name.as_str() == point)?;
            let on: Vec<LinkId> = point.places.iter().map(|place| place.link).collect();
            let (told, word) = if point.is_pin() {
                ("build-joins", "word-reaction")
            } else {
                ("build-stands-on", "word-coupler-curve")
            };
            (vec![text!(told, links = links(&on))], entries(&[word]))
        }
        Part::Slide(slide) => {
            let slide = mechanism.slides.iter().find(|own| own.name.as_str() == slide)?;
            let line = text!("build-slides", link = links(&[slide.link]), on = links(&[slide.on]));
            (vec![line], entries(&["word-guide", "word-tilt"]))
        }
        Part::Load(..) => return None,
    };
    Some(Chosen { title: words_of(part), lines, words })
}

/// A link: its points, and what is told of its group where it is in one.
fn of_link(state: &State, mechanism: &Mechanism, link: &str) -> (Vec<Text>, Vec<&'static glossary::Entry>) {
    let own = mechanism.link(link);
    let points = mechanism.points.iter().filter(|point| own.is_some_and(|link| point.on(link).is_some()));
    let points = text!("build-has-points", points = list(points.map(|point| Text::from(&point.name))));
    let of_group = state.scene.as_ref().and_then(|scene| {
        let id = scene.linkage.mechanism.link(link)?;
        let groups = &scene.linkage.structure.groups;
        group(scene, groups.iter().position(|group| group.frame.links.contains(&id))?)
    });
    match of_group {
        Some(group) => ([vec![points, group.title], group.lines].concat(), group.words),
        None => (vec![points], entries(&["word-input", "word-mobility"])),
    }
}
