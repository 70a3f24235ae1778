//! Walks for the page that are no part of the fixed bench: groups of classes III and IV of every kind, and the shipped scenes.

use std::ops::ControlFlow;

use assur_group::groups;
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;
use assur_structure::{Group, roman};
use assur_testkit::specimen::Recipe;
use assur_words::{joined, name};

use super::{Law, Section, named};
use crate::stability::Comparison;
use crate::stability::friction::friction;
use crate::stability::nearest::nearest;
use crate::stability::row::REACTIONS;
use crate::stability::target::{Target, targets};
use crate::stability::walk::Walk;

static HIGHER: Law =
    Law { section: "Groups of classes III and IV", along: "stability-along", expected: "stability-expected" };

static SHIPPED: Law =
    Law { section: "Shipped scenes", along: "stability-along", expected: "stability-expected" };

static JAMMING: Law = Law {
    section: "Jamming by friction",
    along: "1 - (factor of all coefficients of friction) / (that at which the mechanism jams)",
    expected: "16 eps (groups / product of determinants)^2 / distance, against the equations of the whole mechanism",
};

/// A shipped scene.
fn read(text: &str) -> Mechanism {
    assur_scene::read("scene.toml", text).unwrap()
}

/// Where each group is nearest to a singular position, then the ends of the range.
fn places(linkage: &Linkage) -> Vec<Target> {
    targets(linkage, &nearest(linkage).unwrap_or_default()).0
}

/// Walks to these places.
fn walks(linkage: &Linkage, places: &[Target]) -> Vec<Comparison> {
    let mut rows = Vec::new();
    if let Some(walk) = Walk::new(linkage) {
        for place in places {
            walk.to(place, &mut rows);
        }
    }
    rows
}

/// A mechanism of one group of a kind of class III or above: of random ones the first whose range ends at a singular position, or
/// else the first; of a kind without a pattern a shipped one.
fn of_higher_class(kind: &'static str) -> Option<Linkage> {
    let recipe = Recipe { groups: 1, only: Some(kind), loads: false };
    let random = (0..12).filter_map(|seed| Some(recipe.specimen(seed)?.mechanism));
    let shipped = assur_fixtures::SCENES.iter().map(|(_, text)| read(text));
    let all = random.chain(shipped).filter_map(|mechanism| Linkage::compile(mechanism).ok());
    let is_of_kind = |linkage: &Linkage| matches!(&linkage.structure.groups[..], [Group { plugin, class: 3.., .. }] if plugin.name == kind);
    let mut all: Vec<Linkage> = all.filter(is_of_kind).collect();
    let ends = |linkage: &Linkage| linkage.range.is_some_and(|range| !range.full);
    let best = all.iter().position(ends).unwrap_or(0);
    (best < all.len()).then(|| all.swap_remove(best))
}

/// Each kind of a higher class with its own formulas, and the reactions that follow from them.
fn higher() -> Section {
    let mut rows = Vec::new();
    for plugin in groups().unwrap().iter().filter(|plugin| plugin.number == 0) {
        let Some(linkage) = of_higher_class(plugin.name) else { continue };
        let class = roman(linkage.structure.groups[0].class);
        let Some(last) = places(&linkage).pop() else { continue };
        let words = last.words.to_string();
        let found = walks(&linkage, &[last]).into_iter().filter_map(|row| {
            let is_own = row.quantity != REACTIONS || row.method == name("groups");
            is_own.then(|| Comparison { method: name(plugin.name), ..row })
        });
        rows.extend(named(found.collect(), &format!("class {class}, {}", plugin.kind), &words));
    }
    Section { law: &HIGHER, rows }
}

/// Every shipped scene by its file, the worst of all its walks; those with friction to where it jams; and those without a walk.
pub(super) fn sections() -> (Vec<Section>, Vec<String>) {
    let (mut rows, mut jamming, mut without) = (Vec::new(), Vec::new(), Vec::new());
    let mut scenes = assur_fixtures::SCENES.to_vec();
    scenes.sort_unstable();
    for (scene, text) in scenes {
        let file = format!("`fixtures/{scene}.toml`");
        let mechanism = read(text);
        let mut jams = Vec::new();
        let linkage = Linkage::compile(mechanism.clone()).unwrap();
        assert!(friction(&linkage, &mut jams, &mut || ControlFlow::Continue(())).is_continue());
        for row in &mut jams {
            row.finding.place = joined(": ", [name(file.clone()), row.finding.place.clone()]);
        }
        jamming.extend(jams);
        // The walks have loads of their own, balanced on the input link.
        let linkage = Linkage::compile(Mechanism { balance: None, ..mechanism }).unwrap();
        let class = roman(linkage.structure.class());
        let found = walks(&linkage, &places(&linkage));
        if found.is_empty() {
            without.push(file.clone());
        }
        let worst = |row| Comparison { quantity: "worst", ..row };
        rows.extend(named(found.into_iter().map(worst).collect(), &file, &format!("class {class}")));
    }
    (vec![higher(), Section { law: &JAMMING, rows: jamming }, Section { law: &SHIPPED, rows }], without)
}
