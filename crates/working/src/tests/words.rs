//! The working in each language.

use std::collections::BTreeSet;

use assur_words::{Language, Text};

use super::fixtures::scene;
use super::{compiled, worked};

/// Letters that all languages share: functions, axes, the letters of quantities and what the mathematics calls its variables.
// `any` is the kind of a group of last resort.
const SHARED: [&str; 7] = ["sqrt", "sin", "cos", "atan2", "dq", "dt", "any"];

#[test]
fn in_another_language_only_names_and_symbols_are_latin() {
    for (name, _) in assur_fixtures::SCENES.iter().filter(|(name, _)| !name.starts_with("n-four-bar")) {
        let (linkage, loads) = compiled(scene(name));
        let is_placed = linkage.solve_index(1, assur_group::Order::Second, &mut linkage.position()).is_ok();
        if !is_placed || linkage.kind().is_time() {
            continue;
        }
        let working = worked(&linkage, loads.as_ref(), 1);
        let mechanism = &linkage.mechanism;
        let links = mechanism.links.iter().skip(1).map(|link| &link.name);
        let points = mechanism.points.iter().map(|point| &point.name);
        let pairs = mechanism.slides.iter().map(|slide| &slide.name);
        let loads = mechanism.loads.iter().map(|load| &load.name);
        // The words of a name that the program gives are those of the language.
        let own = |name| Text::from(name).render(Language::find("uk").unwrap());
        let names = links.chain(points).chain(pairs).chain(loads).map(own);
        let known: String = names.chain([mechanism.title.to_string()]).collect::<Vec<_>>().join(" ");
        let known: BTreeSet<&str> = known.split(|c: char| !c.is_alphanumeric()).collect();
        for language in ["uk", "ru"].map(|code| Language::find(code).unwrap()) {
            let text = working.text(language);
            for word in text.split(|c: char| !c.is_alphanumeric()) {
                let latin = word.len() > 1 && word.is_ascii() && word.chars().any(|c| c.is_ascii_lowercase());
                assert!(
                    !latin || known.contains(word) || SHARED.contains(&word),
                    "{name}, {}: {word} in\n{text}",
                    language.code
                );
            }
        }
    }
}
