//! The working in each language.

use std::collections::BTreeSet;

use assur_words::Language;

use super::fixtures::scene;
use super::{compiled, worked};

/// Letters that all languages share: functions, axes, the letters of quantities and what the mathematics calls its variables.
const SHARED: [&str; 6] = ["sqrt", "sin", "cos", "atan2", "dq", "dt"];

#[test]
fn in_another_language_only_names_and_symbols_are_latin() {
    for (name, _) in assur_fixtures::SCENES.iter().filter(|(name, _)| !name.starts_with("n-four-bar")) {
        let (linkage, loads) = compiled(scene(name));
        if linkage.solve_index(1, assur_group::Order::Second, &mut linkage.position()).is_err() {
            continue;
        }
        let working = worked(&linkage, loads.as_ref(), 1);
        let mechanism = &linkage.mechanism;
        let links = mechanism.links.iter().skip(1).map(|link| link.name.as_str());
        let points = mechanism.points.iter().map(|point| point.name.as_str());
        let pairs = mechanism.slides.iter().map(|slide| slide.name.as_str());
        let forces = mechanism.forces.iter().map(|load| load.name.as_str());
        let moments = mechanism.moments.iter().map(|load| load.name.as_str());
        let springs = mechanism.springs.iter().map(|load| load.name.as_str());
        let contacts = mechanism.contacts.iter().map(|load| load.name.as_str());
        let loads = forces.chain(moments).chain(springs).chain(contacts);
        let known: Vec<&str> =
            links.chain(points).chain(pairs).chain(loads).chain([mechanism.title.as_str()]).collect();
        let known = known.join(" ");
        let unnamed = ["force", "moment", "brake", "spring", "contact", "on", "ground"];
        let known: BTreeSet<&str> =
            known.split(|c: char| !c.is_alphanumeric()).filter(|word| !unnamed.contains(word)).collect();
        for language in ["uk", "ru"].map(|code| Language::find(code).unwrap()) {
            let text = working.text(language);
            for word in text.split(|c: char| !c.is_alphanumeric()) {
                let latin = word.len() > 1 && word.chars().any(|c| c.is_ascii_lowercase());
                assert!(
                    !latin || known.contains(word) || SHARED.contains(&word),
                    "{name}, {}: {word} in\n{text}",
                    language.code
                );
            }
        }
    }
}
