//! Sheets of shipped scenes.

use std::sync::Arc;

use assur_all as _;
use assur_analysis::{Calculation, Options, plan, unwatched};
use assur_figure::Form as Outline;
use assur_kinematics::{Linkage, decompose};
use assur_picture::{Found, Results};
use assur_sheet::{Page, Part, sheet};
use assur_words::Language;

/// A regime with a motor, contacts, friction, a group of class III, a motion over time.
pub(crate) const SCENES: [&str; 5] = ["shaper-drive", "press", "shaper-friction", "triad", "brake"];

/// The results of a scene, and its sheets in some languages.
pub(crate) fn results_and_pages<const N: usize>(
    scene: &str,
    languages: [&str; N],
) -> (Results, [Vec<Page>; N]) {
    let text = assur_fixtures::scene(scene);
    let (mechanism, note) = assur_scene::read_with_note(scene, text).unwrap();
    let structure = decompose(&mechanism).unwrap();
    let all = vec![true; structure.groups.len()];
    let options = Options::default();
    let plan = plan(&mechanism, &structure, &options);
    let linkage = Arc::new(Linkage::compile_for(mechanism, structure, &all).unwrap());
    let calculation =
        Calculation::planned(Arc::clone(&linkage), plan, None, &options, &mut unwatched).unwrap();
    let found = Found::of(calculation, Arc::clone(&linkage), &options, &mut unwatched).unwrap();
    let mut results = Results::of(linkage).unwrap();
    results.take(Box::new(found));
    let pages = languages.map(|code| sheet(&results, &note, Language::find(code).unwrap()).unwrap());
    (results, pages)
}

/// The texts of what stands together, in their order.
#[allow(dead_code, reason = "each test is a program of its own")]
pub(crate) fn texts(part: &Part) -> Vec<&str> {
    let words = part.elements.iter().filter_map(|element| match &element.form {
        Outline::Text { words, .. } => Some(words.as_str()),
        _ => None,
    });
    words.collect()
}
