//! What is looked for by its name: pairs, plans, quantities.

use assur_mechanism::{LinkId, Named, PairId};
use assur_words::Text;

use super::act;
use crate::screen::state::{State, View, ViewPart};

/// A pair, and the link on which it acts.
type PairOn = (Named<PairId>, Named<LinkId>);

/// The first of so many items that fits, of those after the present one and then of those up to it.
pub(super) fn next(now: usize, count: usize, fits: impl Fn(usize) -> bool) -> Option<usize> {
    (1..=count).map(|step| (now + step) % count).find(|index| fits(*index))
}

/// Chooses the next reaction of a pair of this name, else one whose pair or link begins with it; false if there is
/// none.
pub(super) fn reaction(state: &mut State, wanted: &str) -> bool {
    let Some(found) = state.found() else { return false };
    let all = &found.reactions;
    let after = |fits: &dyn Fn(&PairOn) -> bool| {
        next(state.chosen.reaction, all.len(), |index| all[index].of.as_ref().is_some_and(fits))
    };
    let begins = |name: &str| name.to_lowercase().starts_with(wanted);
    let same = after(&|(pair, _)| pair.to_lowercase() == wanted);
    let Some(index) = same.or_else(|| after(&|(pair, link)| begins(pair) || begins(link))) else {
        return false;
    };
    state.chosen.reaction = index;
    true
}

/// Chooses the construction of a force analyzer, at its last step, or the force polygon of a group; whether there is one.
pub(super) fn plan(state: &mut State, wanted: &str) -> bool {
    let Some(plans) = state.found().map(|found| found.plans.at(state.position)) else { return false };
    let fits = |text: &Text| state.told(text.clone()).to_lowercase().contains(wanted);
    match state.part(View::Plans) {
        ViewPart::Construction => {
            let same = plans.constructions.iter().position(|(method, _)| *method == wanted);
            let found = same.or_else(|| plans.constructions.iter().position(|(_, drawn)| fits(&drawn.title)));
            let last = found.and_then(|found| plans.steps_of(found).last());
            state.chosen.step = last.unwrap_or(state.chosen.step);
            last.is_some()
        }
        ViewPart::Forces => {
            let polygons = plans.sheet.as_ref().map_or(&[][..], |sheet| &sheet.polygons);
            let found = polygons.iter().position(|polygon| fits(&polygon.title));
            state.chosen.polygon = found.unwrap_or(state.chosen.polygon);
            found.is_some()
        }
        _ => false,
    }
}

/// Chooses quantities for the chart by their names, in this order.
///
/// # Errors
///
/// The name that no quantity has.
pub(crate) fn pick_all<'a>(state: &mut State, names: impl Iterator<Item = &'a str>) -> Result<(), &'a str> {
    let mut picked = Vec::new();
    for wanted in names {
        let column = column(state, &wanted.trim().to_lowercase());
        let short = column.and_then(|column| Some(state.scene.as_ref()?.column(column)?.short.clone()));
        picked.push(short.ok_or(wanted)?);
    }
    state.picked = picked;
    Ok(())
}

/// The quantity of a name: the one with just this name, or else the next one in whose name it occurs.
pub(super) fn column(state: &State, wanted: &str) -> Option<usize> {
    let scene = state.scene.as_ref()?;
    let names = |column: usize| {
        let series = scene.column(column)?;
        let names = [state.told(&series.of), state.told(&series.head), series.short.clone()];
        Some(names.map(|name| name.to_lowercase()))
    };
    let after = |fits: &dyn Fn(&String) -> bool| {
        let fits = |column| names(column).is_some_and(|names| names.iter().any(fits));
        next(state.chosen.column, scene.column_count(), fits)
    };
    after(&|name| name == wanted).or_else(|| after(&|name| name.contains(wanted)))
}

/// The next row behind `now` in which a text occurs as a word of its own, written alike; else as a word; else anywhere.
fn next_row(rows: &[String], now: usize, wanted: &str) -> Option<usize> {
    let lower = wanted.to_lowercase();
    let is_word = |row: &str, wanted: &str| {
        let mut places = row.match_indices(wanted);
        places.any(|(at, _)| {
            let (before, after) = (&row[..at], &row[at + wanted.len()..]);
            !before.ends_with(char::is_alphanumeric) && !after.starts_with(char::is_alphanumeric)
        })
    };
    let fits: [&dyn Fn(&str) -> bool; 3] =
        [&|row| is_word(row, wanted), &|row| is_word(&row.to_lowercase(), &lower), &|row| {
            row.to_lowercase().contains(&lower)
        }];
    fits.iter().find_map(|fits| next(now, rows.len(), |row| fits(&rows[row])))
}

/// Chooses the next row of the list of a view in which a text occurs; false if there is none.
pub(super) fn row(state: &mut State, view: View, wanted: &str) -> bool {
    let Some(scene) = &state.scene else { return false };
    let rows: Vec<Text> = match (view, &scene.found) {
        (View::Values, _) => state.what_if.values.iter().map(|value| (&value.key).into()).collect(),
        (View::Results, Some(found)) => found.results.iter().map(|(_, fact)| fact.what()).collect(),
        (View::Checks, Some(found)) => found.analysis.checks.iter().map(|check| check.name.clone()).collect(),
        (_, Some(_)) => {
            let name = |group| scene.linkage.structure.group_name(&scene.linkage.mechanism, group);
            (0..scene.linkage.structure.groups.len()).map(name).collect()
        }
        _ => return false,
    };
    let rows: Vec<String> = rows.into_iter().map(|row| state.told(row)).collect();
    let chosen = act::chosen(state, view);
    let next = next_row(&rows, *chosen, wanted);
    *chosen = next.unwrap_or(*chosen);
    next.is_some()
}
